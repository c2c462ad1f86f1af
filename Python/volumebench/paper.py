"""Tests what a paper concluded with the rows that were measured here.

A conclusion is about the ratio of two groups of rows: what the selectors `over` and `under` do not
name must agree in both (settings apart), and of several rows that agree the fastest counts, as papers
quote the best variant of each technique.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from .bootstrap import LEVEL, Ratio, RatioSample, geometric_mean, mean_sample
from .bootstrap import ratio_sample
from .results import OK, Record
from .summary import missing_groups, number

HOLDS, FAILS, UNDECIDED, NOT_RUN = "holds", "does not hold", "undecided", "not run"
_FACTORS = (
    *("dataset", "transfer_function", "technique", "integrator", "step_voxels"),
    *("image_size", "blend_mode", "lighting", "path"),
)


@dataclass(frozen=True)
class Verdict:
    """What became of a conclusion; `measured` is the figure it rests on, in words."""

    text: str
    published: str
    measured: str
    word: str


@dataclass(frozen=True)
class Pair:
    """Two rows that differ in what a conclusion is about."""

    over: Record
    under: Record


def matches(row: Record, select: dict[str, Any]) -> bool:
    """Tell whether a row is picked; a stand-in answers to the name of the volume it stands for."""
    for name, wanted in select.items():
        if name == "settings":
            if any(row.settings.get(key) != value for key, value in wanted.items()):
                return False
        elif name == "dataset":
            if wanted not in (row.dataset, row.stand_in_for):
                return False
        elif name == "image_size":
            if list(row.image_size) != list(wanted):
                return False
        elif name == "step_voxels":
            if row.step_voxels is None or abs(row.step_voxels / wanted - 1) > 1e-6:
                return False
        elif getattr(row, name) != wanted:
            return False
    return True


def merged(*selects: dict[str, Any]) -> dict[str, Any]:
    """Return one selector of several; their settings are joined."""
    result: dict[str, Any] = {}
    for select in selects:
        settings = result.get("settings", {}) | select.get("settings", {})
        result |= select
        if settings:
            result["settings"] = settings
    return result


def fastest(rows: Iterable[Record], select: dict[str, Any]) -> Record | None:
    """Return the fastest measured row that is picked."""
    found = [row for row in measured_rows(rows) if matches(row, select)]
    return min(found, key=lambda row: row.frame_ms.median, default=None)


def measured_rows(rows: Iterable[Record]) -> list[Record]:
    """Return the rows with a frame time."""
    return [row for row in rows if row.status == OK and row.frame_ms.median]


def pairs_of(
    rows: Iterable[Record],
    over: dict[str, Any],
    under: dict[str, Any],
    where: dict[str, Any],
) -> list[Pair]:
    """Return the pairs that differ in what `over` and `under` name."""
    named = set(over) | set(under)

    def groups(select: dict[str, Any]) -> dict[tuple, Record]:
        found: dict[tuple, Record] = {}
        wanted = merged(where, select)
        for row in measured_rows(rows):
            if matches(row, wanted):
                key = tuple(
                    getattr(row, name) for name in _FACTORS if name not in named
                )
                held = found.get(key)
                if held is None or row.frame_ms.median < held.frame_ms.median:
                    found[key] = row
        return found

    upper, lower = groups(over), groups(under)
    return [Pair(upper[key], lower[key]) for key in upper if key in lower]


def verdicts(paper: dict[str, Any], rows: list[Record]) -> list[Verdict]:
    """Return what became of each conclusion of a paper."""
    return [verdict_of(conclusion, rows) for conclusion in paper["conclusions"]]


def verdict_of(conclusion: dict[str, Any], rows: list[Record]) -> Verdict:
    """Return what became of one conclusion."""
    measured, word = _KINDS[conclusion["kind"]](conclusion, rows)
    return Verdict(conclusion["text"], conclusion["published"], measured, word)


def _judge(ratio: Ratio, conclusion: dict[str, Any]) -> str:
    """Compare an interval with the bounds of a conclusion."""
    low = conclusion.get("at_least", -np.inf)
    high = conclusion.get("at_most", np.inf)
    if ratio.low is None:
        return UNDECIDED
    if ratio.low >= low and ratio.high <= high:
        return HOLDS
    return FAILS if ratio.high < low or ratio.low > high else UNDECIDED


def _missing(conclusion: dict[str, Any], rows: list[Record]) -> tuple[str, str]:
    """Say why there is nothing to judge."""
    selects = [
        merged(conclusion.get("where", {}), conclusion[key])
        for key in ("over", "under")
    ]
    lost = [
        row
        for row in rows
        if row.status != OK and any(matches(row, s) for s in selects)
    ]
    reasons = dict.fromkeys(group.reason for group in missing_groups(lost))
    return "; ".join(reasons) or "no such rows in this cut of the study", NOT_RUN


def _pairs(
    conclusion: dict[str, Any], rows: list[Record], more: str = ""
) -> list[Pair]:
    where = merged(conclusion.get("where", {}), conclusion.get(more, {}))
    return pairs_of(rows, conclusion["over"], conclusion["under"], where)


def _ratio(conclusion: dict[str, Any], rows: list[Record]) -> tuple[str, str]:
    """The geometric mean of the ratios of all pairs."""
    pairs = _pairs(conclusion, rows)
    if conclusion.get("measure") == "error":
        return _error_ratio(conclusion, pairs, rows)
    if not pairs:
        return _missing(conclusion, rows)
    samples = [ratio_sample(pair.over, pair.under) for pair in pairs]
    known = _known(samples)
    ratio = geometric_mean(known)
    values = [sample.value for sample in samples]
    text = f"{interval_text(ratio)} times, {pairs_text(known)}"
    if len(pairs) > 1:
        text += f" from {min(values):.2f} to {max(values):.2f}"
    if len(known) < len(samples):
        text += f"; {len(samples) - len(known)} more with too few frames"
    if conclusion.get("each"):
        return text, _judge_each(samples, conclusion)
    return text, _judge(ratio, conclusion)


def _known(samples: list[RatioSample]) -> list[RatioSample]:
    """Return the ratios whose noise is known; all, where that is so of none."""
    return [sample for sample in samples if sample.drawn is not None] or samples


def _judge_each(samples: list[RatioSample], conclusion: dict[str, Any]) -> str:
    """One pair that contradicts is enough; intervals are so wide that all hold together."""
    level = 1 - (1 - LEVEL) / len(samples)
    words = {_judge(sample.interval(level), conclusion) for sample in samples}
    return FAILS if FAILS in words else UNDECIDED if UNDECIDED in words else HOLDS


def _error_ratio(
    conclusion: dict[str, Any], pairs: list[Pair], rows: list[Record]
) -> tuple[str, str]:
    """Errors have no noise but the uncertainty of their references."""
    known = [pair for pair in pairs if pair.over.error.rmse and pair.under.error.rmse]
    if not known:
        return _missing(conclusion, rows)
    bounds = []
    for pair in known:
        over, under = pair.over.error, pair.under.error
        doubts = [item.reference_uncertainty or 0 for item in (over, under)]
        low = max(over.rmse - doubts[0], 1e-12) / (under.rmse + doubts[1])
        high = (over.rmse + doubts[0]) / max(under.rmse - doubts[1], 1e-12)
        bounds.append((low, over.rmse / under.rmse, high))
    low, value, high = np.exp(np.mean(np.log(bounds), axis=0))
    ratio = Ratio(float(value), float(low), float(high))
    return f"{interval_text(ratio)} times the error, {pairs_text(known)}", _judge(
        ratio, conclusion
    )


def _change(conclusion: dict[str, Any], rows: list[Record]) -> tuple[str, str]:
    """The ratio of the rows picked by `to` over that of the rows picked by `from`."""
    found = [_pairs(conclusion, rows, key) for key in ("from", "to")]
    if not all(found):
        return _missing(conclusion, rows)
    before, after = (
        mean_sample(_known([ratio_sample(pair.over, pair.under) for pair in pairs]))
        for pairs in found
    )
    drawn = None
    if before.drawn is not None and after.drawn is not None:
        drawn = np.random.default_rng(1).permutation(after.drawn) / before.drawn
    ratio = RatioSample(after.value / before.value, drawn, "").interval()
    text = f"from {before.value:.2f} to {after.value:.2f}: {interval_text(ratio)} times"
    return text, _judge(ratio, conclusion)


def _difference(conclusion: dict[str, Any], rows: list[Record]) -> tuple[str, str]:
    """The largest difference of a pair, in milliseconds without sign."""
    pairs = _pairs(conclusion, rows)
    if not pairs:
        return _missing(conclusion, rows)
    largest: Ratio | None = None
    for pair in pairs:
        sample = ratio_sample(pair.over, pair.under)
        base = pair.under.frame_ms.median
        drawn = None if sample.drawn is None else np.abs(base * (sample.drawn - 1))
        ratio = RatioSample(abs(base * (sample.value - 1)), drawn, "").interval()
        if largest is None or ratio.value > largest.value:
            largest = ratio
    text = f"at most {interval_text(largest)} ms apart, {pairs_text(pairs)}"
    return text, _judge(largest, conclusion)


def _crossover(conclusion: dict[str, Any], rows: list[Record]) -> tuple[str, str]:
    """The step above which `under` is the faster one, straight in log-log between steps."""
    pairs = sorted(
        _pairs(conclusion, rows), key=lambda pair: pair.over.step_voxels or 0
    )
    steps = [pair.over.step_voxels for pair in pairs]
    if len(set(steps)) < 2 or len(set(steps)) != len(steps):
        return _missing(conclusion, rows)
    samples = [ratio_sample(pair.over, pair.under) for pair in pairs]
    ratios = ", ".join(
        f"{item.value:.2f} at {step:g}" for item, step in zip(samples, steps)
    )
    if any(sample.drawn is None for sample in samples):
        return f"ratios {ratios}", UNDECIDED
    draws = np.array([np.log(sample.drawn) for sample in samples])
    places = [_rise(np.log(steps), draw) for draw in draws.T]
    inside = [place for place in places if place is not None]
    if len(inside) < LEVEL * len(places):
        word = FAILS if len(inside) < (1 - LEVEL) * len(places) else UNDECIDED
        return f"no crossover that is sure; ratios {ratios}", word
    value = _rise(np.log(steps), np.array([np.log(item.value) for item in samples]))
    middle = float(np.median(inside)) if value is None else value
    ratio = RatioSample(np.exp(middle), np.exp(np.array(inside)), "").interval()
    return f"at {interval_text(ratio)} voxels; ratios {ratios}", _judge(
        ratio, conclusion
    )


def _rise(places: np.ndarray, logs: np.ndarray) -> float | None:
    """Return the first place where the ratio rises through 1."""
    return next((place for place, rises in crossings(places, logs) if rises), None)


def crossings(places: np.ndarray, logs: np.ndarray) -> list[tuple[float, bool]]:
    """Return where the sign changes, straight between two places, and whether it rises there."""
    found = []
    for place, following, a, b in zip(places, places[1:], logs, logs[1:]):
        if (a < 0) != (b < 0):
            found.append(
                (float(place + (following - place) * a / (a - b)), bool(a < b))
            )
    return found


def _unmeasured(conclusion: dict[str, Any], rows: list[Record]) -> tuple[str, str]:
    return conclusion.get("reason", "nothing here measures it"), NOT_RUN


def pairs_text(pairs: list[Any]) -> str:
    """Return how many pairs there are."""
    return "1 pair" if len(pairs) == 1 else f"{len(pairs)} pairs"


def interval_text(ratio: Ratio) -> str:
    """Return a value with its interval for readers."""
    value = number(ratio.value, ".3g")
    if ratio.low is None:
        return f"{value} (noise not known)"
    return f"{value} ({ratio.low:.3g} to {ratio.high:.3g})"


_KINDS = {
    "ratio": _ratio,
    "change": _change,
    "difference": _difference,
    "crossover": _crossover,
    "unmeasured": _unmeasured,
}
