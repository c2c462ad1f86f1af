"""Volumes are found by name, generated ones have the stated field, faults name file and place."""

from dataclasses import replace

import numpy as np
import pytest
from volumebench import datasets
from volumebench.datasets import find_volume, fitting_memory, free_memory_gb
from volumebench.datasets import with_stand_ins
from volumebench.errors import BenchError, StudyError
from volumebench.generators import Ball, Lemniscate, Shell
from volumebench.generators import radius_around, share_within, write_volume
from volumebench.study import Dataset
from volumebench.study_file import load_study


def voxels(generator: Lemniscate | Ball) -> np.ndarray:
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


def test_ball_is_a_hollow_wall():
    """Radius 0.62 of half the box: index 31 + 0.62 * 31 = 50.2 of 63."""
    volume = voxels(Ball((63, 63, 63), "float32"))
    ray = volume[31, 31, 31:]
    assert int(np.argmax(ray)) == 19
    assert ray[19] == pytest.approx(1, abs=3e-3)
    assert ray[0] < 0.01, "hollow"
    assert ray[31] == volume[0, 0, 0] == 0, "nothing at the faces and beyond"
    assert volume == pytest.approx(volume.transpose(2, 0, 1), abs=1e-6)


def test_ball_is_small_bytes_by_default(tmp_path):
    file = find_volume(Dataset("ball"), None, tmp_path)
    assert "DimSize = 32 32 32" in file.path.read_text()
    assert file.path.with_suffix(".raw").stat().st_size == 32**3
    volume = voxels(Ball())
    assert volume.dtype == np.uint8 and volume.max() > 250


@pytest.fixture
def with_fallback(write_json, document):
    document["datasets"] = [{"name": "bucky", "otherwise": "ball", "dims": [9, 9, 9]}]
    document["transfer_functions"] = {"bucky": ["ramp"]}
    document["techniques"] = ["slices-threaded"]
    document["technique_settings"] = {"slices-threaded": {"slice_threads": [1, 2]}}
    document["technique_settings_scenes"] = [{"dataset": "bucky"}]
    return load_study(write_json(document))


def test_a_missing_volume_has_a_named_stand_in(with_fallback, tmp_path):
    study = with_stand_ins(with_fallback, tmp_path / "nothing")
    (dataset,) = study.datasets
    assert (dataset.name, dataset.stands_for) == ("ball", "bucky")
    assert {run.scene.dataset for run in study.runs()} == {"ball"}
    assert len(study.runs()) == len(with_fallback.runs())
    file = find_volume(dataset, None, tmp_path)
    assert file.name == "ball" and "9 9 9" in file.path.read_text()


def test_a_stand_in_may_have_a_name_of_its_own(document, write_json, tmp_path):
    """Two volumes that are missing may have stand-ins by one generator."""
    names = ("foot", "angio")
    document["datasets"] = [
        {
            "name": name,
            "otherwise": f"{name}-like",
            "generator": "ball",
            "dims": [edge] * 3,
        }
        for name, edge in zip(names, (8, 12))
    ]
    study = load_study(write_json(document))
    (tmp_path / "angio.mhd").write_text("x")
    found = with_stand_ins(study, tmp_path)
    foot, angio = found.datasets
    assert (foot.name, foot.stands_for) == ("foot-like", "foot")
    assert (angio.name, angio.stands_for) == ("angio", None)
    file = find_volume(foot, tmp_path, tmp_path / "cache")
    assert "8 8 8" in file.path.read_text()
    assert find_volume(angio, tmp_path, tmp_path).path == tmp_path / "angio.mhd"


def test_a_volume_that_is_there_needs_no_stand_in(with_fallback, tmp_path):
    (tmp_path / "bucky.mhd").write_text("x")
    study = with_stand_ins(with_fallback, tmp_path)
    assert study == with_fallback
    assert find_volume(study.datasets[0], tmp_path, tmp_path).name == "bucky"


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


@pytest.mark.parametrize("share", [0.01, 0.1, 0.3, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("scalar_type", ["uint8", "float32"])
def test_shell_fills_its_share_of_the_box(share, scalar_type):
    """The outermost points stand for half a cell only: 3 % of 96 points."""
    volume = voxels(Shell((96, 96, 96), scalar_type, share))
    assert (volume > 0).mean() == pytest.approx(share, rel=0.07)
    top = 255 if scalar_type == "uint8" else 1
    assert volume.max() == pytest.approx(top, rel=0.05)


def test_shell_is_hollow_up_to_half_of_the_box():
    assert voxels(Shell((33, 33, 33), "uint8", 0.3))[16, 16, 16] == 0
    assert voxels(Shell((33, 33, 33), "uint8", 0.5))[16, 16, 16] == 255
    inner, outer = Shell(share=0.1).radii()
    assert np.pi / 6 * (outer**3 - inner**3) == pytest.approx(0.1)


@pytest.mark.parametrize("radius", [0.5, 1.1, 1.4, 1.45, 1.6, 1.72])
def test_share_of_a_cube_within_a_distance(radius):
    """Against counting: in the ball, across the faces, and across the edges."""
    axis = (np.arange(160) + 0.5) / 160
    squares = axis[:, None, None] ** 2 + axis[:, None] ** 2 + axis**2
    assert share_within(radius) == pytest.approx(
        (squares < radius**2).mean(), abs=5e-4
    )
    assert radius_around(share_within(radius)) == pytest.approx(radius, abs=1e-3)


def test_a_generated_volume_may_have_a_name_of_its_own(tmp_path):
    dataset = Dataset("wall", (8, 8, 8), "uint8", share=0.25, generator="shell")
    file = find_volume(dataset, None, tmp_path)
    assert file.name == "wall"
    assert file.path.name == "shell-8x8x8-uint8-share0.25.mhd"


@pytest.mark.parametrize(
    "item, expected",
    [
        ({"name": "a", "generator": "cone"}, '"generator" of dataset "a" is "cone"'),
        ({"name": "a", "share": 0.5}, '"share" of dataset "a" applies only to'),
        ({"name": "a", "generator": "ball", "share": 0.5}, '"share" does not apply'),
        ({"name": "a", "generator": "shell", "share": 0}, "at most 1"),
        ({"name": "a", "memory_gb": 0}, "gigabytes, above 0"),
    ],
)
def test_faults_of_generated_volumes_are_named(write_json, document, item, expected):
    document["datasets"] = [item]
    with pytest.raises(StudyError, match=expected):
        load_study(write_json(document))


def test_volumes_too_large_for_the_memory_are_left_out_with_a_note(study):
    small = replace(study.datasets[0], memory_gb=2)
    large = replace(small, name="large", memory_gb=8.5)
    names = {"large": ("ramp",), small.name: ("ramp",)}
    both = replace(study, datasets=(small, large), transfer_functions=names)
    assert fitting_memory(both, 9).datasets == (small, large)
    assert fitting_memory(both, None) is both
    cut = fitting_memory(both, 8.4)
    assert cut.datasets == (small,)
    assert cut.notes == (
        "large is left out: it takes 8.5 GB of memory, and 8 are free.",
    )
    assert {run.scene.dataset for run in cut.runs()} == {small.name}
    with pytest.raises(StudyError, match="no volume fits the 1 GB"):
        fitting_memory(both, 1.2)


def test_this_machine_tells_its_memory():
    assert free_memory_gb() > 0.1
