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
    stage_split,
    standard_rows,
)
from .technique_settings import value_text
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES


@dataclass(frozen=True)
class Table:
    """A title, and cells whose first columns are words and whose other columns are numbers."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    words: int


def technique_table(records: list[Record], scene: Scene) -> Table:
    """Return speed, samples and error of each technique in a scene."""
    header = ("path", "technique", "sampling", "ms", "GPU ms", "FPS")
    header += ("Msamples", "Msamples/s", "RMSE", "FLIP", "dE>1", "speed-up")
    rows = in_scene(records, scene)
    title = "; ".join([scene.title(), *scene_remarks(rows)])
    return Table(title, header, tuple(_technique_row(line) for line in lines(rows)), 3)


def _technique_row(line: Line) -> tuple[str, ...]:
    record = line.record
    speed_up = line.speed_up()
    factor = f"{speed_up:.1f}x" if speed_up else ""
    return (
        record.path,
        TECHNIQUES[record.technique].title,
        sampling_text(record),
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
    """Return one table for each technique whose settings vary in a scene, path and sampling."""
    groups: dict[tuple, list[Record]] = {}
    for row in records:
        if row.status == OK and row.settings:
            sampling = (row.integrator, row.step_voxels, tuple(sorted(row.settings)))
            key = (row.run().scene, row.path, row.technique, *sampling)
            groups.setdefault(key, []).append(row)
    return [_setting_table(rows) for rows in groups.values() if len(rows) > 1]


def _setting_table(rows: list[Record]) -> Table:
    first = rows[0]
    names = [
        name
        for name in first.settings
        if len({row.settings.get(name) for row in rows}) > 1
    ]
    stages = list(dict.fromkeys(name for row in rows for name in row.stages_ms or ()))
    titles = tuple(name.replace("_", " ") for name in names)
    stage_titles = tuple(f"{name} ms" for name in stages)
    cells = tuple(
        (
            *(value_text(name, row.settings[name]) for name in names),
            number(row.fps, ".1f"),
            number(row.frame_ms.median, ".1f"),
            number(row.error.rmse, ".2e"),
            *(number((row.stages_ms or {}).get(name), ".2f") for name in stages),
        )
        for row in rows
    )
    title = (
        f"{TECHNIQUES[first.technique].title} by {', '.join(titles)}: "
        f"{first.run().scene.title()}, path {first.path}"
    )
    if not is_peer(first):
        title += f", {first.integrator}, step {first.step_voxels:g}"
    return Table(
        title, (*titles, "FPS", "ms", "RMSE", *stage_titles), cells, len(names)
    )


def stage_table(records: list[Record]) -> Table | None:
    """Return where the time of a frame goes, for all techniques that have several stages."""
    rows = [
        (
            row.run().scene.title(),
            row.path,
            TECHNIQUES[row.technique].title,
            sampling_text(row),
            stage_split(row),
        )
        for row in standard_rows(records)
        if row.status == OK and row.stages_ms
    ]
    header = ("scene", "path", "technique", "sampling", "stages")
    title = "Stages of a frame, timed in frames of their own"
    return Table(title, header, tuple(rows), len(header)) if rows else None


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
    cells = [table.header, *table.rows]
    widths = [max(map(len, column)) for column in zip(*cells)]

    def line(row: tuple[str, ...]) -> str:
        padded = (
            cell.ljust(width) if column < table.words else cell.rjust(width)
            for column, (cell, width) in enumerate(zip(row, widths))
        )
        return "  " + "  ".join(padded).rstrip()

    return "\n".join([table.title, *map(line, cells)])


def text_tables(study: Study, records: list[Record]) -> str:
    """Return everything that is printed at the end of a study."""
    return "\n".join(_blocks(study, records))


def _blocks(study: Study, records: list[Record]) -> Iterator[str]:
    tables = [technique_table(records, scene) for scene in scenes_of(records)]
    yield from (as_text(table) for table in tables if table.rows)
    if any(row[-1].endswith("*") for table in tables for row in table.rows):
        yield "* not at equal error: no run was as accurate as the peer's"
    yield from (as_text(table) for table in setting_tables(records))
    if stages := stage_table(records):
        yield as_text(stages)
    if slow := slow_table(records):
        yield as_text(slow)
    yield from headlines(records)
    yield from (f"note: {text}" for text in all_notes(study, records))
    yield from (f"{item.status}: {item.text()}" for item in missing_groups(records))
