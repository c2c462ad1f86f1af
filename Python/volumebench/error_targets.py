"""Runs with an error target: the error that came of it, and what a fixed step takes for the same."""

from dataclasses import dataclass

from .results import Record
from .speed import ERROR_TARGET, Match, match_at
from .speed_tables import mega
from .study import Scene
from .summary import in_scene, number, scenes_of
from .tables import Table
from .techniques import TECHNIQUES
from .work_precision import points_of


@dataclass(frozen=True)
class Kept:
    """A run with a target, and the curve of fixed steps at its error; None where that has no such point."""

    scene: Scene
    record: Record
    fixed: Match | None

    def target(self) -> float:
        """Return the RMSE that was asked for."""
        return self.record.settings[ERROR_TARGET]

    def share(self) -> float:
        """Return the measured error as a share of the target; above 1 it is not kept."""
        return self.record.error.rmse / self.target()


def kept_targets(records: list[Record]) -> list[Kept]:
    """Return the runs with a target, scene by scene."""
    result = []
    for scene in scenes_of(records):
        points = points_of(in_scene(records, scene))
        for point in points:
            row = point.record
            if row.settings.get(ERROR_TARGET):
                fixed = [other for other in points if _is_fixed(other.record, row)]
                found = match_at(fixed, row.error.rmse)
                bound = found is not None and found.is_bound
                result.append(Kept(scene, row, None if bound else found))
    return result


def _is_fixed(other: Record, row: Record) -> bool:
    """Tell whether a run differs from one with a target by its steps alone."""
    settings = {
        key: value for key, value in row.settings.items() if key != ERROR_TARGET
    }
    same = (other.technique, other.integrator, other.path)
    return (
        same == (row.technique, row.integrator, row.path) and other.settings == settings
    )


def target_table(records: list[Record]) -> Table | None:
    """Return measured errors beside targets, and times and samples beside those of fixed steps."""
    kept = kept_targets(records)
    if not kept:
        return None
    header = (
        "scene",
        "technique, integrator",
        "path",
        "target",
        "RMSE",
        "share of target",
    )
    header += ("ms", "ms of a fixed step", "Msamples", "Msamples of a fixed step")
    title = "Error targets, and fixed steps at the error that came of them"
    return Table(title, header, tuple(map(_row, kept)), 4)


def _row(item: Kept) -> tuple[str, ...]:
    row, fixed = item.record, item.fixed
    return (
        item.scene.title(),
        f"{TECHNIQUES[row.technique].title}, {row.integrator}",
        row.path,
        f"{item.target():g}",
        number(row.error.rmse, ".1e"),
        number(item.share(), ".2f") + ("" if item.share() <= 1 else " (not kept)"),
        number(row.frame_ms.median, ".1f"),
        number(fixed.ms if fixed else None, ".1f"),
        mega(row.samples_taken),
        mega(fixed.samples if fixed else None),
    )
