"""The walk of Documentation/walk.md in ParaView's window, which keeps its pictures.

Run by Testing/EndToEnd/Gui/start_paraview.py. Environment: VOLUMEBENCH_WALK, a volume file;
VOLUMEBENCH_PICTURES, the folder for the pictures.
"""

import os
from pathlib import Path

from paraview import simple
from PyQt5.QtCore import QTimer
from PyQt5.QtWidgets import QComboBox, QLineEdit, QScrollArea, QSlider
from window import (
    application,
    apply,
    display_panel,
    dock,
    main_window,
    menu_entry,
    press,
    represent,
    row,
    rows,
    save_window,
    settle,
    slide,
    trigger,
    wait_until,
)

VOLUME = Path(os.environ["VOLUMEBENCH_WALK"])
PICTURES = Path(os.environ["VOLUMEBENCH_PICTURES"])


def keep(name: str) -> None:
    save_window(PICTURES / f"walk-{name}.png")


def check_the_walk() -> None:
    widen_panel()
    open_volume()
    display = choose_technique()
    edit(display)
    estimate(display)
    measure()


def widen_panel() -> None:
    panel, browser = dock("propertiesDock"), dock("pipelineBrowserDock")
    main_window().resizeDocks([panel], [430], 1)
    main_window().resizeDocks([browser, panel], [120, 800], 2)
    settle(300)


def open_volume() -> None:
    """File > Open, the file's name, OK, Apply."""
    answer = QTimer(main_window())

    def name_the_file() -> None:
        dialog = application().activeModalWidget()
        if dialog and dialog.findChild(QLineEdit, "EntityName"):
            answer.stop()
            dialog.findChild(QLineEdit, "EntityName").setText(str(VOLUME))
            press(dialog, "OK")

    answer.timeout.connect(name_the_file)  # the dialog keeps the line below waiting
    answer.start(300)
    menu_entry("File", "Open...").trigger()
    wait_until(lambda: simple.GetActiveSource(), "the file's reader")
    apply()
    settle(500)
    keep("1-open")


def choose_technique() -> object:
    listed = row("Representation").findChild(QComboBox)
    assert listed.findText("Volume Compute") >= 0
    represent("Volume Compute")
    view = simple.GetActiveView()
    camera = view.GetActiveCamera()
    camera.Azimuth(30)
    camera.Elevation(20)
    simple.ResetCamera(view)
    simple.Render(view)
    keep("2-compute")
    return simple.GetDisplayProperties()


def edit(display: object) -> None:
    """The colour map's editor, and the step."""
    press(row("ColorEditor"), "EditColorMap")
    editor = dock("colorMapEditorDock")
    wait_until(editor.isVisible, "the Color Map Editor")
    slide(row("StepVoxels").findChild(QSlider), 0.25)
    assert 0.9 < display.StepVoxels < 1.1, display.StepVoxels
    settle(500)
    keep("3-edit")
    editor.hide()


def estimate(display: object) -> None:
    press(display_panel(), "Estimate Error")
    wait_until(lambda: (display.ErrorText or "").startswith("RMSE"), "an error", 120)
    wait_until(lambda: "ErrorRmse" in rows(display_panel()), "its row")
    area = dock("propertiesDock").findChild(QScrollArea, "scrollArea")
    area.ensureWidgetVisible(row("LastFrameMs"))
    keep("4-error")


def measure() -> None:
    trigger("Filters", "Volume", "Volume Benchmark")
    source = simple.GetActiveSource()
    source.ImageSize = [200, 200]
    source.TimeLimit = 1.0
    source.StepVoxels = [2.0, 1.0, 0.5]
    apply()
    wait_until(lambda: len(simple.GetViews()) == 3, "table and chart")
    settle(500)
    keep("5-benchmark")
