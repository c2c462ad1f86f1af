"""Measured rows as markup: a table with a line for each, under the scene that it belongs to."""

from collections.abc import Callable
from dataclasses import dataclass
from html import escape

from .results import Record
from .study import Scene
from .summary import (
    Line,
    in_scene,
    million_samples,
    million_samples_per_second,
    number,
    sampling_text,
    scene_remarks,
)
from .techniques import TECHNIQUES

UNEQUAL = (
    "<p><small>* not at equal error: no run was as accurate as the peer's</small></p>"
)


@dataclass(frozen=True)
class Column:
    """A column by its title and what it shows of a line, both as markup."""

    title: str
    cell: Callable[[Line], str]
    is_number: bool = True

    def attribute(self) -> str:
        """Return the attribute of its cells."""
        return ' class="n"' if self.is_number else ""


def line_table(shown: list[Line], with_scene: bool, shared: frozenset[str]) -> str:
    """Return the lines as a table; the settings that all share are not told in each."""
    columns = _columns(shown, shared)
    head = "".join(f"<th{item.attribute()}>{item.title}</th>" for item in columns)
    rows = []
    previous = None
    for line in shown:
        scene = line.record.run().scene
        if with_scene and scene != previous:
            inside = in_scene([item.record for item in shown], scene)
            rows.append(_scene_row(scene, inside, len(columns)))
        previous = scene
        cells = (f"<td{item.attribute()}>{item.cell(line)}</td>" for item in columns)
        rows.append(f'<tr>{"".join(cells)}</tr>')
    unequal = any(line.speed_up() and not line.matched for line in shown)
    return (
        f'<div class="wide"><table><thead><tr>{head}</tr></thead>'
        f'<tbody>{"".join(rows)}</tbody></table></div>'
        f"{UNEQUAL if unequal else ''}"
    )


def _columns(shown: list[Line], shared: frozenset[str]) -> list[Column]:
    """Return the columns that have something to tell."""

    def title(line: Line) -> str:
        return escape(TECHNIQUES[line.record.technique].title)

    def sampling(line: Line) -> str:
        return escape(sampling_text(line.record, shared))

    columns = [
        Column("Technique", title, False),
        Column("Sampling", sampling, False),
        *_FIGURES,
    ]
    if len({line.record.path for line in shown}) > 1:
        columns.insert(0, Column("Path", lambda line: line.record.path, False))
    if any(line.peer for line in shown):
        columns.append(Column("Speed-up", _factor))
    return columns


def _scene_row(scene: Scene, records: list[Record], columns: int) -> str:
    remarks = "; ".join(scene_remarks(records))
    return (
        f'<tr><th class="scene" colspan="{columns}">{escape(scene.title())} '
        f"<small>{escape(remarks)}</small></th></tr>"
    )


def _factor(line: Line) -> str:
    speed_up = line.speed_up()
    if not speed_up:
        return ""
    factor = f"{speed_up:.1f}&times;"
    return f"<b>{factor}</b>" if line.matched else f"{factor} *"


def _time(line: Line) -> str:
    spread = line.record.frame_ms
    text = number(spread.median, ".1f")
    if spread.q1 is None or spread.q3 is None:
        return text
    return f"{text} <small>({spread.q1:.1f}&ndash;{spread.q3:.1f})</small>"


def _figure(
    title: str, value: Callable[[Record], float | None], pattern: str, unit: str = ""
) -> Column:
    return Column(title, lambda line: number(value(line.record), pattern, unit))


_FIGURES = (
    Column("ms (quartiles)", _time),
    _figure("GPU ms", lambda row: row.gpu_ms.median, ".1f"),
    _figure("FPS", lambda row: row.fps, ".1f"),
    _figure("Msamples", million_samples, ".2f"),
    _figure("Msamples/s", million_samples_per_second, ".0f"),
    _figure("RMSE", lambda row: row.error.rmse, ".2e"),
    _figure("99.9 %", lambda row: row.error.p999, ".2e"),
    _figure("mean error", lambda row: row.error.mean, "+.1e"),
    _figure("SSIM", lambda row: row.error.ssim, ".4f"),
    _figure(
        *("&Delta;E &gt; 1", lambda row: row.error.delta_e_over_1_percent, ".1f", " %")
    ),
    _figure("FLIP", lambda row: row.error.flip_mean, ".4f"),
    _figure("FLIP 99 %", lambda row: row.error.flip_p99, ".4f"),
)
