"""The stability heat map as a figure, for pages and papers that take no HTML."""

from pathlib import Path

from matplotlib.patches import Rectangle

from .plot import FOLDER, plt, save_figure
from .stability import FAIL, Outcome, Row
from .stability_colors import BLANK, color_of
from .stability_report import cell_text
from .techniques import TECHNIQUES

FILE = "stability.png"
_CELL_WIDTH = 0.62  # inches
_CELL_HEIGHT = 0.19
_TITLE_WIDTH = 2.7


def write_stability_plot(folder: Path, outcome: Outcome) -> None:
    """Write plots/stability.png."""
    columns = outcome.columns()
    height = len(outcome.cases)
    size = (
        _TITLE_WIDTH + _CELL_WIDTH * len(columns),
        1.1 + _CELL_HEIGHT * height,
    )
    figure, axes = plt.subplots(figsize=size, layout="constrained")
    for y, case in enumerate(outcome.cases):
        for x, column in enumerate(columns):
            _draw_cell(axes, x, y, outcome.row(case.number, column))
    axes.set_xlim(0, len(columns))
    axes.set_ylim(height, 0)
    axes.set_xticks([x + 0.5 for x in range(len(columns))])
    axes.set_xticklabels([_head(column) for column in columns], rotation=60, ha="left")
    axes.xaxis.tick_top()
    axes.set_yticks([y + 0.5 for y in range(height)])
    axes.set_yticklabels([f"{case.number} {case.title}" for case in outcome.cases])
    axes.tick_params(length=0, labelsize=7)
    for side in axes.spines.values():
        side.set_visible(False)
    axes.set_xlabel(
        "log10(error / limit); framed: what the case is meant for; in brackets: controls",
        fontsize=7,
    )
    save_figure(figure, folder / FOLDER / FILE)


def _head(column: tuple[str, str | None]) -> str:
    technique, integrator = column
    title = TECHNIQUES[technique].title
    return f"{title}, {integrator}" if integrator else title


def _draw_cell(axes, x: int, y: int, row: Row | None) -> None:
    color = color_of(row.ratio_log10()) if row else BLANK
    axes.add_patch(Rectangle((x + 0.03, y + 0.06), 0.94, 0.88, color=color, lw=0))
    if row is None:
        return
    if row.meant:
        defect = row.status == FAIL
        frame = {"fill": False, "ec": "#a50026" if defect else "#3a3f4a"}
        frame["lw"] = 1.8 if defect else 0.6
        axes.add_patch(Rectangle((x + 0.03, y + 0.06), 0.94, 0.88, **frame))
    weight = "bold" if row.meant else "normal"
    place = {"ha": "center", "va": "center", "fontsize": 6}
    axes.text(x + 0.5, y + 0.52, cell_text(row), fontweight=weight, **place)
