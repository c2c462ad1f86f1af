"""The rows of the Properties panel: documented, kept when switching, and reaching the picture."""

from typing import Any

import numpy as np
from paraview import simple
from support import (
    ERRORS,
    LABEL,
    blob,
    capture,
    check_differs,
    color_by,
    image_data,
    labels_named_by,
    look,
    new_view,
    not_drawn,
    producer,
    rmse,
    run_checks,
    set_functions,
    show,
    technique_labels,
    wavelet,
)

# Every property of ours with a value that is not its default.
OURS = {
    "StepVoxels": 0.75,
    "Integrator": "Left",
    "TechniqueBlendMode": "Gradient",
    "TerminationThreshold": 0.01,
    "ErrorTarget": 0.002,
    "InteractiveFrameTime": 250.0,
    "MemoryBudget": 512.0,
    "Skipping": 0,
    "MacrocellVoxels": 4,
    "RaySetUp": "Box",
    "Jitter": 1,
    "JitterSeed": 7,
    "LightingDamping": 0.25,
    "GradientOpacity": 1,
    "GradientOpacityRange": [1.5, 40.0],
    "WorkGroupShape": "8x4",
    "OpenclDevice": "Portable Computing Language: none",
    "OpenclStorage": "Images",
    "VoxelOrder": "Block Shape",
    "PictureTransfer": "Through Host",
    "SliceExtent": "Central Ray",
    "SliceOrder": "Back to Front",
    "SliceTarget": "RGBA16F",
    "SliceThreads": "4",
    "Show": "Samples per Pixel",
}
LIGHTING = {"Ambient": 0.7, "Diffuse": 0.3, "Specular": 0.9, "SpecularPower": 3.0}


def shaded_blob() -> tuple[Any, Any]:
    """Return a view of a shaded hill, and its display."""
    view = new_view()
    display = show(producer(image_data(blob(32, 6))), view)
    color_by(display, view, "values")
    opacity = [(0, 0), (0.3, 0), (0.5, 0.4), (1, 0.8)]
    set_functions("values", [0, 0.2, 0.4, 1, 1, 1, 0.8, 0.2], opacity)
    display.Shade = 1
    look(view)
    return view, display


def volume_property(display: Any) -> Any:
    """Return the vtkVolumeProperty that is drawn with."""
    return (
        display.GetClientSideObject().GetActiveRepresentation().GetActor().GetProperty()
    )


def check_every_row_is_documented() -> None:
    display = show(wavelet(4), new_view())
    for name in OURS:
        documentation = display.GetProperty(name).SMProperty.GetDocumentation()
        text = documentation.GetDescription() if documentation else ""
        assert len(text.split()) > 8, f"{name} says {text!r}"


def check_rows_of_one_technique_name_it() -> None:
    display = show(wavelet(4), new_view())
    labels = set(display.GetProperty("Representation").Available)
    for name in OURS:
        named = labels_named_by(display, name)
        print(f"  {name}: {', '.join(sorted(named)) or 'all'}")
        assert named <= labels, f"{name} is shown for {named - labels}, which are none"


def check_settings_survive_switching() -> None:
    view = new_view()
    display = show(wavelet(4), view)
    color_by(display, view, "RTData")
    for name, value in OURS.items():
        setattr(display, name, value)
    for label in ("Volume", "Surface", *technique_labels(), "Outline", LABEL):
        display.SetRepresentationType(label)
        simple.Render(view)
        for name, value in OURS.items():
            actual = getattr(display, name)
            actual = list(actual) if isinstance(value, list) else actual
            assert actual == value, f"{label}: {name} is {actual!r}, not {value!r}"
    ERRORS.take()  # a technique need not draw every combination


def check_lighting_of_the_panel_reaches_our_volumes() -> None:
    view, display = shaded_blob()
    before = capture(view)
    for name, value in LIGHTING.items():
        setattr(display, name, value)
        after = capture(view)
        check_differs(before, after, name)
        before = after


def check_settings_reach_the_picture() -> None:
    """Those that change it for every technique; the others are about speed or one technique."""
    view, display = shaded_blob()
    usual = capture(view)
    for name, values, least in (
        ("TechniqueBlendMode", ("Maximum", "Minimum", "Average", "Gradient"), 1e-3),
        ("Integrator", ("Left", "PreIntegrated"), 1e-5),
        ("LightingDamping", (1.0,), 1e-3),
        ("GradientOpacity", (1,), 1e-4),
    ):
        default = display.GetProperty(name).GetData()
        for value in values:
            setattr(display, name, value)
            check_differs(usual, capture(view), f"{name} {value}", least)
        setattr(display, name, default)
        assert rmse(capture(view), usual) == 0, f"{name} back gave another picture"


def check_work_group_shapes_are_all_known() -> None:
    view, display = shaded_blob()
    display.SetRepresentationType("Volume Compute")
    usual = capture(view)
    for shape in display.GetProperty("WorkGroupShape").Available:
        display.WorkGroupShape = shape
        error = rmse(capture(view), usual)
        assert error <= 1e-6, f"{shape} changes the picture: RMSE {error:.2g}"


def check_blend_mode_of_paraview_has_no_effect() -> None:
    view, display = shaded_blob()
    before = capture(view)
    for mode in ("Isosurface", "Slice", "Composite"):
        display.BlendMode = mode
        assert rmse(capture(view), before) == 0, f"BlendMode {mode} changes the picture"


def check_gradient_opacity_is_absent_until_asked_for() -> None:
    view, display = shaded_blob()
    before = capture(view)
    assert not volume_property(display).HasGradientOpacity()
    display.GradientOpacity = 1
    simple.Render(view)
    automatic = volume_property(display).GetGradientOpacity().GetRange()
    # A hill of 1 high between two axes of 31 voxels.
    assert np.allclose(automatic, (0.0, 0.1)), f"the automatic range is {automatic}"
    display.GradientOpacityRange = [0.02, 0.25]
    simple.Render(view)
    given = volume_property(display).GetGradientOpacity().GetRange()
    assert np.allclose(given, (0.02, 0.25)), f"the range is {given}"
    display.GradientOpacity = 0
    assert rmse(capture(view), before) == 0, "switched off, the picture is another one"
    assert not volume_property(display).HasGradientOpacity()
    display.SetRepresentationType("Volume")
    simple.Render(view)
    assert not volume_property(display).HasGradientOpacity(), "ours reached ParaView's"


def check_gradient_opacity_range_that_is_none() -> None:
    view, display = shaded_blob()
    good = capture(view)
    display.GradientOpacity = 1
    for limits in ([0.5, 0.5], [1.0, 0.2], [-1.0, 1.0]):
        display.GradientOpacityRange = limits
        assert capture(view).max() == 0, f"{limits}: something was drawn"
        messages = not_drawn(ERRORS.take())
        assert len(messages) == 1 and "gradient opacity range" in messages[0], messages
    display.GradientOpacity = 0
    assert rmse(capture(view), good) == 0, "afterwards it differs"


if __name__ == "__main__":
    run_checks(dict(globals()))
