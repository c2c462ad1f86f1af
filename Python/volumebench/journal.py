"""What an unfinished study has measured so far, so that nothing of it is lost when it is ended.

journal.jsonl holds one JSON object a line and is only ever appended to, each line on the disk before
the next begins: frames of a run, its error, and its whole row once it is measured.
"""

import fcntl
import json
import os
import re
import shutil
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from .error import ImageError
from .errors import BenchError, OutputError
from .results import FrameLog, Record, record_from
from .start import StartRow, row_from
from .study import Run, Scene
from .kept_pictures import Pictures

FILE = "journal.jsonl"
PICTURE_FOLDER = "unfinished"
LOCK_FILE = ".lock"


class FolderLock:
    """Keeps other runs out of an output folder; it ends with the process, however that ends."""

    def __init__(self, folder: Path) -> None:
        path = folder / LOCK_FILE
        try:
            self._stream = open(path, "a+", encoding="ascii")
            fcntl.flock(self._stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._stream.seek(0)
            owner = self._stream.read().strip() or "unknown"
            self._stream.close()
            raise BenchError(
                f"{folder}: another run measures into this folder (process {owner})"
            ) from None
        except OSError as fault:
            raise BenchError(f"{path}: cannot be locked: {fault.strerror}") from None
        try:
            self._stream.truncate(0)
            self._stream.write(f"{os.getpid()}\n")
            self._stream.flush()
        except OSError as fault:
            raise BenchError(f"{path}: cannot be written: {fault.strerror}") from None

    def close(self) -> None:
        """Let others in."""
        self._stream.close()


@dataclass
class RunProgress:
    """What was measured of a run that has no row yet."""

    log: FrameLog = field(default_factory=FrameLog)
    error: ImageError | None = None


@dataclass
class Measured:
    """What a journal holds, by the text of the run."""

    records: dict[str, Record] = field(default_factory=dict)
    progress: dict[str, RunProgress] = field(default_factory=dict)
    start_rows: dict[str, list[StartRow]] = field(default_factory=dict)

    def of(self, run: Run) -> RunProgress:
        """Return what is known of a run, which is nothing at first."""
        return self.progress.setdefault(run_text(run), RunProgress())


def run_text(run: Run) -> str:
    """Return a run as text that tells it from all others of the study."""
    return json.dumps(
        [
            *(run.study, run.scene.title(), run.view, run.path),
            *(run.technique, run.integrator, run.step_voxels),
            sorted(run.settings),
        ]
    )


class Journal:
    """Appends to the journal of an output folder."""

    def __init__(self, folder: Path) -> None:
        self._path = folder / FILE
        try:
            _end_last_line(self._path)
            self._stream = open(self._path, "ab", buffering=0)
        except OSError as fault:
            raise self._fault(fault) from None

    def frames(self, run: Run, log: FrameLog) -> None:
        """Keep frames that were timed."""
        self._append({"run": run_text(run), "frames": asdict(log)})

    def error(self, run: Run, error: ImageError) -> None:
        """Keep the error of a run."""
        self._append({"run": run_text(run), "error": asdict(error)})

    def record(self, record: Record) -> None:
        """Keep the row of a run, which makes it one that is measured."""
        self._append({"run": run_text(record.run()), "record": asdict(record)})

    def start(self, dataset: str, rows: list[StartRow]) -> None:
        """Keep the first pictures of a volume."""
        self._append({"start": dataset, "rows": [asdict(row) for row in rows]})

    def close(self) -> None:
        """Close the file."""
        self._stream.close()

    def _append(self, entry: dict[str, Any]) -> None:
        line = (json.dumps(entry, allow_nan=False) + "\n").encode("utf-8")
        try:
            while line:  # a disk that is nearly full takes a part
                line = line[self._stream.write(line) :]
            os.fsync(self._stream.fileno())
        except OSError as fault:
            raise self._fault(fault) from None

    def _fault(self, fault: OSError) -> OutputError:
        return OutputError(f"{self._path}: cannot be written: {fault.strerror}")


def _end_last_line(path: Path) -> None:
    """Cut off what a process wrote of a line while it was ended."""
    if path.is_file():
        content = path.read_bytes()
        whole = content.rfind(b"\n") + 1
        if whole < len(content):
            os.truncate(path, whole)


def read_journal(folder: Path) -> Measured:
    """Return what the journal of a folder holds; an unfinished last line counts for nothing."""
    path = folder / FILE
    found = Measured()
    if not path.is_file():
        return found
    content = path.read_bytes()
    lines = content[: content.rfind(b"\n") + 1].splitlines()
    for number, line in enumerate(lines, 1):
        try:
            _take(json.loads(line), found)
        except (ValueError, KeyError, TypeError) as fault:
            raise BenchError(
                f"{path}: line {number} is damaged ({type(fault).__name__}); remove the file to "
                "measure anew what results.json does not hold"
            ) from None
    return found


def _take(entry: dict[str, Any], found: Measured) -> None:
    if "start" in entry:
        found.start_rows[entry["start"]] = [row_from(row) for row in entry["rows"]]
        return
    run = entry["run"]
    if "record" in entry:
        found.records[run] = record_from(entry["record"])
        return
    progress = found.progress.setdefault(run, RunProgress())
    if "frames" in entry:
        progress.log.extend(FrameLog(**entry["frames"]))
    else:
        error = entry["error"]
        size = error["image_size"]
        progress.error = ImageError(
            **error | {"image_size": None if size is None else tuple(size)}
        )


def forget_journal(folder: Path) -> None:
    """Remove the journal and the pictures that belong to it."""
    (folder / FILE).unlink(missing_ok=True)
    shutil.rmtree(folder / PICTURE_FOLDER, ignore_errors=True)


class PictureStore:
    """The pictures of a scene that is not finished, as files in the output folder."""

    def __init__(self, folder: Path, scene: Scene, group: str) -> None:
        self._folder = folder / PICTURE_FOLDER / f"{scene.file_stem()}-{group}"

    def keep(self, run: Run, picture: np.ndarray) -> None:
        """Keep the picture of a technique in place of an earlier one."""
        self._write(run.technique, picture, run_text(run))

    def keep_reference(self, pictures: Pictures) -> None:
        """Keep the reference of the first view."""
        label = json.dumps([pictures.label, pictures.uncertainty])
        self._write("reference.truth", pictures.references[0], label)

    def load(self, runs: list[Run]) -> Pictures:
        """Return the pictures of runs of the study."""
        by_text = {run_text(run): run for run in runs}
        pictures = Pictures()
        for file in sorted(self._folder.glob("*.npz")):
            with np.load(file, allow_pickle=False) as stored:
                image, text = stored["image"], str(stored["text"])
            if file.name == "reference.truth.npz":
                pictures.references = [image]
                pictures.label, pictures.uncertainty = json.loads(text)
            elif text in by_text:
                pictures.keep(by_text[text], image)
        return pictures

    def _write(self, name: str, image: np.ndarray, text: str) -> None:
        if not re.fullmatch(r"[\w.-]+", name):
            raise BenchError(f'"{name}" cannot be the name of a picture')
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            temporary = self._folder / f"{name}.tmp"
            with open(temporary, "wb") as stream:
                np.savez(stream, image=image, text=np.array(text))
            temporary.replace(self._folder / f"{name}.npz")
        except OSError as fault:
            raise OutputError(
                f"{self._folder}: cannot be written: {fault.strerror}"
            ) from None
