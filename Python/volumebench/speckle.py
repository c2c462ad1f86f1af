"""Ultrasound: fully developed speckle with dark vessels."""

import math
from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from .generated_volume import GeneratedVolume, Triple
from .generated_volume import lower_half, random_bits, upper_half
from .vessels import TreeShape, Tube, grow_tree, tree_slice


@dataclass(frozen=True)
class Speckle(GeneratedVolume):
    """What a scanner shows of tissue with many scatterers in each cell of its resolution.

    Each voxel scatters a random real and imaginary part, uniform in [-1, 1); the pulse spreads them
    over 5 x 5 x 5 voxels with binomial weights. The length of the sum is nearly Rayleigh distributed
    (Goodman 1975). In vessels, a tree, it is 34 dB lower. Lengths are shown as
    1 + 20 log10(length / 10 sigma) / 50, that is over 50 dB.
    """

    NAME: ClassVar[str] = "speckle"

    dims: tuple[int, int, int] = (512, 378, 222)
    scalar_type: str = "uint8"
    seed: int = 1
    spacing: Triple = field(default=(0.42, 0.39, 0.63), kw_only=True)

    WEIGHTS = (1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16)
    # Of each part: 1/3 for the uniform number, times the sums of squared weights of three axes.
    SIGMA = math.sqrt((70 / 256) ** 3 / 3)
    FULL_SCALE = 10.0
    RANGE_DB = 50.0
    VESSEL_DB = -34.0

    def tubes(self) -> list[Tube]:
        """Return the vessels; they enter in the middle of the first slice."""
        nx, ny, nz = self.dims
        root = (0.5 * (nx - 1), 0.5 * (ny - 1), 0.0)
        radius = 0.045 * min(nx, ny)
        return grow_tree(
            TreeShape(self.dims, root, 0.35 * (nz - 1), radius, 6), self.seed
        )

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        tubes = self.tubes()
        planes: deque[tuple[np.ndarray, np.ndarray]] = deque(maxlen=5)
        for z in range(-4, self.dims[2]):
            planes.append(self._scatterers(z + 2))
            if z >= 0:
                parts = (self._spread([plane[i] for plane in planes]) for i in (0, 1))
                real, imaginary = parts
                length = np.sqrt(real * real + imaginary * imaginary)
                yield self._shown(length, tree_slice(tubes, self.dims, z))

    def _scatterers(self, z: int) -> tuple[np.ndarray, np.ndarray]:
        """Return both parts of a plane, [y, x] with two more voxels on each side."""
        nx, ny = self.dims[0] + 4, self.dims[1] + 4
        first = (z + 2) * nx * ny
        index = np.arange(first, first + nx * ny, dtype=np.uint64).reshape(ny, nx)
        bits = random_bits(self.seed, index)
        return 2 * upper_half(bits) - 1, 2 * lower_half(bits) - 1

    def _spread(self, planes: list[np.ndarray]) -> np.ndarray:
        nx, ny = self.dims[0], self.dims[1]
        sums = _weighted(self.WEIGHTS, planes)
        sums = _weighted(self.WEIGHTS, [sums[i : i + ny] for i in range(5)])
        return _weighted(self.WEIGHTS, [sums[:, i : i + nx] for i in range(5)])

    def _shown(self, length: np.ndarray, vessel: np.ndarray) -> np.ndarray:
        with np.errstate(divide="ignore"):  # nothing is 0 after the cut to [0, 1]
            decibels = 20 * np.log10(length / (self.FULL_SCALE * self.SIGMA))
        return 1 + (decibels + self.VESSEL_DB * vessel) / self.RANGE_DB


def _weighted(weights: tuple[float, ...], parts: list[np.ndarray]) -> np.ndarray:
    total = weights[0] * parts[0]
    for weight, part in zip(weights[1:], parts[1:]):
        total = total + weight * part
    return total
