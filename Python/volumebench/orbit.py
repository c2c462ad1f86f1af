"""The camera of a study as a pure function of the frame, so that every technique sees the same."""

import math
from dataclasses import dataclass

from .study import Camera

VIEW_ANGLE_DEGREES = 30.0
THREE_VIEWS = "three-views"
FIXED_ANGLES = ((90.0, 0.0), (0.0, 0.0), (40.0, 25.0))  # azimuth, elevation
IN_AND_OUT_AZIMUTH = 40.0
Y_AXIS = (0.0, 1.0, 0.0)
Vector = tuple[float, float, float]
Bounds = tuple[float, float, float, float, float, float]


@dataclass(frozen=True)
class CameraPose:
    """Where the camera stands, what it looks at, and which way is up."""

    position: Vector
    focal_point: Vector
    view_up: Vector = (0.0, 1.0, 0.0)
    view_angle_degrees: float = VIEW_ANGLE_DEGREES


def orbit_pose(frame: int, frames: int, bounds: Bounds, camera: Camera) -> CameraPose:
    """Return the pose of one frame, looking at the middle of the bounds.

    Path orbit-y: azimuth 360 * frame / frames about y, from +z at frame 0; orbit-x and
    orbit-diagonal: the same about x, and about the line between x and y. Path three-views: along x,
    along z, obliquely. Path in-and-out: once to half the distance and back. Path random: anywhere
    on the sphere. At zoom 1 the bounding sphere just fits the view angle; zoom z divides the
    distance by z. The filter has the same in Orbit.cxx.
    """
    low, high = bounds[0::2], bounds[1::2]
    center = tuple((a + b) / 2 for a, b in zip(low, high))
    radius = math.dist(low, high) / 2 or 0.5
    distance = radius / math.sin(math.radians(VIEW_ANGLE_DEGREES / 2)) / camera.zoom
    direction, view_up, nearness = _standpoint(frame, frames, camera)
    distance /= nearness
    position = tuple(c + distance * d for c, d in zip(center, direction))
    return CameraPose(position, center, view_up)


def _standpoint(
    frame: int, frames: int, camera: Camera
) -> tuple[Vector, Vector, float]:
    """Return the direction of the camera, what is up, and what divides the distance."""
    turn = 2 * math.pi * (frame % frames) / frames
    elevation = math.radians(camera.elevation_degrees)
    sine, cosine = math.sin(turn), math.cos(turn)
    raised, level = math.sin(elevation), math.cos(elevation)
    if camera.path == "orbit-x":
        return (raised, level * sine, level * cosine), (0.0, cosine, -sine), 1.0
    if camera.path == "orbit-diagonal":
        half = math.sqrt(0.5)
        direction = (half * (level * sine + raised), half * (raised - level * sine))
        return (*direction, level * cosine), (half, half, 0.0), 1.0
    if camera.path == "in-and-out":
        azimuth = math.radians(IN_AND_OUT_AZIMUTH)
        return _on_orbit_y(azimuth, elevation), Y_AXIS, 1.5 - 0.5 * cosine
    if camera.path == "random":
        return _at_random(frame % frames, camera.seed)
    if camera.path == THREE_VIEWS:
        turn, elevation = map(math.radians, FIXED_ANGLES[frame % len(FIXED_ANGLES)])
    return _on_orbit_y(turn, elevation), Y_AXIS, 1.0


def _on_orbit_y(azimuth: float, elevation: float) -> Vector:
    level = math.cos(elevation)
    return (
        level * math.sin(azimuth),
        math.sin(elevation),
        level * math.cos(azimuth),
    )


def _at_random(frame: int, seed: int) -> tuple[Vector, Vector, float]:
    """Return a direction that depends on seed and frame alone, evenly over the sphere."""
    state = (seed << 32) + 2 * frame
    height = 2 * _random_share(state) - 1
    azimuth = 2 * math.pi * _random_share(state + 1)
    radius = math.sqrt(1 - height * height)
    direction = (radius * math.sin(azimuth), height, radius * math.cos(azimuth))
    # Too near to the y axis, that cannot be up.
    return direction, (0.0, 0.0, 1.0) if abs(height) > 0.9 else Y_AXIS, 1.0


def _random_share(state: int) -> float:
    """Return a number in [0, 1): SplitMix64 (Steele, Lea and Flood 2014)."""
    mask = 2**64 - 1
    state = (state + 0x9E3779B97F4A7C15) & mask
    state = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & mask
    state = ((state ^ (state >> 27)) * 0x94D049BB133111EB) & mask
    return ((state ^ (state >> 31)) >> 11) / 2**53


def block_frames(block: int, size: int, frames: int) -> list[int]:
    """Return the frames of a block, spread evenly over the revolution.

    A run that stops after any whole number of blocks has then seen all sides of the volume,
    and successive blocks fill the gaps until every frame was shown.
    """
    size = min(size, frames)
    shift = block % math.ceil(frames / size)
    return [(index * frames // size + shift) % frames for index in range(size)]


def error_frame(view: int, views: int, frames: int) -> int:
    """Return the frame of an error view, as the filter chooses it for path engine.

    It lies an eighth of a view's share past the axes, where grids and silhouettes look best.
    """
    views = max(views, 1)
    return (8 * view + 1) * frames // (8 * views)
