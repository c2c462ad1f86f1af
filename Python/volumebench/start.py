"""The first picture of a volume and the picture after an edit of its transfer function."""

import json
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from .errors import BenchError
from .json_file import read_json, write_atomically
from .measure import shuffled
from .orbit import orbit_pose
from .results import FAILED, OK, UNSUPPORTED, SetUpTimes, described_values
from .statistics import Spread, spread
from .study import Start, Study
from .techniques import find_technique
from .transfer_functions import TransferFunction
from .view_measure import Sampling, Stage, Unsupported

FILE = "start.json"
EDITED_OPACITY = 0.9
STILL_FRAMES = 3


@dataclass(frozen=True)
class StartRow:
    """What one technique takes for one volume in a render view; times are milliseconds.

    Making the display (`show_ms`) is part of the first picture (`first_ms`): there, ParaView finds
    the ranges of the data, whoever draws them. Set-up is what our mapper tells of its first frame and of the one after an edit; of a peer it
    is absent.
    """

    dataset: str
    dims: tuple[int, int, int]
    scalar_type: str
    technique: str
    status: str = OK
    reason: str | None = None
    show_ms: Spread = field(default_factory=Spread)
    first_ms: Spread = field(default_factory=Spread)
    still_ms: Spread = field(default_factory=Spread)
    edit_ms: Spread = field(default_factory=Spread)
    setup_ms: SetUpTimes = field(default_factory=SetUpTimes)
    edit_setup_ms: SetUpTimes = field(default_factory=SetUpTimes)
    bytes_on_device: int | None = None
    volume_bytes: int | None = None


@dataclass
class _Times:
    """The frames of one technique, over all repeats."""

    show: list[float] = field(default_factory=list)
    first: list[float] = field(default_factory=list)
    still: list[float] = field(default_factory=list)
    edit: list[float] = field(default_factory=list)
    at_first: dict[str, Any] = field(default_factory=dict)
    at_edit: dict[str, Any] = field(default_factory=dict)
    fault: BenchError | None = None


def measure_start(
    open_stage: Callable[[], Stage],
    function: TransferFunction,
    study: Study,
    report: Callable[[float], None],
) -> list[dict[str, Any]]:
    """Return what a row holds beside its volume, for each technique of `study.start`.

    Each repeat opens a new view on a new copy of the data, in which nothing is known of them yet;
    the techniques take turns in an order shuffled with a fixed seed.
    """
    start = study.start
    found = {technique: _Times() for technique in start.techniques}
    for repeat in range(start.repeats):
        for done, technique in enumerate(shuffled(list(start.techniques), repeat)):
            times = found[technique]
            if times.fault is None:
                _guarded(open_stage, function, study, technique, times)
            report((repeat + (done + 1) / len(found)) / start.repeats)
    return [
        {"technique": technique} | _values(times) for technique, times in found.items()
    ]


def _guarded(
    open_stage: Callable[[], Stage],
    function: TransferFunction,
    study: Study,
    technique: str,
    times: _Times,
) -> None:
    """Measure one repeat; whatever goes wrong ends this technique only."""
    stage = open_stage()
    try:
        _repeat(stage, function, study, technique, times)
        if fault := stage.take_errors():
            raise BenchError(fault)
    except BenchError as fault:
        times.fault = fault
    except Exception as fault:  # a proxy may raise anything; the study goes on
        times.fault = BenchError(f"{type(fault).__name__}: {fault}")
    finally:
        stage.close()


def _repeat(
    stage: Stage,
    function: TransferFunction,
    study: Study,
    technique: str,
    times: _Times,
) -> None:
    """Time the first picture, further ones, and those after edits, all from the same place."""
    pose = orbit_pose(0, study.camera.frames, stage.bounds, study.camera)
    peer = find_technique(technique, FILE).peer
    sampling = (None, None) if peer else ("Midpoint", study.start.step_voxels)

    def draw() -> None:
        stage.render(pose, interactive=False)

    shown = Sampling(technique, *sampling, study.termination_threshold)
    times.show.append(_timed(lambda: stage.show(shown)))
    times.first.append(times.show[-1] + _timed(draw))
    times.at_first = stage.describe()
    for _ in range(STILL_FRAMES):
        times.still.append(_timed(draw))
    for edit in range(study.start.edits):
        changed = edited(function) if edit % 2 == 0 else function
        edit_ms = _timed(lambda: stage.set_function(changed))
        times.edit.append(edit_ms + _timed(draw))
        times.at_edit = stage.describe()


def _timed(work: Callable[[], None]) -> float:
    """Return the milliseconds that some work takes."""
    start_s = time.perf_counter()
    work()
    return (time.perf_counter() - start_s) * 1000


def edited(function: TransferFunction) -> TransferFunction:
    """Return a function whose opacities are all a little lower."""
    opacity = tuple((x, EDITED_OPACITY * alpha) for x, alpha in function.opacity)
    return replace(function, opacity=opacity)


def _values(times: _Times) -> dict[str, Any]:
    if times.fault is not None:
        absent = isinstance(times.fault, Unsupported)
        return {"status": UNSUPPORTED if absent else FAILED, "reason": str(times.fault)}
    first, edit = described_values(times.at_first), described_values(times.at_edit)
    return {
        "show_ms": spread(times.show),
        "first_ms": spread(times.first),
        "still_ms": spread(times.still),
        "edit_ms": spread(times.edit),
        "setup_ms": first["setup_ms"],
        "edit_setup_ms": edit["setup_ms"],
        "bytes_on_device": first["bytes_on_device"],
    }


def write_start(folder: Path, start: Start, rows: list[StartRow]) -> None:
    """Write start.json."""
    document = {
        "schema": 1,
        "image_size": start.image_size,
        "transfer_function": start.transfer_function,
        "step_voxels": start.step_voxels,
        "rows": [asdict(row) for row in rows],
    }
    text = json.dumps(document, indent=1, allow_nan=False)
    write_atomically(folder / FILE, text + "\n")


def read_start(folder: Path) -> list[StartRow]:
    """Return the rows of the start.json that write_start left in a folder; none if there is none."""
    path = folder / FILE
    if not path.is_file():
        return []
    return [row_from(values) for values in read_json(path)["rows"]]


def row_from(values: dict[str, Any]) -> StartRow:
    """Return the row of its JSON object."""
    times = {
        name: Spread(**values[name])
        for name in ("show_ms", "first_ms", "still_ms", "edit_ms")
    }
    costs = {name: SetUpTimes(**values[name]) for name in ("setup_ms", "edit_setup_ms")}
    return StartRow(**values | times | costs | {"dims": tuple(values["dims"])})
