"""Error against time of a sweep: a curve per method, the front, and the peers, in log-log."""

from typing import Any

import matplotlib.pyplot as plt

from .plot_style import COLORS, PATH_TITLES, PEER_COLOR, log_ticks
from .results import Record
from .summary import PEER_DISTANCE, is_peer, sample_distance
from .technique_settings import settings_text
from .techniques import PARAVIEW, TECHNIQUES
from .work_precision import NEVER_STOPPING, Point, front_of, is_doubtful, points_of

GREY = "#b5bac4"
FRONT_COLOR = "#f2b705"
MARKERS = ("o", "s", "^", "v", "D", "P", "X", "<", ">")
SECONDS = 1e-3


def sweep_figure(rows: list[Record]) -> Any:
    """One panel per path, all with the same axes: RMSE over seconds per frame."""
    points = points_of(rows)
    paths = list(dict.fromkeys(point.record.path for point in points))
    figure, panels = plt.subplots(
        1,
        len(paths),
        figsize=(max(6.0, 5.2 * len(paths)), 4.6),
        sharex=True,
        sharey=True,
        squeeze=False,
    )
    styles = _styles(points)
    for panel, path in zip(panels[0], paths):
        _panel(panel, [item for item in points if item.record.path == path], styles)
        panel.set_title(PATH_TITLES[path])
        panel.set_xlabel("time of one frame (s)")
    panels[0][0].set_ylabel("RMSE against the reference")
    for panel in panels[0]:
        _guides(panel)
    handles: dict[str, Any] = {}
    for panel in panels[0]:
        for handle, label in zip(*panel.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    figure.tight_layout()
    figure.legend(
        handles.values(),
        handles.keys(),
        loc="upper center",
        bbox_to_anchor=(0.5, 0.0),
        ncol=3,
    )
    return figure


def _method(record: Record) -> str:
    """Return the name of the curve of a run: settings that vary make points, not curves."""
    title = TECHNIQUES[record.technique].title
    if is_peer(record):
        return title
    text = f"{title}, {record.integrator}"
    if record.settings == NEVER_STOPPING:
        text += ", rays never stop"
    elif record.settings:
        text += f", other {' and '.join(record.settings).replace('_', ' ')}"
    return text


def _styles(points: list[Point]) -> dict[str, tuple[str, str]]:
    """Return colour and marker of each method, the same in all panels.

    Settings do not change the colour of an integrator, but its marker.
    """
    ours = [point.record for point in points if not is_peer(point.record)]
    colors = list(dict.fromkeys(_sampling(record) for record in ours))
    names = {_method(record): _sampling(record) for record in ours}
    return {
        name: (
            COLORS[colors.index(sampling) % len(COLORS)],
            MARKERS[index % len(MARKERS)],
        )
        for index, (name, sampling) in enumerate(names.items())
    }


def _sampling(record: Record) -> tuple[str, str | None]:
    return record.technique, record.integrator


def _panel(panel: Any, points: list[Point], styles: dict[str, tuple[str, str]]) -> None:
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.grid(True, which="major")
    methods: dict[str, list[Point]] = {}
    for point in points:
        methods.setdefault(_method(point.record), []).append(point)
    front = front_of(points)
    panel.plot(
        [point.ms * SECONDS for point in front],
        [point.rmse for point in front],
        color=FRONT_COLOR,
        alpha=0.45,
        linewidth=7,
        solid_capstyle="round",
        zorder=1,
        label="Pareto front",
    )
    for name, curve in methods.items():
        if is_peer(curve[0].record):
            _peer(panel, name, curve)
        else:
            _curve(panel, name, curve, *styles[name])
    log_ticks(panel.xaxis)


def _curve(panel: Any, name: str, points: list[Point], color: str, marker: str) -> None:
    """Draw a method: joined along its steps, or loose points where settings vary."""
    given = points[0].record.settings
    never_stopping = given == NEVER_STOPPING
    settings = bool(given) and not never_stopping
    ordered = sorted(points, key=lambda point: point.record.step_voxels)
    x = [point.ms * SECONDS for point in ordered]
    y = [point.rmse for point in ordered]
    panel.plot(
        x,
        y,
        color=color,
        marker=marker,
        markersize=5,
        linestyle="none" if settings else ":" if never_stopping else "-",
        markerfacecolor="white" if given else color,
        linewidth=1.4,
        label=name,
        zorder=3,
    )
    _grey_doubtful(panel, ordered, marker)
    ends = () if never_stopping else (ordered[0], ordered[-1])
    for point in ordered if settings else ends:
        record = point.record
        words = f"step {record.step_voxels:g}"
        if settings:
            words = settings_text(record.settings).split(" ")[-1]
        _words(panel, point, words)


def _peer(panel: Any, name: str, points: list[Point]) -> None:
    """Draw a peer: its sample distances joined, what ParaView takes starred."""
    ordered = sorted(points, key=lambda point: sample_distance(point.record))
    x = [point.ms * SECONDS for point in ordered]
    y = [point.rmse for point in ordered]
    if len(points) > 1:
        panel.plot(x, y, color=PEER_COLOR, marker="d", markersize=6, label=name)
        _grey_doubtful(panel, ordered, "d")
        for point in (ordered[0], ordered[-1]):
            _words(panel, point, f"distance {sample_distance(point.record):g}")
    for point in ordered:
        if sample_distance(point.record) == PEER_DISTANCE:
            own = point.record.technique == PARAVIEW
            panel.scatter(
                point.ms * SECONDS,
                point.rmse,
                marker="*",
                s=210,
                color=FRONT_COLOR if own else GREY,
                edgecolor=PEER_COLOR,
                zorder=5,
                label=f"{name}, default",
            )


def _grey_doubtful(panel: Any, points: list[Point], marker: str) -> None:
    doubtful = [point for point in points if is_doubtful(point.record)]
    if doubtful:
        panel.scatter(
            [point.ms * SECONDS for point in doubtful],
            [point.rmse for point in doubtful],
            marker=marker,
            s=26,
            color=GREY,
            zorder=4,
            label="grey: below what the reference can tell",
        )


def _words(panel: Any, point: Point, words: str) -> None:
    panel.annotate(
        words,
        (point.ms * SECONDS, point.rmse),
        xytext=(5, 4),
        textcoords="offset points",
        fontsize=6.5,
        color="#5b616d",
    )


def _guides(panel: Any) -> None:
    """Draw slopes of order 1 and 2 from the top left corner: half the step takes twice the time."""
    left, right = panel.get_xlim()
    bottom, top = panel.get_ylim()
    for order, dashes in ((1, (0, (5, 4))), (2, (0, (1, 2)))):
        end = min(right, left * (top / bottom) ** (1 / order))
        panel.plot(
            [left, end],
            [top, top * (left / end) ** order],
            color="#9aa0ab",
            linestyle=dashes,
            linewidth=1,
            zorder=0,
            label=f"slope of order {order}",
        )
    panel.set_xlim(left, right)
    panel.set_ylim(bottom, top)
