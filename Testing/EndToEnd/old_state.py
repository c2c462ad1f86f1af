"""State files of every release open with all their values, and show the same picture.

`old_state.py make FILE` writes one; keep a release's under States/ when it is made.
"""

import os
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

from paraview import simple
from state import FILTER, SETTINGS, scene, the_display
from support import (
    SIZE,
    capture,
    check_close,
    check_not_empty,
    load_plugin,
    run_checks,
    technique_labels,
    temporary_folder,
)

STATES = Path(__file__).resolve().parent / "States"
# Settings that a release did not have: its states leave them as they are in a new session.
ADDED_SINCE = {"0.1.0.pvsm": {"InteractiveFrameTime", "MemoryBudget"}}


def make(path: Path) -> None:
    """Write the state of a scene and of a benchmark that has not been applied."""
    load_plugin()
    scene()
    source = next(iter(simple.GetSources().values()))
    benchmark = simple.VolumeBenchmark(registrationName="Benchmark", Input=source)
    for name, value in FILTER.items():
        setattr(benchmark, name, value)
    simple.SaveState(str(path))


def saved_values(path: Path, proxy_type: str) -> dict[str, list[str]]:
    """Return what a state file holds of the only proxy of a type: from property to values."""
    found = ElementTree.parse(path).iter("Proxy")
    (proxy,) = [one for one in found if one.get("type") == proxy_type]
    return {
        one.attrib["name"]: [each.attrib["value"] for each in one.findall("Element")]
        for one in proxy.findall("Property")
        if one.findall("Element")
    }


def expect_values(proxy: Any, saved: dict[str, list[str]], names: list[str]) -> None:
    """Fail unless properties of a proxy have the values of a state file."""
    for name in names:
        assert name in saved, f"the state has no {name}"
        live = proxy.SMProxy.GetProperty(name)
        assert live, f"there is no {name} any more"
        actual = [str(live.GetElement(i)) for i in range(live.GetNumberOfElements())]
        same = [as_number(one) for one in actual] == [
            as_number(one) for one in saved[name]
        ]
        assert same, f"{name} is {actual}, not {saved[name]}"


def as_number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def releases() -> list[Path]:
    found = sorted(STATES.glob("*.pvsm"))
    assert found, f"no states in {STATES}"
    return found


def check_all_values_are_as_they_were() -> None:
    for path in releases():
        simple.ResetSession()
        simple.LoadState(str(path))
        saved = saved_values(path, "UniformGridRepresentation")
        added = ADDED_SINCE.get(path.name, set())
        names = [*(set(SETTINGS) - added), "Representation"]
        expect_values(the_display(), saved, names)
        for name in added:
            live = the_display().SMProxy.GetProperty(name)
            assert live.IsValueDefault(), f"{name} is not as in a new session"
        benchmark = simple.FindSource("Benchmark")
        saved = saved_values(path, "VolumeBenchmark")
        assert set(FILTER) <= set(
            saved
        ), f"{path.name} lacks {set(FILTER) - set(saved)}"
        expect_values(benchmark, saved, [name for name in saved if name != "Input"])


def check_the_picture_is_as_it_was() -> None:
    """In every technique: its label is all that differs between their states."""
    for path in releases():
        text = path.read_text()
        for label in technique_labels():
            simple.ResetSession()
            scene()
            the_display().SetRepresentationType(label)
            the_display().OpenclDevice = "Auto"  # the states name one that nobody has
            expected = capture(simple.GetActiveView())
            simple.ResetSession()
            with temporary_folder() as folder:
                copy = folder / path.name
                copy.write_text(text.replace("Volume Single Pass", label))
                simple.LoadState(str(copy))
            view = simple.GetActiveViewOrCreate("RenderView")
            view.ViewSize = list(SIZE)
            assert the_display().Representation == label, the_display().Representation
            the_display().OpenclDevice = "Auto"
            actual = capture(view)
            check_not_empty(actual, label)
            check_close(actual, expected, 1e-6, f"{path.name}, {label}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["make"]:
        make(Path(sys.argv[2]))
        sys.stdout.flush()
        os._exit(0)
    run_checks(dict(globals()))
