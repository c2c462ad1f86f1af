"""Growth along each series: a panel for each quantity, log-log, with the fitted lines."""

from collections.abc import Callable
from functools import partial
from typing import Any

import matplotlib.pyplot as plt
from matplotlib.ticker import NullFormatter

from .plot import technique_color
from .results import Record
from .scaling import FACTOR_TITLES, Growth, growths
from .study import Series, Study
from .techniques import TECHNIQUES

MARKERS = ("o", "s", "^", "D", "v")


def series_figures(
    study: Study, records: list[Record]
) -> dict[str, tuple[str, Callable[[], Any | None]]]:
    """Return by file name the title of each figure and what makes it."""
    found = growths(study, records)
    return {
        f"scaling-{index + 1}-{series.factor}.png": (
            series.title,
            partial(_figure, series, [item for item in found if item.series == series]),
        )
        for index, series in enumerate(study.series)
    }


def _figure(series: Series, found: list[Growth]) -> Any | None:
    quantities = list(dict.fromkeys(item.quantity for item in found))
    if not quantities:
        return None
    figure, panels = plt.subplots(
        1, len(quantities), figsize=(3.9 * len(quantities), 3.7), squeeze=False
    )
    for panel, quantity in zip(panels[0], quantities):
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.grid(True, which="major")
        own = [item for item in found if item.quantity == quantity]
        for index, item in enumerate(own):
            _growth(panel, item, MARKERS[index % len(MARKERS)])
        panel.set_title(quantity)
        panel.set_xlabel(FACTOR_TITLES[series.factor])
        places = sorted({x for item in own for x, _ in item.points})
        panel.set_xticks(places, [f"{x:.4g}" for x in places])
        panel.xaxis.set_minor_formatter(NullFormatter())
        panel.tick_params(axis="x", labelrotation=30)
        panel.legend(fontsize=7)
    figure.suptitle(series.title, x=0.01, ha="left", fontsize=10)
    figure.tight_layout()
    return figure


def _growth(panel: Any, item: Growth, marker: str) -> None:
    x = [point[0] for point in item.points]
    color = technique_color(item.technique)
    label = f"{TECHNIQUES[item.technique].title}: {item.exponent_text()}"
    panel.plot(
        x,
        [point[1] for point in item.points],
        color=color,
        marker=marker,
        markersize=5,
        linestyle="none",
        label=label,
    )
    fit = item.fit()
    if fit is not None:
        ends = [min(x), max(x)]
        panel.plot(ends, [fit.at(end) for end in ends], color=color, linewidth=1.2)
