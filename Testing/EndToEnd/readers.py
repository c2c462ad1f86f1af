"""File > Open for the formats that ParaView lacks: PVM and Voreen volumes, as a user opens them."""

import sys
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from support import (
    ERRORS,
    blob,
    capture,
    check_not_empty,
    color_by,
    look,
    new_view,
    run_checks,
    show,
    temporary_folder,
)

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Python"))

from volumebench.datasets import find_volume  # noqa: E402
from volumebench.errors import BenchError  # noqa: E402
from volumebench.session import plugin_readers  # noqa: E402
from volumebench.study import Dataset  # noqa: E402
from volumebench.volume_io import open_volume  # noqa: E402


def pvm_bytes(values: np.ndarray) -> bytes:
    """Return [z, y, x] values of 8 or 16 bits as a plain PVM volume with voxels 1 x 1 x 2."""
    depth, height, width = values.shape
    header = f"PVM2\n{width} {height} {depth}\n1 1 2\n{values.itemsize}\n"
    return header.encode() + values.astype(values.dtype.newbyteorder(">")).tobytes()


def write_voreen(path: Path, values: np.ndarray) -> None:
    """Write [z, y, x] 16-bit values as a header with its raw file."""
    values.astype("<u2").tofile(path.with_suffix(".raw"))
    size = " ".join(str(count) for count in reversed(values.shape))
    header = f"ObjectFileName: {path.stem}.raw\nResolution: {size}\nFormat: USHORT\n"
    path.write_text(header + "SliceThickness: 1 1 2\nObjectModel: I\n")


def hill() -> np.ndarray:
    return np.rint(blob(20) * 60000).astype(np.uint16).transpose(2, 1, 0)[:15]


def offered_readers(path: Path) -> list[str]:
    """Return the readers that File > Open would offer."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    found = factory.GetReaders(str(path), servermanager.ActiveConnection.Session)
    return [found.GetString(3 * i + 1) for i in range(found.GetLength() // 3)]


def expect_volume(source: object, values: np.ndarray) -> None:
    """Check values, spacing and that the volume is drawn."""
    source.UpdatePipeline()
    info = source.GetDataInformation()
    assert info.GetExtent() == (0, 19, 0, 19, 0, 14), info.GetExtent()
    assert info.GetBounds() == (0, 19, 0, 19, 0, 28), info.GetBounds()
    array = source.PointData["voxels"]
    assert array.GetRange() == (values.min(), values.max()), array.GetRange()
    view = new_view()
    display = show(source, view)
    color_by(display, view, "voxels")
    look(view)
    check_not_empty(capture(view), "the volume")


def check_pvm_volumes_are_opened() -> None:
    with temporary_folder() as folder:
        path = folder / "hill.pvm"
        path.write_bytes(pvm_bytes(hill()))
        source = simple.OpenDataFile(str(path))
        assert source.GetXMLName() == "PVMReader", source.GetXMLName()
        expect_volume(source, hill())


def check_voreen_volumes_are_opened() -> None:
    with temporary_folder() as folder:
        path = folder / "hill.dat"
        write_voreen(path, hill())
        assert "VoreenReader" in offered_readers(path)
        expect_volume(simple.VoreenReader(FileName=str(path)), hill())


def check_file_dialog_knows_the_formats() -> None:
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    session = servermanager.ActiveConnection.Session
    types = factory.GetSupportedFileTypes(session)
    assert "PVM Volumes (*.pvm)" in types, types
    assert "Voreen Volumes (*.dat)" in types, types


def check_a_file_of_another_kind_is_left_to_other_readers() -> None:
    """Tecplot's files end in .dat as well; ParaView asks the user where several readers are left."""
    with temporary_folder() as folder:
        path = folder / "points.dat"
        path.write_text('TITLE = "a Tecplot file"\nVARIABLES = "X"\n')
        offered = offered_readers(path)
        assert offered and "VoreenReader" not in offered, offered


def check_a_broken_file_is_one_error() -> None:
    with temporary_folder() as folder:
        for reader, name, content, cause in (
            (simple.PVMReader, "a.pvm", b"PVM\n9 9 9\n1\nfew", "has 3 bytes of voxels"),
            (
                simple.VoreenReader,
                "a.dat",
                b"ObjectFileName: a\n",
                "Resolution is missing",
            ),
        ):
            path = folder / name
            path.write_bytes(content)
            source = reader(FileName=str(path))
            source.UpdatePipeline()
            messages = ERRORS.take()
            assert len(messages) == 1, f"{name}: {messages}"
            told = messages[0].rpartition("): ")[2]
            assert told.startswith(f"{path}: ") and cause in told, told
            assert "\n" not in told, told
            assert source.GetDataInformation().GetNumberOfPoints() == 0
        (folder / "b.pvm").write_bytes(pvm_bytes(hill()))
        source = simple.PVMReader(FileName=str(folder / "a.pvm"))
        assert len(ERRORS.take()) == 1
        source.FileName = str(folder / "b.pvm")
        expect_volume(source, hill())


def check_studies_read_them_by_name() -> None:
    with temporary_folder() as folder:
        (folder / "first.pvm").write_bytes(pvm_bytes(hill()))
        write_voreen(folder / "second.dat", hill())
        for name in ("first", "second"):
            file = find_volume(Dataset(name), folder, folder)
            volume = open_volume(file, plugin_readers())
            assert volume.dims == (20, 20, 15) and volume.scalar_type == "uint16"
            assert volume.range == (hill().min(), hill().max())
            assert volume.spacing == (1, 1, 2)
        (folder / "second.raw").write_bytes(b"short")
        try:
            open_volume(
                find_volume(Dataset("second"), folder, folder), plugin_readers()
            )
        except BenchError as fault:
            assert str(fault).startswith(f"{folder / 'second.dat'}: its voxels"), fault
        else:
            raise AssertionError("a short file was read")


run_checks(globals())
