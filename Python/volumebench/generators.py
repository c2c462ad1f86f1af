"""Volumes from equations, computed slice by slice so that any size fits in memory, and their files."""

import math
import os
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from .errors import BenchError
from .flower import Flower
from .generated_volume import GeneratedVolume, byte_count, centred
from .json_file import write_atomically
from .speckle import Speckle
from .vessels import Vessels

META_TYPES = {"uint8": "MET_UCHAR", "uint16": "MET_USHORT", "float32": "MET_FLOAT"}


@dataclass(frozen=True)
class Lemniscate(GeneratedVolume):
    """Nested Cassini ovals of revolution about z, with Bernoulli's lemniscate among them.

    With d1 and d2 the distances to two foci on the z axis and c half their distance apart,
    t = sqrt(d1 d2) / c is 0 at the foci and 1 on the lemniscate. The value 1 / (1 + t^2) falls
    off smoothly outwards, so each level is one closed shell: two drops, a figure eight, a
    peanut. It is scaled to 0 at the corners of the box and 1 at the foci.
    """

    NAME: ClassVar[str] = "lemniscate"

    dims: tuple[int, int, int] = (96, 96, 200)
    scalar_type: str = "uint16"
    extent: float = 1.7

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        axes = self._axes()
        radius_squared = axes[0][None, :] ** 2 + axes[1][:, None] ** 2
        corner = self._field(axes[0][0] ** 2 + axes[1][0] ** 2, axes[2][0])
        for z in axes[2]:
            yield (self._field(radius_squared, z) - corner) / (1 - corner)

    def _axes(self) -> list[np.ndarray]:
        """Return sample positions in focal distances; z spans [-extent, extent]."""
        spacing = 2 * self.extent / (self.dims[2] - 1)
        return [centred(count) * spacing for count in self.dims]

    @staticmethod
    def _field(radius_squared: np.ndarray, z: float) -> np.ndarray:
        product = np.sqrt(
            (radius_squared + (z - 1) ** 2) * (radius_squared + (z + 1) ** 2)
        )
        return 1 / (1 + product)


@dataclass(frozen=True)
class Ball(GeneratedVolume):
    """A hollow ball with a smooth wall, alone in a box that it nearly fills.

    With r the distance from the centre, 1 at the nearest faces, the value is
    exp(-((r - 0.62) / 0.16)^2), less what it is at the faces: all nought from there outwards.
    """

    NAME: ClassVar[str] = "ball"

    dims: tuple[int, int, int] = (32, 32, 32)
    scalar_type: str = "uint8"

    RADIUS = 0.62
    WALL = 0.16

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        half = (min(self.dims) - 1) / 2
        x, y, z = (centred(count) / half for count in self.dims)
        radius_squared = x[None, :] ** 2 + y[:, None] ** 2
        edge = self._field(np.float64(1.0))
        for height in z:
            value = self._field(np.sqrt(radius_squared + height**2))
            yield (value - edge) / (1 - edge)

    def _field(self, radius: np.ndarray) -> np.ndarray:
        return np.exp(-(((radius - self.RADIUS) / self.WALL) ** 2))


@dataclass(frozen=True)
class Waves(GeneratedVolume):
    """A smooth field that fills its box: the sum of one sine along each axis.

    With x, y and z from 0 to 1 over the box, the value is
    (3 + sin(4 pi x + 0.5) + sin(3 pi y + 1.7) + sin(5 pi z + 2.9)) / 6.
    """

    NAME: ClassVar[str] = "waves"

    dims: tuple[int, int, int] = (128, 128, 128)
    scalar_type: str = "uint16"

    HALF_WAVES = (4, 3, 5)
    PHASES = (0.5, 1.7, 2.9)

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        x, y, z = (
            np.sin(half_waves * math.pi * np.linspace(0, 1, count) + phase)
            for half_waves, phase, count in zip(self.HALF_WAVES, self.PHASES, self.dims)
        )
        for height in z:
            value = (3 + x[None, :] + y[:, None] + height) / 6
            yield value


@dataclass(frozen=True)
class Shell(GeneratedVolume):
    """A spherical shell that fills a share of its box, or a solid ball where that is half or more.

    Five times the share of the box, at most half, lies within its outer radius; of a solid ball,
    the share does, so that at a share of 1 its surface passes through the corners. With r the
    distance from the centre, m the middle of the wall (0 of a ball) and h half its thickness, the
    value is 1 - ((r - m) / h)^2 in the wall and 0 elsewhere.
    """

    NAME: ClassVar[str] = "shell"

    dims: tuple[int, int, int] = (128, 128, 128)
    scalar_type: str = "uint8"
    share: float = 0.1

    OUTER_SHARES = 5  # thinner walls would fall between the voxels
    SOLID_SHARE = 0.5

    def radii(self) -> tuple[float, float]:
        """Return inner and outer radius in half edges of the box; a ball has no inner one."""
        if self.share >= self.SOLID_SHARE:
            return 0.0, radius_around(self.share)
        outer = min(self.OUTER_SHARES * self.share, self.SOLID_SHARE)
        return radius_around(outer - self.share), radius_around(outer)

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        inner, outer = self.radii()
        middle, half = ((inner + outer) / 2, (outer - inner) / 2)
        if inner == 0:
            middle, half = 0.0, outer
        x, y, z = (np.linspace(-1, 1, count) for count in self.dims)
        plane = x[None, :] ** 2 + y[:, None] ** 2
        for height in z:
            across = (np.sqrt(plane + height**2) - middle) / half
            yield 1 - across**2


def share_within(radius: float) -> float:
    """Return the share of the cube [-1, 1]^3 that lies within a distance from its centre.

    Up to 1 a ball; up to sqrt(2) a ball without six caps; beyond that the caps overlap, and the
    part of each cube that is left is integrated over its height.
    """
    if radius <= 1:
        return math.pi * radius**3 / 6
    if radius <= math.sqrt(2):
        cap = math.pi * (radius - 1) ** 2 * (2 * radius + 1) / 3
        return (4 * math.pi * radius**3 / 3 - 6 * cap) / 8
    if radius >= math.sqrt(3):
        return 1.0
    height = (np.arange(4096) + 0.5) / 4096
    disc = np.sqrt(radius**2 - height**2)  # its radius at that height, at least 1
    edge = np.sqrt(np.maximum(disc**2 - 1, 0))  # where it leaves the square
    angle = np.pi / 2 - 2 * np.arccos(np.minimum(1 / disc, 1))
    area = np.where(edge >= 1, 1.0, edge + disc**2 * angle / 2)
    return float(np.mean(area))


def radius_around(share: float) -> float:
    """Return the radius within which that share of the cube [-1, 1]^3 lies, by bisection."""
    low, high = 0.0, math.sqrt(3)
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if share_within(middle) < share else (low, middle)
    return (low + high) / 2


@dataclass(frozen=True)
class MarschnerLobb(GeneratedVolume):
    """The test signal of Marschner and Lobb (1994) over [-1, 1]^3.

    (1 - sin(pi z / 2) + 0.25 (1 + cos(12 pi cos(pi r / 2)))) / 2.5, with r the distance from the z
    axis: at 41 samples along each axis close to what can be sampled at all.
    """

    NAME: ClassVar[str] = "marschner-lobb"

    dims: tuple[int, int, int] = (41, 41, 41)
    scalar_type: str = "uint8"

    FREQUENCY = 6
    DEPTH = 0.25

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z."""
        x, y, z = (np.linspace(-1, 1, count) for count in self.dims)
        radius = np.sqrt(x[None, :] ** 2 + y[:, None] ** 2)
        phase = 2 * math.pi * self.FREQUENCY * np.cos(math.pi * radius / 2)
        rings = self.DEPTH * (1 + np.cos(phase))
        for height in z:
            slope = 1 - np.sin(math.pi * height / 2)
            yield (slope + rings) / (2 * (1 + self.DEPTH))


GENERATORS: dict[str, type[GeneratedVolume]] = {
    kind.NAME: kind
    for kind in (
        Lemniscate,
        Ball,
        Waves,
        Shell,
        MarschnerLobb,
        Speckle,
        Vessels,
        Flower,
    )
}


def write_volume(generator: GeneratedVolume, folder: Path) -> Path:
    """Write a volume under the name of its parameters, unless it is there; return the header."""
    return write_volume_as(generator, folder / f"{generator.file_stem()}.mhd")


def write_volume_as(generator: GeneratedVolume, header: Path) -> Path:
    """Write NAME.raw and NAME.mhd unless both are there; the header comes last."""
    raw = header.with_suffix(".raw")
    if (
        header.is_file()
        and raw.is_file()
        and raw.stat().st_size == byte_count(generator)
    ):
        return header
    _write_raw(generator, raw)
    lines = [
        "ObjectType = Image",
        "NDims = 3",
        "BinaryData = True",
        "BinaryDataByteOrderMSB = False",
        "DimSize = " + " ".join(str(count) for count in generator.dims),
        "ElementSpacing = " + " ".join(f"{item:g}" for item in generator.spacing),
        f"ElementType = {META_TYPES[generator.scalar_type]}",
        f"ElementDataFile = {raw.name}",
    ]
    write_atomically(header, "\n".join(lines) + "\n")
    return header


def _write_raw(generator: GeneratedVolume, raw: Path) -> None:
    temporary = None
    try:
        raw.parent.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=raw.parent, prefix=f".{raw.name}.")
        temporary = Path(name)
        with os.fdopen(handle, "wb") as stream:
            for layer in generator.slices():
                stream.write(layer.tobytes())
        temporary.chmod(0o644)
        temporary.replace(raw)
    except OSError as fault:
        raise BenchError(f"{raw}: cannot be written: {fault.strerror}") from None
    finally:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
