"""What the panels of a paper's figures show of the rows of one scene."""

import math
import re
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np
from matplotlib.ticker import MaxNLocator

from .paper import crossings, fastest
from .plot import technique_color
from .plot_style import log_ticks
from .results import FrameLog, Record
from .summary import counted, is_peer, sampling_text
from .technique_settings import settings_text, without
from .techniques import TECHNIQUES

MOST_BOXES = 14
MOST_CURVES = 8
LINES = ("-", "--", ":", "-.")
DARK = 0.55  # of the range of the colours: from there on numbers are white
_SHAPE = re.compile(r"(\d+)x(\d+)")


@dataclass(frozen=True)
class Drawn:
    """What all panels of a study share: frames of a turn, and settings that need no words."""

    turn: int
    shared: frozenset[str] = frozenset()


def _label(row: Record, drawn: Drawn) -> str:
    return f"{TECHNIQUES[row.technique].title}, {sampling_text(row, drawn.shared)}"


def _chosen(rows: list[Record]) -> list[Record]:
    """Return all rows where they are few, or else the fastest of each technique at the shortest step."""
    if len(rows) <= MOST_CURVES:
        return rows
    finest = min((row.step_voxels for row in rows if row.step_voxels), default=None)
    rows = [row for row in rows if row.step_voxels in (None, finest)]
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


def angle_panel(axes: Any, rows: list[Record], drawn: Drawn) -> None:
    """The rate by the angle of the camera; frames that were not timed leave gaps."""
    polar = axes.name == "polar"
    seen: dict[str, int] = {}
    for row in _chosen([row for row in rows if row.frame_log]):
        rates = dict(zip(*fps_of_frames(row.frame_log)))
        turn = range(drawn.turn + 1)  # ends where it began
        degrees = np.array([360 * frame / drawn.turn for frame in turn])
        place = seen[row.technique] = seen.get(row.technique, -1) + 1
        axes.plot(
            np.radians(degrees) if polar else degrees,
            [rates.get(frame % drawn.turn, np.nan) for frame in turn],
            linestyle=LINES[place % len(LINES)],
            marker=".",
            markersize=3,
            color=technique_color(row.technique),
            label=_label(row, drawn),
        )
    if polar:
        axes.tick_params(labelsize=6)
        axes.set_rlabel_position(22.5)
        axes.yaxis.set_major_locator(MaxNLocator(4))
        axes.set_ylim(bottom=0)
    else:
        axes.set_xlabel("angle of the camera (degrees)")
        axes.set_ylabel("frames per second")
        axes.set_ylim(bottom=0)
        axes.set_xticks(range(0, 361, 90))


def box_panel(axes: Any, rows: list[Record], drawn: Drawn) -> None:
    """Quartiles, and every frame outside 1.5 quartile ranges, of the fastest rows."""
    shown = sorted(
        (row for row in rows if row.frame_log), key=lambda row: row.frame_ms.median
    )[:MOST_BOXES]
    boxes = axes.boxplot(
        [row.frame_log.ms for row in shown],
        vert=False,
        labels=[_label(row, drawn) for row in shown],
        flierprops={"markersize": 2},
        medianprops={"color": "#1f2430"},
        patch_artist=True,
    )
    for box, row in zip(boxes["boxes"], shown):
        box.set_facecolor(technique_color(row.technique))
    axes.tick_params(axis="y", labelsize=6.5)
    axes.invert_yaxis()
    axes.set_xlim(0, edge_of([row.frame_log.ms for row in shown]))
    beyond = sum(ms > axes.get_xlim()[1] for row in shown for ms in row.frame_log.ms)
    words = f"; {counted(beyond, 'frame')} beyond the edge" if beyond else ""
    axes.set_xlabel(f"time of one frame (ms{words})")


def edge_of(times: list[list[float]]) -> float:
    """Return where an axis of times ends, so that a frame that took far longer than all others does
    not leave the boxes without width."""
    longest = max(map(max, times))
    return 1.05 * min(longest, 3 * max(map(np.median, times)))


def curves_of(
    rows: list[Record], shared: frozenset[str] = frozenset()
) -> dict[tuple[str, str], list[Record]]:
    """Return rows that differ in the step only, by technique and by what else they have in common."""
    curves: dict[tuple[str, str], list[Record]] = {}
    for row in sorted(rows, key=lambda row: row.step_voxels or 0):
        if row.step_voxels is not None:
            common = settings_text(without(row.settings, shared))
            integrator = "" if "integrator" in shared else row.integrator
            text = ", ".join(filter(None, [integrator, common]))
            curves.setdefault((row.technique, text), []).append(row)
    return {key: curve for key, curve in curves.items() if len(curve) > 1}


def step_panel(axes: Any, rows: list[Record], drawn: Drawn) -> None:
    """Curves cross where one technique becomes the faster one."""
    curves = curves_of(rows, drawn.shared)
    for (technique, text), curve in curves.items():
        off = curve[0].settings.get("termination_threshold") == 0
        axes.plot(
            [row.step_voxels for row in curve],
            [row.frame_ms.median for row in curve],
            "o--" if off else "o-",
            markersize=3,
            color=technique_color(technique),
            label=", ".join(filter(None, [TECHNIQUES[technique].title, text])),
        )
    places = places_of_crossing(curves)
    if places:
        axes.plot(
            *zip(*places),
            *("X",),
            markersize=7,
            color="#1f2430",
            markerfacecolor="none",
            label="two techniques with the same settings cross",
        )
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("step (voxels)")
    axes.set_ylabel("time of one frame (ms)")
    log_ticks(axes.xaxis)
    log_ticks(axes.yaxis)


def places_of_crossing(
    curves: dict[tuple[str, str], list[Record]]
) -> list[tuple[float, float]]:
    """Return step and time where curves of two techniques cross that have all else in common."""
    found = []
    for one, other in combinations(curves, 2):
        if one[0] == other[0] or one[1] != other[1]:
            continue
        times = [
            {row.step_voxels: row.frame_ms.median for row in curves[key]}
            for key in (one, other)
        ]
        steps = sorted(set(times[0]) & set(times[1]))
        logs = [np.log([item[step] for step in steps]) for item in times]
        for place, _ in crossings(np.log(steps), logs[0] - logs[1]):
            height = np.interp(place, np.log(steps), logs[0])
            found.append((math.exp(place), math.exp(height)))
    return found


def thread_rows(rows: list[Record]) -> list[Record]:
    """Return the rows that name their threads, fewest first."""
    return sorted(
        (row for row in rows if row.settings.get("slice_threads")),
        key=lambda row: row.settings["slice_threads"],
    )


def thread_panel(axes: Any, rows: list[Record], drawn: Drawn) -> None:
    """The rate by the threads that make slices, with quartiles."""
    threads = thread_rows(rows)
    counts = sorted({row.settings["slice_threads"] for row in threads})
    for step in dict.fromkeys(row.step_voxels for row in threads):
        curve = [row for row in threads if row.step_voxels == step]
        spreads = [row.frame_ms for row in curve]
        rates = np.array([1000 / item.median for item in spreads])
        below = rates - [1000 / item.q3 for item in spreads]
        above = [1000 / item.q1 for item in spreads] - rates
        axes.errorbar(
            [row.settings["slice_threads"] for row in curve],
            rates,
            yerr=np.array([below, above]),
            marker="o",
            markersize=3,
            capsize=2,
            label=f"step {step:.3g}",
        )
    axes.set_xscale("log", base=2)
    axes.set_xticks(counts, [str(count) for count in counts])
    axes.set_ylim(bottom=0)
    axes.set_xlabel("threads that make the slices")
    axes.set_ylabel("frames per second (quartiles)")


def shaped(rows: list[Record]) -> list[tuple[int, int, Record]]:
    """Return the exponents of width and height of each row with a work group of its own."""
    found = []
    for row in rows:
        shape = _SHAPE.fullmatch(str(row.settings.get("work_group_shape", "")))
        if shape:
            found.append((*(int(math.log2(int(side))) for side in shape.groups()), row))
    return found


def shape_panel(axes: Any, rows: list[Record], drawn: Drawn) -> None:
    """The fastest time with each shape, whatever else is set."""
    found = shaped(rows)
    size = (
        1 + max(height for _, height, _ in found),
        1 + max(width for width, _, _ in found),
    )
    times = np.full(size, np.nan)
    for width, height, row in found:
        times[height, width] = np.nanmin([times[height, width], row.frame_ms.median])
    axes.imshow(times, cmap="viridis_r", origin="lower", aspect="auto")
    low, high = np.nanmin(times), np.nanmax(times)
    for (height, width), value in np.ndenumerate(times):
        if not np.isnan(value):
            dark = value - low > DARK * (high - low)
            axes.text(
                *(width, height, f"{value:.3g}" if value < 1000 else f"{value:.0f}"),
                ha="center",
                va="center",
                fontsize=6.5,
                color="white" if dark else "black",
            )
    for axis, count in ((axes.xaxis, size[1]), (axes.yaxis, size[0])):
        axis.set_ticks(range(count), [str(2**power) for power in range(count)])
    axes.set_xlabel("width of a work group")
    axes.set_ylabel("height (ms in the cells)")


def pareto_panel(axes: Any, rows: list[Record], drawn: Drawn) -> None:
    """Error and time of every row, and the front of those that no other beats in both."""
    known = [row for row in rows if row.error.rmse]
    for row in known:
        axes.plot(
            row.frame_ms.median,
            row.error.rmse,
            "*" if is_peer(row) else "o",
            color=technique_color(row.technique),
            markersize=4,
            label=TECHNIQUES[row.technique].title,
        )
    front: list[tuple[float, float]] = []
    for time, error in sorted((row.frame_ms.median, row.error.rmse) for row in known):
        if not front or error < front[-1][1]:
            front.append((time, error))
    axes.step(*zip(*front), where="post", color="#9aa0ab", linewidth=1, zorder=0)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("time of one frame (ms)")
    axes.set_ylabel("RMSE against the reference")
    log_ticks(axes.xaxis)
    log_ticks(axes.yaxis)
