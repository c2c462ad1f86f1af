"""The walk of Documentation/walk.md in ParaView's window: every name in it is what the window says.

Names are in the page's bold and italics; a step finds what it uses by one of them, and each must be
used. The pictures are those of the page. Environment: VOLUMEBENCH_PICTURES, a folder that they go
to; without it they are compared with those of the page instead, and left in VOLUMEBENCH_DIFFERENT
where they differ.
"""

import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from paraview import simple
from patience import patient_s
from PyQt5.QtCore import QTimer
from PyQt5.QtWidgets import (
    QAbstractButton,
    QDialog,
    QLabel,
    QLineEdit,
    QScrollArea,
    QSlider,
    QTextEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)
from support import temporary_folder
from walk_pictures import Pictures
from window import (
    advanced,
    application,
    apply,
    display_panel,
    dock,
    headings,
    labels,
    main_window,
    menu_entry,
    press,
    represent,
    representations,
    row,
    rows,
    settle,
    slide,
    source_panel,
    wait_until,
)

ROOT = Path(__file__).resolve().parents[3]
PAGE = ROOT / "Documentation" / "walk.md"


class Page:
    """The names in the page, and which of them the walk has used."""

    def __init__(self, text: str) -> None:
        self.names: set[str] = set()
        self.used: set[str] = set()

        def keep(found: re.Match) -> str:
            self.names.add(" ".join("".join(found.groups()).split()))
            return " "

        text = re.sub(r"```.*?```|`[^`]*`|!?\[[^]]*\]\([^)]*\)", " ", text, flags=re.S)
        # The first has bold at its end, the others are all bold and all italics.
        for form in (r"\*([^*]+)\*\*([^*]+)\*{3}", r"\*\*([^*]+)\*\*", r"\*([^*]+)\*"):
            text = re.sub(form, keep, text)

    def name(self, text: str) -> str:
        """Return the name, which must be in the page."""
        assert text in self.names, f"the page does not name {text}: {self.names}"
        self.used.add(text)
        return text

    def path(self, text: str) -> list[str]:
        """Return the steps through the menus that the page writes as A > B > C."""
        return self.name(text).split(" > ")


def check_the_walk() -> None:
    page = Page(PAGE.read_text(encoding="utf-8"))
    with temporary_folder() as folder:
        volume = folder / "your-volume.mhd"
        make_volume(volume)
        wanted = os.environ.get("VOLUMEBENCH_PICTURES")
        pictures = Pictures(Path(wanted or folder))
        widen_panel()
        find_plugin(page)
        open_volume(page, volume, pictures)
        display = choose_technique(page, pictures)
        edit(page, display, pictures)
        ask(page, display, pictures)
        measure(page, pictures)
        assert page.used == page.names, f"never used: {page.names - page.used}"
        if not wanted:
            pictures.compare()


def make_volume(path: Path) -> None:
    command = [
        "/usr/bin/python3", str(ROOT / "Python" / "generate.py"),
        "lemniscate", "--dims", "40", "40", "60", "--out", str(path)
    ]  # fmt: skip
    limit_s = patient_s(60)
    subprocess.run(command, check=True, timeout=limit_s, stdout=sys.__stdout__)


# --- steps -----------------------------------------------------------------------------------


def widen_panel() -> None:
    panel, browser = dock("propertiesDock"), dock("pipelineBrowserDock")
    main_window().resizeDocks([panel], [430], 1)
    main_window().resizeDocks([browser, panel], [120, 800], 2)
    settle(300)


def in_dialog(entry: Any, use: Any) -> None:
    """Choose an entry of a menu, and use the dialog that it opens, which `use` has to close."""
    faults: list[BaseException] = []
    timer = QTimer(main_window())

    def look() -> None:
        dialog = application().activeModalWidget()
        if dialog:
            timer.stop()
            try:
                use(dialog)
            except BaseException as fault:  # Qt would only print it
                faults.append(fault)
                dialog.close()

    timer.timeout.connect(look)  # a dialog keeps the line below waiting
    timer.start(300)
    entry.trigger()
    wait_until(lambda: not timer.isActive(), "a dialog")
    if faults:
        raise faults[0]


def find_plugin(page: Page) -> None:
    """Look at the list of plugins, where the page says how to load ours."""
    *path, button = page.path("Tools > Manage Plugins > Load New")

    def look(dialog: QDialog) -> None:
        texts = [one.text() for one in dialog.findChildren(QAbstractButton)]
        assert any(one.startswith(button) for one in texts), texts
        items = [
            item
            for tree in dialog.findChildren(QTreeWidget)
            for item in all_items(tree.invisibleRootItem())
        ]
        (ours,) = [one for one in items if one.text(0) == "VolumeBench"]
        assert ours.text(1) == "Loaded", ours.text(1)
        parts = [one.text(0) for one in all_items(ours)]
        assert page.name("Auto Load") in parts, parts
        dialog.close()

    in_dialog(menu_entry(path[0], f"{path[1]}..."), look)


def all_items(root: QTreeWidgetItem) -> list[QTreeWidgetItem]:
    children = [root.child(index) for index in range(root.childCount())]
    return children + [one for child in children for one in all_items(child)]


def open_volume(page: Page, volume: Path, pictures: Pictures) -> None:
    menu, entry = page.path("File > Open")

    def name_the_file(dialog: QDialog) -> None:
        dialog.findChild(QLineEdit, "EntityName").setText(str(volume))
        press(dialog, "OK")

    in_dialog(menu_entry(menu, f"{entry}..."), name_the_file)
    wait_until(simple.GetActiveSource, "the file's reader")
    button = dock("propertiesDock").findChild(QAbstractButton, "Accept")
    assert button.text().replace("&", "") == page.name("Apply"), button.text()
    apply()
    settle(500)
    pictures.save("1-open")


def choose_technique(page: Page, pictures: Pictures) -> Any:
    label = page.name("Volume Compute")
    listed = representations()
    offered = [listed.itemText(index) for index in range(listed.count())]
    ours = [one for one in offered if one.startswith(page.name("Volume") + " ")]
    assert label in ours and len(ours) > 5, offered
    represent(label)
    view = simple.GetActiveView()
    camera = view.GetActiveCamera()
    camera.Azimuth(30)
    camera.Elevation(20)
    simple.ResetCamera(view)
    simple.Render(view)
    pictures.save("2-compute")
    return simple.GetDisplayProperties()


def edit(page: Page, display: Any, pictures: Pictures) -> None:
    """The colour map's editor, the step, and the advanced rows."""
    press(row("ColorEditor"), page.name("Edit"))
    editor = dock("colorMapEditorDock")
    wait_until(editor.isVisible, "the Color Map Editor")
    assert editor.windowTitle() == page.name("Color Map Editor"), editor.windowTitle()
    assert page.name("Volume Techniques") in headings(display_panel())
    slide(labelled(display, page.name("Step (voxels)")).findChild(QSlider), 0.25)
    assert 0.9 < display.StepVoxels < 1.1, display.StepVoxels
    settle(500)
    pictures.save("3-edit")
    editor.hide()
    few = len(rows(display_panel()))
    advanced(True)
    assert len(rows(display_panel())) > few + 5, "the gear shows no more rows"
    advanced(False)


def labelled(display: Any, label: str) -> QWidget:
    """Return the row with a label, which stands before it or in it."""
    named = [
        one
        for one in rows(display_panel())
        if display.SMProxy.GetProperty(one)
        and display.SMProxy.GetProperty(one).GetXMLLabel() == label
    ]
    assert len(named) == 1, f"{label} is the label of {named}"
    within = [one.text() for one in row(named[0]).findChildren(QLabel)]
    shown = labels(display_panel()) + within
    assert label in shown, shown
    return row(named[0])


def ask(page: Page, display: Any, pictures: Pictures) -> None:
    """What the picture is worth, and what it costs."""
    press(display_panel(), page.name("Estimate Error"))
    wait_until(lambda: (display.ErrorText or "").startswith("RMSE"), "an error", 120)
    wait_until(lambda: "ErrorRmse" in rows(display_panel()), "its row")
    press(display_panel(), page.name("Count Samples"))
    wait_until(lambda: "SamplesText" in rows(display_panel()), "the samples")
    for unit in ("ms", "samples"):
        field = labelled(display, f"{page.name('Last Frame')} ({unit})")
        assert field.findChild(QLineEdit).text(), f"no {unit}"
    left_out = labelled(display, page.name("Left Out")).findChild(QTextEdit)
    assert "shading (off)" in left_out.toPlainText(), left_out.toPlainText()
    scroll_to(display_panel, "LeftOutText")
    pictures.save("4-error")


def scroll_to(panel: Callable[[], QWidget], name: str) -> None:
    """Bring a row into sight, from the top: else what came before and when decides what stands above it."""
    settle(500)
    area = dock("propertiesDock").findChild(QScrollArea, "scrollArea")
    area.verticalScrollBar().setValue(0)
    area.ensureWidgetVisible(rows(panel())[name])


def measure(page: Page, pictures: Pictures) -> None:
    *menus, name = page.path("Filters > Volume > Volume Benchmark")
    menu_entry(*menus, name).trigger()
    settle(300)
    source = simple.GetActiveSource()
    assert page.name("Techniques") in headings(source_panel()), headings(source_panel())
    source.ImageSize = [200, 200]
    source.TimeLimit = 1.0
    source.StepVoxels = [2.0, 1.0, 0.5]
    apply()
    wait_until(lambda: len(simple.GetViews()) == 3, "table and chart")
    scroll_to(source_panel, "ErrorViews")
    pictures.save("5-benchmark")
