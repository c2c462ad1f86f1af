"""How many samples a picture takes, from a picture of counts."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class SampleCount:
    """Of one picture or, as means, of several; a peer tells neither of the last two."""

    taken: float
    skipped: float | None = None
    rays_terminated: float | None = None


def sample_count(picture: np.ndarray, peer: bool) -> SampleCount | None:
    """Return the sums over a picture of counts; None if it holds anything but counts."""
    counts = picture[..., :3].astype(np.float64)
    if peer:
        counts = counts[..., :1]
    if not (np.isfinite(counts).all() and (counts == np.floor(counts)).all()):
        return None
    sums = counts.sum(axis=(0, 1))
    return SampleCount(*map(float, sums)) if sums[:2].any() else None


def mean_count(counts: list[SampleCount]) -> SampleCount:
    """Return the means; None stands for what one of them does not tell."""

    def mean(name: str) -> float | None:
        values = [getattr(count, name) for count in counts]
        return None if None in values else sum(values) / len(values)

    return SampleCount(mean("taken"), mean("skipped"), mean("rays_terminated"))
