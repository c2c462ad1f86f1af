"""Colours, words, ticks and style that all figures share."""

from typing import Any

from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

PEER_COLOR = "#3a3f4a"
COLORS = (
    "#0072b2",
    "#d55e00",
    "#009e73",
    "#cc79a7",
    "#e69f00",
    "#56b4e9",
    "#7a5195",
    "#8c564b",
)
PATH_TITLES = {
    "engine": "engine: the filter's own window",
    "view": "view: ParaView, still render",
    "interactive": "interactive: ParaView while dragging",
    "remote": "remote: client and server",
}
STYLE = {
    "font.size": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#9aa0ab",
    "axes.titlesize": 10,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.axisbelow": True,
    "grid.color": "#e4e6ea",
    "legend.frameon": False,
    "figure.dpi": 130,
    "svg.hashsalt": "volumebench",  # the same figure is the same file
}

FEW_TICKS = (1, 2, 5)  # of a decade


def log_ticks(axis: Any) -> None:
    """Write plain numbers along a logarithmic axis, as many as its range has room for."""
    low, high = axis.get_view_interval()
    every = tuple(range(1, 10)) if high < 5 * low else FEW_TICKS
    axis.set_major_locator(
        LogLocator(base=10, subs=(1,) if high > 1e3 * low else every)
    )
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
