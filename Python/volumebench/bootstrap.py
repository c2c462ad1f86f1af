"""How sure a ratio of frame times is: percentile bootstrap of the ratio of two medians.

Efron and Tibshirani, An Introduction to the Bootstrap, 1993, chapter 13. Where both runs showed the
same frames of the camera path, the frames are drawn, and both runs take those that were drawn: what
differs from view to view then differs in both. Otherwise each run is resampled on its own.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .results import FrameLog, Record

RESAMPLES = 2000
SEED = 20260101
LEVEL = 0.95
FRAMES = "frames"
QUARTILES = "quartiles"
LEAST_FRAMES = 3


@dataclass(frozen=True)
class Ratio:
    """A ratio with its interval, which is None where nothing is known of the noise."""

    value: float
    low: float | None = None
    high: float | None = None

    def excludes(self, value: float) -> bool:
        """Tell whether the ratio differs from a value beyond noise."""
        return self.low is not None and not self.low <= value <= self.high


@dataclass(frozen=True)
class RatioSample:
    """The ratio of two medians with resampled ones; `basis` says what they were drawn from."""

    value: float
    drawn: np.ndarray | None
    basis: str

    def interval(self, level: float = LEVEL) -> Ratio:
        """Return the ratio with the interval that holds it with this probability."""
        return _interval(self.value, self.drawn, level)


def ratio_sample(over: Record, under: Record) -> RatioSample:
    """Return the ratio of two rows' median frame times; both must have been measured."""
    value = over.frame_ms.median / under.frame_ms.median
    logs = over.frame_log, under.frame_log
    random = np.random.default_rng(SEED)
    if None in logs:
        return RatioSample(value, _from_quartiles(over, under, random), QUARTILES)
    if min(len(set(log.frame)) for log in logs) < LEAST_FRAMES:
        return RatioSample(value, None, FRAMES)
    if set(logs[0].frame) == set(logs[1].frame):
        return RatioSample(value, _paired(*logs, random), FRAMES)
    drawn = [_medians(np.array(log.ms), random) for log in logs]
    return RatioSample(value, drawn[0] / drawn[1], FRAMES)


def geometric_mean(samples: Sequence[RatioSample], level: float = LEVEL) -> Ratio:
    """Return the geometric mean of ratios, with the interval that all their noise leaves."""
    return mean_sample(samples).interval(level)


def mean_sample(samples: Sequence[RatioSample]) -> RatioSample:
    """Return the geometric mean of ratios; drawn where every ratio has draws."""
    value = float(np.exp(np.mean([np.log(sample.value) for sample in samples])))
    if any(sample.drawn is None for sample in samples):
        return RatioSample(value, None, FRAMES)
    # Ratios may share a run, and were all drawn with one seed: their draws are put in other orders.
    random = np.random.default_rng(SEED)
    logs = [np.log(random.permutation(sample.drawn)) for sample in samples]
    return RatioSample(value, np.exp(np.mean(logs, axis=0)), FRAMES)


def _interval(value: float, drawn: np.ndarray | None, level: float) -> Ratio:
    if drawn is None:
        return Ratio(value)
    tail = (1 - level) / 2
    low, high = np.quantile(drawn, [tail, 1 - tail])
    return Ratio(value, float(min(low, value)), float(max(high, value)))


def _medians(values: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Return the medians of resampled values."""
    picks = random.integers(0, len(values), (RESAMPLES, len(values)))
    return np.median(values[picks], axis=1)


def _paired(a: FrameLog, b: FrameLog, random: np.random.Generator) -> np.ndarray:
    """Draw frames of the path, and of each one time of either run for each that it took of it."""
    frames = sorted(set(a.frame))
    picks = random.integers(0, len(frames), (RESAMPLES, len(frames)))
    medians = [_drawn_times(log, frames, picks, random) for log in (a, b)]
    return medians[0] / medians[1]


def _drawn_times(
    log: FrameLog, frames: list[int], picks: np.ndarray, random: np.random.Generator
) -> np.ndarray:
    times: list[list[float]] = [[] for _ in frames]
    places = {frame: place for place, frame in enumerate(frames)}
    for frame, ms in zip(log.frame, log.ms):
        times[places[frame]].append(ms)
    longest = max(map(len, times))
    # One table of drawn times: a frame with fewer of them has its draws from fewer.
    table = np.array([(item * longest)[:longest] for item in times])
    counts = np.array([len(item) for item in times])
    drawn = (random.random((*picks.shape, longest)) * counts[picks][..., None]).astype(
        int
    )
    return np.median(table[picks[..., None], drawn].reshape(len(picks), -1), axis=1)


def _from_quartiles(
    over: Record, under: Record, random: np.random.Generator
) -> np.ndarray | None:
    """Draw medians about those of rows that kept no frames: 1.57 quartile ranges over the square
    root of the frames are 1.96 standard errors (McGill, Tukey and Larsen 1978)."""
    drawn = []
    for row in (over, under):
        spread = row.frame_ms
        if not row.frames or row.frames < LEAST_FRAMES or spread.q1 is None:
            return None
        error = 1.57 / 1.96 * (spread.q3 - spread.q1) / np.sqrt(row.frames)
        share = error / spread.median
        drawn.append(spread.median * np.exp(share * random.standard_normal(RESAMPLES)))
    return drawn[0] / drawn[1]
