"""Volume files arrive with the right voxels, spacing and axes; unreadable ones are named."""

import gzip
import json
import struct

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
