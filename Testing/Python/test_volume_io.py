"""Volume files arrive with the right voxels, spacing and axes; unreadable ones are named."""

import gzip
import json
import struct
import zlib

import numpy as np
import pytest

pytest.importorskip("vtkmodules.vtkIOImage")

from vtkmodules.util import numpy_support  # noqa: E402
from volumebench.datasets import VolumeFile, find_volume  # noqa: E402
from volumebench.errors import BenchError  # noqa: E402
from volumebench.generators import Lemniscate  # noqa: E402
from volumebench.study import Dataset  # noqa: E402
from volumebench.volume_io import open_volume  # noqa: E402


def voxels(volume) -> np.ndarray:
    """Return the values as [x, y, z]."""
    scalars = volume.image.GetPointData().GetScalars()
    nx, ny, nz = volume.dims
    flat = numpy_support.vtk_to_numpy(scalars)
    return flat.reshape(nz, ny, nx).transpose(2, 1, 0)


def write_nifti(path, values: np.ndarray, spacing) -> None:
    """Write uint8 [x, y, z] as a NIfTI-1 file."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *values.shape, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, 2, 8)
    struct.pack_into("<8f", header, 76, 1, *spacing, 0, 0, 0, 0)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    header[344:348] = b"n+1\0"
    path.write_bytes(gzip.compress(bytes(header) + values.tobytes("F")))


def test_generated_volume(tmp_path):
    generator = Lemniscate((6, 5, 9), "uint16")
    dataset = Dataset("lemniscate", (6, 5, 9))
    volume = open_volume(find_volume(dataset, None, tmp_path))
    assert (volume.dims, volume.scalar_type) == ((6, 5, 9), "uint16")
    assert volume.spacing == (1, 1, 1)
    expected = np.stack(list(generator.slices())).transpose(2, 1, 0)
    assert (voxels(volume) == expected).all()
    assert volume.range == (expected.min(), expected.max())


def test_raw_volume_of_other_byte_order(tmp_path):
    values = (np.arange(24) * 1000).astype(">u2")
    (tmp_path / "ct.raw").write_bytes(values.tobytes())
    layout = {
        "dims": [4, 3, 2],
        "scalar_type": "uint16",
        "spacing": [1, 2, 3],
        "byte_order": "big",
    }
    (tmp_path / "ct.json").write_text(json.dumps(layout))
    volume = open_volume(find_volume(Dataset("ct"), tmp_path, tmp_path))
    assert volume.range == (0, 23000)
    assert voxels(volume)[1, 2, 1] == 1000 * (1 + 4 * 2 + 12)
    assert volume.bounds == (0, 3, 0, 4, 0, 3)


def test_a_head_is_turned_upright_without_mirroring(tmp_path):
    values = np.arange(2 * 3 * 4, dtype=np.uint8).reshape(2, 3, 4)
    write_nifti(tmp_path / "head.nii.gz", values, (1, 2, 3))
    path = tmp_path / "head.nii.gz"
    plain = open_volume(VolumeFile("head", path))
    assert plain.dims == (2, 3, 4) and (voxels(plain) == values).all()
    turned = open_volume(VolumeFile("head", path, upright=True))
    assert turned.dims == (2, 4, 3) and turned.spacing == (1, 3, 2)
    for x, y, z in np.ndindex(2, 3, 4):
        assert voxels(turned)[1 - x, z, y] == values[x, y, z]


@pytest.mark.parametrize(
    "name, content",
    [
        ("a.nrrd", b"NRRD0004\ntype: foo\n"),
        ("a.mhd", b"ObjectType = Image\nNDims = 3\nElementDataFile = none.raw\n"),
        ("a.nii", b"x" * 400),
        ("a.nii.gz", b"no gzip"),
        ("a.vti", b"<a>"),
    ],
)
def test_unreadable_files_are_named(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(BenchError, match=f"{name}: cannot be read as"):
        open_volume(find_volume(Dataset("a"), tmp_path, tmp_path))


@pytest.mark.parametrize(
    "values, dims, expected",
    [
        (np.zeros(4, "<f4"), [4, 1, 1], "4 x 1 x 1"),
        (np.full(8, np.nan, "<f4"), [2, 2, 2], "no finite value"),
    ],
)
def test_volumes_that_cannot_be_drawn(tmp_path, values, dims, expected):
    (tmp_path / "a.raw").write_bytes(values.tobytes())
    layout = {"dims": dims, "scalar_type": "float32"}
    (tmp_path / "a.json").write_text(json.dumps(layout))
    with pytest.raises(BenchError, match=expected):
        open_volume(find_volume(Dataset("a"), tmp_path, tmp_path))


def ramp(nx: int = 16, ny: int = 3, nz: int = 2) -> np.ndarray:
    """Return [x, y, z] values of 16 bits, all different; VTK takes a short x axis for components."""
    return (
        np.arange(nx * ny * nz, dtype="<u2").reshape(nz, ny, nx).transpose(2, 1, 0)
        * 100
    )


def nrrd_header(encoding: str, more: str = "") -> bytes:
    lines = ["NRRD0004", "type: uint16", "dimension: 3", "sizes: 16 3 2"]
    lines += ["endian: little", f"encoding: {encoding}"]
    lines += ["spacings: 1 2 3"]
    return ("\n".join(lines) + "\n" + more).encode()


def meta_header(data_file: str, compressed: bool) -> str:
    return (
        "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
        "BinaryDataByteOrderMSB = False\nDimSize = 16 3 2\nElementSpacing = 1 2 3\n"
        f"CompressedData = {compressed}\nElementType = MET_USHORT\n"
        f"ElementDataFile = {data_file}\n"
    )


def write_nrrd(folder) -> None:
    raw = ramp().tobytes("F")
    (folder / "a.nrrd").write_bytes(nrrd_header("raw") + b"\n" + raw)


def write_gzipped_nrrd(folder) -> None:
    raw = ramp().tobytes("F")
    (folder / "a.nrrd").write_bytes(nrrd_header("gzip") + b"\n" + gzip.compress(raw))


def write_detached_nrrd(folder) -> None:
    (folder / "a.nhdr").write_bytes(nrrd_header("raw", "data file: voxels.bin\n"))
    (folder / "voxels.bin").write_bytes(ramp().tobytes("F"))


def write_meta(folder) -> None:
    (folder / "a.mhd").write_text(meta_header("a.raw", False))
    (folder / "a.raw").write_bytes(ramp().tobytes("F"))


def write_compressed_meta(folder) -> None:
    (folder / "a.mhd").write_text(meta_header("a.zraw", True))
    (folder / "a.zraw").write_bytes(zlib.compress(ramp().tobytes("F")))


def write_meta_in_one_file(folder) -> None:
    header = meta_header("LOCAL", False).encode()
    (folder / "a.mha").write_bytes(header + ramp().tobytes("F"))


def write_vti(folder) -> None:
    values = " ".join(str(value) for value in ramp().ravel("F"))
    extent = "0 15 0 2 0 1"
    (folder / "a.vti").write_text(
        '<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">'
        f'<ImageData WholeExtent="{extent}" Origin="0 0 0" Spacing="1 2 3">'
        f'<Piece Extent="{extent}"><PointData Scalars="s"><DataArray type="UInt16" '
        f'Name="s" format="ascii">{values}</DataArray></PointData></Piece>'
        "</ImageData></VTKFile>"
    )


def write_raw(folder) -> None:
    (folder / "a.raw").write_bytes(ramp().tobytes("F"))
    layout = {"dims": [16, 3, 2], "scalar_type": "uint16", "spacing": [1, 2, 3]}
    (folder / "a.json").write_text(json.dumps(layout))


@pytest.mark.parametrize(
    "write",
    [
        write_nrrd,
        write_gzipped_nrrd,
        write_detached_nrrd,
        write_meta,
        write_compressed_meta,
        write_meta_in_one_file,
        write_vti,
        write_raw,
    ],
)
def test_every_format_is_found_by_name_and_read(tmp_path, write):
    write(tmp_path)
    volume = open_volume(find_volume(Dataset("a"), tmp_path, tmp_path))
    assert (volume.dims, volume.scalar_type) == ((16, 3, 2), "uint16")
    assert (voxels(volume) == ramp()).all()
    assert volume.spacing == (1, 2, 3)


def test_nifti_plain_and_compressed(tmp_path):
    values = np.arange(24, dtype=np.uint8).reshape(2, 3, 4)
    write_nifti(tmp_path / "b.nii.gz", values, (1, 2, 3))
    packed = (tmp_path / "b.nii.gz").read_bytes()
    (tmp_path / "a.nii").write_bytes(gzip.decompress(packed))
    for name in ("a", "b"):
        volume = open_volume(find_volume(Dataset(name), tmp_path, tmp_path))
        assert (voxels(volume) == values).all() and volume.spacing == (1, 2, 3)


@pytest.mark.parametrize("extension", [".pvm", ".dat"])
def test_formats_of_the_plugin_need_it(tmp_path, extension):
    """Testing/EndToEnd/readers.py reads them."""
    path = tmp_path / f"a{extension}"
    path.write_bytes(b"PVM\n")
    path.with_suffix(".raw").write_bytes(b"belongs to a.dat")
    file = find_volume(Dataset("a"), tmp_path, tmp_path)
    assert file.path == path
    with pytest.raises(BenchError, match=f"a{extension}: {extension} files need"):
        open_volume(file)
