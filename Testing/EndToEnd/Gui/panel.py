"""The Properties panel of our representations, in ParaView's window."""

from paraview import simple
from PyQt5.QtWidgets import QCheckBox, QComboBox, QLineEdit, QSlider, QTextEdit
from support import labels_named_by
from window import (
    advanced,
    apply,
    display_panel,
    headings,
    labels,
    press,
    report,
    represent,
    representations,
    row,
    rows,
    slide,
    tooltip,
    trigger,
    wait_until,
)

GROUP = "Volume Techniques"
SHOWN = {False: ("default",), True: ("default", "advanced")}
# Rows that another row switches on, and which are off in a new session.
HIDDEN_BY_ROWS = {
    "GradientOpacityRange": "Gradient Opacity",
    "LightingDamping": "Shade",
    "FullScaleSamples": "Show",
    "ExpectedError": "Error Target",
    "SamplesText": "Count Samples",
    "ErrorText": "Estimate Error",
    "ErrorRmse": "Estimate Error",
    "LargestError": "Estimate Error",
    "ReferenceSeconds": "Estimate Error",
    "FrameMs": "Estimate Error",
}
# What ParaView's own groups show, or hide, for its "Volume" too.
AS_FOR_VOLUME = {"Shade", "UseCropping"}
NOT_FOR_VOLUMES = {"Opacity", "PointSize", "LineWidth", "Interpolation", "Texture"}
READ_ONLY = ("LastFrameMs", "UsedText", "LeftOutText")


def wavelet(label: str) -> object:
    """Make a wavelet from the menu, apply, and choose a representation; return its display."""
    trigger("Sources", "Alphabetical", "Wavelet")
    apply()
    represent(label)
    return simple.GetDisplayProperties()


def ours(display: object) -> dict[str, object]:
    """Return the properties of our group from name to property, in order."""
    proxy = display.SMProxy
    for index in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(index)
        if group.GetXMLLabel() == GROUP:
            names = [
                group.GetProperty(i).GetXMLName()
                for i in range(group.GetNumberOfProperties())
            ]
            return {name: display.GetProperty(name).SMProperty for name in names}
    raise AssertionError(f"there is no group {GROUP}")


def runnable_labels() -> list[str]:
    """Return the techniques in the list that need no device of their own."""
    combo = representations()
    listed = [combo.itemText(index) for index in range(combo.count())]
    return [one for one in listed if one.startswith("Volume ") and "CUDA" not in one]


def applies(display: object, name: str, label: str) -> bool:
    """Tell whether a row is shown for a technique, as long as no other row hides it."""
    named = labels_named_by(display, name)
    return not named or label in named


def check_each_technique_has_its_rows_only() -> None:
    display = wavelet("Volume Single Pass")
    ours_by_name = ours(display)
    for label in runnable_labels():
        represent(label)
        for visible in (False, True):
            advanced(visible)
            expected = [
                name
                for name, one in ours_by_name.items()
                if name not in HIDDEN_BY_ROWS
                and one.GetPanelVisibility() in SHOWN[visible]
                and applies(display, name, label)
            ]
            actual = [name for name in rows(display_panel()) if name in ours_by_name]
            assert actual == expected, f"{label}: {actual}, not {expected}"
            report(f"  {label}: {len(actual)} rows")
    advanced(False)


def check_paraviews_own_rows_suit_volumes() -> None:
    display = wavelet("Volume Compute")
    shown = set(rows(display_panel()))
    assert AS_FOR_VOLUME <= shown, f"missing: {AS_FOR_VOLUME - shown}"
    advanced(True)
    shown = set(rows(display_panel()))
    assert not NOT_FOR_VOLUMES & shown, f"no volume has {NOT_FOR_VOLUMES & shown}"
    assert {"Ambient", "Diffuse", "Specular", "SpecularPower"} <= shown
    found = headings(display_panel())
    for heading in (GROUP, "Volume Rendering", "Lighting"):
        assert found.count(heading) == 1, found
    assert "Styling" not in found, found
    represent("Surface")
    shown = set(rows(display_panel()))
    assert NOT_FOR_VOLUMES <= shown, f"Surface lacks {NOT_FOR_VOLUMES - shown}"
    assert not set(ours(display)) & shown, "our rows are shown for Surface"
    assert headings(display_panel()).count("Lighting") == 1
    advanced(False)


def check_every_row_tells_what_it_is_for() -> None:
    display = wavelet("Volume Compute")
    advanced(True)
    told = 0
    for name, one in ours(display).items():
        if name in rows(display_panel()):
            expected = " ".join(one.GetDocumentation().GetDescription().split())
            actual = tooltip(row(name))
            assert actual == expected, f"{name}: {actual!r}, not {expected!r}"
            told += 1
    assert told > 15, f"only {told} rows were looked at"
    advanced(False)


def check_rows_on_the_picture_cannot_be_edited() -> None:
    wavelet("Volume Compute")
    advanced(True)
    for name in READ_ONLY:
        for field in row(name).findChildren(QLineEdit) + row(name).findChildren(
            QTextEdit
        ):
            assert not field.isEnabled() or field.isReadOnly(), f"{name} can be edited"
    advanced(False)


def check_switching_colours_by_an_array_and_undo_takes_it_back() -> None:
    trigger("Sources", "Alphabetical", "Wavelet")
    apply()
    display = simple.GetDisplayProperties()
    assert display.Representation == "Outline", display.Representation
    assert not display.ColorArrayName[1], display.ColorArrayName
    represent("Volume Compute")
    coloured = list(display.ColorArrayName)
    assert coloured == ["POINTS", "RTData"], coloured
    points = list(display.ScalarOpacityFunction.Points)
    assert (
        30 < points[0] < 40 and 270 < points[-4] < 280
    ), f"not the data's range: {points}"
    trigger("Edit", "Undo Change representation type")
    assert display.Representation == "Outline", display.Representation
    assert not display.ColorArrayName[1], display.ColorArrayName


def check_widgets_suit_what_they_set() -> None:
    display = wavelet("Volume Compute")
    advanced(True)
    for name in (
        "StepVoxels",
        "TerminationThreshold",
        "ErrorTarget",
        "MacrocellVoxels",
    ):
        assert row(name).findChild(QSlider), f"{name} has no slider"
    for name in ("Integrator", "TechniqueBlendMode", "RaySetUp", "WorkGroupShape"):
        shown = row(name).findChild(QComboBox)
        offered = [shown.itemText(index) for index in range(shown.count())]
        available = list(display.GetProperty(name).Available)
        assert offered == available, f"{name} offers {offered}, not {available}"
    for name in ("Skipping", "Jitter", "GradientOpacity"):
        assert row(name).findChild(QCheckBox), f"{name} has no check box"
    for text in ("Step (voxels)", "Blend Mode", "Last Frame (ms)"):
        assert text in labels(display_panel()), f"{text}: {labels(display_panel())}"
    slide(row("StepVoxels").findChild(QSlider), 0.25)
    assert 0.9 < display.StepVoxels < 1.1, display.StepVoxels
    advanced(False)


def check_error_rows_come_with_the_estimate() -> None:
    display = wavelet("Volume Compute")
    assert "ErrorText" not in rows(display_panel()), "an error is shown unasked"
    press(display_panel(), "Estimate Error")
    wait_until(lambda: (display.ErrorText or "").startswith("RMSE"), "the estimate")
    wait_until(lambda: "ErrorRmse" in rows(display_panel()), "the row of the error")
    written = float(row("ErrorRmse").findChild(QLineEdit).text())
    known = display.ErrorRmse
    assert 0 < known < 0.1 and abs(written - known) < 1e-5, (written, known)


def check_expected_error_comes_with_the_target() -> None:
    display = wavelet("Volume Compute")
    advanced(True)
    assert "ExpectedError" not in rows(display_panel()), "nothing is expected"
    display.ErrorTarget = 0.01
    simple.Render()
    wait_until(lambda: "ExpectedError" in rows(display_panel()), "the expected error")
    field = row("ExpectedError").findChild(QLineEdit)
    wait_until(lambda: 0 < float(field.text()) <= 0.01, "an error within the target")
    assert not field.isEnabled() or field.isReadOnly(), "it can be edited"
    represent("Volume Slices")
    assert "ExpectedError" not in rows(display_panel()), "its steps are all alike"
    advanced(False)


def check_samples_row_comes_with_the_count() -> None:
    display = wavelet("Volume Compute")
    assert "SamplesText" not in rows(display_panel()), "samples are counted unasked"
    press(display_panel(), "Count Samples")
    wait_until(lambda: "SamplesText" in rows(display_panel()), "the row of the samples")
    assert "Last Frame (samples)" in labels(display_panel()), labels(display_panel())
    field = row("SamplesText").findChild(QLineEdit)
    assert field.text() == display.SamplesText, (field.text(), display.SamplesText)
    assert " per ray; " in field.text(), field.text()
    assert not field.isEnabled() or field.isReadOnly(), "the samples can be edited"
    slide(row("StepVoxels").findChild(QSlider), 0.25)
    wait_until(lambda: field.text().endswith(": out of date"), "samples out of date")
