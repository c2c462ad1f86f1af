"""Statistics, stop rule, camera path and the order of blocks."""

import math

import pytest
from volumebench.measure import StopRule, shuffled
from volumebench.orbit import block_frames, error_frame, orbit_pose
from volumebench.statistics import quantile, relative_noise_of_mean, spread
from volumebench.study import Camera, Timing

HALF = math.sqrt(0.5)
BOX = (0, 10, 0, 20, 0, 20)


def test_spread_of_known_values():
    found = spread([4, 1, 3, 2, 5])
    assert (found.median, found.q1, found.q3, found.min, found.max) == (3, 2, 4, 1, 5)
    assert spread([1, 2]).median == 1.5
    assert quantile([10, 20], 0.25) == 12.5


def test_spread_of_nothing_is_absent_not_zero():
    assert spread([]).median is None


def test_relative_noise_of_the_mean():
    # Mean 10, sample variance 8/3, standard error sqrt(8/3/4).
    assert relative_noise_of_mean([8, 10, 10, 12]) == pytest.approx(
        math.sqrt(8 / 3 / 4) / 10
    )
    assert relative_noise_of_mean([5]) == math.inf
    assert relative_noise_of_mean([0, 0]) == math.inf


def rule(frames, **values) -> StopRule:
    defaults = {"minimum_frames": 3, "relative_noise": 0.1, "time_limit_s": 1.0}
    result = StopRule(Timing(**(defaults | values)))
    for frame in frames:
        result.add(frame)
    return result


def test_stop_rule():
    assert not rule([]).is_finished()
    assert not rule([10, 10]).is_finished(), "too few frames"
    assert rule([10, 10, 10]).is_finished()
    assert not rule([10, 30, 90]).is_finished(), "too noisy"
    assert rule([10, 30, 960]).is_finished(), "out of time"
    assert rule([1500]).is_finished(), "one frame beyond the limit is enough"


def test_shuffled_depends_on_the_seed_alone():
    items = list(range(20))
    assert shuffled(items, 3) == shuffled(items, 3)
    assert shuffled(items, 3) != shuffled(items, 4)
    assert sorted(shuffled(items, 3)) == items == list(range(20))


def test_orbit_keeps_distance_and_elevation():
    camera = Camera(elevation_degrees=30, zoom=2)
    distance = math.dist((0, 0, 0), (10, 20, 20)) / 2 / math.sin(math.radians(15)) / 2
    for frame in range(7):
        pose = orbit_pose(frame, 7, BOX, camera)
        assert pose.focal_point == (5, 10, 10)
        assert math.dist(pose.position, pose.focal_point) == pytest.approx(distance)
        assert pose.position[1] - 10 == pytest.approx(distance / 2)


def test_orbit_starts_at_z_and_turns_to_x():
    camera = Camera(elevation_degrees=0)
    start, quarter = (orbit_pose(frame, 4, BOX, camera).position for frame in (0, 1))
    assert start[0] == pytest.approx(5) and start[2] > 10
    assert quarter[2] == pytest.approx(10) and quarter[0] > 5
    assert orbit_pose(4, 4, BOX, camera).position == pytest.approx(start)


def standpoint(path, frame, elevation=0, seed=0, frames=4):
    """Return direction at length 1, and up."""
    camera = Camera(path, frames, elevation, 1, seed)
    pose = orbit_pose(frame, frames, BOX, camera)
    distance = math.dist((0, 0, 0), (10, 20, 20)) / 2 / math.sin(math.radians(15))
    offset = (a - b for a, b in zip(pose.position, pose.focal_point))
    return [part / distance for part in offset], pose.view_up


# The same numbers stand in Testing/Unit/TestOrbit.cxx: both must take the same path.
@pytest.mark.parametrize(
    "arguments, direction, view_up",
    [
        (("orbit-x", 0), (0, 0, 1), (0, 1, 0)),
        (("orbit-x", 1), (0, 1, 0), (0, 0, -1)),
        (("orbit-x", 1, 30), (0.5, math.sqrt(0.75), 0), (0, 0, -1)),
        (("orbit-diagonal", 0), (0, 0, 1), (HALF, HALF, 0)),
        (("orbit-diagonal", 1), (HALF, -HALF, 0), (HALF, HALF, 0)),
        (
            ("random", 0, 0, 7, 36),
            (0.528310536855, 0.475411236409, 0.703471486944),
            (0, 1, 0),
        ),
        (
            ("random", 5, 0, 7, 36),
            (0.042180250344, -0.684248482334, 0.728028049531),
            (0, 1, 0),
        ),
    ],
)
def test_other_paths(arguments, direction, view_up):
    found, up = standpoint(*arguments)
    assert found == pytest.approx(direction, abs=1e-9)
    assert up == pytest.approx(view_up, abs=1e-9)


def test_in_and_out_halves_the_distance_in_the_middle():
    def distance(frame):
        return math.dist(standpoint("in-and-out", frame, frames=8)[0], (0, 0, 0))

    assert [distance(frame) for frame in (0, 2, 4)] == pytest.approx([1, 2 / 3, 0.5])
    assert distance(7) == pytest.approx(distance(1))


def test_a_block_is_spread_over_the_revolution():
    assert block_frames(0, 4, 36) == [0, 9, 18, 27]
    assert block_frames(1, 4, 36) == [1, 10, 19, 28]


@pytest.mark.parametrize("size, frames", [(4, 36), (4, 7), (4, 3), (4, 1), (5, 12)])
def test_blocks_cover_every_frame(size, frames):
    blocks = [block_frames(block, size, frames) for block in range(frames)]
    assert {frame for block in blocks for frame in block} == set(range(frames))
    assert all(len(set(block)) == len(block) for block in blocks)


def test_error_views_are_spread_over_the_revolution():
    assert [error_frame(view, 3, 12) for view in range(3)] == [0, 4, 8]
    assert [error_frame(view, 2, 5) for view in range(2)] == [0, 2]
    assert error_frame(0, 1, 12) == 1, "off the axis"
    assert (
        error_frame(0, 0, 12) == 1
    ), "without error views, the picture is of the same frame"
