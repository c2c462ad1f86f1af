"""What the benchmark filter tells while it measures, and what it is told of earlier frames."""

import json
from pathlib import Path
from typing import Any

import numpy as np

from .kept_pictures import Pictures
from .results import FrameLog, values_of_row
from .study import Run
from .watch import Watch

REFERENCE_FILE = "reference.rgba32f"


def earlier_text(run: Run, watch: Watch) -> str:
    """Return what the filter is told of an earlier measurement, to follow the text of a variant."""
    log = watch.earlier_log(run)
    parts = []
    if log.ms:
        gpu = ["nan" if value is None else repr(value) for value in log.gpu_ms]
        parts.append(f"frames_ms={' '.join(map(repr, log.ms))}")
        parts.append(f"frames_gpu_ms={' '.join(gpu)}")
    if watch.earlier_error(run) is not None:
        parts.append("error_known=true")
    return "".join(f"; {part}" for part in parts)


class FilterNotes:
    """Hands the notes of the filter on: a note names its run by the place among the variants."""

    def __init__(self, runs: list[Run], folder: Path, watch: Watch) -> None:
        self.watch = watch
        self.pictures = Pictures()
        self._runs = runs
        self._folder = folder

    def take(self, _caller: Any, _event: str, text: str = "") -> None:
        """Take a note; VTK calls this."""
        note = json.loads(text)
        run = self._runs[note["run"]] if note["run"] >= 0 else None
        event = note["event"]
        if event == "begin":
            self.watch.begin(run, note["work"])
        elif event == "frames":
            self.watch.frames(run, FrameLog(**note["log"]))
        elif event == "error":
            self._take_error(run, note["row"])
        elif event == "done":
            self.watch.done(run, self.values(run, note["row"]))

    take.CallDataType = "string0"

    def values(self, run: Run, row: dict[str, Any]) -> dict[str, Any]:
        """Return the values of a record, with the error of an earlier measurement if there is one."""
        values = values_of_row(row)
        earlier = self.watch.earlier_error(run)
        return values if earlier is None else values | {"error": earlier}

    def _take_error(self, run: Run, row: dict[str, Any]) -> None:
        error = values_of_row(row)["error"]
        if row["picture"]:
            self._keep_picture(run, row, error.image_size, error.reference)
            self.pictures.uncertainty = error.reference_uncertainty
        self.watch.error(run, error)

    def _keep_picture(
        self, run: Run, row: dict[str, Any], size: tuple[int, int], label: str | None
    ) -> None:
        """Keep what the filter drew for the run, and the reference with the first of them."""
        if not self.pictures.references:
            self.pictures.references = [self._read(REFERENCE_FILE, size)]
            self.pictures.label = label
            self.watch.reference(self.pictures)
        picture = self._read(row["picture"], size)
        if self.pictures.keep(run, picture):
            self.watch.picture(run, picture)

    def _read(self, name: str, size: tuple[int, int]) -> np.ndarray:
        values = np.fromfile(self._folder / name, "<f4")
        return values.reshape(size[1], size[0], 4)[::-1].copy()
