"""Data spread over two ranks, and a server of its own, give the picture of a single process."""

import contextlib
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from paraview import simple
from patience import patient_s
from support import (
    SIZE,
    check_close,
    color_by,
    eighths,
    load_plugin,
    look,
    new_view,
    read_png,
    run_checks,
    set_functions,
    show,
    temporary_folder,
    wavelet,
)
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkNIFTIImageReader
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

MRI_FILE = Path("/usr/share/mricron/templates/ch2.nii.gz")
MRI_SIZE = (181, 217, 181)
SAME_PICTURE = 2e-3
WORST_PIXEL = 4 / 255
SCENES = ("wavelet", "blocks", "volume")
# Ranks that wait leave the processor to those that draw.
YIELD = ["--mca", "mpi_yield_when_idle", "1"]
MPI = ["mpirun", "--allow-run-as-root", "--oversubscribe", *YIELD, "-np", "2"]


def check_client_and_server() -> None:
    with temporary_folder() as folder:
        write_volume(folder)
        with server() as port:
            run(["pvpython", __file__, "scenes", str(folder), str(port)])
        compare(folder, "client and server")


def check_client_and_two_servers() -> None:
    with temporary_folder() as folder:
        write_volume(folder)
        with server(MPI) as port:
            run(["pvpython", __file__, "scenes", str(folder), str(port)])
        compare(folder, "client and two servers")


def check_volume_of_another_kind_in_the_way() -> None:
    """ParaView's own Volume keeps its data where they are."""
    done = start([*MPI, shutil.which("pvbatch"), __file__, "beside"])
    assert done.returncode == 0, f"{done.stdout}{done.stderr}"
    lines = [line for line in done.stderr.splitlines() if "Volume not drawn" in line]
    assert len(lines) == 2, f"{len(lines)} errors: {lines}"
    cause = "what the view shows on different ranks interleaves"
    assert all(cause in line for line in lines), lines


def beside() -> None:
    """The other process: show a volume of ours beside one of ParaView's that overlaps its cut."""
    load_plugin()
    view = new_view()
    color_by(show(wavelet(), view), view, "RTData")
    cut_elsewhere = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, 0, 14])
    color_by(show(cut_elsewhere, view, "Volume"), view, "RTData")
    look(view)
    simple.Render(view)
    simple.Render(view)


def compare(folder: Path, what: str) -> None:
    """Check the pictures that another process left against ours, seam by seam."""
    for name in SCENES:
        other = read_png(folder / f"{name}-other.png")
        draw(name, folder, folder / f"{name}.png", remote=False)
        ours = read_png(folder / f"{name}.png")
        check_close(other, ours, SAME_PICTURE, f"{what}, {name}")
        # A seam is a thin line of wrong pixels that a mean over the picture would forgive.
        worst = np.abs(other - ours).max()
        print(f"  largest difference of a pixel {worst:.3f}")
        assert worst <= WORST_PIXEL, f"{what}, {name}: a seam shows"
        simple.ResetSession()


def draw(name: str, folder: Path, path: Path, remote: bool) -> None:
    """Save ParaView's own picture of a scene."""
    view = new_view()
    if remote:
        view.RemoteRenderThreshold = 0
    if name in ("wavelet", "blocks"):
        source, array = wavelet(), "RTData"
        if name == "blocks":
            source = simple.OpenDataFile(str(folder / "blocks.vtm"))
        colors = [37.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.8, 0.2, 277.0, 1.0, 0.3, 0.1]
        opacity = [(37, 0.0), (130, 0.2), (160, 0.02), (277, 0.5)]
    else:
        source, array = (
            simple.XMLImageDataReader(FileName=[str(folder / "volume.vti")]),
            "scalars",
        )
        colors = [0.0, 0.1, 0.2, 0.4, 120.0, 0.9, 0.5, 0.3, 255.0, 1.0, 1.0, 1.0]
        opacity = [(0, 0.0), (30, 0.0), (90, 0.02), (160, 0.1), (255, 0.3)]
    source.UpdatePipeline()
    display = show(source, view)
    color_by(display, view, array)
    set_functions(array, colors, opacity)
    display.ScalarOpacityUnitDistance = 1.0
    look(view)
    simple.SaveScreenshot(str(path), view, ImageResolution=list(SIZE))
    distributed = view.GetClientSideObject().GetUseDistributedRenderingForRender()
    assert distributed or not remote, "it was drawn by the client"


def scenes(folder: Path, port: int) -> None:
    """The other process: draw all scenes on the server and leave their pictures."""
    simple.Connect("127.0.0.1", port)
    load_plugin(remote=True)
    load_plugin(remote=False)
    for name in SCENES:
        draw(name, folder, folder / f"{name}-other.png", remote=True)


def write_volume(folder: Path) -> None:
    """Write the MRI that the demo shows, or a generated volume of its size, as .vti."""
    if MRI_FILE.is_file():
        reader = vtkNIFTIImageReader()
        reader.SetFileName(str(MRI_FILE))
        reader.Update()
        image = reader.GetOutput()
    else:
        image = generated_volume()
    write_blocks(folder)
    image.GetPointData().GetScalars().SetName("scalars")
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(folder / "volume.vti"))
    writer.SetInputData(image)
    writer.SetCompressorTypeToNone()
    # Appended data cannot be read back with the expat of Debian 12's security updates.
    writer.SetDataModeToBinary()
    writer.Write()


def write_blocks(folder: Path) -> None:
    """Write the wavelet in eight blocks, the lower four first: ranks read consecutive ones."""
    blocks = simple.GroupDatasets(Input=eighths(wavelet()))
    simple.SaveData(str(folder / "blocks.vtm"), proxy=blocks, DataMode="Binary")
    simple.ResetSession()


def generated_volume() -> vtkImageData:
    axes = [np.linspace(-1, 1, side, dtype=np.float32) for side in MRI_SIZE]
    x, y, z = np.meshgrid(*axes, indexing="ij")
    radius = np.sqrt(x**2 + y**2 + z**2)
    waves = 120 * (1 + np.sin(18 * radius + 4 * x)) * np.exp(-2 * radius**2)
    image = vtkImageData()
    image.SetDimensions(*MRI_SIZE)
    flat = np.ascontiguousarray(waves.astype(np.uint8).transpose(2, 1, 0)).ravel()
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def first_environment() -> dict[str, str]:
    """Return the environment this process began with: MPI has since put itself into it."""
    lines = Path("/proc/self/environ").read_bytes().decode().split("\0")
    return dict(line.split("=", 1) for line in lines if "=" in line)


def start(command: list[str]) -> subprocess.CompletedProcess:
    return subprocess.run(
        command,
        capture_output=True,
        text=True,
        timeout=patient_s(240),
        env=first_environment(),
    )


def run(command: list[str]) -> None:
    done = start(command)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    assert "ERR|" not in done.stderr, done.stderr


@contextlib.contextmanager
def server(launcher: list[str] | None = None, complains: bool = False) -> Iterator[int]:
    """Start a pvserver on a free port, and see that it ends, without errors unless it may."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [*(launcher or []), shutil.which("pvserver"), f"--server-port={port}"]
    with temporary_folder() as folder, open(folder / "log", "w+") as log:
        process = subprocess.Popen(
            command, stdout=log, stderr=subprocess.STDOUT, env=first_environment()
        )
        try:
            wait_for(
                lambda: "Accepting connection" in (folder / "log").read_text(), process
            )
            yield port
            process.wait(timeout=patient_s(30))
            said = (folder / "log").read_text()
            assert complains or "ERR|" not in said, said
        finally:
            process.terminate()
            process.wait(timeout=patient_s(30))


def run_client_of_server(script: str) -> None:
    """Run the script in a client as "client PORT", beside a server at that port."""
    with server() as port:
        run([shutil.which("pvpython"), script, "client", str(port)])


def wait_for(ready: Any, process: subprocess.Popen) -> None:
    end = time.monotonic() + patient_s(60)
    while not ready():
        assert process.poll() is None, "the server ended"
        assert time.monotonic() < end, "the server did not start"
        time.sleep(0.1)


if __name__ == "__main__":
    if sys.argv[1:2] == ["scenes"]:
        scenes(Path(sys.argv[2]), int(sys.argv[3]))
    elif sys.argv[1:2] == ["beside"]:
        beside()
    else:
        run_checks(dict(globals()))
