"""A server of its own draws what one process draws; what is wrong with it is said at the client."""

import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from paraview import servermanager, simple
from parallel import first_environment, server, start, wait_for
from patience import patient_s
from support import (
    ERRORS,
    PLUGIN,
    SIZE,
    check_close,
    check_not_empty,
    color_by,
    load_plugin,
    look,
    new_view,
    read_png,
    run_checks,
    set_functions,
    show,
    technique_labels,
    temporary_folder,
    wavelet,
)

SAME_PICTURE = 1e-3
COLORS = [37.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.8, 0.2, 277.0, 1.0, 0.3, 0.1]
OPACITY = [(37, 0.0), (130, 0.2), (160, 0.02), (277, 0.5)]
# Whether the client may draw what is small: volumes stay where they are all the same.
THRESHOLDS_MB = (0, 1000)
PATIENCE_S = patient_s(60)


def shown(label: str, half: int = 10, size: tuple[int, int] = SIZE) -> tuple[Any, Any]:
    """Return a view of a wavelet, and its display."""
    view = new_view(size)
    display = show(wavelet(half), view, label)
    color_by(display, view, "RTData")
    set_functions("RTData", COLORS, OPACITY)
    look(view)
    return view, display


def save(view: Any, path: Path) -> None:
    simple.SaveScreenshot(str(path), view, ImageResolution=list(SIZE))


def rows(display: Any) -> dict[str, str]:
    """Return what the panel tells of the picture in words."""
    names = ("UsedText", "LeftOutText")
    return {name: display.GetProperty(name).GetData() for name in names}


def connect(port: int, sides: Sequence[str] = ("remote", "local")) -> None:
    """Become a client of the server, with the plugin on these sides, in this order."""
    simple.Connect("127.0.0.1", port)
    for side in sides:
        load_plugin(remote=side == "remote")


# --- the same as one process -----------------------------------------------------------------


def check_pictures_rows_and_benchmark_are_those_of_one_process() -> None:
    labels = technique_labels()
    with temporary_folder() as folder:
        with server() as port:
            said = run_client(port, "draw and measure", str(folder), *labels)
        assert "The server" not in said, said
        for label in labels:
            view, display = shown(label)
            save(view, folder / "ours.png")
            ours = read_png(folder / "ours.png")
            for threshold in THRESHOLDS_MB:
                name = f"{label}-{threshold}"
                theirs = read_png(folder / f"{name}.png")
                check_close(theirs, ours, SAME_PICTURE, f"{name} MB")
            told = (folder / f"{label}.txt").read_text()
            assert told == str(rows(display)), f"{label}: {told}, not {rows(display)}"
            simple.Delete(view)


def draw_and_measure(port: int, folder: str, *labels: str) -> None:
    connect(port)
    for label in labels:
        view, display = shown(label)
        for threshold in THRESHOLDS_MB:
            view.RemoteRenderThreshold = threshold
            save(view, Path(folder, f"{label}-{threshold}.png"))
            assert view.GetClientSideObject().GetUseDistributedRenderingForRender()
        simple.Render(view)
        assert display.GetProperty("LastFrameMs").GetData() > 0
        Path(folder, f"{label}.txt").write_text(str(rows(display)))
        simple.Delete(view)
    measure()


def measure() -> None:
    """Run the benchmark filter on the server."""
    bench = simple.VolumeBenchmark(Input=wavelet())
    bench.Array = ["POINTS", "RTData"]
    bench.Techniques = ["single-pass", "compute"]
    bench.StepVoxels = [1.0]
    bench.ImageSize = [64, 64]
    bench.UpdatePipeline()
    assert bench.GetClientSideObject() is None, "the client measured"
    table = servermanager.Fetch(bench)
    assert table.GetNumberOfRows() == 2, f"{table.GetNumberOfRows()} rows"
    for row in range(2):
        for name in ("frame_ms.median", "error.rmse"):
            value = table.GetValueByName(row, name).ToDouble()
            assert value > 0, f"row {row}: {name} is {value}"


# --- a server that lacks something -----------------------------------------------------------


def check_server_without_opencl_says_so_and_draws_the_rest() -> None:
    with temporary_folder() as folder:
        with server(["env", f"OCL_ICD_VENDORS={folder}"], complains=True) as port:
            run_client(port, "without")


def draw_without(port: int) -> None:
    reason = "'opencl' cannot run here: OpenCL has no driver"
    connect(port)
    with ERRORS, temporary_folder() as folder:
        view, display = shown("Volume OpenCL")
        for _ in range(3):
            simple.Render(view)
        said = [text for text in ERRORS.take() if "Volume not drawn" in text]
        assert len(said) == 1, f"said {len(said)} times: {said}"
        assert reason in said[0].splitlines()[-1], said[0]
        for label in ("Volume Single Pass", "Volume Compute"):
            display.SetRepresentationType(label)
            save(view, folder / "picture.png")
            check_not_empty(read_png(folder / "picture.png"), label)
        assert not ERRORS.messages, ERRORS.messages


# --- a side without the plugin ---------------------------------------------------------------


def check_server_without_the_plugin_is_named() -> None:
    with server() as port:
        said = run_client(port, "show", "local")
    assert said.count("The server has no plugin VolumeBench") == 1, said
    assert f'LoadPlugin("{PLUGIN}", remote=True)' in said, said


def check_server_with_another_version_is_named() -> None:
    version = plugin_version()
    other = re.sub(r"\d", "7", version)
    with temporary_folder() as folder:
        shutil.copytree(Path(PLUGIN).parent, folder, dirs_exist_ok=True)
        copy = folder / Path(PLUGIN).name
        binary = copy.read_bytes()
        assert binary.count(version.encode() + b"\0") == 1, "where is the version?"
        copy.write_bytes(
            binary.replace(version.encode() + b"\0", other.encode() + b"\0")
        )
        with server(["env", f"PV_PLUGIN_PATH={folder}"]) as port:
            said = run_client(port, "show", "local")
    told = f"The client has VolumeBench {version}, the server {other}."
    assert said.count(told) == 1, said


def plugin_version() -> str:
    """Return the version of the plugin that is loaded here."""
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    plugins = manager.GetLocalInformation()
    names = [plugins.GetPluginName(i) for i in range(plugins.GetNumberOfPlugins())]
    return plugins.GetPluginVersion(names.index("VolumeBench"))


def check_client_without_the_plugin_is_named() -> None:
    loads_by_itself = ["env", f"PV_PLUGIN_PATH={Path(PLUGIN).parent}"]
    with server(loads_by_itself, complains=True) as port:
        said = run_client(port, "show")
    assert "The server has the plugin VolumeBench, the client has not" in said, said
    assert 'VolumeBench.so", remote=False)' in said, said


def check_the_client_may_be_the_first_to_load_it() -> None:
    with server() as port:
        said = run_client(port, "show", "local", "remote")
    assert "VolumeBench" not in said and "|" not in said, said


def show_something(port: int, *sides: str) -> None:
    """Show image data as ParaView does, with the plugin on these sides."""
    connect(port, sides)
    view = new_view()
    simple.Show(wavelet(), view)
    simple.Render(view)


# --- a server that dies ----------------------------------------------------------------------


def check_server_killed_in_mid_frame_leaves_the_client_alive() -> None:
    with temporary_folder() as folder:
        said = client_of_killed_server(folder)
    whole_s, cut_s = (float(word) for word in re.findall(r"took ([0-9.]+) s", said))
    print(f"  a frame of {whole_s:.1f} s ended after {cut_s:.1f} s")
    assert cut_s < 0.7 * whole_s, "the frame was done before the server was killed"
    assert said.count("The server ended, or the connection to it was lost") == 1, said
    assert "connect to a new server" in said, said
    assert said.splitlines()[-1] == "alive", said


def client_of_killed_server(folder: Path) -> str:
    """Return what a client says whose server is killed while it draws."""
    log, server_id = folder / "client", folder / "server"
    keep_id = ["sh", "-c", f'echo $$ > {server_id}; exec "$@"', "sh"]
    with server(keep_id) as port, open(log, "w") as out:
        client = subprocess.Popen(
            client_command(port, "slow"),
            stdout=out,
            stderr=subprocess.STDOUT,
            env=first_environment(),
        )
        try:
            wait_for(lambda: "drawing" in log.read_text(), client)
            time.sleep(0.5)
            os.kill(int(server_id.read_text()), signal.SIGKILL)
            code = client.wait(timeout=PATIENCE_S)
        finally:
            client.kill()
            client.wait()
    assert code == 0, f"the client ended with {code}: {log.read_text()}"
    return log.read_text()


def draw_slowly(port: int) -> None:
    """Draw what takes seconds, twice; then what can be drawn without a server."""
    connect(port)
    view, display = shown("Volume Single Pass", 36, (500, 500))
    display.SetRepresentationType("Volume Reference")
    for message in ("first", "drawing"):
        view.GetActiveCamera().Azimuth(5)
        print(message, flush=True)
        start_s = time.monotonic()
        simple.Render(view)
        print(f"took {time.monotonic() - start_s} s", flush=True)
    simple.Disconnect()
    simple.Connect()
    view, _ = shown("Volume Single Pass")
    with temporary_folder() as folder:
        save(view, folder / "picture.png")
        check_not_empty(read_png(folder / "picture.png"), "a session without server")
    print("alive", flush=True)


# --- clients ---------------------------------------------------------------------------------

CLIENTS = {
    "draw and measure": draw_and_measure,
    "without": draw_without,
    "show": show_something,
    "slow": draw_slowly,
}


def client_command(port: int, work: str, *arguments: str) -> list[str]:
    return [
        shutil.which("pvpython"), __file__, "client", work, str(port), *arguments
    ]  # fmt: skip


def run_client(port: int, work: str, *arguments: str) -> str:
    """Run one of the functions above as a client of the server; return what it says."""
    done = start(client_command(port, work, *arguments))
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    return said


if __name__ == "__main__":
    if sys.argv[1:2] == ["client"]:
        CLIENTS[sys.argv[2]](int(sys.argv[3]), *sys.argv[4:])
    else:
        run_checks(dict(globals()))
