"""Figures of a study: frames per second, and image error against time with one curve each."""

import base64
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from .error import EIGHT_BIT_RMSE  # noqa: E402
from .errors import OutputError  # noqa: E402
from .plot_style import COLORS, PATH_TITLES, PEER_COLOR, STYLE, log_ticks  # noqa: E402
from .results import OK, Record  # noqa: E402
from .study import Scene  # noqa: E402
from .summary import in_scene, is_peer, lines, sampling_text  # noqa: E402
from .summary import scenes_of, shared_settings, standard_rows  # noqa: E402
from .techniques import PARAVIEW, TECHNIQUES  # noqa: E402
from .work_precision_plot import sweep_figure  # noqa: E402

LABEL_ROOM = 1.3  # times as long: closer dots share the label of their step
FOLDER = "plots"
EIGHT_BIT_LABEL = "rounding of an 8-bit screen"
DOUBT_LABEL = "uncertainty of the reference"


def technique_color(technique: str) -> str:
    """Return the colour of a technique, the same in every figure."""
    if TECHNIQUES[technique].peer:
        return PEER_COLOR
    ours = [name for name, item in TECHNIQUES.items() if not item.peer]
    return COLORS[ours.index(technique) % len(COLORS)]


def error_plot_file(scene: Scene) -> str:
    """Return the name of a scene's error figure."""
    return f"error-time-{scene.file_stem()}.png"


def fps_plot_file(scene: Scene) -> str:
    """Return the name of a scene's speed figure."""
    return f"fps-{scene.file_stem()}.png"


def write_plots(folder: Path, records: list[Record], swept: bool = False) -> None:
    """Write the figures of each scene that has something to show."""
    error_figure = sweep_figure if swept else _error_figure
    target = folder / FOLDER
    shared = shared_settings(records)
    for scene in scenes_of(records):
        rows = [row for row in in_scene(records, scene) if row.status == OK]
        with plt.rc_context(STYLE):
            if any(row.error.rmse for row in rows):
                save_figure(error_figure(rows), target / error_plot_file(scene))
            if rows:
                save_figure(_fps_figure(rows, shared), target / fps_plot_file(scene))


def inlined(path: Path) -> str:
    """Return a picture as the address of itself."""
    content = base64.b64encode(path.read_bytes()).decode("ascii")
    return f"data:image/png;base64,{content}"


def save_figure(figure: Any, path: Path) -> None:
    """Write a figure as PNG and as SVG beside it, and close it."""
    try:
        path.parent.mkdir(exist_ok=True)
        for file in (path, path.with_suffix(".svg")):
            figure.savefig(file, bbox_inches="tight", facecolor="white")
    except OSError as fault:
        raise OutputError(f"{path}: cannot be written: {fault.strerror}") from None
    finally:
        plt.close(figure)


def _error_figure(rows: list[Record]) -> Any:
    """One panel per path, all with the same axes."""
    timed = [row for row in rows if row.error.rmse and row.frame_ms.median]
    shown = standard_rows(timed)
    paths = list(dict.fromkeys(row.path for row in shown))
    figure, panels = plt.subplots(
        1,
        len(paths),
        figsize=(max(5.2, 3.9 * len(paths)), 3.6),
        sharex=True,
        sharey=True,
        squeeze=False,
    )
    for panel, path in zip(panels[0], paths):
        _error_panel(panel, [row for row in shown if row.path == path])
        panel.set_title(PATH_TITLES[path])
        panel.set_xlabel("time of one frame (ms)")
        _limit_errors(panel, shown)
    panels[0][0].set_ylabel("RMSE against the reference")
    handles: dict[str, Any] = {}
    for panel in panels[0]:
        for handle, label in zip(*panel.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    for label in (EIGHT_BIT_LABEL, DOUBT_LABEL):
        if label in handles:
            handles[label] = handles.pop(label)
    figure.tight_layout()
    figure.legend(
        handles.values(),
        handles.keys(),
        loc="upper center",
        bbox_to_anchor=(0.5, 0.0),
        ncol=min(len(handles), 5),
    )
    return figure


def _error_panel(panel: Any, rows: list[Record]) -> None:
    panel.set_xscale("log")
    panel.set_yscale("log")
    panel.grid(True, which="major")
    panel.margins(x=0.12)
    for technique, integrator in dict.fromkeys(
        (row.technique, row.integrator) for row in rows
    ):
        curve = [
            row
            for row in rows
            if (row.technique, row.integrator) == (technique, integrator)
        ]
        if is_peer(curve[0]):
            _peer_star(panel, curve[0])
        else:
            _curve(panel, curve)
    panel.axhline(
        EIGHT_BIT_RMSE,
        color="#b0b5bf",
        linewidth=1,
        linestyle=(0, (1, 2)),
        label=EIGHT_BIT_LABEL,
    )
    log_ticks(panel.xaxis)


def _limit_errors(panel: Any, rows: list[Record]) -> None:
    """Frame the measured errors; shade those that the reference is too coarse for."""
    errors = [row.error.rmse for row in rows]
    bottom, top = min(errors) / 2.5, max(errors) * 2.5
    panel.set_ylim(bottom, top)
    doubt = max(row.error.reference_uncertainty or 0 for row in rows)
    if doubt > bottom:
        panel.axhspan(
            bottom, doubt, color="#f1ddd8", linewidth=0, zorder=0, label=DOUBT_LABEL
        )


def _peer_star(panel: Any, row: Record) -> None:
    title = TECHNIQUES[row.technique].title
    x, y = row.frame_ms.median, row.error.rmse
    face = "#f2b705" if row.technique == PARAVIEW else "#b9bec8"
    panel.scatter(
        x, y, marker="*", s=190, color=face, edgecolor=PEER_COLOR, zorder=5, label=title
    )


def _curve(panel: Any, rows: list[Record]) -> None:
    ordered = sorted(rows, key=lambda row: row.step_voxels or 0)
    x = [row.frame_ms.median for row in ordered]
    y = [row.error.rmse for row in ordered]
    first = ordered[0]
    left = first.integrator == "Left"
    panel.plot(
        x,
        y,
        color=technique_color(first.technique),
        linestyle="--" if left else "-",
        marker="o",
        markersize=4.5,
        markerfacecolor="white" if left else technique_color(first.technique),
        linewidth=1.6,
        label=f"{TECHNIQUES[first.technique].title}, {first.integrator}",
    )
    if not left and len(ordered) > 1:
        for row, side in ((ordered[0], (5, 3)), (ordered[-1], (-8, -12))):
            _label_step(panel, row, side)


def _label_step(panel: Any, row: Record, side: tuple[int, int]) -> None:
    """Write the step beside a dot, unless the same words stand there already."""
    words = f"step {row.step_voxels:g}"
    time, error = row.frame_ms.median, row.error.rmse
    for text in panel.texts:
        apart = max(
            time / text.xy[0], text.xy[0] / time, error / text.xy[1], text.xy[1] / error
        )
        if text.get_text() == words and apart < LABEL_ROOM:
            return
    panel.annotate(
        words,
        (time, error),
        xytext=side,
        textcoords="offset points",
        fontsize=7,
        color="#5b616d",
    )


def _fps_figure(rows: list[Record], shared: frozenset[str]) -> Any:
    """Bars of frames per second at equal or smaller error, one group per path."""
    shown = lines(rows)
    labels = [_bar_label(line.record, shared) for line in shown]
    height = 0.34 * len(shown) + 0.9
    figure, panel = plt.subplots(figsize=(6.4, height))
    positions, ticks = [], []
    top, previous = 0.0, None
    for line in shown:
        top += 1.0 if line.record.path == previous else 1.6
        previous = line.record.path
        positions.append(top)
        ticks.append(top)
    speeds = [line.record.fps or 0 for line in shown]
    colors = [technique_color(line.record.technique) for line in shown]
    panel.barh(positions, speeds, color=colors, height=0.78)
    for line, position, speed in zip(shown, positions, speeds):
        factor = line.speed_up() if line.matched else None
        text = f" {speed:.1f}" + (f"  ({factor:.1f}x)" if factor else "")
        panel.text(speed, position, text, va="center", fontsize=8)
    panel.set_yticks(ticks, labels)
    panel.invert_yaxis()
    panel.set_xlim(0, max(speeds) * 1.22 or 1)
    panel.grid(True, axis="x")
    panel.tick_params(axis="y", length=0)
    peers = any(line.peer for line in shown)
    words = " (in brackets: against the peer of that path)" if peers else ""
    panel.set_xlabel(f"frames per second{words}")
    return figure


def _bar_label(record: Record, shared: frozenset[str]) -> str:
    title = TECHNIQUES[record.technique].title
    sampling = (
        "" if record.step_voxels is None else f" ({sampling_text(record, shared)})"
    )
    return f"{record.path}: {title}{sampling}"
