"""A flower: thin curved petals in a mostly empty box."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .generated_volume import GeneratedVolume, RandomNumbers, centred, soft_step


@dataclass(frozen=True)
class Whorl:
    """Petals of one ring: the radius of their tips, their turn and how steeply they rise."""

    radius: float
    turn: float
    rise: float
    value: float


@dataclass(frozen=True)
class Flower(GeneratedVolume):
    """Five whorls of five petals about an ovary on a stem, as a scanner shows a dried flower.

    The box is [-1, 1]^3 along its shortest edge. A petal is a sheet z = -0.35 + rise (r / R)^2 within
    r < R (0.7 + 0.3 |cos(2.5 (angle - turn))|), of thickness 0.015 or 1.5 voxels, whichever is more:
    its value times exp(-(distance along z / thickness)^2), nothing beyond 4 thicknesses, darker along
    60 veins.
    """

    NAME: ClassVar[str] = "flower"

    dims: tuple[int, int, int] = (128, 128, 128)
    scalar_type: str = "uint8"
    seed: int = 1

    BOTTOM = -0.35
    GOLDEN_ANGLE = 2.399963229728653
    REACH = 4

    def whorls(self) -> list[Whorl]:
        """Return the rings from the inmost to the outmost; the inner ones stand upright."""
        random = RandomNumbers(self.seed)
        return [
            Whorl(
                0.35 + 0.14 * ring,
                self.GOLDEN_ANGLE * ring + random.between(-0.2, 0.2),
                1.05 - 0.17 * ring + random.between(-0.05, 0.05),
                0.85 - 0.1 * ring,
            )
            for ring in range(5)
        ]

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        half = (min(self.dims) - 1) / 2
        x, y, heights = (centred(count) / half for count in self.dims)
        radius = np.sqrt(x[None, :] ** 2 + y[:, None] ** 2)
        angle = np.arctan2(y[:, None], x[None, :])
        thickness = max(0.015, 1.5 / half)
        petals = [_petals(whorl, radius, angle) for whorl in self.whorls()]
        for z in heights:
            value = np.maximum(
                self._ovary(radius, z, half), self._stem(radius, z, half)
            )
            for values, rise in petals:
                above = z - self.BOTTOM - rise
                near = np.abs(above) < self.REACH * thickness
                across = above[near] / thickness
                petal = values[near] * np.exp(-across * across)
                value[near] = np.maximum(value[near], petal)
            yield value

    def _ovary(self, radius: np.ndarray, z: float, half: float) -> np.ndarray:
        distance = np.sqrt(radius * radius + (z - self.BOTTOM) ** 2)
        return 0.95 * soft_step((0.12 - distance) * half, 2)

    def _stem(self, radius: np.ndarray, z: float, half: float) -> np.ndarray:
        depth = np.minimum(0.035 - radius, self.BOTTOM - z)
        return 0.65 * soft_step(depth * half, 2)


def _petals(
    whorl: Whorl, radius: np.ndarray, angle: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the values [y, x] in the middle of a ring of petals and how high they rise there."""
    outline = 0.7 + 0.3 * np.abs(np.cos(2.5 * (angle - whorl.turn)))
    within = soft_step(whorl.radius * outline - radius, 0.03)
    veins = 1 - 0.15 * np.abs(np.cos(30 * angle))
    share = radius / whorl.radius
    return whorl.value * veins * within, whorl.rise * (share * share)
