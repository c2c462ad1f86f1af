"""The pictures of Documentation/walk.md: made, or compared with those of the page.

Times differ from run to run and from machine to machine, so the parts of the window that show any are left
out of the comparison: what is drawn, every row, every label and every other value has to be as in the page.
"""

import os
from pathlib import Path

import numpy as np
from PyQt5.QtCore import QPoint, QRect
from PyQt5.QtWidgets import QFrame, QLabel, QLineEdit, QScrollArea, QWidget
from support import read_png, rmse
from window import display_panel, dock, main_window, report, rows, save_window

KEPT = Path(__file__).resolve().parents[3] / "Documentation" / "Pictures"
SAME_WINDOW = 0.003  # RMSE; a word that moves or changes is beyond
TIMED_ROWS = ("ErrorText", "ReferenceSeconds", "FrameMs", "LastFrameMs")
TIMED_VIEW = "ErroragainstTime"
STATUS_BAR = 36  # pixels, where the window tells how much memory the machine's programs use
LEAST_COMPARED = 0.7  # share of the window


class Pictures:
    """Pictures of the window in a folder, and where each shows times."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.timed: dict[str, list[QRect]] = {}
        folder.mkdir(exist_ok=True)

    def save(self, name: str) -> None:
        """Save a picture of the window as it is now."""
        path = self.folder / f"walk-{name}.png"
        save_window(path)
        self.timed[path.name] = timed_parts()

    def compare(self) -> None:
        """Fail unless the window looked as in the page; leave the pictures where it did not."""
        kept = {one.name for one in KEPT.glob("walk-*.png")}
        assert set(self.timed) == kept, (set(self.timed), kept)
        differs = []
        for name, timed in self.timed.items():
            ours, theirs = self.folder / name, KEPT / name
            error = rmse(without(ours, timed), without(theirs, timed))
            report(f"  {name}: RMSE {error:.4f} (at most {SAME_WINDOW})")
            if error > SAME_WINDOW:
                differs.append(name)
                keep = Path(os.environ["VOLUMEBENCH_DIFFERENT"])
                keep.mkdir(parents=True, exist_ok=True)
                (keep / name).write_bytes(ours.read_bytes())
        assert not differs, f"{differs} differ; Documentation/Build/walk.sh makes them anew"


def without(path: Path, timed: list[QRect]) -> np.ndarray:
    """Return a picture of the window without the status bar, and with the parts that show times white."""
    seen = read_png(path)[:-STATUS_BAR].copy()
    compared = np.ones(seen.shape[:2], bool)
    for part in timed:
        compared[part.top() : part.bottom() + 1, part.left() : part.right() + 1] = False
    assert compared.mean() > LEAST_COMPARED, f"{compared.mean():.2f} of {path.name}"
    seen[~compared] = 1.0
    return seen


def timed_parts() -> list[QRect]:
    """Return where the window shows times, in its pixels: fields that are in sight, and the chart."""
    panel, parts = display_panel(), []
    area = dock("propertiesDock").findChild(QScrollArea, "scrollArea")
    for name, row in rows(panel).items() if panel else ():
        if name in TIMED_ROWS:
            parts.append(place(row.findChild(QLineEdit)) & place(area.viewport()))
    for drawn in main_window().centralWidget().findChildren(QFrame, "CentralWidgetFrame"):
        titles = drawn.parent().findChildren(QLabel)
        if drawn.isVisible() and any(TIMED_VIEW in one.text() for one in titles):
            parts.append(place(drawn))
    return [one for one in parts if not one.isEmpty()]


def place(widget: QWidget) -> QRect:
    """Return where a widget is, in the window's pixels."""
    return QRect(widget.mapTo(main_window(), QPoint(0, 0)), widget.size())
