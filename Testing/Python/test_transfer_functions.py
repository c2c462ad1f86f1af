"""Transfer functions are mapped to values, and every fault in a file is told in one line."""

from pathlib import Path

import pytest
from conftest import ramp_document
from volumebench.errors import StudyError
from volumebench.transfer_functions import (
    TRANSFER_FUNCTION_FOLDER,
    find_transfer_function,
    load_transfer_function,
)


def load(write_json, **changes):
    given = ramp_document() | changes
    document = {key: value for key, value in given.items() if value is not None}
    return load_transfer_function(write_json(document, "tf.json"))


def test_normalized_points_are_mapped_to_the_scalar_range(write_json):
    function = load(write_json).in_values(100, 300)
    assert function.opacity == ((100, 0), (200, 0.25), (300, 1))
    assert function.color[1] == (300, 1, 0, 0)
    assert function.domain == "value"


def test_points_over_values_stay(write_json):
    points = [[-5, 0], [1000, 1]]
    function = load(write_json, domain="value", opacity=points)
    assert function.in_values(0, 1).opacity == ((-5, 0), (1000, 1))


def test_a_constant_volume_still_has_ascending_points(write_json):
    function = load(write_json).in_values(7, 7)
    assert [point[0] for point in function.opacity] == [7, 7.5, 8]


def test_unit_distance_is_voxels_times_mean_spacing(write_json):
    assert load(write_json).unit_distance((1, 2, 3), (9, 9, 9)) == pytest.approx(4)


def test_unit_distance_may_be_a_share_of_the_box(write_json):
    """Edges of 8 * 1, 16 * 2 and 4 * 3 are 52 / 3 in the mean; another grid of the box is as far."""
    function = load(write_json, unit_distance_voxels=None, unit_distance_edges=0.5)
    assert function.unit_distance((1, 2, 3), (9, 17, 5)) == pytest.approx(26 / 3)
    finer = function.in_values(3, 9).unit_distance((0.5, 1, 1.5), (17, 33, 9))
    assert finer == pytest.approx(26 / 3)


@pytest.mark.parametrize("changes", [{}, {"unit_distance_voxels": 1}])
def test_there_is_one_unit_distance(write_json, changes):
    given = {"unit_distance_voxels": None, "unit_distance_edges": None} | changes
    given["unit_distance_edges"] = 1 if changes else None
    with pytest.raises(StudyError, match="needs one of"):
        load(write_json, **given)


@pytest.mark.parametrize(
    "changes, expected",
    [
        ({"opacity": []}, '"opacity"'),
        ({"opacity": [[0, 0]]}, '"opacity"'),
        ({"opacity": [[0, 0], [1, 1.5]]}, "1.5"),
        ({"opacity": [[0, 0], [1, -0.1]]}, "-0.1"),
        ({"opacity": [[0, 0], [0.5, 0.1], [0.5, 0.2]]}, '"opacity[2]": x 0.5'),
        ({"opacity": [[0.6, 0], [0.5, 0.1]]}, '"opacity[1]": x 0.5'),
        ({"opacity": [[0, 0], [1.2, 1]]}, "outside [0, 1]"),
        ({"opacity": [[0, 0, 0], [1, 1, 1]]}, '"opacity[0]"'),
        ({"color": [[0, 0, 0, 0], [1, 0, 2, 0]]}, '"color[1][2]"'),
        ({"color": [[0, 0, 0], [1, 0, 0]]}, '"color[0]"'),
        ({"domain": "percent"}, "normalized or value"),
        ({"unit_distance_voxels": 0}, '"unit_distance_voxels"'),
        ({"schema": 7}, '"schema"'),
        ({"extra": 7}, "extra"),
    ],
)
def test_each_fault_names_the_place(write_json, changes, expected):
    with pytest.raises(StudyError) as caught:
        load(write_json, **changes)
    assert expected in str(caught.value)
    assert "tf.json" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_missing_file_names_the_folders(tmp_path):
    with pytest.raises(StudyError) as caught:
        find_transfer_function("glow", [tmp_path, Path("/nowhere")])
    message = str(caught.value)
    assert "glow.json" in message and str(tmp_path) in message and "/nowhere" in message


def test_the_first_folder_wins(tmp_path):
    (tmp_path / "mri-opaque.json").write_text("{}")
    folders = [tmp_path, TRANSFER_FUNCTION_FOLDER]
    assert find_transfer_function("mri-opaque", folders).parent == tmp_path


def test_every_shipped_file_is_valid():
    files = sorted(TRANSFER_FUNCTION_FOLDER.glob("*.json"))
    assert len(files) >= 4
    for path in files:
        function = load_transfer_function(path)
        assert function.name == path.stem
        assert function.description
