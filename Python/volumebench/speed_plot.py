"""The frame-time ratio of each scene as bars with their intervals."""

from typing import Any

import matplotlib.pyplot as plt

from .plot_style import COLORS, PEER_COLOR
from .results import Record
from .speed import LEVEL, Ratio, ratios
from .work_precision import geometric_mean

BAR_HEIGHT = 0.38


def ratio_figure(records: list[Record]) -> Any | None:
    """Return two bars for each scene: at ParaView's own error, and at the level; None without any."""
    groups = (
        ("at ParaView's own error", COLORS[0], ratios(records)),
        (
            f"at an RMSE of {LEVEL:g} or ParaView's own",
            COLORS[5],
            ratios(records, LEVEL),
        ),
    )
    if not any(item.ours for _, _, items in groups for item in items):
        return None
    scenes = [item.scene for item in groups[0][2]]
    figure, panel = plt.subplots(figsize=(7.2, 0.5 * len(scenes) + 1.4))
    for index, (label, color, items) in enumerate(groups):
        _bars(panel, items, (index - 0.5) * BAR_HEIGHT, label, color)
        known = [item.factor() for item in items if item.ours]
        if known:
            panel.axvline(
                geometric_mean(known), color=color, linewidth=1, linestyle=":"
            )
    panel.axvline(1, color=PEER_COLOR, linewidth=1)
    panel.set_yticks(
        range(len(scenes)),
        [scene_label(item) for item in groups[0][2]],
    )
    panel.invert_yaxis()
    panel.grid(True, axis="x")
    panel.set_xlim(left=0)
    panel.set_xlabel(
        "frame time of ParaView's Volume over ours (dotted: geometric mean)"
    )
    panel.legend(loc="upper center", bbox_to_anchor=(0.4, -0.12), ncol=2)
    return figure


def scene_label(item: Ratio) -> str:
    """Return the scene without its size, and whether a generated volume stands in."""
    label = f"{item.scene.dataset}, {item.scene.transfer_function}"
    return f"{label} (stand-in)" if item.paraview.stand_in_for else label


def _bars(
    panel: Any, items: list[Ratio], offset: float, label: str, color: str
) -> None:
    for place, item in enumerate(items):
        if item.ours is None:
            panel.text(0.05, place + offset, "not reached", va="center", fontsize=7)
            continue
        factor, (low, high) = item.factor(), item.interval()
        panel.barh(
            place + offset,
            factor,
            height=BAR_HEIGHT,
            color=color,
            label=label,
            xerr=[[factor - low], [high - factor]],
            error_kw={"elinewidth": 1, "capsize": 2, "ecolor": PEER_COLOR},
        )
        text = f"  {'>= ' if item.ours.is_bound else ''}{factor:.1f}"
        panel.text(high, place + offset, text, va="center", fontsize=7)
        label = "_nolegend_"
