"""A tree of vessels, and a body with such a tree that stands in for an angiography."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .generated_volume import GeneratedVolume, RandomNumbers, Triple
from .generated_volume import random_bits, soft_step, upper_half

WALL_VOXELS = 1.5  # over which the border of a vessel fades


@dataclass(frozen=True)
class Tube:
    """A straight vessel with round ends, in voxels; its radius goes from one to the other."""

    begin: Triple
    end: Triple
    begin_radius: float
    end_radius: float

    def reach(self, axis: int) -> tuple[float, float]:
        """Return where it begins and ends along an axis, its border included."""
        margin = max(self.begin_radius, self.end_radius) + WALL_VOXELS
        ends = (self.begin[axis], self.end[axis])
        return min(ends) - margin, max(ends) + margin


@dataclass(frozen=True)
class TreeShape:
    """Root and size of a tree, in voxels; it grows along z and ends within the box of `dims`."""

    dims: tuple[int, int, int]
    root: Triple
    length: float
    radius: float
    levels: int = 9


SMALLEST_RADIUS_VOXELS = 0.6


def grow_tree(shape: TreeShape, seed: int) -> list[Tube]:
    """Return the tubes of a tree, each parent before its children.

    `length` and `radius` are those of the trunk. At each fork the cubes of the radii add up (Murray 1926); a child goes on at an angle of 20 to 50
    degrees, its sibling on the other side.
    """
    random = RandomNumbers(seed)
    width = min(shape.dims[0], shape.dims[1])
    tubes: list[Tube] = []
    open_ends = [(shape.root, (0.0, 0.0, 1.0), shape.length, shape.radius, 1)]
    while open_ends:
        begin, direction, length, radius, level = open_ends.pop(0)
        end = _along(begin, direction, length)
        tubes.append(Tube(begin, end, radius, 0.9 * radius))
        inside = all(0 <= place <= n - 1 for place, n in zip(end, shape.dims))
        if level == shape.levels or not inside:
            continue
        share = random.between(0.35, 0.65)
        turn = random.between(0, 2 * math.pi)
        for part, side in ((share, 0.0), (1 - share, math.pi)):
            thinner = 0.9 * radius * part ** (1 / 3)
            angle = random.between(20, 50) * math.pi / 180
            shorter = min(length, 0.35 * width) * random.between(0.6, 0.9)
            if thinner >= SMALLEST_RADIUS_VOXELS:
                turned = _turned(direction, angle, turn + side)
                open_ends.append((end, turned, shorter, thinner, level + 1))
    return tubes


def _along(begin: Triple, direction: Triple, length: float) -> Triple:
    x, y, z = (place + length * part for place, part in zip(begin, direction))
    return x, y, z


def _turned(direction: Triple, angle: float, turn: float) -> Triple:
    """Return the direction tilted by an angle, towards a side that `turn` chooses."""
    x, y, z = direction
    other = (1.0, 0.0, 0.0) if abs(x) < 0.5 else (0.0, 1.0, 0.0)
    first = _unit(_cross(direction, other))
    second = _cross(direction, first)
    ahead, right, up = (
        math.cos(angle),
        math.sin(angle) * math.cos(turn),
        math.sin(angle) * math.sin(turn),
    )
    parts = [
        ahead * d + right * a + up * b for d, a, b in zip((x, y, z), first, second)
    ]
    return _unit((parts[0], parts[1], parts[2]))


def _cross(a: Triple, b: Triple) -> Triple:
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def _unit(a: Triple) -> Triple:
    length = math.sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])
    return a[0] / length, a[1] / length, a[2] / length


def tree_slice(tubes: list[Tube], dims: tuple[int, int, int], z: int) -> np.ndarray:
    """Return how much of each voxel [y, x] of a slice is vessel, from 0 to 1."""
    covered = np.zeros((dims[1], dims[0]))
    for tube in tubes:
        low, high = tube.reach(2)
        if not low <= z <= high:
            continue
        columns, rows = (_indices(tube.reach(axis), dims[axis]) for axis in (0, 1))
        if columns.size and rows.size:
            part = covered[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
            depth = _depth(tube, columns[None, :], rows[:, None], z)
            np.maximum(part, soft_step(depth, WALL_VOXELS), out=part)
    return covered


def _indices(reach: tuple[float, float], count: int) -> np.ndarray:
    return np.arange(
        max(math.ceil(reach[0]), 0), min(math.floor(reach[1]), count - 1) + 1
    )


def _depth(tube: Tube, x: np.ndarray, y: np.ndarray, z: int) -> np.ndarray:
    """Return how far voxels lie below the surface of a tube; negative outside."""
    along = [b - a for a, b in zip(tube.begin, tube.end)]
    squared = along[0] * along[0] + along[1] * along[1] + along[2] * along[2]
    dx, dy, dz = x - tube.begin[0], y - tube.begin[1], z - tube.begin[2]
    share = np.clip((dx * along[0] + dy * along[1] + dz * along[2]) / squared, 0, 1)
    px, py, pz = (d - share * part for d, part in zip((dx, dy, dz), along))
    radius = tube.begin_radius + (tube.end_radius - tube.begin_radius) * share
    return radius - np.sqrt(px * px + py * py + pz * pz)


@dataclass(frozen=True)
class Vessels(GeneratedVolume):
    """A body with a spine and a tree of filled vessels, as an angiography by CT shows them.

    Values: air 0, tissue 0.25 with noise of 0.02, vessels 0.55, spongy bone 0.7 within compact bone
    of 0.95. An aneurysm, a ball of 2.2 radii, sits at the first fork.
    """

    NAME: ClassVar[str] = "vessels"

    dims: tuple[int, int, int] = (128, 128, 256)
    scalar_type: str = "uint16"
    seed: int = 1

    TISSUE = 0.25
    NOISE = 0.02
    VESSEL = 0.55
    SPONGY_BONE = 0.7
    COMPACT_BONE = 0.95

    def tubes(self) -> list[Tube]:
        """Return the tree, with the aneurysm as its last tube."""
        nx, ny, nz = self.dims
        radius = 0.035 * min(nx, ny)
        root = ((nx - 1) / 2, 0.45 * (ny - 1), 0.0)
        shape = TreeShape(self.dims, root, 0.3 * (nz - 1), radius)
        tubes = grow_tree(shape, self.seed)
        fork = tubes[0].end
        ball_end = (fork[0], fork[1], fork[2] + 1)
        return [*tubes, Tube(fork, ball_end, 2.2 * radius, 2.2 * radius)]

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        nx, ny, nz = self.dims
        tubes = self.tubes()
        x, y = np.arange(nx)[None, :], np.arange(ny)[:, None]
        body = self._body(x, y)
        spine = self._spine_distance(x, y)
        index = (y * nx + x).astype(np.uint64)
        for z in range(nz):
            noise = upper_half(random_bits(self.seed, index + np.uint64(z * nx * ny)))
            value = body * (self.TISSUE + self.NOISE * (2 * noise - 1))
            covered = body * tree_slice(tubes, self.dims, z)
            value += covered * (self.VESSEL - value)
            yield self._with_bone(value, spine, z)

    def _body(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return an ellipse of 0.92 by 0.8 of the box."""
        nx, ny, _ = self.dims
        u = (x - (nx - 1) / 2) / (0.46 * nx)
        v = (y - (ny - 1) / 2) / (0.40 * ny)
        return soft_step((1 - np.sqrt(u * u + v * v)) * 0.4 * min(nx, ny), 2)

    def _spine_distance(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        nx, ny, _ = self.dims
        dx, dy = x - (nx - 1) / 2, y - 0.7 * (ny - 1)
        return np.sqrt(dx * dx + dy * dy)

    def _with_bone(self, value: np.ndarray, distance: np.ndarray, z: int) -> np.ndarray:
        """Lay vertebrae over the values: the spine is thicker and thinner by turns."""
        size = min(self.dims[0], self.dims[1])
        radius = size * (0.075 + 0.02 * math.cos(2 * math.pi * z / (0.16 * size)))
        value = value + soft_step(radius - distance, 2) * (self.COMPACT_BONE - value)
        core = soft_step(radius - 0.02 * size - distance, 2)
        return value + core * (self.SPONGY_BONE - value)
