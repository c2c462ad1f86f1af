"""Volumes are found by name, generated ones have the stated field, faults name file and place."""

import numpy as np
import pytest
from volumebench import datasets
from volumebench.datasets import find_volume
from volumebench.errors import BenchError, StudyError
from volumebench.generators import Lemniscate, write_volume
from volumebench.study import Dataset


def voxels(generator: Lemniscate) -> np.ndarray:
    return np.stack(list(generator.slices()))


def test_lemniscate_is_highest_at_the_foci_and_falls_off():
    volume = voxels(Lemniscate((33, 33, 69), "float32", 1.7))
    center = volume[:, 16, 16]
    peak = int(np.argmax(center))
    # Foci at z = +-1 of [-1.7, 1.7]: index 34 -+ 20.
    assert peak in (14, 54)
    assert center[peak] == pytest.approx(1.0, abs=1e-6)
    assert (np.diff(volume[peak, 16, 16:]) < 0).all()
    assert volume.min() == pytest.approx(0.0, abs=1e-6)


def test_lemniscate_level_at_the_centre():
    """At the centre t = 1, so the field is 1/2; the corner is scaled to 0."""
    volume = voxels(Lemniscate((33, 33, 69), "float32", 1.7))
    half = 1.7 * 32 / 68
    radius = 2 * half**2
    product = np.sqrt((radius + 0.7**2) * (radius + 2.7**2))
    corner = 1 / (1 + product)
    assert volume[34, 16, 16] == pytest.approx((0.5 - corner) / (1 - corner), abs=1e-6)


def test_lemniscate_is_symmetric():
    volume = voxels(Lemniscate((20, 20, 41), "uint16"))
    assert (volume == volume[::-1]).all()
    assert (volume == volume.transpose(0, 2, 1)).all()


@pytest.mark.parametrize(
    "scalar_type, top", [("uint8", 255), ("uint16", 65535), ("float32", 1)]
)
def test_scalar_types_use_their_range(scalar_type, top):
    volume = voxels(Lemniscate((9, 9, 69), scalar_type))
    assert volume.dtype == np.dtype(scalar_type)
    assert volume.max() == pytest.approx(top, rel=1e-6)


def test_written_volume_holds_the_slices_in_order(tmp_path):
    generator = Lemniscate((6, 5, 9), "uint16")
    header = write_volume(generator, tmp_path)
    assert "DimSize = 6 5 9" in header.read_text()
    stored = np.fromfile(header.with_suffix(".raw"), "<u2").reshape(9, 5, 6)
    assert (stored == voxels(generator)).all()
    assert sorted(path.suffix for path in tmp_path.iterdir()) == [".mhd", ".raw"]


def test_a_damaged_volume_is_written_again(tmp_path):
    generator = Lemniscate((6, 5, 9), "uint8")
    raw = write_volume(generator, tmp_path).with_suffix(".raw")
    raw.write_bytes(b"short")
    write_volume(generator, tmp_path)
    assert raw.stat().st_size == 6 * 5 * 9


def test_generated_volume_in_an_unusable_folder(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(BenchError, match="cannot be written"):
        write_volume(Lemniscate((4, 4, 4)), tmp_path / "file" / "sub")


def test_parameters_tell_generated_files_apart(tmp_path):
    small = find_volume(Dataset("lemniscate", (4, 4, 8)), None, tmp_path)
    other = find_volume(Dataset("lemniscate", (4, 4, 8), "uint8"), None, tmp_path)
    assert small.path != other.path


def test_user_files_are_found_by_stem(tmp_path):
    (tmp_path / "foot.nii.gz").write_bytes(b"x")
    assert find_volume(Dataset("foot"), tmp_path, tmp_path).path.name == "foot.nii.gz"


def test_missing_volume_names_what_was_looked_for(tmp_path):
    with pytest.raises(StudyError) as caught:
        find_volume(Dataset("foot"), tmp_path, tmp_path)
    message = str(caught.value)
    assert '"foot"' in message and "nrrd" in message and str(tmp_path) in message
    with pytest.raises(StudyError, match="no --data folder is given"):
        find_volume(Dataset("foot"), None, tmp_path)


def test_missing_mri_names_the_package(tmp_path, monkeypatch):
    monkeypatch.setattr(datasets, "MRI_FILE", tmp_path / "absent.nii.gz")
    with pytest.raises(StudyError, match="mricron-data"):
        find_volume(Dataset("mri"), None, tmp_path)


def raw_volume(tmp_path, write_json, byte_count: int, **changes):
    (tmp_path / "ct.raw").write_bytes(bytes(byte_count))
    layout = {"dims": [4, 3, 2], "scalar_type": "uint16", "spacing": [1, 1, 2.5]}
    write_json(layout | changes, "ct.json")
    return find_volume(Dataset("ct"), tmp_path, tmp_path)


def test_raw_volume_with_its_sidecar(tmp_path, write_json):
    layout = raw_volume(tmp_path, write_json, 48).raw
    assert layout.dims == (4, 3, 2)
    assert layout.spacing == (1, 1, 2.5)
    assert layout.byte_order == "little"


@pytest.mark.parametrize(
    "byte_count, changes, expected",
    [
        (47, {}, "47 bytes.*48 bytes"),
        (48, {"scalar_type": "uint12"}, "uint12"),
        (48, {"dims": [4, 3]}, "dims"),
        (48, {"dims": [4, 3, 0]}, "dims"),
        (48, {"spacing": [1, 0, 1]}, "spacing"),
        (48, {"endian": "big"}, "endian"),
    ],
)
def test_raw_volume_faults(tmp_path, write_json, byte_count, changes, expected):
    with pytest.raises(StudyError, match=expected):
        raw_volume(tmp_path, write_json, byte_count, **changes)


def test_raw_volume_without_sidecar(tmp_path):
    (tmp_path / "ct.raw").write_bytes(b"1234")
    with pytest.raises(StudyError, match="ct.json is missing"):
        find_volume(Dataset("ct"), tmp_path, tmp_path)
