"""How sure a ratio of frame times is: percentile bootstrap (Efron and Tibshirani, An Introduction to
the Bootstrap, 1993, chapter 13).

Views of one path differ more than repeats of one view. Where two runs share frames of the path, the
ratio is therefore the median over these frames of the ratio of their median times, and the frames are
drawn; of a path with few frames, the repeats of each. Runs that share too few have the ratio of their
medians, each resampled on its own.
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
# The range of so many values holds their median with 97 %; of fewer, with less than 95 %.
LEAST_FRAMES = 6
LEAST_QUARTILE_FRAMES = 3


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
    """A ratio of times with resampled ones; `basis` says what they were drawn from."""

    value: float
    drawn: np.ndarray | None
    basis: str

    def interval(self, level: float = LEVEL) -> Ratio:
        """Return the ratio with the interval that holds it with this probability."""
        return _interval(self.value, self.drawn, level)


def ratio_sample(over: Record, under: Record) -> RatioSample:
    """Return the ratio of two rows' frame times; both must have been measured."""
    value = over.frame_ms.median / under.frame_ms.median
    random = np.random.default_rng(SEED)
    if over.frame_log is None or under.frame_log is None:
        return RatioSample(value, _from_quartiles(over, under, random), QUARTILES)
    times = _by_frame(over.frame_log), _by_frame(under.frame_log)
    shared = sorted(set(times[0]) & set(times[1]))
    pairs = [(np.array(times[0][frame]), np.array(times[1][frame])) for frame in shared]
    if len(shared) >= LEAST_FRAMES:
        return _over_frames(pairs, random)
    if shared and min(len(item) for pair in pairs for item in pair) >= LEAST_FRAMES:
        return _within_frames(pairs, random)
    logs = np.array(over.frame_log.ms), np.array(under.frame_log.ms)
    if shared or min(map(len, logs)) < LEAST_FRAMES:
        return RatioSample(value, None, FRAMES)
    drawn = _medians(logs[0], random) / _medians(logs[1], random)
    return RatioSample(value, drawn, FRAMES)


def _by_frame(log: FrameLog) -> dict[int, list[float]]:
    times: dict[int, list[float]] = {}
    for frame, ms in zip(log.frame, log.ms):
        times.setdefault(frame, []).append(ms)
    return times


def _over_frames(
    pairs: list[tuple[np.ndarray, np.ndarray]], random: np.random.Generator
) -> RatioSample:
    """Draw frames of the path."""
    ratios = np.array([np.median(over) / np.median(under) for over, under in pairs])
    return RatioSample(float(np.median(ratios)), _medians(ratios, random), FRAMES)


def _within_frames(
    pairs: list[tuple[np.ndarray, np.ndarray]], random: np.random.Generator
) -> RatioSample:
    """Draw repeats of each frame of a path that has few."""
    ratios = [np.median(over) / np.median(under) for over, under in pairs]
    drawn = [_medians(over, random) / _medians(under, random) for over, under in pairs]
    return RatioSample(float(np.median(ratios)), np.median(drawn, axis=0), FRAMES)


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


def _from_quartiles(
    over: Record, under: Record, random: np.random.Generator
) -> np.ndarray | None:
    """Draw medians about those of rows that kept no frames: 1.57 quartile ranges over the square
    root of the frames are 1.96 standard errors (McGill, Tukey and Larsen 1978)."""
    drawn = []
    for row in (over, under):
        spread = row.frame_ms
        if not row.frames or row.frames < LEAST_QUARTILE_FRAMES or spread.q1 is None:
            return None
        error = 1.57 / 1.96 * (spread.q3 - spread.q1) / np.sqrt(row.frames)
        share = error / spread.median
        drawn.append(spread.median * np.exp(share * random.standard_normal(RESAMPLES)))
    return drawn[0] / drawn[1]
