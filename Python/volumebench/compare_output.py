"""Writes a comparison: a figure, a page, and all runs as CSV."""

import csv
import io
from html import escape
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt

from .compare import FASTER, SLOWER, Change, Comparison, change_tables, summary_of
from .html_table import html_table
from .json_file import make_writable_folder, write_atomically
from .page import page
from .plot import inlined, save_figure
from .plot_style import STYLE
from .summary import describe

MOST_BARS = 40
_COLORS = {FASTER: "#009e73", SLOWER: "#d55e00"}
_FIGURE = "compare.png"


def write_comparison(folder: Path, comparison: Comparison, title: str) -> None:
    """Write compare.html, compare.csv and the figure."""
    make_writable_folder(folder)
    with plt.rc_context(STYLE):
        save_figure(_figure(comparison), folder / _FIGURE)
    write_atomically(folder / "compare.csv", _csv(comparison))
    sentences = "".join(f"<li>{escape(text)}</li>" for text in summary_of(comparison))
    body = (
        f'<header><p class="kicker">VolumeBench</p><h1>{escape(title)}</h1></header>'
        f"<section><ul>{sentences}</ul>"
        f'<img class="plot" alt="Frame time, new over old" src="{inlined(folder / _FIGURE)}">'
        f"{''.join(map(html_table, change_tables(comparison)))}</section>"
    )
    write_atomically(folder / "compare.html", page(title, body))


def _figure(comparison: Comparison) -> Any:
    """One bar of uncertainty per run, the largest changes on top; and both errors, if known."""
    order = sorted(comparison.changes, key=lambda item: abs(1 - item.ratio.value))
    shown = order[-MOST_BARS:]
    errors = [item for item in comparison.changes if item.accuracy]
    panels = 2 if errors else 1
    figure, axes = plt.subplots(
        *(1, panels),
        figsize=(6.4 + 4 * (panels - 1), 0.22 * len(shown) + 1.4),
        squeeze=False,
        gridspec_kw={"width_ratios": [3, 2][:panels]},
    )
    _ratios(axes[0][0], shown, comparison.margin)
    if errors:
        _errors(axes[0][1], errors)
    figure.tight_layout()
    return figure


def _ratios(panel: Any, shown: list[Change], margin: float) -> None:
    panel.axvspan(1 / (1 + margin), 1 + margin, color="#e4e6ea", linewidth=0)
    for place, item in enumerate(shown):
        ratio = item.ratio
        color = _COLORS.get(item.speed, "#7a808c")
        if ratio.low is not None:
            panel.plot(
                [ratio.low, ratio.high], [place, place], color=color, linewidth=2
            )
        panel.plot([ratio.value], [place], "o", color=color, markersize=4)
    panel.set_yticks(
        range(len(shown)), [describe(item.new) for item in shown], fontsize=6
    )
    panel.set_xscale("log")
    panel.set_xlabel("frame time, new over old (left is faster)")


def _errors(panel: Any, shown: list[Change]) -> None:
    x = [item.old.error.rmse for item in shown]
    y = [item.new.error.rmse for item in shown]
    positive = [value for value in (*x, *y) if value]
    if positive:
        ends = [min(positive) / 2, max(positive) * 2]
        panel.plot(ends, ends, color="#9aa0ab", linewidth=1)
        panel.set_xscale("log")
        panel.set_yscale("log")
    panel.scatter(x, y, s=14, color="#0072b2")
    panel.set_xlabel("old RMSE")
    panel.set_ylabel("new RMSE")


def _csv(comparison: Comparison) -> str:
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(
        "run old_ms new_ms ratio low high speed noise_from old_rmse new_rmse accuracy".split()
    )
    for item in comparison.changes:
        ratio = item.ratio
        writer.writerow(
            [
                *(
                    describe(item.new),
                    item.old.frame_ms.median,
                    item.new.frame_ms.median,
                ),
                *(ratio.value, ratio.low, ratio.high, item.speed, item.sample.basis),
                *(item.old.error.rmse, item.new.error.rmse, item.accuracy),
            ]
        )
    return stream.getvalue()
