"""The record of a study: results.json and results.csv, where an absent measurement is null."""

import csv
import io
import json
import math
import re
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import Any

from .error import ImageError
from .errors import BenchError
from .json_file import check_schema, read_json, write_atomically
from .statistics import Spread, spread
from .study import COMPOSITE, Run, Scene

SCHEMA = 1
OK = "ok"
UNSUPPORTED = "unsupported"
FAILED = "failed"
_LISTS = ("features", "left_out")
_NESTED = ("stages_ms", "settings")


@dataclass(frozen=True)
class Context:
    """The machine and the programs that the figures belong to."""

    date: str | None = None
    host: str | None = None
    cpu: str | None = None
    cores: int | None = None
    gl_renderer: str | None = None
    gl_version: str | None = None
    paraview: str | None = None
    vtk: str | None = None
    plugin: str | None = None
    build_type: str | None = None
    cuda_device: str | None = None
    opencl_device: str | None = None
    calibration: dict[str, Any] | None = None
    os: str | None = None
    kernel: str | None = None
    memory_gb: float | None = None
    cpu_governor: str | None = None
    load_average: float | None = None  # of the last minute before measuring
    source: str | None = None  # commit of the sources, "+" where they were changed


@dataclass
class FrameLog:
    """Every timed frame, none left out: frame of the camera path, milliseconds, and the GPU's."""

    frame: list[int] = field(default_factory=list)
    ms: list[float] = field(default_factory=list)
    gpu_ms: list[float | None] = field(default_factory=list)

    def extend(self, more: "FrameLog") -> None:
        """Append the frames of another log."""
        self.frame += more.frame
        self.ms += more.ms
        self.gpu_ms += more.gpu_ms

    def since(self, first: int) -> "FrameLog":
        """Return the frames from an index on."""
        return FrameLog(self.frame[first:], self.ms[first:], self.gpu_ms[first:])


@dataclass(frozen=True)
class SetUpTimes:
    """Milliseconds of the work done once before the first frame."""

    upload: float | None = None
    tables: float | None = None
    grid: float | None = None
    compile: float | None = None


@dataclass(frozen=True)
class Record:
    """One row of results.json; the order of the fields is the order in the file."""

    study: str
    dataset: str
    dims: tuple[int, int, int] | None
    scalar_type: str | None
    transfer_function: str
    technique: str
    integrator: str | None
    blend_mode: str | None
    step_voxels: float | None
    image_size: tuple[int, int]
    view: str
    path: str
    settings: dict[str, Any] = field(default_factory=dict)
    lighting: bool = False
    stand_in_for: str | None = None
    features: tuple[str, ...] | None = None
    left_out: tuple[str, ...] | None = None
    status: str = OK
    reason: str | None = None
    frames: int | None = None
    frame_ms: Spread = field(default_factory=Spread)
    gpu_ms: Spread = field(default_factory=Spread)
    fps: float | None = None
    frame_log: FrameLog | None = None
    setup_ms: SetUpTimes = field(default_factory=SetUpTimes)
    stages_ms: dict[str, float | None] | None = None
    samples_taken: int | None = None
    samples_skipped: int | None = None
    rays_terminated: int | None = None
    bytes_on_device: int | None = None
    error: ImageError = field(default_factory=ImageError)

    def run(self) -> Run:
        """Return the run that this row answers."""
        blending = self.blend_mode or COMPOSITE
        scene = Scene(
            self.dataset,
            self.transfer_function,
            self.image_size,
            blending,
            self.lighting,
        )
        return Run(
            self.study,
            scene,
            self.technique,
            self.integrator,
            self.step_voxels,
            self.view,
            self.path,
            tuple(self.settings.items()),
        )


def record_of(
    run: Run, dims: tuple | None, scalar_type: str | None, **values: Any
) -> Record:
    """Return the record of a run with the measured values given by name."""
    scene = run.scene
    return Record(
        study=run.study,
        dataset=scene.dataset,
        dims=dims,
        scalar_type=scalar_type,
        transfer_function=scene.transfer_function,
        technique=run.technique,
        integrator=run.integrator,
        blend_mode=scene.blend_mode,
        step_voxels=run.step_voxels,
        image_size=scene.image_size,
        view=run.view,
        path=run.path,
        settings=dict(run.settings),
        lighting=scene.lighting,
        **values,
    )


def times(log: FrameLog) -> dict[str, Any]:
    """Return the record values that follow from measured frames."""
    summary = spread(log.ms)
    fps = 1000 / summary.median if summary.median else None
    return {
        "frames": len(log.ms) or None,
        "frame_ms": summary,
        "fps": fps,
        "frame_log": log if log.ms else None,
    }


def values_of_row(row: dict[str, Any]) -> dict[str, Any]:
    """Return the record values of a table row whose columns are dotted paths."""
    cleaned = {name: _cleaned(value) for name, value in row.items()}
    values = described_values(row)
    for name, group in (
        ("frame_ms", Spread),
        ("gpu_ms", Spread),
        ("error", ImageError),
    ):
        values[name] = _group_of(cleaned, name, group)
    values["error"] = replace(values["error"], image_size=_error_size(cleaned))
    stages, log = cleaned.get("stages_ms"), cleaned.get("frame_log")
    values["stages_ms"] = json.loads(stages) if stages else None
    values["frame_log"] = FrameLog(**json.loads(log)) if log else None
    for name in ("frames", "samples_taken", "samples_skipped", "rays_terminated"):
        values[name] = _whole(cleaned.get(name))
    for name in ("fps", "reason"):
        values[name] = cleaned.get(name)
    values["status"] = cleaned.get("status") or FAILED
    return values


def described_values(row: dict[str, Any]) -> dict[str, Any]:
    """Return what a mapper tells of its last frame, from columns whose names are dotted paths."""
    cleaned = {name: _cleaned(value) for name, value in row.items()}
    values: dict[str, Any] = {
        "setup_ms": _group_of(cleaned, "setup_ms", SetUpTimes),
        "bytes_on_device": _whole(cleaned.get("bytes_on_device")),
    }
    for name in _LISTS:
        text = cleaned.get(name)
        values[name] = tuple(text.split()) if text else () if name in row else None
    return values


def _group_of(row: dict[str, Any], name: str, group: type) -> Any:
    return group(
        **{part.name: row.get(f"{name}.{part.name}") for part in fields(group)}
    )


def _error_size(row: dict[str, Any]) -> tuple[int, int] | None:
    width, height = (row.get(f"error.image_size.{side}") for side in "wh")
    return (int(width), int(height)) if width and height else None


def _cleaned(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return None if value == "" else value


def _whole(value: Any) -> int | None:
    return None if value is None else round(value)


def write_results(folder: Path, context: Context, records: list[Record]) -> None:
    """Write results.json and results.csv."""
    document = {
        "schema": SCHEMA,
        "context": asdict(context),
        "runs": [asdict(record) for record in records],
    }
    text = _with_short_lists(json.dumps(document, indent=1, allow_nan=False))
    write_atomically(folder / "results.json", text + "\n")
    write_atomically(folder / "results.csv", as_csv(records))


def _with_short_lists(text: str) -> str:
    """Return JSON text with each list of numbers on one line."""
    numbers = r"\[\s*((?:[-+.\deE]+|null)(?:,\s*(?:[-+.\deE]+|null))*)\s*\]"

    def on_one_line(found: re.Match[str]) -> str:
        return "[" + re.sub(r",\s*", ", ", found.group(1)) + "]"

    return re.sub(numbers, on_one_line, text)


def read_results(path: Path) -> tuple[Context, list[Record]]:
    """Read a results.json that this package wrote."""
    document = read_json(path)
    check_schema(document, "results_schema.json", path)
    records = [record_from(row) for row in document["runs"]]
    return Context(**document["context"]), records


def record_from(row: dict[str, Any]) -> Record:
    """Return the record of a row of results.json."""
    values = dict(row)
    if values.get("frame_log") is not None:
        values["frame_log"] = FrameLog(**values["frame_log"])
    for name in ("dims", "image_size", *_LISTS):
        values[name] = None if values[name] is None else tuple(values[name])
    for name, group in (
        ("frame_ms", Spread),
        ("gpu_ms", Spread),
        ("setup_ms", SetUpTimes),
        ("error", ImageError),
    ):
        values[name] = group(**values[name])
    size = values["error"].image_size
    if size is not None:
        error = replace(values["error"], image_size=tuple(size))
        values["error"] = error
    return Record(**values)


def flattened(record: Record) -> dict[str, Any]:
    """Return the record with dotted names; lists are joined, sizes split in w and h.

    Objects whose keys differ from row to row stay JSON text in one cell.
    """
    flat: dict[str, Any] = {}
    for name, value in asdict(record).items():
        if name == "frame_log":
            continue  # one row per run has no room for every frame
        if name in _NESTED:
            flat[name] = json.dumps(value) if value else None
        elif isinstance(value, dict):
            for part, item in value.items():
                flat.update(_flat_value(f"{name}.{part}", item))
        elif name == "dims":
            flat[name] = None if value is None else "x".join(str(n) for n in value)
        elif name in _LISTS:
            flat[name] = None if value is None else " ".join(value)
        else:
            flat.update(_flat_value(name, value))
    return flat


def _flat_value(name: str, value: Any) -> dict[str, Any]:
    """Return one cell, or two for the size of a picture."""
    if not name.endswith("image_size"):
        return {name: value}
    return dict(zip((f"{name}.w", f"{name}.h"), value or (None, None)))


def as_csv(records: list[Record]) -> str:
    """Return the records as comma-separated text with a header line."""
    rows = [flattened(record) for record in records]
    stream = io.StringIO()
    if rows:
        writer = csv.DictWriter(stream, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return stream.getvalue()


def check_same_settings(folder: Path, settings: dict[str, Any]) -> None:
    """Refuse to resume into a folder whose study had other settings."""
    path = folder / "settings.json"
    if not path.is_file():
        raise BenchError(
            f"{folder}: --resume: settings.json is missing, so the rows cannot be trusted; "
            "measure into a new folder"
        )
    stored = read_json(path)
    for key, value in settings.items():
        if stored.get(key) != value:
            raise BenchError(
                f'{path}: --resume: "{key}" was {json.dumps(stored.get(key))} and is now '
                f"{json.dumps(value)}; measure into a new folder"
            )


def write_settings(folder: Path, settings: dict[str, Any]) -> None:
    """Keep the settings of the study beside its results."""
    write_atomically(folder / "settings.json", json.dumps(settings, indent=1) + "\n")
