"""Figures of a paper's study: one panel a scene, some of each volume where there are many."""

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import matplotlib.pyplot as plt

from .paper import measured_rows
from .paper_panels import (
    Drawn,
    angle_panel,
    box_panel,
    curves_of,
    pareto_panel,
    shape_panel,
    shaped,
    step_panel,
    thread_panel,
    thread_rows,
)
from .results import Record
from .study import Scene, Study
from .summary import in_scene, scenes_of, shared_settings
from .techniques import TECHNIQUES

MOST_PANELS = 6
LETTERS_AN_INCH = 13  # of a legend
LEGEND_MARK = 7  # letters that the mark of an entry and the gap before it take


@dataclass(frozen=True)
class Kind:
    """What a figure shows in each panel, and of which rows; panels are `inches` wide and high."""

    title: str
    wanted: Callable[[list[Record]], bool]
    panel: Callable[[Any, list[Record], Drawn], None]
    columns: int = 3
    inches: tuple[float, float] = (3.9, 3.0)
    polar: bool = False
    by_technique: bool = False


@dataclass(frozen=True)
class Part:
    """The rows of one panel."""

    title: str
    rows: list[Record]


def paper_figures(
    study: Study, records: list[Record]
) -> dict[str, tuple[str, Callable[[], Any | None]]]:
    """Return file, title and maker of each figure that the study asks for."""
    figures: dict[str, tuple[str, Callable[[], Any | None]]] = {}
    turns = study.camera.path.startswith("orbit")
    rows = measured_rows(records)
    drawn = Drawn(study.camera.frames, shared_settings(rows))
    for wanted in study.paper.get("figures", ()):
        for name, kind in _KINDS.items():
            if name.partition("-")[0] != wanted or (wanted == "angle" and not turns):
                continue
            title, parts = _parts(rows, kind)
            figures[f"paper-{name}.png"] = (title, _maker(parts, kind, drawn))
    return figures


def _parts(rows: list[Record], kind: Kind) -> tuple[str, list[Part]]:
    """Return the panels of a figure, and its title."""
    scenes = [scene for scene in scenes_of(rows) if kind.wanted(in_scene(rows, scene))]
    chosen = spread_over_volumes(scenes, MOST_PANELS)
    title = kind.title
    if len(chosen) < len(scenes):
        title += f" ({len(chosen)} of {len(scenes)} scenes)"
    parts = [Part(scene.title(), in_scene(rows, scene)) for scene in chosen]
    if kind.by_technique:
        parts = [piece for part in parts for piece in _pieces(part, kind)]
    return title, parts


def _pieces(part: Part, kind: Kind) -> list[Part]:
    """Return a part for each technique that has something to show."""
    found: dict[str, list[Record]] = {}
    for row in part.rows:
        found.setdefault(row.technique, []).append(row)
    return [
        Part(f"{TECHNIQUES[technique].title}\n{part.title}", rows)
        for technique, rows in found.items()
        if kind.wanted(rows)
    ]


def spread_over_volumes(scenes: list[Scene], most: int) -> list[Scene]:
    """Return the first scene of each volume, then the second ones, as many as may be, in order."""
    seen: Counter[str] = Counter()
    rank = {}
    for scene in scenes:
        rank[scene] = seen[scene.dataset]
        seen[scene.dataset] += 1
    chosen = set(sorted(scenes, key=rank.get)[:most])
    return [scene for scene in scenes if scene in chosen]


def _maker(parts: list[Part], kind: Kind, drawn: Drawn) -> Callable[[], Any | None]:
    return lambda: _grid(parts, kind, drawn) if parts else None


def _grid(parts: list[Part], kind: Kind, drawn: Drawn) -> Any:
    columns = min(len(parts), kind.columns)
    lines = -(-len(parts) // columns)
    width, height = kind.inches
    figure, panels = plt.subplots(
        *(lines, columns),
        figsize=(width * columns, height * lines),
        squeeze=False,
        subplot_kw={"projection": "polar"} if kind.polar else {},
    )
    handles: dict[str, Any] = {}
    for place, axes in enumerate(panels.flat):
        if place >= len(parts):
            axes.set_visible(False)
            continue
        axes.set_title(parts[place].title, fontsize=7.5)
        kind.panel(axes, parts[place].rows, drawn)
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    figure.tight_layout()
    if handles:
        figure.legend(
            *(handles.values(), handles.keys()),
            loc="upper center",
            bbox_to_anchor=(0.5, 0),
            ncol=_legend_columns(list(handles), width * columns),
        )
    return figure


def _legend_columns(labels: list[str], inches: float) -> int:
    """Return how many entries fit side by side, so that a legend does not widen its figure."""
    letters = max(map(len, labels)) + LEGEND_MARK
    return max(1, min(len(labels), 4, int(LETTERS_AN_INCH * inches / letters)))


def _has_frames(rows: list[Record]) -> bool:
    return any(row.frame_log for row in rows)


_KINDS = {
    "angle": Kind("Frames per second by angle", _has_frames, angle_panel),
    "angle-polar": Kind(
        *("Frames per second round a turn", _has_frames, angle_panel), polar=True
    ),
    "box": Kind(
        *("Times of all frames", _has_frames, box_panel), columns=2, inches=(5.8, 3.6)
    ),
    "step": Kind("Time by step", lambda rows: bool(curves_of(rows)), step_panel),
    "threads": Kind(
        "Speed by threads", lambda rows: bool(thread_rows(rows)), thread_panel
    ),
    "shapes": Kind(
        *("Time by shape of the work group", lambda rows: bool(shaped(rows))),
        *(shape_panel, 3, (3.9, 3.4)),
        by_technique=True,
    ),
    "pareto": Kind(
        *("Error against time", lambda rows: any(row.error.rmse for row in rows)),
        pareto_panel,
    ),
}
