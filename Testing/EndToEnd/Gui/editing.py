"""What users do to any representation: edit, undo, reset, copy, crop, recolour, select, animate."""

import numpy as np
from paraview import simple
from PyQt5.QtCore import QPoint, Qt
from PyQt5.QtTest import QTest
from PyQt5.QtWidgets import QAction, QSlider, QWidget
from window import (
    apply,
    as_displayed,
    tick,
    click,
    display_panel,
    dock,
    main_window,
    picture_of,
    press,
    report,
    represent,
    row,
    rows,
    settle,
    slide,
    trigger,
    view_picture,
    wait_until,
)

LABEL = "Volume Compute"


def shown_wavelet() -> object:
    """Make a wavelet and show it with one of our representations; return its display."""
    trigger("Sources", "Alphabetical", "Wavelet")
    apply()
    represent(LABEL)
    return simple.GetDisplayProperties()


def difference(first: np.ndarray, second: np.ndarray) -> float:
    """Return the root mean square difference of two pictures."""
    return float(np.sqrt(np.mean((first - second) ** 2)))


def step_slider() -> QSlider:
    return row("StepVoxels").findChild(QSlider)


def check_undo_and_redo_a_row() -> None:
    display = shown_wavelet()
    fine = view_picture()
    slide(step_slider(), 1.0)
    coarse = view_picture()
    assert display.StepVoxels == 4.0, display.StepVoxels
    assert difference(fine, coarse) > 1e-3, "the step does not reach the picture"
    trigger("Edit", undo_text())
    assert display.StepVoxels == 0.5, display.StepVoxels
    assert difference(fine, view_picture()) == 0, "undone, the picture is another"
    trigger("Edit", redo_text())
    assert display.StepVoxels == 4.0, display.StepVoxels
    assert difference(coarse, view_picture()) == 0, "redone, the picture is another"


def undo_text() -> str:
    return edit_entry("Undo ")


def redo_text() -> str:
    return edit_entry("Redo ")


def edit_entry(start: str) -> str:
    """Return the whole text of an entry of the menu Edit."""
    for menu in main_window().menuBar().actions():
        for one in menu.menu().actions() if menu.text() == "&Edit" else []:
            text = one.text().replace("&", "")
            if text.startswith(start):
                return text
    raise AssertionError(f"the menu Edit has no {start}")


def check_defaults_button_restores_every_row() -> None:
    display = shown_wavelet()
    before = view_picture()
    slide(step_slider(), 1.0)
    tick("GradientOpacity")
    assert display.StepVoxels == 4.0 and display.GradientOpacity == 1
    press(dock("propertiesDock"), "DisplayRestoreDefaults")
    settle(300)
    assert display.StepVoxels == 0.5, display.StepVoxels
    assert display.GradientOpacity == 0, display.GradientOpacity
    represent(LABEL)
    assert difference(before, view_picture()) < 0.05


def check_copy_and_paste_of_the_display() -> None:
    first = shown_wavelet()
    slide(step_slider(), 0.5)
    tick("GradientOpacity")
    copied = first.StepVoxels
    press(dock("propertiesDock"), "DisplayCopy")
    second = shown_wavelet()
    assert second.StepVoxels == 0.5 and second.GradientOpacity == 0
    press(dock("propertiesDock"), "DisplayPaste")
    assert second.StepVoxels == copied != 0.5, second.StepVoxels
    assert second.GradientOpacity == 1


def check_colour_map_editor_edits_our_volume() -> None:
    display = shown_wavelet()
    before = view_picture()
    press(row("ColorEditor"), "EditColorMap")
    editor = dock("colorMapEditorDock")
    wait_until(editor.isVisible, "the Color Map Editor")
    settle(500)
    opacity = editor.findChild(QWidget, "OpacityEditor")
    points = list(display.ScalarOpacityFunction.Points)
    middle = QPoint(opacity.width() // 2, opacity.height() // 8)
    chart = opacity.childAt(middle)
    middle = chart.mapFrom(opacity, middle)
    QTest.mouseMove(chart, middle)
    click(chart, middle)
    settle(500)
    edited = list(display.ScalarOpacityFunction.Points)
    assert len(edited) > len(points), f"no point was added to {points}"
    editor.hide()
    settle(500)
    assert difference(before, view_picture()) > 1e-2, "the opacity did not change"


def check_crop_box_cuts_our_volume() -> None:
    display = shown_wavelet()
    whole = view_picture()
    assert "CroppingOrigin" not in rows(display_panel())
    tick("UseCropping")
    assert display.UseCropping == 1
    boxes = [one for one in widgets_of("pqBoxPropertyWidget") if one.isVisible()]
    assert boxes, "there is no row for the crop box"
    display.CroppingScale = [0.5, 1.0, 1.0]
    cut = view_picture()
    width = whole.shape[1]
    changed = np.abs(whole - cut).max(axis=(0, 2)) > 0.02
    assert changed[: width // 2].any() or changed[width // 2 :].any(), "nothing was cut"
    assert difference(whole, cut) > 1e-2
    tick("UseCropping")
    assert difference(whole, view_picture()) == 0, "uncropped, the picture is another"


def widgets_of(class_name: str) -> list[QWidget]:
    return [
        one
        for one in display_panel().findChildren(QWidget)
        if one.metaObject().className() == class_name
    ]


def check_select_cells_through_our_volume() -> None:
    shown_wavelet()
    source, view = simple.GetActiveSource(), simple.GetActiveView()
    before = view_picture()
    height, width = before.shape[:2]
    box = [int(0.45 * width), int(0.45 * height), int(0.55 * width), int(0.55 * height)]
    simple.SelectCellsThrough(Rectangle=box, View=view)
    settle()
    assert source.SMProxy.GetSelectionInput(0), "nothing was selected"
    selected = view_picture()
    assert difference(before, selected) > 1e-3, "the selection is not shown"
    simple.ClearSelection(source)
    settle()
    assert difference(before, view_picture()) == 0, "unselected, the picture is another"


def check_animation_of_a_row_and_playing() -> None:
    display = shown_wavelet()
    track = simple.GetAnimationTrack("StepVoxels", proxy=display)
    track.KeyFrames = [
        simple.CompositeKeyFrame(KeyTime=0.0, KeyValues=[0.25]),
        simple.CompositeKeyFrame(KeyTime=1.0, KeyValues=[4.0]),
    ]
    scene = simple.GetAnimationScene()
    scene.NumberOfFrames = 4
    seen = []
    for _ in range(4):
        scene.GoToNext() if seen else scene.GoToFirst()
        settle(200)
        seen.append((display.StepVoxels, view_picture()))
    steps = [step for step, _ in seen]
    assert steps == sorted(steps) and steps[0] == 0.25 and steps[-1] == 4.0, steps
    assert difference(seen[0][1], seen[-1][1]) > 1e-3


def last_frame_ms(display: object) -> float:
    display.SMProxy.UpdatePropertyInformation()
    return display.GetProperty("LastFrameMs").SMProperty.GetElement(0)


def make_slow(display: object) -> bool:
    """Shorten the step until a picture takes longer than a second; false where none does."""
    for step in (0.5, 0.125, 0.03, 0.008, 0.002):
        display.StepVoxels = step
        simple.Render()
        settle(500)
        if last_frame_ms(display) > 1200.0:
            return True
    return False


def check_coarse_picture_before_one_that_takes_long() -> None:
    display = shown_wavelet()
    display.InteractiveFrameTime = 1.0  # as coarse as can be
    if not make_slow(display):
        report("left out: no picture of this machine takes a second")
        return
    view = simple.GetActiveView()
    drawn = []
    view.GetRenderWindow().AddObserver("EndEvent", lambda *_: drawn.append(1))
    simple.GetActiveCamera().Azimuth(30.0)
    simple.Render()
    assert len(drawn) == 1, drawn
    coarse = as_displayed()
    captured = picture_of(view.SMProxy.CaptureWindow(1))
    drawn.clear()
    wait_until(lambda: drawn, "the complete picture")
    settle(1000)
    assert len(drawn) == 1, f"{len(drawn)} pictures instead of the complete one"
    assert difference(coarse, as_displayed()) > 1e-3, "the first picture is not coarse"
    assert difference(captured, as_displayed()) == 0, "a screenshot is coarse"
