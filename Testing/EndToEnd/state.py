"""State files and traces give the same picture again, in a process of their own."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
from paraview import servermanager, simple, smstate, smtrace
from patience import patient_s
from support import (
    LABEL,
    SIZE,
    capture,
    check_not_empty,
    color_by,
    load_plugin,
    look,
    new_view,
    rmse,
    run_checks,
    set_functions,
    show,
    technique_labels,
    temporary_folder,
    wavelet,
)

SETTINGS = {
    "StepVoxels": 0.75,
    "Integrator": "Left",
    "TerminationThreshold": 0.01,
    "ErrorTarget": 0.002,
    "InteractiveFrameTime": 250.0,
    "MemoryBudget": 512.0,
    "Skipping": 0,
    "MacrocellVoxels": 4,
    "RaySetUp": "Box",
    "Jitter": 1,
    "JitterSeed": 7,
    "Shade": 1,
    "ScalarOpacityUnitDistance": 3.0,
    "TechniqueBlendMode": "Gradient",
    "LightingDamping": 0.25,
    "GradientOpacity": 1,
    "GradientOpacityRange": [1.5, 40.0],
    "WorkGroupShape": "8x4",
    "OpenclDevice": "Portable Computing Language: none",
    "OpenclStorage": "Images",
    "VoxelOrder": "Block Shape",
    "PictureTransfer": "Register Each Frame",
    "SliceExtent": "Central Ray",
    "SliceOrder": "Back to Front",
    "SliceTarget": "RGBA16F",
    "SliceThreads": "4",
}
FILTER = {
    "Techniques": ["compute", "vtk-gpu"],
    "Integrators": ["Midpoint", "Segment"],
    "StepVoxels": [2.0, 0.25],
    "ImageSize": [320, 200],
    "Frames": 12,
    "ErrorViews": 0,
}


def check_python_state() -> None:
    with temporary_folder() as folder:
        picture = scene()
        (folder / "state.py").write_text(smstate.get_state())
        compare(reopened(folder, "state.py"), picture)


def check_xml_state() -> None:
    with temporary_folder() as folder:
        picture = scene()
        simple.SaveState(str(folder / "state.pvsm"))
        compare(reopened(folder, "state.pvsm"), picture)


def check_trace() -> None:
    smtrace.start_trace()
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    change_traced(display)
    look(view)
    text = smtrace.stop_trace()
    for line in (f"SetRepresentationType('{LABEL}')", ".StepVoxels = 0.75"):
        assert line in text, f"{line!r} is not in the trace:\n{text}"
    with temporary_folder() as folder:
        (folder / "trace.py").write_text(text)
        compare(reopened(folder, "trace.py"), capture(view))


def check_every_representation_and_the_filter() -> None:
    for label in technique_labels():
        for name in ("state.pvsm", "state.py"):
            simple.ResetSession()
            scene()
            the_display().SetRepresentationType(label)
            source = next(iter(simple.GetSources().values()))
            bench = simple.VolumeBenchmark(registrationName="Benchmark", Input=source)
            for row, value in FILTER.items():
                setattr(bench, row, value)
            expect_kept_by(name, label)


def check_a_volume_without_an_array_stays_without() -> None:
    """Choosing one of ours in the panel colours it; a file that says otherwise is right."""
    for name in ("state.pvsm", "state.py"):
        simple.ResetSession()
        scene()
        simple.ColorBy(the_display(), None)
        assert not array_of(the_display()), array_of(the_display())
        with temporary_folder() as folder:
            save_file(folder / name)
            simple.ResetSession()
            open_file(folder / name)
        simple.Render()
        assert not array_of(the_display()), f"{name}: {array_of(the_display())}"


def array_of(display: Any) -> str:
    """Return the name of the array that a representation is coloured by."""
    return display.ColorArrayName[1] or ""


def expect_kept_by(name: str, label: str) -> None:
    """Fail unless a state file of the session brings everything back."""
    with temporary_folder() as folder:
        save_file(folder / name)
        simple.ResetSession()
        open_file(folder / name)
    display, bench = the_display(), simple.FindSource("Benchmark")
    assert display.Representation == label, f"{name}: {display.Representation}"
    for proxy, rows in ((display, SETTINGS), (bench, FILTER)):
        for row, value in rows.items():
            actual = getattr(proxy, row)
            same = list(actual) == value if isinstance(value, list) else actual == value
            assert same, f"{label}, {name}: {row} is {actual}, not {value}"


def save_file(path: Path) -> None:
    if path.suffix == ".py":
        path.write_text(smstate.get_state())
    else:
        simple.SaveState(str(path))


def open_file(path: Path) -> None:
    if path.suffix == ".py":
        text = path.read_text()
        exec(compile(text, str(path), "exec"), {"__name__": "state"})
    else:
        simple.LoadState(str(path))


def change_traced(display: Any) -> None:
    """Set the properties as the Properties panel does; what Python sets is never traced."""
    item = smtrace._create_trace_item_internal(
        "PropertiesModified", kwargs={"proxy": display.SMProxy}
    )
    for name, value in SETTINGS.items():
        setattr(display, name, value)
    item.finalize()


def scene() -> np.ndarray:
    """Show a volume with settings that are not the default, and return its picture."""
    view = new_view()
    display = show(wavelet(), view)
    color_by(display, view, "RTData")
    colors = [37.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.8, 0.2, 277.0, 1.0, 0.3, 0.1]
    set_functions("RTData", colors, [(37, 0.0), (130, 0.2), (160, 0.02), (277, 0.5)])
    for name, value in SETTINGS.items():
        setattr(display, name, value)
    look(view)
    picture = capture(view)
    check_not_empty(picture, "the scene")
    return picture


def reopened(folder: Path, name: str) -> np.ndarray:
    """Open a state or trace in another process, which leaves the picture that it shows."""
    command = ["pvpython", __file__, "reopen", str(folder / name)]
    done = subprocess.run(
        command, capture_output=True, text=True, timeout=patient_s(120)
    )
    assert done.returncode == 0, f"{name}: {done.stdout}{done.stderr}"
    return np.load(folder / "picture.npy")


def reopen(path: Path) -> None:
    """The other process: open the file, check the settings and leave the picture."""
    load_plugin()
    open_file(path)
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = list(SIZE)
    display = the_display()
    assert display.Representation == LABEL, display.Representation
    for name, value in SETTINGS.items():
        actual = getattr(display, name)
        assert actual == value, f"{name} is {actual!r}, not {value!r}"
    np.save(path.parent / "picture.npy", capture(view))


def the_display() -> Any:
    """Return the only representation there is of a source."""
    displays = servermanager.ProxyManager().GetProxiesInGroup("representations")
    found = [one for one in displays.values() if hasattr(one, "StepVoxels")]
    assert len(found) == 1, f"{len(found)} representations"
    return found[0]


def compare(actual: np.ndarray, expected: np.ndarray) -> None:
    assert np.array_equal(
        actual, expected
    ), f"the picture is another one: RMSE {rmse(actual, expected)}"


if __name__ == "__main__":
    if sys.argv[1:2] == ["reopen"]:
        reopen(Path(sys.argv[2]))
        sys.stdout.flush()
        os._exit(0)
    run_checks(dict(globals()))
