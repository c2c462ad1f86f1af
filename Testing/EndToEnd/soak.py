"""Random actions in two views, as of a long day: memory and objects of OpenGL stay as many as they were.

VOLUMEBENCH_SOAK_ACTIONS says how many (100 without it), VOLUMEBENCH_SOAK_SEED which ones (2026). What is
done is printed, so that the last lines tell what a crash came from, and the same seed does it again.
"""

import ctypes
import gc
import os
import random
import statistics
from collections import Counter
from typing import Any

import numpy as np
from paraview import simple
from support import (
    ERRORS,
    blob,
    capture,
    check_not_empty,
    color_by,
    image_data,
    look,
    new_view,
    producer,
    replace_output,
    run_checks,
    set_functions,
    show,
    technique_labels,
    temporary_folder,
)

ACTIONS = int(os.environ.get("VOLUMEBENCH_SOAK_ACTIONS", "100"))
SEED = int(os.environ.get("VOLUMEBENCH_SOAK_SEED", "2026"))
PER_ROUND = 25  # actions from one empty session to the next
MOST_VOLUMES = 3
# Rounds until all that is made once has been made, such as the kernels of OpenCL.
WARM_UP = 0.4
MEGABYTE = 1024 * 1024
# Bytes a round. ParaView's own Volume adds 0.2 MiB; each view whose window VTK forgot added 0.8 MiB.
MOST_GROWTH = 0.5 * MEGABYTE
# VTK keeps each shader of its own that a view has needed, and timers, for as long as the view lives.
KEPT_BY_VTK = ("Program", "Shader", "Query")
FEWEST_ROUNDS = 20  # that tell of growth beside what is made once
NAMES = 4096  # of OpenGL, many more than are in use
KINDS = (
    "Texture",
    "Buffer",
    "Framebuffer",
    "Renderbuffer",
    "Program",
    "Shader",
    "VertexArray",
    "Query",
)

GL = ctypes.CDLL("libGL.so.1")
LIBC = ctypes.CDLL("libc.so.6")


def gl_objects(view: Any) -> Counter:
    """Count the objects of the context that a view draws in."""
    view.GetRenderWindow().MakeCurrent()
    tests = {kind: getattr(GL, f"glIs{kind}") for kind in KINDS}
    for test in tests.values():
        test.restype = ctypes.c_ubyte
    return Counter(
        {
            kind: sum(bool(test(name)) for name in range(1, NAMES))
            for kind, test in tests.items()
        }
    )


def resident_bytes() -> int:
    """Return the memory of this process, after giving back what is free."""
    gc.collect()
    LIBC.malloc_trim(0)
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Session:
    """Two views at most, a few volumes, and what a user may do with them."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.labels = technique_labels()
        self.views = [new_view((90, 80))]
        self.shown: list[tuple[Any, Any, Any]] = []  # source, display, view

    def act(self) -> str:
        """Do something, render, and tell what it was."""
        actions = [self.load, self.open_or_close]
        if self.shown:
            actions += [self.switch, self.edit, self.set, self.resize, self.turn]
            actions += [self.replace, self.delete, self.switch, self.set, self.edit]
        told = self.random.choice(actions)()
        for view in self.views:
            simple.Render(view)
        return told

    def some_image(self) -> Any:
        side = self.random.choice((7, 12, 20))
        values = blob(side, self.random.choice((2.0, 4.0)))
        if self.random.random() < 0.5:
            values = (values * 255).astype(np.uint8)
        return image_data(values, cells=self.random.random() < 0.3)

    def load(self) -> str:
        if len(self.shown) >= MOST_VOLUMES:
            return self.delete()
        view = self.random.choice(self.views)
        source = producer(self.some_image())
        display = show(source, view, self.random.choice(self.labels))
        self.color(source, display, view)
        self.shown.append((source, display, view))
        look(view)
        return "load"

    @staticmethod
    def color(source: Any, display: Any, view: Any) -> None:
        cells = source.GetClientSideObject().GetOutputDataObject(0).GetCellData()
        association = "CELLS" if cells.GetArray("values") else "POINTS"
        color_by(display, view, "values", association)

    def delete(self) -> str:
        source, _, _ = self.shown.pop(self.random.randrange(len(self.shown)))
        simple.Delete(source)
        return "delete"

    def open_or_close(self) -> str:
        if len(self.views) == 1:
            self.views.append(new_view((60, 70)))
            # VTK's interactors open a connection to the X server that they never close.
            self.views[-1].GetRenderWindow().SetInteractor(None)
            return "open a view"
        self.close_second()
        return "close a view"

    def close_second(self) -> None:
        second = self.views.pop()
        for entry in [entry for entry in self.shown if entry[2] is second]:
            simple.Delete(entry[0])
            self.shown.remove(entry)
        simple.Delete(second)

    def switch(self) -> str:
        label = self.random.choice([*self.labels, "Volume", "Outline"])
        self.random.choice(self.shown)[1].SetRepresentationType(label)
        return f"switch to {label}"

    def edit(self) -> str:
        peak = self.random.choice((0.2, 0.5, 0.9))
        high = self.random.choice((1.0, 255.0))
        points = [(0, 0), (peak * high, peak), (high, 0.3)]
        set_functions("values", [0, 0.1, 0.2, 0.9, high, 1, 0.3, 0.1], points)
        return f"edit: {points}"

    def set(self) -> str:
        display = self.random.choice(self.shown)[1]
        name, values = self.random.choice(
            (
                ("Integrator", ("Midpoint", "Segment", "PreIntegrated")),
                ("TechniqueBlendMode", ("Composite", "Maximum")),
                ("StepVoxels", (0.5, 1.0, 2.0)),
                ("Shade", (0, 1)),
                ("Visibility", (0, 1)),
            )
        )
        value = self.random.choice(values)
        setattr(display, name, value)
        return f"{name} = {value}"

    def resize(self) -> str:
        size = [self.random.randint(20, 160), self.random.randint(20, 160)]
        self.random.choice(self.views).ViewSize = size
        return f"resize to {size}"

    def turn(self) -> str:
        camera = self.random.choice(self.views).GetActiveCamera()
        camera.Azimuth(self.random.uniform(-90, 90))
        return "turn"

    def replace(self) -> str:
        source, display, view = self.random.choice(self.shown)
        replace_output(source, self.some_image())
        self.color(source, display, view)
        return "other data"

    def clear(self) -> tuple[Counter, int]:
        """Leave one view with nothing in it; count objects and bytes."""
        while self.shown:
            self.delete()
        if len(self.views) > 1:
            self.close_second()
        self.views[0].ViewSize = [90, 80]
        simple.Render(self.views[0])
        return gl_objects(self.views[0]), resident_bytes()


def check_random_actions() -> None:
    with temporary_folder() as folder:
        # PoCL takes memory for its compiler when it first needs it: here, not in some later round.
        os.environ["POCL_CACHE_DIR"] = str(folder)
        run_random_actions(Session(SEED))


def run_random_actions(session: Session) -> None:
    objects: list[Counter] = []
    memory: list[int] = []
    for number in range(ACTIONS):
        told = session.act()
        print(f"  {number} {told}", flush=True)
        assert not ERRORS.messages, f"{number}: {told}: {ERRORS.take()}"
        if number % PER_ROUND == PER_ROUND - 1:
            counted, held = session.clear()
            print(f"  {dict(counted)}, {held / MEGABYTE:.1f} MiB", flush=True)
            objects.append(counted)
            memory.append(held)
    check_objects(objects)
    check_memory(memory)
    check_draws(session)


def warm_rounds(rounds: list) -> int:
    return max(2, int(WARM_UP * len(rounds)))


def check_objects(objects: list[Counter]) -> None:
    """An empty view has no more objects than it had when it had drawn the first few volumes."""
    warm = warm_rounds(objects)
    most = Counter()
    for counted in objects[:warm]:
        most |= counted
    few = len(objects) - warm < FEWEST_ROUNDS
    for number, counted in enumerate(objects[warm:], warm):
        grown = counted - most
        for kind in KEPT_BY_VTK if few else ():
            grown.pop(kind, None)
        assert not grown, f"round {number}: {dict(grown)} more than before"


def check_memory(memory: list[int]) -> None:
    """Most of the later rounds add no more than ParaView's own Volume does.

    What is made once, such as a kernel of OpenCL for settings that had not met yet, adds to few rounds.
    """
    later = memory[warm_rounds(memory) :]
    if len(later) < FEWEST_ROUNDS:
        return
    growth = statistics.median(
        after - before for before, after in zip(later, later[1:])
    )
    print(f"  {growth / MEGABYTE:.2f} MiB more in most rounds")
    assert growth <= MOST_GROWTH, "memory grows"


def check_draws(session: Session) -> None:
    """After all that, the view still shows a volume."""
    view = session.views[0]
    for label in session.labels:
        source = producer(image_data(blob(), "good"))
        display = show(source, view, label)
        color_by(display, view, "good")
        look(view)
        check_not_empty(capture(view), label)
        simple.Delete(source)


if __name__ == "__main__":
    run_checks({"check_random_actions": check_random_actions})
