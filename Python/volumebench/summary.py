"""Condenses the rows of a study: which run of a technique is fair to set against the peer's."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from .results import OK, Record
from .study import Scene
from .technique_settings import settings_text, without
from .techniques import TECHNIQUES

STANDARD_STEP_VOXELS = 1.0
# Voxels: what vtk-gpu takes unless it is set, and ParaView from 100 cells an edge upwards.
PEER_DISTANCE = 0.5


@dataclass(frozen=True)
class Line:
    """One technique in one scene on one path, beside the peer of that path."""

    record: Record
    peer: Record | None
    matched: bool

    def speed_up(self) -> float | None:
        """Return how many times shorter the frame is than the peer's."""
        if self.peer is None or self.record is self.peer:
            return None
        ours, theirs = self.record.frame_ms.median, self.peer.frame_ms.median
        return theirs / ours if ours and theirs else None


def is_peer(record: Record) -> bool:
    """Tell whether the row belongs to a technique that is not ours."""
    return TECHNIQUES[record.technique].peer


def sample_distance(record: Record) -> float:
    """Return the distance of a peer's samples in voxels: what it was set to, or its default."""
    return record.settings.get("sample_distance_voxels", PEER_DISTANCE)


def scenes_of(records: list[Record]) -> list[Scene]:
    """Return the scenes in order of appearance."""
    return list(dict.fromkeys(record.run().scene for record in records))


def in_scene(records: list[Record], scene: Scene) -> list[Record]:
    """Return the rows of one scene."""
    return [record for record in records if record.run().scene == scene]


def standard_rows(records: list[Record]) -> list[Record]:
    """Return the rows that have the first of the settings that their technique varies."""
    first: dict[tuple[Scene, str, str], dict] = {}
    for row in records:
        first.setdefault((row.run().scene, row.path, row.technique), row.settings)
    return [
        row
        for row in records
        if row.settings == first[row.run().scene, row.path, row.technique]
    ]


def shared_settings(records: list[Record]) -> frozenset[str]:
    """Return what all rows of ours have with one value, so that readers need it once only: the
    integrator, and settings by their names."""
    return shared_settings_of(
        {"integrator": row.integrator} | row.settings
        for row in records
        if not is_peer(row)
    )


def shared_settings_of(settings: Iterable[dict[str, Any]]) -> frozenset[str]:
    """Return the names that all settings have with one value."""
    given = list(settings)
    return frozenset(
        name
        for name, value in (given[0] if given else {}).items()
        if all(name in other and other[name] == value for other in given)
    )


def shared_text(records: list[Record]) -> str:
    """Return integrator and settings that all rows of ours share, for readers."""
    first = next((row for row in records if not is_peer(row)), None)
    if first is None:
        return ""
    shared = shared_settings(records)
    texts = [first.integrator] if "integrator" in shared else []
    shared_ones = {
        name: first.settings[name] for name in first.settings if name in shared
    }
    return ", ".join(filter(None, [*texts, settings_text(shared_ones)]))


def matching(candidates: list[Record], peer: Record | None) -> tuple[Record, bool]:
    """Return the fastest candidate whose RMSE does not exceed the peer's, and True.

    Without such a one: the most accurate; without errors, the one of the standard step; and
    False, since its speed is then not comparable.
    """
    limit = peer.error.rmse if peer else None
    measured = [item for item in candidates if item.error.rmse is not None]
    if limit is not None:
        fair = [item for item in measured if item.error.rmse <= limit]
        if fair:
            return min(fair, key=lambda item: item.frame_ms.median), True
        if measured:
            return min(measured, key=lambda item: item.error.rmse), False
    return min(candidates, key=_step_distance), False


def _step_distance(record: Record) -> tuple[float, bool]:
    step = record.step_voxels or STANDARD_STEP_VOXELS
    return (abs(step - STANDARD_STEP_VOXELS), record.integrator != "Midpoint")


def lines(records: list[Record]) -> list[Line]:
    """Return one line for each technique of each scene and path, the peers first."""
    result: list[Line] = []
    for scene in scenes_of(records):
        rows = [row for row in in_scene(records, scene) if row.status == OK]
        for path in dict.fromkeys(row.path for row in rows):
            result.extend(_lines_of_path([row for row in rows if row.path == path]))
    return result


def _lines_of_path(rows: list[Record]) -> list[Line]:
    peers = [row for row in rows if is_peer(row)]
    # A sweep measures a peer at other sample distances too: it is set against its default one.
    peers = [row for row in peers if sample_distance(row) == PEER_DISTANCE] or peers
    peer = peers[0] if peers else None
    result = [Line(row, peer, True) for row in peers]
    for technique in dict.fromkeys(row.technique for row in rows if not is_peer(row)):
        candidates = [row for row in rows if row.technique == technique]
        record, matched = matching(candidates, peer)
        result.append(Line(record, peer, matched))
    return result


def headlines(records: list[Record]) -> list[str]:
    """Return one sentence per path: the speed-ups of the fastest technique in each scene."""
    best: dict[tuple[str, str], dict[Scene, float]] = {}
    for line in lines(records):
        factor = line.speed_up()
        if line.matched and factor and not is_peer(line.record):
            key = (line.record.path, line.peer.technique)
            scene = line.record.run().scene
            factors = best.setdefault(key, {})
            factors[scene] = max(factors.get(scene, 0.0), factor)
    return [
        f"{path}: {range_text(list(factors.values()))} the frame rate of "
        f"{TECHNIQUES[peer].title}, at equal or smaller error"
        for (path, peer), factors in best.items()
    ]


def range_text(factors: list[float], pattern: str = ".1f") -> str:
    """Return factors as "2.0 to 3.5 times"."""
    low, high = format(min(factors), pattern), format(max(factors), pattern)
    return f"{low} times" if low == high else f"{low} to {high} times"


def million_samples(record: Record) -> float | None:
    """Return the samples of one frame, in millions."""
    return None if record.samples_taken is None else record.samples_taken / 1e6


def million_samples_per_second(record: Record) -> float | None:
    """Return the samples of one frame over the median time of a frame."""
    count, frame_ms = million_samples(record), record.frame_ms.median
    return 1000 * count / frame_ms if count is not None and frame_ms else None


def stage_shares(record: Record) -> dict[str, float]:
    """Return the share of each stage in the sum of all; none for a frame without stages."""
    stages = {name: ms for name, ms in (record.stages_ms or {}).items() if ms}
    total = sum(stages.values())
    return {name: ms / total for name, ms in stages.items()}


def stage_split(record: Record) -> str:
    """Return the stages of a frame with their shares; empty for one that has no stages."""
    return ", ".join(
        f"{name} {record.stages_ms[name]:.2f} ms ({100 * share:.0f} %)"
        for name, share in stage_shares(record).items()
    )


def scene_remarks(records: list[Record]) -> list[str]:
    """Return what a reader must know of the rows of one scene beside its name."""
    remarks = []
    for row in records:
        size = row.error.image_size
        if row.stand_in_for:
            remarks.append(f"generated, stands in for {row.stand_in_for}")
        if size and size != row.image_size:
            remarks.append(f"errors measured on {size[0]} x {size[1]}")
    return list(dict.fromkeys(remarks))


def unfinished(records: list[Record]) -> list[Record]:
    """Return the rows that hold no measurement."""
    return [record for record in records if record.status != OK]


def sampling_text(record: Record, shared: frozenset[str] = frozenset()) -> str:
    """Return integrator, step and settings for readers, less what all rows share."""
    settings = settings_text(without(record.settings, shared))
    if record.step_voxels is None:
        return settings or "its own default"
    integrator = "" if "integrator" in shared else record.integrator
    step = f"step {record.step_voxels:g}"
    return ", ".join(filter(None, [integrator, step, settings]))


@dataclass(frozen=True)
class MissingGroup:
    """Rows of one technique that lack a measurement for the same reason."""

    status: str
    reason: str
    rows: tuple[Record, ...]

    def text(self) -> str:
        """Return one line for readers; a single row is told in full."""
        count = len(self.rows)
        if count == 1:
            return f"{describe(self.rows[0])}: {self.reason}"
        title = TECHNIQUES[self.rows[0].technique].title
        scenes = len(scenes_of(list(self.rows)))
        paths = ", ".join(dict.fromkeys(row.path for row in self.rows))
        return f"{title}, {count} rows in {scenes} scenes, path {paths}: {self.reason}"


def missing_groups(records: list[Record]) -> list[MissingGroup]:
    """Return the rows without a measurement, gathered by technique and reason."""
    groups: dict[tuple[str, str, str], list[Record]] = {}
    for row in unfinished(records):
        key = (row.technique, row.status, row.reason or "no reason was given")
        groups.setdefault(key, []).append(row)
    return [
        MissingGroup(status, reason, tuple(rows))
        for (_, status, reason), rows in groups.items()
    ]


def describe(record: Record) -> str:
    """Name a row for readers."""
    title = TECHNIQUES[record.technique].title
    sampling = f" ({sampling_text(record)})" if record.step_voxels is not None else ""
    return f"{title}{sampling}, {record.run().scene.title()}, path {record.path}"


def counted(count: int, word: str) -> str:
    """Return "1 view" or "2 views"."""
    return f"{count} {word}" + "s" * (count != 1)


def number(value: float | None, pattern: str, unit: str = "") -> str:
    """Format a number with its unit; an absent one is a dash."""
    return "-" if value is None else format(value, pattern) + unit
