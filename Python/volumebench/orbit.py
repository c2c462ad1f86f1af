"""The camera of a study as a pure function of the frame, so that every technique sees the same."""

import math
from dataclasses import dataclass

from .study import Camera

VIEW_ANGLE_DEGREES = 30.0
THREE_VIEWS = "three-views"
FIXED_ANGLES = ((90.0, 0.0), (0.0, 0.0), (40.0, 25.0))  # azimuth, elevation
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

    Path orbit-y: azimuth 360 * frame / frames about y, from +z at frame 0. Path three-views: along
    x, along z, obliquely. At zoom 1 the bounding sphere just fits the view angle; zoom z divides
    the distance by z.
    """
    low, high = bounds[0::2], bounds[1::2]
    center = tuple((a + b) / 2 for a, b in zip(low, high))
    radius = math.dist(low, high) / 2 or 0.5
    distance = radius / math.sin(math.radians(VIEW_ANGLE_DEGREES / 2)) / camera.zoom
    azimuth, elevation = (
        math.radians(angle) for angle in _angles(frame, frames, camera)
    )
    direction = (
        math.cos(elevation) * math.sin(azimuth),
        math.sin(elevation),
        math.cos(elevation) * math.cos(azimuth),
    )
    position = tuple(c + distance * d for c, d in zip(center, direction))
    return CameraPose(position, center)


def _angles(frame: int, frames: int, camera: Camera) -> tuple[float, float]:
    """Return azimuth and elevation in degrees."""
    if camera.path == THREE_VIEWS:
        return FIXED_ANGLES[frame % len(FIXED_ANGLES)]
    return 360 * frame / frames, camera.elevation_degrees


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
