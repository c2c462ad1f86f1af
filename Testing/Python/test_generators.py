"""Generated volumes hold what they promise, are the same everywhere, and need little memory."""

import json
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from volumebench.datasets import find_volume
from volumebench.errors import StudyError
from volumebench.flower import Flower
from volumebench.generate import main
from volumebench.generated_volume import byte_count, random_bits, upper_half
from volumebench.generators import GENERATORS, MarschnerLobb, write_volume
from volumebench.speckle import Speckle
from volumebench.study import Dataset
from volumebench.study_file import load_study
from volumebench.vessels import TreeShape, Vessels, grow_tree, tree_slice

KNOWN = Path(__file__).resolve().parents[1] / "Support" / "generated_volumes.json"


def voxels(generator) -> np.ndarray:
    """Return all values as [z, y, x]."""
    return np.stack(list(generator.slices()))


@pytest.mark.parametrize(
    "row", json.loads(KNOWN.read_text()), ids=lambda row: row["dataset"]["name"]
)
def test_voxels_are_those_that_volumebench_run_makes(row):
    """Its own test reads the same file; sines may differ in their last digit."""
    given = {
        key: tuple(value) if isinstance(value, list) else value
        for key, value in row["dataset"].items()
    }
    generator = GENERATORS[given.pop("name")](**given)
    volume = voxels(generator)
    assert volume.mean() == pytest.approx(row["mean"], abs=1e-3)
    assert list(generator.spacing) == row["spacing"]
    for x, y, z, value in row["voxels"]:
        assert abs(int(volume[z, y, x]) - value) <= 1


def test_every_generator_is_known():
    rows = json.loads(KNOWN.read_text())
    assert [row["dataset"]["name"] for row in rows] == list(GENERATORS)


def test_random_bits_are_those_of_splitmix():
    """The first outputs for the state 0, as its authors' program prints them."""
    gamma = np.uint64(0x9E3779B97F4A7C15)
    index = np.arange(3, dtype=np.uint64) * gamma
    start = random_bits(0, np.zeros(1, np.uint64))  # mixed twice
    first = np.uint64(0xE220A8397B1DCDAF)
    assert random_bits(0, index - first)[0] == first
    assert start[0] != first
    numbers = upper_half(random_bits(5, np.arange(100_000, dtype=np.uint64)))
    assert 0 <= numbers.min() and numbers.max() < 1
    assert numbers.mean() == pytest.approx(0.5, abs=0.005)
    assert np.corrcoef(numbers[1:], numbers[:-1])[0, 1] == pytest.approx(0, abs=0.01)


@pytest.mark.parametrize("kind", [Speckle, Vessels, Flower])
def test_a_seed_is_a_volume(kind):
    first, again, other = (voxels(kind((24, 24, 24), seed=seed)) for seed in (3, 3, 4))
    assert (first == again).all()
    assert (first != other).any()


@pytest.mark.parametrize("name", list(GENERATORS))
def test_writing_takes_less_memory_than_the_volume(tmp_path, name):
    generator = GENERATORS[name](dims=(96, 96, 240), scalar_type="float32")
    tracemalloc.start()
    try:
        header = write_volume(generator, tmp_path)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert header.with_suffix(".raw").stat().st_size == byte_count(generator)
    assert peak < byte_count(generator) / 2


def test_marschner_lobb_signal():
    """At the axis 12 pi cos(0) is a full turn; at r = 1 cos(pi / 2) = 0 is one as well."""
    volume = voxels(MarschnerLobb((41, 41, 41), "float32"))
    for x in (20, 40):
        assert volume[20, 20, x] == pytest.approx(1.5 / 2.5, abs=1e-6)
    assert volume[40, 20, 20] == pytest.approx(0.5 / 2.5, abs=1e-6)
    assert volume[0, 20, 20] == 1
    # r = 0.5: cos(12 pi cos(pi / 4)) with 8.485 pi.
    rings = 0.25 * (1 + np.cos(12 * np.pi * np.sqrt(0.5)))
    assert volume[20, 20, 30] == pytest.approx((1 + rings) / 2.5, abs=1e-6)


def test_speckle_is_rayleigh_distributed():
    """Mean and spread of a Rayleigh length: sigma sqrt(pi / 2) and sigma sqrt(2 - pi / 2)."""
    generator = Speckle((96, 96, 40), "float32")
    volume = voxels(generator)
    tissue = volume[:, 4:24, :]  # no vessel comes there
    decibels = (tissue.astype(float) - 1) * generator.RANGE_DB
    length = 10 ** (decibels / 20) * generator.FULL_SCALE
    assert length.mean() == pytest.approx(np.sqrt(np.pi / 2), rel=0.02)
    assert length.std() == pytest.approx(np.sqrt(2 - np.pi / 2), rel=0.02)
    near = np.corrcoef(length[:, :, :-1].ravel(), length[:, :, 1:].ravel())[0, 1]
    far = np.corrcoef(length[:, :, :-8].ravel(), length[:, :, 8:].ravel())[0, 1]
    assert near > 0.5 and abs(far) < 0.03


def test_speckle_has_the_size_of_the_paper_and_dark_vessels(tmp_path):
    generator = Speckle()
    assert generator.dims == (512, 378, 222)
    small = find_volume(Dataset("speckle", (48, 48, 48)), None, tmp_path)
    assert "ElementSpacing = 0.42 0.39 0.63\n" in small.path.read_text()
    volume = voxels(Speckle((48, 48, 48)))
    assert volume[2, 22:26, 22:26].mean() < 0.2 * volume[2, :8].mean()


def test_a_tree_keeps_the_sum_of_cubed_radii():
    tubes = grow_tree(TreeShape((400, 400, 400), (199.5, 199.5, 0), 120, 12), 7)
    trunk = tubes[0]
    children = [tube for tube in tubes if tube.begin == trunk.end]
    assert len(children) == 2 and len(tubes) > 30
    cubes = sum(tube.begin_radius**3 for tube in children)
    assert cubes == pytest.approx(trunk.end_radius**3)
    for child in children:
        along = np.subtract(child.end, child.begin)
        cosine = along[2] / np.linalg.norm(along)
        assert np.cos(np.radians(50.001)) <= cosine <= np.cos(np.radians(19.999))


def test_a_tube_is_as_thick_as_it_says():
    tubes = grow_tree(TreeShape((41, 41, 200), (20, 20, 0), 100, 8, levels=1), 1)
    area = tree_slice(tubes, (41, 41, 200), 50).sum()
    assert area == pytest.approx(np.pi * (0.95 * 8) ** 2, rel=0.01)


def test_vessels_are_a_body_with_bone_and_contrast():
    volume = voxels(Vessels((96, 96, 160), "float32"))
    assert volume[:, 0, 0].max() == 0, "air in the corners"
    assert volume[80, 30, 80] == pytest.approx(0.25, abs=0.021), "tissue"
    assert volume[20, 43, 48] == pytest.approx(0.55, abs=1e-6), "the trunk"
    assert volume[80, 66, 48] == pytest.approx(0.7, abs=1e-6), "the spine's core"
    assert 0.9 < volume.max() <= 0.95, "compact bone"
    fork = round(0.3 * 159)
    ball, trunk = (volume[z, 43, 20:].astype(float) for z in (fork, fork // 2))
    across = [(row > 0.5).sum() for row in (ball, trunk)]
    assert across[0] > 1.5 * across[1], "the aneurysm is thicker than the trunk"


def test_a_flower_is_thin_and_mostly_air():
    volume = voxels(Flower((96, 96, 96), "float32"))
    assert 0.5 < (volume == 0).mean() < 0.95
    assert volume[31, 47, 47] == pytest.approx(0.95, abs=0.01), "the ovary"
    assert volume[5, 47, 47] == pytest.approx(0.65, abs=0.02), "the stem"
    turned = voxels(Flower((96, 96, 96), "float32", seed=2))
    assert (volume != turned).any()


def test_studies_name_seed_and_spacing(write_json, document):
    document["datasets"] = [{"name": "speckle", "dims": [8, 8, 8], "seed": 7}]
    document["datasets"] += [{"name": "a", "generator": "ball", "spacing": [1, 2, 3]}]
    first, second = load_study(write_json(document)).datasets
    assert first.seed == 7 and second.spacing == (1, 2, 3)


@pytest.mark.parametrize(
    "item, expected",
    [
        ({"name": "ball", "seed": 1}, '"seed" does not apply to "ball"'),
        ({"name": "speckle", "seed": -1}, "from 0 to 2147483647"),
        ({"name": "ball", "spacing": [1, 0, 1]}, "above 0"),
        ({"name": "foot", "spacing": [1, 1, 1]}, "applies only to generated volumes"),
    ],
)
def test_faults_of_seed_and_spacing(write_json, document, item, expected):
    document["datasets"] = [item]
    with pytest.raises(StudyError, match=expected):
        load_study(write_json(document))


def test_the_command_writes_a_file(tmp_path, capsys):
    header = tmp_path / "us.mhd"
    options = ["--dims", "10", "9", "8", "--seed", "3", "--scalar-type", "uint16"]
    assert main(["speckle", "--out", str(header), *options]) == 0
    assert "10 x 9 x 8 uint16, 1440 bytes" in capsys.readouterr().out
    stored = np.fromfile(tmp_path / "us.raw", "<u2").reshape(8, 9, 10)
    assert (stored == voxels(Speckle((10, 9, 8), "uint16", 3))).all()
    assert main(["speckle", "--out", str(header), *options[:4], "--seed", "4"]) == 0
    assert (tmp_path / "us.raw").stat().st_size == 720, "another volume replaces it"


@pytest.mark.parametrize(
    "arguments, expected",
    [
        (["ball", "--seed", "1"], '--seed does not apply to "ball"'),
        (["speckle", "--seed", "-1"], "--seed: -1 is not from 0"),
        (["ball", "--dims", "1", "9", "9"], "--dims: each must be from 2 to 4096"),
        (["ball", "--spacing", "1", "nan", "1"], "--spacing: each must be above 0"),
        (["shell", "--share", "0"], "--share: 0 is not above 0 and at most 1"),
        (["ball", "--out", "a.raw"], "a.raw does not end in .mhd"),
    ],
)
def test_faults_of_the_command_are_one_line(capsys, arguments, expected):
    assert main(arguments) == 2
    told = capsys.readouterr().err
    assert expected in told and told.count("\n") == 1


def test_a_folder_that_cannot_be_written_is_one_line(tmp_path, capsys):
    (tmp_path / "file").write_text("")
    assert main(["ball", "--out", str(tmp_path / "file" / "a.mhd")]) == 2
    told = capsys.readouterr().err
    assert "file/a" in told and told.count("\n") == 1
