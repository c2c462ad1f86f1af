"""Colours, words and style that all figures share."""

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
