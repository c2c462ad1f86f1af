"""Whatever was shown before, a picture is the one that a fresh ParaView would show."""

import json
import os
import random
import subprocess
import sys
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from paraview import simple
from patience import patient_s
from support import (
    ERRORS,
    blob,
    capture,
    check_not_empty,
    color_by,
    image_data,
    load_plugin,
    look,
    new_view,
    producer,
    rmse,
    run_checks,
    set_functions,
    show,
    technique_labels,
    temporary_folder,
    wavelet,
)

SEED = 2026
STEPS = 50
SAMPLED = 5  # every fifth picture is compared
SAME_PICTURE = 1e-6
PEERS = ("Volume", "Surface", "Outline")
DATASETS = ("wavelet", "bytes", "cells")
BLEND_MODES = ("Composite", "Maximum", "Average", "Gradient")
INTEGRATORS = ("Left", "Midpoint", "PreIntegrated")
# Values as shares of the data's range.
FUNCTIONS = (
    ([0, 0.1, 0.2, 0.9, 0.5, 0.9, 0.8, 0.2, 1, 1, 0.3, 0.1], [(0, 0), (1, 0.3)]),
    ([0, 1, 1, 1, 1, 0.2, 0.9, 0.4], [(0, 0), (0.4, 0), (0.5, 0.5), (0.6, 0), (1, 0)]),
    ([0, 0, 0, 1, 1, 1, 0, 0], [(0, 0.02), (0.7, 0.1), (1, 0.9)]),
)


@dataclass(frozen=True)
class Step:
    """All that a picture depends on."""

    label: str
    dataset: str
    size: tuple[int, int]
    azimuth: float
    elevation: float
    function: int
    blend_mode: str
    integrator: str
    step_voxels: float
    shade: int


def random_steps() -> list[Step]:
    """Return the steps; the first ones show each representation once."""
    choice = random.Random(SEED)
    labels = [*technique_labels(), *PEERS]
    order = choice.sample(labels, len(labels))
    order += [choice.choice(labels) for _ in range(STEPS - len(order))]
    return [
        Step(
            label=label,
            dataset=choice.choice(DATASETS),
            size=(choice.randint(60, 220), choice.randint(60, 220)),
            azimuth=choice.uniform(-180, 180),
            elevation=choice.uniform(-80, 80),
            function=choice.randrange(len(FUNCTIONS)),
            blend_mode=choice.choice(BLEND_MODES),
            integrator=choice.choice(INTEGRATORS),
            step_voxels=choice.choice((0.25, 0.5, 1.0)),
            shade=choice.randint(0, 1),
        )
        for label in order
    ]


class Stage:
    """One view, and a display for each data set that has been asked for."""

    def __init__(self) -> None:
        self.view = new_view()
        self.displays: dict[str, Any] = {}

    def picture(self, step: Step) -> np.ndarray:
        """Change everything that the step tells, and capture."""
        view = self.view
        view.ViewSize = list(step.size)
        for display in self.displays.values():
            display.Visibility = 0
        display = self.display(step.dataset, step.label)
        display.SetRepresentationType(step.label)
        display.Visibility = 1
        display.TechniqueBlendMode = step.blend_mode
        display.Integrator = step.integrator
        display.StepVoxels = step.step_voxels
        display.Shade = step.shade
        self.apply_function(display, step)
        simple.Render(view)
        look(view, step.azimuth, step.elevation)
        return capture(view)

    def display(self, name: str, label: str) -> Any:
        if name not in self.displays:
            source, array, association = {
                "wavelet": lambda: (wavelet(), "RTData", "POINTS"),
                "bytes": lambda: (
                    producer(
                        image_data(
                            (blob(28) * 255).astype(np.uint8), "bytes", (1, 2, 1)
                        )
                    ),
                    "bytes",
                    "POINTS",
                ),
                "cells": lambda: (
                    producer(image_data(blob(17, 2.0), "cells", cells=True)),
                    "cells",
                    "CELLS",
                ),
            }[name]()
            display = show(source, self.view, label)
            color_by(display, self.view, array, association)
            self.displays[name] = display
        return self.displays[name]

    @staticmethod
    def apply_function(display: Any, step: Step) -> None:
        name = display.ColorArrayName.GetArrayName()
        low, high = {"RTData": (37.0, 277.0), "bytes": (0.0, 255.0)}.get(
            name, (0.0, 1.0)
        )
        colors, opacity = FUNCTIONS[step.function]
        scaled = [
            low + value * (high - low) if place % 4 == 0 else value
            for place, value in enumerate(colors)
        ]
        set_functions(name, scaled, [(low + x * (high - low), a) for x, a in opacity])


def check_fifty_switches() -> None:
    steps = random_steps()
    stage = Stage()
    first_of: dict[str, int] = {}
    pictures = {}
    for number, step in enumerate(steps):
        picture = stage.picture(step)
        assert not ERRORS.messages, f"{number}: {step}: {ERRORS.take()}"
        first = first_of.setdefault(step.label, number) == number
        if number % SAMPLED == SAMPLED - 1 or (first and step.label not in PEERS):
            pictures[number] = picture
    for number, picture in pictures.items():
        expected = fresh_picture(steps[number])
        check_not_empty(expected, f"{steps[number]}")
        error = rmse(picture, expected)
        print(f"  {number} {steps[number].label}: RMSE {error:.2g}")
        assert error <= SAME_PICTURE, f"{number}: RMSE {error:.2g}: {steps[number]}"


def fresh_picture(step: Step) -> np.ndarray:
    """Draw a step, and nothing before it, in a process of its own."""
    with temporary_folder() as folder:
        (folder / "step.json").write_text(json.dumps(asdict(step)))
        command = ["pvpython", __file__, "fresh", str(folder)]
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=patient_s(120)
        )
        assert done.returncode == 0, f"{step}: {done.stdout}{done.stderr}"
        assert "ERR|" not in done.stderr, f"{step}: {done.stderr}"
        return np.load(folder / "picture.npy")


def fresh(folder: Path) -> None:
    """The other process."""
    load_plugin()
    step = Step(**json.loads((folder / "step.json").read_text()))
    np.save(folder / "picture.npy", Stage().picture(step))


if __name__ == "__main__":
    if sys.argv[1:2] == ["fresh"]:
        fresh(Path(sys.argv[2]))
        sys.stdout.flush()
        os._exit(0)
    run_checks(dict(globals()))
