"""What became faster, slower, more or less accurate between two results of the same runs."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .bootstrap import LEVEL, Ratio, RatioSample, geometric_mean, ratio_sample
from .errors import BenchError
from .results import OK, Context, Record, read_results
from .summary import describe, number
from .tables import Table

MARGIN = 0.03  # two runs of one program differ so much on a quiet machine
ERROR_MARGIN = 0.01
FASTER, SLOWER, UNDECIDED = "faster", "slower", "undecided"
BETTER, WORSE, SAME = "more accurate", "less accurate", "as accurate"
_MACHINE = ("host", "cpu", "cores", "gl_renderer", "build_type", "opencl_device")


@dataclass(frozen=True)
class Change:
    """One run in both results: the ratio of frame times, new over old, and both errors."""

    old: Record
    new: Record
    sample: RatioSample
    ratio: Ratio
    speed: str
    accuracy: str | None

    def is_regression(self) -> bool:
        """Tell whether the run became worse beyond noise."""
        return self.speed == SLOWER or self.accuracy == WORSE


@dataclass(frozen=True)
class Comparison:
    """All that can be said of two results files."""

    changes: tuple[Change, ...]
    lost: tuple[Record, ...]  # measured before, now failed or unsupported
    won: tuple[Record, ...]  # the other way round
    only_old: int
    only_new: int
    machine: tuple[str, ...]
    level: float
    margin: float

    def is_regression(self) -> bool:
        """Tell whether anything became worse beyond noise."""
        return bool(self.lost) or any(item.is_regression() for item in self.changes)

    def of(self, verdict: str) -> list[Change]:
        """Return the changes with a verdict, the largest first."""
        chosen = [
            item for item in self.changes if verdict in (item.speed, item.accuracy)
        ]
        return sorted(chosen, key=lambda item: abs(1 - item.ratio.value), reverse=True)


def compare_files(old: Path, new: Path, margin: float = MARGIN) -> Comparison:
    """Compare two results files; it is an error if they have no measured run in common."""
    comparison = compare(read_results(old), read_results(new), margin)
    if not comparison.changes and not comparison.lost:
        raise BenchError(f"{new}: has no measured run in common with {old}")
    return comparison


def compare(
    old: tuple[Context, list[Record]],
    new: tuple[Context, list[Record]],
    margin: float = MARGIN,
) -> Comparison:
    """Compare the rows of two results.

    A run is faster or slower where its interval lies beyond the margin. The more runs are compared,
    the wider are their intervals (Bonferroni), so that all verdicts together hold with 95 %.
    """
    before = {_key(row): row for row in old[1]}
    after = {_key(row): row for row in new[1]}
    shared = [key for key in before if key in after]
    both = [key for key in shared if _is_measured(before[key], after[key])]
    level = 1 - (1 - LEVEL) / max(len(both), 1)
    lost = [after[key] for key in shared if _is_lost(before[key], after[key])]
    won = [after[key] for key in shared if _is_lost(after[key], before[key])]
    return Comparison(
        tuple(_change(before[key], after[key], level, margin) for key in both),
        tuple(lost),
        tuple(won),
        len(before) - len(shared),
        len(after) - len(shared),
        tuple(_differences(old[0], new[0])),
        level,
        margin,
    )


def _key(row: Record) -> tuple[Any, ...]:
    """Return the run without the name of its study: a quick one may be compared with a full one."""
    return row.run().key()[1:]


def _is_measured(*rows: Record) -> bool:
    return all(row.status == OK and row.frame_ms.median for row in rows)


def _is_lost(old: Record, new: Record) -> bool:
    return old.status == OK and new.status != OK


def _change(old: Record, new: Record, level: float, margin: float) -> Change:
    sample = ratio_sample(new, old)
    ratio = sample.interval(level)
    return Change(
        old, new, sample, ratio, _speed(ratio, margin), _accuracy(old.error, new.error)
    )


def _speed(ratio: Ratio, margin: float) -> str:
    if ratio.low is not None and ratio.low > 1 + margin:
        return SLOWER
    if ratio.high is not None and ratio.high < 1 / (1 + margin):
        return FASTER
    return UNDECIDED


def _accuracy(old: Any, new: Any) -> str | None:
    """Compare two errors; what the references leave open, and a hundredth, is no difference."""
    if old.rmse is None or new.rmse is None:
        return None
    doubt = (old.reference_uncertainty or 0) + (new.reference_uncertainty or 0)
    doubt += ERROR_MARGIN * old.rmse
    if abs(new.rmse - old.rmse) <= doubt:
        return SAME
    return WORSE if new.rmse > old.rmse else BETTER


def _differences(old: Context, new: Context) -> list[str]:
    """Return what differs between the machines."""
    pairs = {name: (getattr(old, name), getattr(new, name)) for name in _MACHINE}
    return [
        f"{name} was {was} and is {now}"
        for name, (was, now) in pairs.items()
        if was != now
    ]


def summary_of(comparison: Comparison) -> list[str]:
    """Return the sentences to print before the tables."""
    changes = comparison.changes
    counts = [
        f"{len(comparison.of(word))} {word}" for word in (FASTER, SLOWER, UNDECIDED)
    ]
    texts = [
        f"{len(changes)} runs in both: {', '.join(counts)} (a difference counts beyond "
        f"{100 * comparison.margin:g} %, with {100 * LEVEL:g} % for all verdicts together)"
    ]
    if changes:
        mean = geometric_mean([item.sample for item in changes])
        texts.append(f"frame time, new over old: {ratio_text(mean)} (geometric mean)")
    known = [item for item in changes if item.accuracy]
    if known:
        counts = [
            f"{len(comparison.of(word))} {word}" for word in (BETTER, WORSE, SAME)
        ]
        texts.append(f"errors: {', '.join(counts)}")
    texts += [
        f"no longer measured: {describe(row)}: {row.reason}" for row in comparison.lost
    ]
    texts += [f"now measured: {describe(row)}" for row in comparison.won]
    for count, name in ((comparison.only_old, "OLD"), (comparison.only_new, "NEW")):
        if count:
            texts.append(f"{count} runs are in {name} only")
    texts += [f"not the same machine: {text}" for text in comparison.machine]
    return texts


def ratio_text(ratio: Ratio) -> str:
    """Return a ratio with its interval for readers."""
    if ratio.low is None:
        return f"{ratio.value:.3f} (noise not known)"
    return f"{ratio.value:.3f} ({ratio.low:.3f} to {ratio.high:.3f})"


def change_tables(comparison: Comparison) -> list[Table]:
    """Return a table of each verdict that says that something changed."""
    verdicts = (SLOWER, FASTER, WORSE, BETTER)
    tables = [_table(word, comparison.of(word)) for word in verdicts]
    return [table for table in tables if table.rows]


def _table(verdict: str, changes: list[Change]) -> Table:
    header = (
        "run",
        "noise from",
        "old ms",
        "new ms",
        "new / old",
        "old RMSE",
        "new RMSE",
    )
    rows = tuple(
        (
            describe(item.new),
            item.sample.basis,
            number(item.old.frame_ms.median, ".2f"),
            number(item.new.frame_ms.median, ".2f"),
            ratio_text(item.ratio),
            number(item.old.error.rmse, ".2e"),
            number(item.new.error.rmse, ".2e"),
        )
        for item in changes
    )
    return Table(verdict.capitalize(), header, rows, 2)
