"""Opacity editor, crop box and rows do to ours what they do to ParaView's Volume; Save Screenshot."""

from pathlib import Path
from typing import Any

import numpy as np
from mouse import OURS, PARAVIEWS, choose, shown_wavelet, view_widget
from paraview import simple
from PyQt5.QtCore import QPoint
from PyQt5.QtTest import QTest
from PyQt5.QtWidgets import QDialog, QLineEdit, QWidget
from support import read_png, rmse, temporary_folder
from walk import in_dialog
from window import (
    advanced,
    answer_dialogs,
    click,
    dock,
    main_window,
    menu_entry,
    press,
    report,
    row,
    settle,
    tick,
    type_into,
    view_picture,
    wait_until,
)

# VTK's mapper misses something with its long steps, and the cut of a crop box by a pixel.
ALIKE, SHARE = 0.02, 0.99
CHANGED = 0.01
LARGE = (1600, 1200)  # pixels of a screenshot, more than the view has


def check_edits_show_as_with_volume() -> None:
    shown_wavelet()
    display = simple.GetDisplayProperties()
    press(row("ColorEditor"), "EditColorMap")
    editor = dock("colorMapEditorDock")
    wait_until(editor.isVisible, "the Color Map Editor")
    settle(300)
    pictures = [both(display, "as it was")]
    for what, edit in (
        ("opacity", lambda: add_point(editor)),
        ("unit distance", lambda: set_unit_distance("2.5")),
        ("crop box", lambda: tick("UseCropping")),
        ("a smaller box", lambda: crop(display)),
    ):
        edit()
        pictures.append(both(display, what))
        change = rmse(pictures[-1], pictures[-2])
        if what != "crop box":  # it begins with all of the volume
            assert change > CHANGED, f"{what}: the picture changed by {change:.4f}"
    tick("GradientOpacity")
    faded = view_picture()
    assert rmse(faded, pictures[-1]) > CHANGED, "Gradient Opacity shows nothing"
    set_gradient_range("5", "80")
    assert rmse(view_picture(), faded) > CHANGED / 4, "its range shows nothing"


def both(display: Any, what: str) -> np.ndarray:
    """Return our picture, which must be like that of ParaView's Volume."""
    cropped = display.UseCropping
    if cropped:
        show_box(False)
    ours = view_picture()
    choose(PARAVIEWS)
    if cropped:
        show_box(False)
    theirs = view_picture()
    choose(OURS)
    error = np.quantile(np.abs(ours - theirs).max(axis=2), SHARE)
    report(f"  {what}: {error:.4f} (at most {ALIKE})")
    assert error < ALIKE, f"{what}: {error:.4f} away from Volume"
    return ours


def box_row() -> QWidget:
    (found,) = [
        one
        for one in dock("propertiesDock").findChildren(QWidget)
        if one.metaObject().className() == "pqBoxPropertyWidget" and one.isVisible()
    ]
    return found


def show_box(shown: bool) -> None:
    """Show or hide the box that the mouse can pull."""
    box = box_row().findChild(QWidget, "show3DWidget")
    if box.isChecked() != shown:
        box.click()
        settle(300)


def add_point(editor: QWidget) -> None:
    opacity = editor.findChild(QWidget, "OpacityEditor")
    place = QPoint(opacity.width() // 2, opacity.height() // 8)
    chart = opacity.childAt(place)
    place = chart.mapFrom(opacity, place)
    QTest.mouseMove(chart, place)
    click(chart, place)
    settle(300)


def set_unit_distance(text: str) -> None:
    advanced(True)
    type_into(row("ScalarOpacityUnitDistance").findChild(QLineEdit), text)
    advanced(False)


def set_gradient_range(low: str, high: str) -> None:
    fields = row("GradientOpacityRange").findChildren(QLineEdit)
    type_into(fields[1], high)  # first, since a range that falls is refused
    type_into(fields[0], low)


def crop(display: Any) -> None:
    display.CroppingOrigin, display.CroppingScale = [4.0, 0.0, 0.0], [0.5, 1.0, 1.0]
    simple.Render()
    settle()


def check_screenshots_are_what_the_view_shows() -> None:
    shown_wavelet()
    with temporary_folder() as folder:
        path = folder / "shot.png"
        save_by_dialogs(path)
        assert np.abs(read_png(path) - view_picture()).max() < 1.5 / 255


def save_by_dialogs(path: Path) -> None:
    """File > Save Screenshot, the file's name, and OK to its options."""
    options = answer_dialogs(["OK"])
    options.stop()

    def name_the_file(dialog: QDialog) -> None:
        dialog.findChild(QLineEdit, "EntityName").setText(str(path))
        options.start(300)
        press(dialog, "OK")

    in_dialog(menu_entry("File", "Save Screenshot..."), name_the_file)
    wait_until(path.is_file, "the screenshot")
    options.stop()
    settle(300)


def check_large_screenshots_have_no_seams() -> None:
    shown_wavelet()
    settle()
    view = simple.GetActiveView()
    view.OrientationAxesVisibility = 0  # of a size in pixels of the window
    view.CenterAxesVisibility = 0
    with temporary_folder() as folder:
        tiled, whole = folder / "tiled.png", folder / "whole.png"
        simple.SaveScreenshot(str(tiled), view, ImageResolution=list(LARGE))
        assert view_widget().width() < LARGE[0], "the view has room for all"
        main_window().resize(LARGE[0] + 800, LARGE[1] + 500)
        settle(500)
        assert view_widget().width() >= LARGE[0], view_widget().width()
        simple.SaveScreenshot(str(whole), view, ImageResolution=list(LARGE))
        joined, one = read_png(tiled), read_png(whole)
    assert joined.shape == one.shape == (LARGE[1], LARGE[0], 3), joined.shape
    difference = np.abs(joined - one)
    worst = difference.max()
    report(f"  RMSE {rmse(joined, one):.5f}, largest difference {worst:.3f}")
    assert np.ptp(joined) > 0.1 and worst < 2.5 / 255, f"a seam: {worst:.3f}"
