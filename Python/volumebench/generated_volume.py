"""What generators share: the base class, quantised values and random numbers by counting."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, fields
from typing import ClassVar

import numpy as np

Triple = tuple[float, float, float]
_NOT_IN_STEM = ("dims", "scalar_type", "spacing")


@dataclass(frozen=True)
class GeneratedVolume:
    """A volume that is computed from its parameters, slice by slice.

    `dims` are voxels along x, y and z, `spacing` their distances in units of the world.
    """

    NAME: ClassVar[str]

    dims: tuple[int, int, int]
    scalar_type: str
    spacing: Triple = field(default=(1.0, 1.0, 1.0), kw_only=True)

    @classmethod
    def parameters(cls) -> tuple[str, ...]:
        """Return what a study may give: dims, scalar_type, spacing and what is the kind's own."""
        return tuple(item.name for item in fields(cls))

    def slices(self) -> Iterator[np.ndarray]:
        """Yield the slices along z, each [y, x], in the scalar type of the volume."""
        for values in self.fields():
            yield quantised(values, self.scalar_type)

    def fields(self) -> Iterator[np.ndarray]:
        """Yield the slices along z, each [y, x], as numbers that are cut to [0, 1]."""
        raise NotImplementedError

    def file_stem(self) -> str:
        """Return a name that holds every parameter, so that a stored volume can be reused."""
        parts = [self.NAME, _times(self.dims), self.scalar_type]
        for name in self.parameters():
            if name not in _NOT_IN_STEM:
                value = getattr(self, name)
                text = str(value) if isinstance(value, int) else f"{value:g}"
                parts.append(f"{name}{text}")
        if self.spacing != (1, 1, 1):
            parts.append(f"spacing{_times(self.spacing)}")
        return "-".join(parts)


def _times(numbers: tuple[float, ...]) -> str:
    return "x".join(f"{number:g}" for number in numbers)


def quantised(value: np.ndarray, scalar_type: str) -> np.ndarray:
    """Return values, cut to [0, 1], over the whole range of a scalar type."""
    value = np.clip(value, 0, 1)
    if scalar_type == "float32":
        return value.astype("<f4")
    stored = np.dtype(scalar_type).newbyteorder("<")
    return np.rint(value * np.iinfo(stored).max).astype(stored)


def centred(count: int) -> np.ndarray:
    """Return the places of so many samples, in samples from the middle."""
    return np.arange(count) - (count - 1) / 2


def random_bits(seed: int, index: np.ndarray) -> np.ndarray:
    """Return 64 random bits for each index (uint64): SplitMix64 (Steele, Lea, Flood 2014).

    The bits of an index are the same on every machine and whatever is asked before.
    """
    start = _mixed(np.array([seed], np.uint64))
    return _mixed(start + index)


def _mixed(bits: np.ndarray) -> np.ndarray:
    bits = bits + np.uint64(0x9E3779B97F4A7C15)
    bits ^= bits >> np.uint64(30)
    bits *= np.uint64(0xBF58476D1CE4E5B9)
    bits ^= bits >> np.uint64(27)
    bits *= np.uint64(0x94D049BB133111EB)
    bits ^= bits >> np.uint64(31)
    return bits


def upper_half(bits: np.ndarray) -> np.ndarray:
    """Return the upper 32 of 64 bits as a number from 0 to 1, below 1."""
    return (bits >> np.uint64(32)) / 2.0**32


def lower_half(bits: np.ndarray) -> np.ndarray:
    """Return the lower 32 of 64 bits as a number from 0 to 1, below 1."""
    return (bits & np.uint64(0xFFFFFFFF)) / 2.0**32


class RandomNumbers:
    """A sequence of random numbers from 0 to 1, below 1."""

    def __init__(self, seed: int) -> None:
        self._seed = seed
        self._count = 0

    def next(self) -> float:
        """Return the next number."""
        bits = random_bits(self._seed, np.array([self._count], np.uint64))
        self._count += 1
        return float(upper_half(bits)[0])

    def between(self, low: float, high: float) -> float:
        """Return the next number, spread over a range."""
        return low + (high - low) * self.next()


def soft_step(depth: np.ndarray, width: float) -> np.ndarray:
    """Return 0 outside and 1 inside of a surface, linear over a width about it."""
    return np.clip(depth / width + 0.5, 0, 1)


def byte_count(volume: GeneratedVolume) -> int:
    """Return what the voxels take in a file."""
    return math.prod(volume.dims) * np.dtype(volume.scalar_type).itemsize
