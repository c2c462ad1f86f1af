"""Growth as a power of a factor: a straight line through log-log points, with its uncertainty."""

import math
from dataclasses import dataclass

# Student's t for two-sided 95 %, at 1, 2, ... degrees of freedom; the last stands for all beyond.
_STUDENT_T = (
    *(12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228),
    *(2.201, 2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086),
)


@dataclass(frozen=True)
class PowerLaw:
    """y = factor * x^exponent; the half width of the exponent's 95 % interval is None of two points."""

    exponent: float
    factor: float
    half_width: float | None
    points: int

    def at(self, x: float) -> float:
        """Return the fitted value."""
        return self.factor * x**self.exponent


def power_law(points: list[tuple[float, float]]) -> PowerLaw | None:
    """Return the least-squares line through the logarithms of (x, y), all above 0.

    None where all x are equal, as of a single point.
    """
    if len({x for x, _ in points}) < 2:
        return None
    x = [math.log(point[0]) for point in points]
    y = [math.log(point[1]) for point in points]
    count = len(points)
    mean_x, mean_y = math.fsum(x) / count, math.fsum(y) / count
    spread = math.fsum((a - mean_x) ** 2 for a in x)
    exponent = math.fsum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / spread
    offset = mean_y - exponent * mean_x
    half_width = None
    if count > 2:
        squares = math.fsum((b - offset - exponent * a) ** 2 for a, b in zip(x, y))
        quantile = _STUDENT_T[min(count - 2, len(_STUDENT_T)) - 1]
        half_width = quantile * math.sqrt(squares / (count - 2) / spread)
    return PowerLaw(exponent, math.exp(offset), half_width, count)
