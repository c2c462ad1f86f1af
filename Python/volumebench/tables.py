"""Tables of a study as rows of text, for the terminal and for the report."""

from collections.abc import Iterator
from dataclasses import dataclass

from .notes import SLOW_FACTOR, SlowRow, all_notes, slow_rows
from .results import OK, Record
from .study import Scene, Study
from .summary import (
    Line,
    headlines,
    in_scene,
    is_peer,
    lines,
    million_samples,
    million_samples_per_second,
    missing_groups,
    number,
    sampling_text,
    scene_remarks,
    scenes_of,
    shared_settings,
    shared_settings_of,
    stage_split,
    standard_rows,
)
from .technique_settings import value_text
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES


@dataclass(frozen=True)
class Table:
    """A title, and cells whose first columns are words and whose other columns are numbers.

    `groups` are titles over so many columns each, all of them; `marked` tables have verdicts in
    their first column.
    """

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    words: int
    groups: tuple[tuple[str, int], ...] = ()
    marked: bool = False

    def full_header(self) -> tuple[str, ...]:
        """Return the titles of the columns, each with that of its group."""
        over = [title for title, count in self.groups for _ in range(count)]
        return tuple(
            f"{group}: {title}" if group else title
            for group, title in zip(over or [""] * len(self.header), self.header)
        )


def technique_table(
    records: list[Record], scene: Scene, shared: frozenset[str] = frozenset()
) -> Table:
    """Return speed, samples and error of each technique in a scene."""
    header = ("path", "technique", "sampling", "ms", "GPU ms", "FPS")
    header += ("Msamples", "Msamples/s", "RMSE", "FLIP", "dE>1", "speed-up")
    rows = in_scene(records, scene)
    title = "; ".join([scene.title(), *scene_remarks(rows)])
    cells = tuple(_technique_row(line, shared) for line in lines(rows))
    return Table(title, header, cells, 3)


def _technique_row(line: Line, shared: frozenset[str]) -> tuple[str, ...]:
    record = line.record
    speed_up = line.speed_up()
    factor = f"{speed_up:.1f}x" if speed_up else ""
    return (
        record.path,
        TECHNIQUES[record.technique].title,
        sampling_text(record, shared),
        number(record.frame_ms.median, ".1f"),
        number(record.gpu_ms.median, ".1f"),
        number(record.fps, ".1f"),
        number(million_samples(record), ".2f"),
        number(million_samples_per_second(record), ".0f"),
        number(record.error.rmse, ".2e"),
        number(record.error.flip_mean, ".4f"),
        number(record.error.delta_e_over_1_percent, ".1f", " %"),
        factor if line.matched or not factor else factor + " *",
    )


def setting_tables(records: list[Record]) -> list[Table]:
    """Return one table for each technique whose settings vary in a scene and path."""
    groups: dict[tuple, list[Record]] = {}
    for row in records:
        if row.status == OK and row.settings:
            settings = tuple(sorted(row.settings))
            key = (row.run().scene, row.path, row.technique, row.integrator, settings)
            groups.setdefault(key, []).append(row)
    return [_setting_table(rows) for rows in groups.values() if _varied(rows)]


def _varied(rows: list[Record]) -> list[str]:
    """Return the settings that are not the same in all rows."""
    shared = shared_settings_of(row.settings for row in rows)
    return [name for name in rows[0].settings if name not in shared]


def _setting_table(rows: list[Record]) -> Table:
    """A row for each step and value of the settings."""
    first = rows[0]
    names = _varied(rows)
    steps = {row.step_voxels for row in rows}
    stages = list(dict.fromkeys(name for row in rows for name in row.stages_ms or ()))
    words = ["step"] * (len(steps) > 1) + [name.replace("_", " ") for name in names]
    header = (*words, "FPS", "ms", "RMSE", *(f"{name} ms" for name in stages))
    cells = tuple(
        (
            *[number(row.step_voxels, "g")] * (len(steps) > 1),
            *(value_text(name, row.settings[name]) for name in names),
            number(row.fps, ".1f"),
            number(row.frame_ms.median, ".1f"),
            number(row.error.rmse, ".2e"),
            *(number((row.stages_ms or {}).get(name), ".2f") for name in stages),
        )
        for row in rows
    )
    title = (
        f"{TECHNIQUES[first.technique].title} by {', '.join(words)}: "
        f"{first.run().scene.title()}, path {first.path}"
    )
    if not is_peer(first):
        title += f", {first.integrator}"
        title += f", step {first.step_voxels:g}" * (len(steps) == 1)
    return Table(title, header, cells, len(words))


def stage_table(
    records: list[Record], shared: frozenset[str] = frozenset()
) -> Table | None:
    """Return where the time of a frame goes, for all techniques that have several stages."""
    rows = [
        (
            row.run().scene.title(),
            row.path,
            TECHNIQUES[row.technique].title,
            sampling_text(row, shared),
            stage_split(row),
        )
        for row in standard_rows(records)
        if row.status == OK and row.stages_ms
    ]
    header = ("scene", "path", "technique", "sampling", "stages")
    title = "Stages of a frame, timed in frames of their own"
    return Table(title, header, tuple(rows), len(header)) if rows else None


def feature_table(records: list[Record]) -> Table | None:
    """Return what the kernels of each technique were made for, and what was left out of them."""
    groups: dict[tuple, list[str]] = {}
    for row in records:
        if row.status == OK and row.features is not None:
            title = TECHNIQUES[row.technique].title
            groups.setdefault((row.features, row.left_out or ()), []).append(title)
    rows = tuple(
        (
            ", ".join(dict.fromkeys(titles)),
            *(", ".join(names) or "none" for names in key),
        )
        for key, titles in groups.items()
    )
    header = ("technique", "made for", "left out")
    return Table("Kernels", header, rows, len(header)) if rows else None


def slow_table(records: list[Record]) -> Table | None:
    """Return where the time goes in each row that is much slower than single pass."""
    rows = tuple(_slow_row(row) for row in slow_rows(records))
    base = TECHNIQUES[REFERENCE_TECHNIQUE].title
    title = f"More than {SLOW_FACTOR:g} times as long as {base}"
    header = ("scene", "path", "technique", "sampling", "stages", "ms")
    header += (f"{base} ms", "time", "samples", "time of a sample")
    return Table(title, header, rows, 5) if rows else None


def _slow_row(row: SlowRow) -> tuple[str, ...]:
    record = row.record
    return (
        record.run().scene.title(),
        record.path,
        TECHNIQUES[record.technique].title,
        sampling_text(record),
        stage_split(record) or "one",
        number(record.frame_ms.median, ".1f"),
        number(row.base.frame_ms.median, ".1f"),
        _factor(row.slower(), ".1f"),
        _factor(row.more_samples(), ".2f"),
        _factor(row.slower_sample(), ".1f"),
    )


def _factor(value: float | None, pattern: str) -> str:
    return number(value, pattern) + ("x" if value is not None else "")


def as_text(table: Table) -> str:
    """Return the table for the terminal."""
    cells = [_text_header(table), *table.rows]
    widths = [max(map(len, column)) for column in zip(*cells)]

    def line(row: tuple[str, ...]) -> str:
        padded = (
            cell.ljust(width) if column < table.words else cell.rjust(width)
            for column, (cell, width) in enumerate(zip(row, widths))
        )
        return "  " + "  ".join(padded).rstrip()

    return "\n".join([table.title, *map(line, cells)])


def _text_header(table: Table) -> tuple[str, ...]:
    """Return the titles of the columns; that of a group stands with its first one."""
    titles = list(table.header)
    place = 0
    for group, count in table.groups:
        if group:
            titles[place] = f"{group}: {titles[place]}"
        place += count
    return tuple(titles)


def text_tables(study: Study, records: list[Record]) -> str:
    """Return everything that is printed at the end of a study."""
    return "\n".join(_blocks(study, records))


def _blocks(study: Study, records: list[Record]) -> Iterator[str]:
    shared = shared_settings(records)
    tables = [technique_table(records, scene, shared) for scene in scenes_of(records)]
    yield from (as_text(table) for table in tables if table.rows)
    if any(row[-1].endswith("*") for table in tables for row in table.rows):
        yield "* not at equal error: no run was as accurate as the peer's"
    yield from (as_text(table) for table in setting_tables(records))
    if stages := stage_table(records, shared):
        yield as_text(stages)
    if slow := slow_table(records):
        yield as_text(slow)
    yield from headlines(records)
    yield from (f"note: {text}" for text in all_notes(study, records))
    yield from (f"{item.status}: {item.text()}" for item in missing_groups(records))
