"""Figures of a paper's study: one panel a scene, the first scenes where there are many."""

import math
import re
from collections.abc import Callable
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

from .orbit import THREE_VIEWS
from .paper import fastest, measured_rows
from .plot import technique_color
from .results import FrameLog, Record
from .study import Scene, Study
from .summary import in_scene, is_peer, scenes_of
from .technique_settings import settings_text
from .techniques import TECHNIQUES

MOST_PANELS = 6
MOST_BOXES = 14
PANEL_INCHES = (3.9, 3.0)
_SHAPE = re.compile(r"(\d+)x(\d+)")
Panel = Callable[[Any, list[Record]], None]


def paper_figures(
    study: Study, records: list[Record]
) -> dict[str, tuple[str, Callable[[], Any | None]]]:
    """Return file, title and maker of each figure that the study asks for."""
    figures: dict[str, tuple[str, Callable[[], Any | None]]] = {}
    turns = study.camera.path.startswith("orbit")
    for kind in study.paper.get("figures", ()):
        for name, (title, wanted, panel, polar) in _KINDS.items():
            if name.partition("-")[0] != kind or (kind == "angle" and not turns):
                continue
            frames = study.camera.frames
            figures[f"paper-{name}.png"] = (
                title,
                _maker(records, wanted, panel(frames), polar),
            )
    return figures


def _maker(
    records: list[Record], wanted: Callable, panel: Panel, polar: bool
) -> Callable[[], Any | None]:
    def make() -> Any | None:
        rows = measured_rows(records)
        scenes = [scene for scene in scenes_of(rows) if wanted(in_scene(rows, scene))]
        return _grid(rows, scenes[:MOST_PANELS], panel, polar) if scenes else None

    return make


def _grid(rows: list[Record], scenes: list[Scene], panel: Panel, polar: bool) -> Any:
    columns = min(len(scenes), 3)
    lines = -(-len(scenes) // columns)
    width, height = PANEL_INCHES
    figure, panels = plt.subplots(
        *(lines, columns),
        figsize=(width * columns, height * lines),
        squeeze=False,
        subplot_kw={"projection": "polar"} if polar else {},
    )
    handles: dict[str, Any] = {}
    for place, axes in enumerate(panels.flat):
        if place >= len(scenes):
            axes.set_visible(False)
            continue
        axes.set_title(scenes[place].title(), fontsize=7)
        panel(axes, in_scene(rows, scenes[place]))
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    figure.tight_layout()
    if handles:
        figure.legend(
            *(handles.values(), handles.keys()),
            loc="upper center",
            bbox_to_anchor=(0.5, 0),
            ncol=4,
        )
    return figure


def _best(rows: list[Record]) -> list[Record]:
    """Return the fastest row of each technique."""
    names = dict.fromkeys(row.technique for row in rows)
    return [fastest(rows, {"technique": name}) for name in names]


def fps_of_frames(log: FrameLog) -> tuple[list[int], list[float]]:
    """Return the frames of the path, and of each the rate by the median of its times."""
    frames = sorted(set(log.frame))
    times = [
        np.median([ms for at, ms in zip(log.frame, log.ms) if at == frame])
        for frame in frames
    ]
    return frames, [1000 / ms for ms in times]


def _angle_panel(polar: bool) -> Callable[[int], Panel]:
    def of_turn(turn: int) -> Panel:
        def panel(axes: Any, rows: list[Record]) -> None:
            for row in _best([row for row in rows if row.frame_log]):
                frames, fps = fps_of_frames(row.frame_log)
                angles = [360 * frame / turn for frame in frames]
                if polar and len(angles) == turn:  # a full turn ends where it began
                    angles, fps = [*angles, 360], [*fps, fps[0]]
                x = np.radians(angles) if polar else angles
                color = technique_color(row.technique)
                title = TECHNIQUES[row.technique].title
                axes.plot(x, fps, ".-", color=color, markersize=3, label=title)
            if polar:
                axes.tick_params(labelsize=6)
            else:
                axes.set_xlabel("angle of the camera (degrees)")
                axes.set_ylabel("frames per second")
                axes.set_ylim(bottom=0)
                axes.set_xticks(range(0, 361, 90))

        return panel

    return of_turn


def _any_turn(panel: Panel) -> Callable[[int], Panel]:
    return lambda _: panel


def _box_panel(axes: Any, rows: list[Record]) -> None:
    """Quartiles, and every frame outside 1.5 quartile ranges."""
    shown = sorted(
        (row for row in rows if row.frame_log), key=lambda row: row.frame_ms.median
    )[:MOST_BOXES]
    labels = [_label(row) for row in shown]
    boxes = axes.boxplot(
        [row.frame_log.ms for row in shown],
        vert=False,
        labels=labels,
        flierprops={"markersize": 2},
        patch_artist=True,
    )
    for box, row in zip(boxes["boxes"], shown):
        box.set_facecolor(technique_color(row.technique))
    axes.tick_params(axis="y", labelsize=5)
    axes.invert_yaxis()
    axes.set_xlabel("time of one frame (ms)")


def _label(row: Record) -> str:
    step = "" if row.step_voxels is None else f" {row.step_voxels:.3g}"
    settings = f" {settings_text(row.settings)}" if row.settings else ""
    return f"{TECHNIQUES[row.technique].title}{step}{settings}"


def _curves(rows: list[Record]) -> dict[str, list[Record]]:
    """Return rows that differ in the step only, by what they have in common."""
    curves: dict[str, list[Record]] = {}
    for row in sorted(rows, key=lambda row: row.step_voxels or 0):
        if row.step_voxels is not None:
            settings = f" {settings_text(row.settings)}" if row.settings else ""
            title = f"{TECHNIQUES[row.technique].title}, {row.integrator}{settings}"
            curves.setdefault(title, []).append(row)
    return {title: curve for title, curve in curves.items() if len(curve) > 1}


def _step_panel(axes: Any, rows: list[Record]) -> None:
    """Curves cross where one technique becomes the faster one."""
    for title, curve in _curves(rows).items():
        off = curve[0].settings.get("termination_threshold") == 0
        axes.plot(
            [row.step_voxels for row in curve],
            [row.frame_ms.median for row in curve],
            "o--" if off else "o-",
            markersize=3,
            color=technique_color(curve[0].technique),
            label=title,
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("step (voxels)")
    axes.set_ylabel("time of one frame (ms)")


def _thread_rows(rows: list[Record]) -> list[Record]:
    return sorted(
        (row for row in rows if row.settings.get("slice_threads")),
        key=lambda row: row.settings["slice_threads"],
    )


def _thread_panel(axes: Any, rows: list[Record]) -> None:
    threads = _thread_rows(rows)
    for step in dict.fromkeys(row.step_voxels for row in threads):
        curve = [row for row in threads if row.step_voxels == step]
        axes.errorbar(
            [row.settings["slice_threads"] for row in curve],
            [1000 / row.frame_ms.median for row in curve],
            yerr=np.array(
                [
                    [
                        1000 / row.frame_ms.median - 1000 / row.frame_ms.q3,
                        1000 / row.frame_ms.q1 - 1000 / row.frame_ms.median,
                    ]
                    for row in curve
                ]
            ).T,
            marker="o",
            markersize=3,
            capsize=2,
            label=f"step {step:.3g}",
        )
    axes.set_xscale("log", base=2)
    axes.set_ylim(bottom=0)
    axes.set_xlabel("threads that make the slices")
    axes.set_ylabel("frames per second (quartiles)")


def _shaped(rows: list[Record]) -> list[tuple[int, int, Record]]:
    """Return the exponents of width and height of each row with a work group of its own."""
    found = []
    for row in rows:
        shape = _SHAPE.fullmatch(str(row.settings.get("work_group_shape", "")))
        if shape:
            found.append((*(int(math.log2(int(side))) for side in shape.groups()), row))
    return found


def _shape_panel(axes: Any, rows: list[Record]) -> None:
    """The fastest time with each shape, whatever technique and set-up."""
    shaped = _shaped(rows)
    size = 1 + max(max(width, height) for width, height, _ in shaped)
    times = np.full((size, size), np.nan)
    for width, height, row in shaped:
        times[height, width] = np.nanmin([times[height, width], row.frame_ms.median])
    axes.imshow(times, cmap="viridis_r", origin="lower")
    for (height, width), value in np.ndenumerate(times):
        if not np.isnan(value):
            axes.text(
                width, height, f"{value:.3g}", ha="center", va="center", fontsize=6
            )
    ticks = [str(2**power) for power in range(size)]
    axes.set_xticks(range(size), ticks)
    axes.set_yticks(range(size), ticks)
    axes.set_xlabel("width of a work group")
    axes.set_ylabel("height (ms in the cells)")


def _pareto_panel(axes: Any, rows: list[Record]) -> None:
    for row in rows:
        if row.error.rmse:
            axes.plot(
                row.frame_ms.median,
                row.error.rmse,
                "*" if is_peer(row) else "o",
                color=technique_color(row.technique),
                markersize=4,
                label=TECHNIQUES[row.technique].title,
            )
    known = sorted(
        (row.frame_ms.median, row.error.rmse) for row in rows if row.error.rmse
    )
    front: list[tuple[float, float]] = []
    for time, error in known:
        if not front or error < front[-1][1]:
            front.append((time, error))
    axes.step(*zip(*front), where="post", color="#9aa0ab", linewidth=1, zorder=0)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("time of one frame (ms)")
    axes.set_ylabel("RMSE against the reference")


def _has_frames(rows: list[Record]) -> bool:
    return any(row.frame_log for row in rows)


_KINDS = {
    "angle": ("Frames per second by angle", _has_frames, _angle_panel(False), False),
    "angle-polar": (
        "Frames per second round a turn",
        _has_frames,
        _angle_panel(True),
        True,
    ),
    "box": ("Times of all frames", _has_frames, _any_turn(_box_panel), False),
    "step": (
        *("Time by step", lambda rows: bool(_curves(rows))),
        *(_any_turn(_step_panel), False),
    ),
    "threads": (
        *("Speed by threads", lambda rows: bool(_thread_rows(rows))),
        *(_any_turn(_thread_panel), False),
    ),
    "shapes": (
        *("Time by shape of the work group", lambda rows: bool(_shaped(rows))),
        *(_any_turn(_shape_panel), False),
    ),
    "pareto": (
        *("Error against time", lambda rows: any(row.error.rmse for row in rows)),
        *(_any_turn(_pareto_panel), False),
    ),
}
