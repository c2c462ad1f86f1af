"""Order statistics of frame times."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Spread:
    """Median, quartiles and extremes; None stands for not measured."""

    median: float | None = None
    q1: float | None = None
    q3: float | None = None
    min: float | None = None
    max: float | None = None


def quantile(values: list[float], fraction: float) -> float:
    """Return the quantile by linear interpolation between order statistics."""
    ordered = sorted(values)
    position = (len(ordered) - 1) * fraction
    lower = math.floor(position)
    upper = min(lower + 1, len(ordered) - 1)
    return ordered[lower] + (ordered[upper] - ordered[lower]) * (position - lower)


def spread(values: list[float]) -> Spread:
    """Return the spread of the values; of no value, an empty one."""
    if not values:
        return Spread()
    return Spread(
        quantile(values, 0.5),
        quantile(values, 0.25),
        quantile(values, 0.75),
        min(values),
        max(values),
    )


def relative_noise_of_mean(values: list[float]) -> float:
    """Return the standard error of the mean over the mean; infinite below two values."""
    count = len(values)
    if count < 2:
        return math.inf
    mean = math.fsum(values) / count
    if mean <= 0:
        return math.inf
    variance = math.fsum((value - mean) ** 2 for value in values) / (count - 1)
    return math.sqrt(variance / count) / mean
