"""The mouse over the view does to our volumes what it does to ParaView's Volume, or its Surface."""

from collections.abc import Callable
from typing import Any

import numpy as np
from paraview import simple
from PyQt5.QtCore import QEvent, QPoint, QPointF, Qt
from PyQt5.QtGui import QMouseEvent, QWheelEvent
from PyQt5.QtWidgets import QAction, QToolTip, QWidget
from window import (
    answer_dialogs,
    application,
    apply,
    as_displayed,
    main_window,
    represent,
    representations,
    settle,
    trigger,
    view_picture,
    wait_until,
)

PARAVIEWS = "Volume"
OURS = "Volume Compute"
SURFACE = "Surface"
STEPS = 6
STILL_AFTER_MS = (
    700  # ParaView draws the still picture half a second after the last event
)
SMALL = (900, 700)  # pixels of the window: less to draw


# --- the mouse -------------------------------------------------------------------------------


def view_widget() -> QWidget:
    """What the active view is drawn in."""
    (found,) = [
        one
        for one in main_window().centralWidget().findChildren(QWidget)
        if one.isVisible() and one.metaObject().className().startswith("QVTKOpenGL")
    ]
    return found


def point(x: float, y: float) -> QPoint:
    """Return a place in the view, as shares of its width and height from its upper left."""
    widget = view_widget()
    return QPoint(round(x * widget.width()), round(y * widget.height()))


def send(
    kind: QEvent.Type,
    at: QPoint,
    button: Qt.MouseButton = Qt.NoButton,
    buttons: Qt.MouseButton = Qt.NoButton,
) -> None:
    widget = view_widget()
    event = QMouseEvent(
        kind,
        QPointF(at),
        QPointF(widget.mapToGlobal(at)),
        button,
        buttons,
        Qt.NoModifier,
    )
    application().sendEvent(widget, event)
    application().processEvents()


def drag(
    start: QPoint,
    end: QPoint,
    button: Qt.MouseButton = Qt.LeftButton,
) -> None:
    send(QEvent.MouseMove, start)
    send(QEvent.MouseButtonPress, start, button, button)
    for step in range(1, STEPS + 1):
        at = start + (end - start) * step / STEPS
        send(QEvent.MouseMove, at, Qt.NoButton, button)
    send(QEvent.MouseButtonRelease, end, button)
    settle(STILL_AFTER_MS)


def turn_wheel(at: QPoint, notches: int) -> None:
    widget = view_widget()
    event = QWheelEvent(
        QPointF(at),
        QPointF(widget.mapToGlobal(at)),
        QPoint(),
        QPoint(0, 120 * notches),
        Qt.NoButton,
        Qt.NoModifier,
        Qt.NoScrollPhase,
        False,
    )
    application().sendEvent(widget, event)
    settle(STILL_AFTER_MS)


# --- what is looked at -----------------------------------------------------------------------


def shown_wavelet() -> Any:
    """Make a wavelet from the menu and show all of it, in a small window; return it."""
    main_window().resize(*SMALL)
    trigger("Sources", "Alphabetical", "Wavelet")
    apply()
    choose(OURS)
    simple.ResetCamera()
    settle()
    return simple.GetActiveSource()


def choose(label: str) -> None:
    """Choose a representation; ParaView asks whether one is sure of its own Volume."""
    answer = answer_dialogs(["Yes"])
    represent(label)
    answer.stop()
    assert representations().currentText() == label, representations().currentText()


def camera() -> list[float]:
    """Return where the camera is, and how wide it looks."""
    one = simple.GetActiveCamera()
    places = (*one.GetPosition(), *one.GetFocalPoint(), *one.GetViewUp())
    return [*places, one.GetParallelScale()]


def place(values: list[float]) -> None:
    one = simple.GetActiveCamera()
    one.SetPosition(*values[:3])
    one.SetFocalPoint(*values[3:6])
    one.SetViewUp(*values[6:9])
    one.SetParallelScale(values[9])
    simple.GetActiveView().GetClientSideObject().GetRenderer().ResetCameraClippingRange()
    simple.Render()


def results(act: Callable[[], Any], *labels: str) -> list[Any]:
    """Do the same with some representations, from where the camera is; return what comes of it."""
    begin = camera()
    found = []
    for label in labels:
        choose(label)
        place(begin)
        found.append(act())
    return found


def tool(name: str) -> QAction:
    """Return a button of the view's tool bar by its object name."""
    found = main_window().centralWidget().findChildren(QAction, name)
    assert len(found) == 1, f"{len(found)} actions {name}"
    return found[0]


def selection_of(source: Any) -> dict[str, list[float]]:
    """Return what is selected of a source: ids, or the corners of a frustum, by their kind."""
    selected = source.SMProxy.GetSelectionInput(0)
    inputs = selected.GetProperty("Input") if selected else None
    found = {}
    for index in range(inputs.GetNumberOfProxies() if inputs else 0):
        one = inputs.GetProxy(index)
        values = one.GetProperty("IDs") or one.GetProperty("Frustum")
        count = values.GetNumberOfElements() if values else 0
        found[one.GetXMLName()] = [values.GetElement(i) for i in range(count)]
    return found


def select(source: Any, name: str) -> dict[str, list[float]]:
    """Drag a rectangle with a tool of the view; return what is selected then."""
    tool(name).trigger()
    settle()
    drag(point(0.45, 0.45), point(0.55, 0.55))
    found = selection_of(source)
    simple.ClearSelection(source)
    settle()
    return found


def ids_of(selection: dict[str, list[float]]) -> list[int]:
    """Return the ids, without the process before each."""
    return [int(one) for one in selection["IDSelectionSource"][1::2]]


# --- checks ----------------------------------------------------------------------------------


def check_dragging_and_the_wheel_move_the_camera_as_with_volume() -> None:
    shown_wavelet()
    drawn: list[int] = []
    window = simple.GetActiveView().GetRenderWindow()
    window.AddObserver("EndEvent", lambda *_: drawn.append(1))
    middle, aside = point(0.45, 0.45), point(0.6, 0.55)
    for what, frames, act in (
        ("rotate", STEPS, lambda: drag(middle, aside)),
        ("pan", STEPS, lambda: drag(middle, aside, Qt.MiddleButton)),
        ("zoom", STEPS, lambda: drag(middle, point(0.45, 0.6), Qt.RightButton)),
        ("wheel", 1, lambda: turn_wheel(middle, 1)),
    ):

        def moved() -> list[float]:
            drawn.clear()
            act()
            assert len(drawn) > frames, f"{what}: {len(drawn)} pictures"
            return camera()

        before = camera()
        expected, actual = results(moved, PARAVIEWS, OURS)
        assert actual == expected != before, f"{what}: {actual}, not {expected}"
        left = as_displayed()
        assert np.array_equal(left, view_picture()), f"{what}: left a coarse picture"
    assert np.ptp(view_picture()) > 0.1, "the volume is out of sight"


def check_what_is_on_the_surface_can_be_selected() -> None:
    source = shown_wavelet()
    cells = results(
        lambda: ids_of(select(source, "actionSelectSurfaceCells")), SURFACE, OURS
    )
    assert cells[1] == cells[0] and len(cells[0]) > 8, cells
    points = results(
        lambda: ids_of(select(source, "actionSelectSurfacePoints")), SURFACE, OURS
    )
    # The surface's must lie in the rectangle; ours are nearest to a pixel of it.
    assert set(points[1]) >= set(points[0]) and len(points[0]) > 8, points
    assert len(points[1]) < 2 * len(points[0]), points


def check_what_is_behind_a_rectangle_can_be_selected() -> None:
    source = shown_wavelet()
    before = view_picture()
    through = results(
        lambda: select(source, "actionSelectFrustumCells"), PARAVIEWS, OURS
    )
    assert through[1] == through[0] and "FrustumSelectionSource" in through[0], through
    blocks = results(lambda: select(source, "actionSelectBlock"), PARAVIEWS, OURS)
    assert blocks[1] == blocks[0] and "BlockSelectionSource" in blocks[0], blocks
    assert np.array_equal(before, view_picture()), "unselected, the picture is another"


def check_hovering_tells_of_the_cell_under_the_mouse() -> None:
    shown_wavelet()
    texts = results(hover, SURFACE, OURS)
    assert texts[1] == texts[0] and "Wavelet1" in texts[0], texts


def hover() -> str:
    """Return what is shown of the cell in the middle of the view."""
    answer = answer_dialogs(["OK"])  # ParaView explains the tool
    tool("actionHoveringSurfaceCells").trigger()
    answer.stop()
    for share in (0.47, 0.48, 0.49):
        send(QEvent.MouseMove, point(share, share))
        settle()
    settle(500)
    text = QToolTip.text()
    tool("actionHoveringSurfaceCells").trigger()
    settle()
    return text


def check_the_right_button_opens_the_menu_of_the_volume() -> None:
    shown_wavelet()
    menus = results(lambda: menu_at(point(0.5, 0.5)), PARAVIEWS, OURS)
    assert menus[1] == menus[0] and "Hide" in menus[0], menus
    assert "Hide" not in menu_at(point(0.02, 0.5)), "the menu of a volume beside it"


def menu_at(at: QPoint) -> list[str]:
    """Return the entries of the menu of a place in the view."""
    send(QEvent.MouseButtonPress, at, Qt.RightButton, Qt.RightButton)
    send(QEvent.MouseButtonRelease, at, Qt.RightButton)
    menu = wait_until(application().activePopupWidget, "a menu")
    entries = [one.text().replace("&", "") for one in menu.actions()]
    menu.close()
    settle()
    return entries
