"""How much faster than ParaView's Volume at equal error: the ratio of each scene with its interval."""

import math
from dataclasses import dataclass

from .results import Record
from .statistics import Spread
from .study import Scene
from .summary import in_scene, is_peer, sampling_text, scenes_of
from .techniques import TECHNIQUES, VIEW
from .work_precision import (
    Point,
    bracket_at,
    front_of,
    geometric_mean,
    paraview_row,
    points_of,
)

LEVEL = 1e-3  # RMSE
NOTCH = 1.57  # quartile ranges over sqrt(frames): half a 95 % interval of a median
SKIPPING = "skipping"
ERROR_TARGET = "error_target"


@dataclass(frozen=True)
class Match:
    """The time at an error on the curve of one variant, which is straight in log-log.

    Of a bound, the variant's fastest run is more accurate than was asked for.
    """

    ms: float
    half_width: float  # of the logarithm of the time
    samples: float | None
    record: Record  # the finer of the two measured runs that it lies between
    is_bound: bool

    def variant(self) -> str:
        """Return the technique with its sampling, for readers."""
        text = (
            f"{TECHNIQUES[self.record.technique].title}, {sampling_text(self.record)}"
        )
        return f"{text} or finer" if self.is_bound else text


@dataclass(frozen=True)
class Ratio:
    """ParaView's time over ours in a scene, at an RMSE; None where no run of ours gets there."""

    scene: Scene
    paraview: Record
    rmse: float
    ours: Match | None

    def factor(self) -> float | None:
        """Return how many times shorter our frame is; at least so many where ours is a bound."""
        return self.paraview.frame_ms.median / self.ours.ms if self.ours else None

    def interval(self) -> tuple[float, float] | None:
        """Return the ends of its 95 % interval."""
        if self.ours is None:
            return None
        theirs = median_half_width(self.paraview.frame_ms, self.paraview.frames)
        width = math.exp(math.hypot(theirs, self.ours.half_width))
        return self.factor() / width, self.factor() * width


def median_half_width(times: Spread, frames: int | None) -> float:
    """Return half the 95 % interval of the logarithm of a median, from its quartiles."""
    if not frames or times.q1 is None or times.q3 is None:
        return 0.0
    return NOTCH * (times.q3 - times.q1) / (times.median * math.sqrt(frames))


def match_at(curve: list[Point], rmse: float) -> Match | None:
    """Return where the curve of one variant reaches an error."""
    front = front_of(curve)
    if front and rmse > front[0].rmse:
        row = front[0].record
        width = median_half_width(row.frame_ms, row.frames)
        return Match(front[0].ms, width, row.samples_taken, row, True)
    found = bracket_at(front, rmse)
    if found is None:
        return None
    rows = (found.coarse.record, found.fine.record)
    widths = [median_half_width(row.frame_ms, row.frames) for row in rows]
    samples = [row.samples_taken for row in rows]
    return Match(
        found.between(found.coarse.ms, found.fine.ms),
        (1 - found.share) * widths[0] + found.share * widths[1],
        found.between(*samples) if all(samples) else None,
        found.fine.record,
        False,
    )


def best_match(rows: list[Record], rmse: float) -> Match | None:
    """Return the fastest of our variants at an error; runs that skip nothing are controls."""
    curves: dict[tuple, list[Point]] = {}
    for point in points_of(rows):
        row = point.record
        if not is_peer(row) and not skips_nothing(row):
            settings = tuple(sorted(_but_target(row).items()))
            key = (row.technique, row.integrator, settings)
            curves.setdefault(key, []).append(point)
    found = [match_at(curve, rmse) for curve in curves.values()]
    return min((item for item in found if item), key=lambda item: item.ms, default=None)


def _but_target(row: Record) -> dict:
    """Return the settings of a variant: runs with different error targets are points of one curve."""
    targeted = row.settings.get(ERROR_TARGET, 0) > 0
    return {**row.settings, ERROR_TARGET: True} if targeted else row.settings


def skips_nothing(row: Record) -> bool:
    """Tell whether empty space is not skipped in a run."""
    return row.settings.get(SKIPPING) is False


def ratios(records: list[Record], level: float | None = None) -> list[Ratio]:
    """Return the ratio of each scene at ParaView's own error, or at a level if that is smaller.

    ParaView's Volume has one picture: at a level below its error it is still the same.
    """
    rows = [row for row in records if row.path == VIEW]
    result = []
    for scene in scenes_of(rows):
        theirs = paraview_row(rows, scene)
        if theirs is None or not theirs.frame_ms.median or not theirs.error.rmse:
            continue
        rmse = min(theirs.error.rmse, level or math.inf)
        ours = best_match(in_scene(rows, scene), rmse)
        result.append(Ratio(scene, theirs, rmse, ours))
    return result


def sentence(records: list[Record]) -> str:
    """Return the sentence to quote."""
    own, at_level = ratios(records), ratios(records, LEVEL)
    if not any(item.ours for item in own):
        return "No run of ours was as accurate as ParaView's Volume."
    scenes = len(own)
    sizes = sorted({item.scene.image_size for item in own})
    size = ", ".join(f"{width} x {height}" for width, height in sizes)
    text = (
        f"At ParaView's own error, VolumeBench draws still pictures {_range_text(own)} times as "
        f"fast as ParaView's Volume in the same view ({_counted(own)}, {size})"
    )
    if any(item.ours for item in at_level):
        text += (
            f"; at an RMSE of {LEVEL:g}, or ParaView's own where that is smaller, "
            f"{_range_text(at_level)} times ({_counted(at_level)})"
        )
    stand_ins = sum(item.paraview.stand_in_for is not None for item in own)
    if stand_ins:
        text += f"; generated stand-ins in {stand_ins} of {scenes}"
    return text + "."


def _counted(items: list[Ratio]) -> str:
    """Return of how many scenes; those whose error was not reached are not in the mean."""
    reached = sum(item.ours is not None for item in items)
    count = f"{reached}" if reached == len(items) else f"{reached} of {len(items)}"
    return f"{count} scene" + ("" if len(items) == 1 else "s")


def _range_text(items: list[Ratio]) -> str:
    factors = [item.factor() for item in items if item.ours]
    least = (
        "at least " if any(item.ours and item.ours.is_bound for item in items) else ""
    )
    return (
        f"{least}{geometric_mean(factors):.1f} (geometric mean; {min(factors):.1f} to "
        f"{max(factors):.1f})"
    )


@dataclass(frozen=True)
class Saving:
    """One run with and one without skipping, alike in all else."""

    skipping: Record
    off: Record

    def factor(self) -> float:
        """Return how many times longer the frame takes without."""
        return self.off.frame_ms.median / self.skipping.frame_ms.median


def savings(records: list[Record]) -> list[Saving]:
    """Return the pairs of runs of which only one skips empty space."""
    measured = [row for row in records if row.frame_ms.median]
    result = []
    for off in filter(skips_nothing, measured):
        for row in measured:
            if _but_skipping(row) == _but_skipping(off) and not skips_nothing(row):
                result.append(Saving(row, off))
    return result


def _but_skipping(row: Record) -> tuple:
    settings = {key: value for key, value in row.settings.items() if key != SKIPPING}
    run = row.run()
    sampling = (run.technique, run.integrator, run.step_voxels)
    return (run.scene, run.path, *sampling, tuple(sorted(settings.items())))
