"""ParaView's window in the hands of a test: its rows, buttons and menus, by the names users see.

Runs in ParaView's own process. PyQt5 is bound to the same Qt, so its widgets are ParaView's.
"""

import faulthandler
import html
import importlib
import os
import re
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from lost_memory import report_lost_memory
from paraview import simple
from patience import patient_s
from PyQt5.QtCore import QPoint, Qt, QTimer
from PyQt5.QtTest import QTest
from PyQt5.QtWidgets import (
    QAbstractButton,
    QAction,
    QApplication,
    QCheckBox,
    QComboBox,
    QDockWidget,
    QFrame,
    QLabel,
    QLineEdit,
    QMainWindow,
    QMenu,
    QSlider,
    QTreeView,
    QWidget,
)
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

PATIENCE_S = patient_s(40.0)
HANG_S = 270
SETTLED_MS = 150


def application() -> QApplication:
    return QApplication.instance()


def main_window() -> QMainWindow:
    return next(
        one for one in application().topLevelWidgets() if isinstance(one, QMainWindow)
    )


def settle(ms: int = SETTLED_MS) -> None:
    """Let ParaView do what it has put off; it draws from timers."""
    QTest.qWait(ms)


def wait_until(
    condition: Callable[[], Any], what: str, patience_s: float = PATIENCE_S
) -> Any:
    """Return the first true value of the condition."""
    end = time.monotonic() + patience_s
    while True:
        value = condition()
        if value:
            return value
        assert time.monotonic() < end, f"gave up waiting: {what}"
        QTest.qWait(50)


# --- what is where ---------------------------------------------------------------------------


def dock(name: str) -> QDockWidget:
    found = main_window().findChild(QDockWidget, name)
    assert found, f"there is no dock {name}"
    return found


def display_panel() -> QWidget:
    """The part of the Properties panel with the rows of the representation."""
    frame = dock("propertiesDock").findChild(QFrame, "DisplayFrame")
    return frame.findChild(QWidget, "ProxyPanel")


def source_panel() -> QWidget:
    """The part of the Properties panel with the rows of the source or filter."""
    frame = dock("propertiesDock").findChild(QFrame, "PropertiesFrame")
    return frame.findChild(QWidget, "ProxyPanel")


def rows(panel: QWidget) -> dict[str, QWidget]:
    """Return the rows that can be seen, from the property's name to its widget, in order."""
    return {
        one.objectName(): one
        for one in panel.children()
        if isinstance(one, QWidget)
        and one.isVisible()
        and one.objectName()
        and _class_of(one).endswith("Widget")
    }


def headings(panel: QWidget) -> list[str]:
    """Return the headings of the groups that can be seen."""
    found = []
    for one in panel.children():
        if (
            isinstance(one, QWidget)
            and one.isVisible()
            and _class_of(one) == "QWidget"
            and one.findChild(QLabel)
        ):
            found.append(_plain(one.findChild(QLabel).text()))
    return found


def row(name: str) -> QWidget:
    """Return a row of the representation, which must be in sight."""
    shown = rows(display_panel())
    assert name in shown, f"no row {name} among {', '.join(shown)}"
    return shown[name]


def labels(panel: QWidget) -> list[str]:
    """Return the texts before the rows that can be seen."""
    return [
        _plain(one.text())
        for one in panel.findChildren(QLabel)
        if one.isVisible() and one.parent() is panel
    ]


def tooltip(widget: QWidget) -> str:
    """Return what is shown when the mouse rests there."""
    while widget and not widget.toolTip():
        widget = widget.parent()
    return _plain(widget.toolTip()) if widget else ""


def representations() -> QComboBox:
    """The list of representations in the Properties panel."""
    return row("Representation").findChild(QComboBox)


def messages() -> list[str]:
    """Return what ParaView has put into its window for errors and warnings, new text last."""
    model = dock("outputWidgetDock").findChild(QTreeView).model()
    return [
        str(model.index(number, column).data())
        for number in range(model.rowCount())
        for column in range(model.columnCount())
    ]


def _class_of(widget: QWidget) -> str:
    return widget.metaObject().className()


def _plain(text: str) -> str:
    return " ".join(html.unescape(re.sub(r"<[^>]*>", " ", text)).split())


# --- hands -----------------------------------------------------------------------------------


def click(widget: QWidget, at: QPoint = QPoint()) -> None:
    """Click a widget that can be seen and used."""
    assert widget.isVisible(), f"{widget.objectName()} cannot be seen"
    assert widget.isEnabled(), f"{widget.objectName()} is greyed out"
    QTest.mouseClick(widget, Qt.LeftButton, Qt.NoModifier, at)
    settle()


def tick(name: str) -> None:
    """Switch the box of a row of the representation on or off."""
    box = row(name).findChild(QCheckBox)
    click(box, QPoint(8, box.height() // 2))


def press(parent: QWidget, name: str) -> None:
    """Press the button of this object name or text."""
    for one in parent.findChildren(QAbstractButton):
        if one.isVisible() and name in (one.objectName(), one.text()):
            click(one)
            return
    raise AssertionError(f"there is no button {name}")


def apply() -> None:
    """Press Apply, and wait until there is nothing left to apply."""
    button = dock("propertiesDock").findChild(QAbstractButton, "Accept")
    click(button)
    wait_until(lambda: not button.isEnabled(), "Apply")
    settle()


def advanced(shown: bool) -> None:
    """Show or hide the advanced rows."""
    button = dock("propertiesDock").findChild(QAbstractButton, "AdvancedButton")
    if button.isChecked() != shown:
        button.click()
        settle(400)


def choose(combo: QComboBox, text: str) -> None:
    """Choose an entry as the mouse does."""
    index = combo.findText(text)
    assert (
        index >= 0
    ), f"{text} is not in {[combo.itemText(i) for i in range(combo.count())]}"
    combo.setCurrentIndex(index)
    combo.activated.emit(index)
    settle()


def represent(label: str) -> None:
    """Choose a representation, and wait for its picture."""
    choose(representations(), label)
    settle(300)


def type_into(field: QLineEdit, text: str) -> None:
    """Replace a field's text and press Enter."""
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, Qt.Key_Return)
    settle()


def slide(slider: QSlider, share: float) -> None:
    """Drag a slider to a share of its length."""
    low, high = slider.minimum(), slider.maximum()
    slider.setSliderDown(True)
    slider.setSliderPosition(round(low + share * (high - low)))
    slider.setSliderDown(False)
    settle()


def menu_entry(*path: str) -> QAction:
    """Return an entry of the menu bar: ("Filters", "Volume", "Volume Benchmark")."""
    entries = main_window().menuBar().actions()
    for depth, name in enumerate(path):
        found = [one for one in entries if one.text().replace("&", "") == name]
        assert found, f"no {name} in {[one.text() for one in entries]}"
        if depth + 1 == len(path):
            return found[0]
        menu: QMenu = found[0].menu()
        menu.aboutToShow.emit()
        settle(50)
        entries = menu.actions()
    raise AssertionError("a menu entry needs a name")


def trigger(*path: str) -> None:
    """Choose an entry of the menu bar, which must not be greyed out."""
    entry = menu_entry(*path)
    assert entry.isEnabled(), f"{' > '.join(path)} is greyed out"
    entry.trigger()
    settle(300)


def answer_dialogs(answers: list[str]) -> QTimer:
    """Press the named button of each dialog that opens, in turn; keep what is returned."""
    timer = QTimer(main_window())

    def look() -> None:
        dialog = application().activeModalWidget()
        if dialog and answers:
            texts = {
                one.text().replace("&", ""): one
                for one in dialog.findChildren(QAbstractButton)
            }
            if answers[0] in texts:
                texts[answers.pop(0)].click()

    timer.timeout.connect(look)
    timer.start(100)
    return timer


# --- pictures --------------------------------------------------------------------------------


def view_picture() -> np.ndarray:
    """Draw the active view still and return what it shows, RGB in 0..1, row 0 on top."""
    view = simple.GetActiveView()
    simple.Render(view)
    return picture_of(view.SMProxy.CaptureWindow(1))


def as_displayed() -> np.ndarray:
    """Return what the active view shows, without drawing it anew."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(simple.GetActiveView().GetRenderWindow())
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    grabber.Update()
    return picture_of(grabber.GetOutput())


def picture_of(image: Any) -> np.ndarray:
    """Return the colours of image data, row 0 on top."""
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1, :, :3] / 255.0


def save_window(path: Path) -> None:
    """Save a picture of the whole window."""
    settle(300)
    assert (
        application().primaryScreen().grabWindow(main_window().winId()).save(str(path))
    )


def report(text: str) -> None:
    """Tell the terminal; what is printed goes to ParaView's window as well, among the messages."""
    sys.__stdout__.write(text + "\n")
    sys.__stdout__.flush()


# --- running ---------------------------------------------------------------------------------


def run_script(name: str, only: list[str]) -> None:
    """Run every `check_...` of a module, each in a new session, and leave ParaView."""

    def run() -> None:
        module = importlib.import_module(name)
        checks = {
            one: getattr(module, one)
            for one in vars(module)
            if one.startswith("check_") and (not only or one in only)
        }
        failed = [one for one, check in checks.items() if not _passes(one, check)]
        good = bool(checks) and not failed
        report("PASSED" if good else f"FAILED: {' '.join(failed) or 'no checks'}")
        report_lost_memory()
        os._exit(0 if good else 1)

    def guarded() -> None:
        try:
            run()
        except BaseException:  # Qt would only print it
            report(traceback.format_exc())
            os._exit(1)

    # Shorter than what start_paraview.py waits: a test that hangs tells where.
    faulthandler.dump_traceback_later(HANG_S, exit=True, file=sys.__stdout__)
    QTimer.singleShot(200, guarded)


def _passes(name: str, check: Callable[[], None]) -> bool:
    report(name)
    try:
        simple.ResetSession()
        simple.GetActiveViewOrCreate("RenderView")
        settle(300)
        before = messages()
        check()
        assert messages() == before, f"ParaView says: {messages()}"
    except Exception:  # a test may fail in any way, and the next one shall still run
        report(traceback.format_exc())
        return False
    return True
