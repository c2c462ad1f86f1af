"""Path `engine`: measures the runs of one scene through the filter proxy VolumeBenchmark."""

import json
import math
import tempfile
from pathlib import Path
from typing import Any

from paraview import servermanager, simple

from .errors import BenchError
from .filter_notes import FilterNotes, earlier_text
from .results import FAILED, UNSUPPORTED, Record, record_of
from .session_support import ErrorLog, producer_of, rows_of
from .study import Run, Study
from .technique_settings import variant_text
from .techniques import ENGINE, TECHNIQUES
from .transfer_functions import TransferFunction
from .kept_pictures import Pictures
from .volume_io import OpenVolume
from .watch import Watch

FILTER_PROXY = "VolumeBenchmark"


def run_engine(
    study: Study,
    volume: OpenVolume,
    function: TransferFunction,
    runs: list[Run],
    labels: list[str],
    watch: Watch,
) -> tuple[list[Record], Pictures]:
    """Measure the runs that this build has a technique for; return one record per run."""
    present = [run for run in runs if _is_present(run, labels)]
    measured: dict[Run, Record] = {}
    pictures = Pictures()
    with tempfile.TemporaryDirectory(prefix="volumebench-") as folder:
        if present:
            notes = FilterNotes(present, Path(folder), watch)
            rows, reason = _execute(
                study, volume, function, present, Path(folder), notes
            )
            for run in present:
                row = next((row for row in rows if _answers(row, run)), None)
                values = notes.values(run, row) if row else _unknown(reason)
                measured[run] = record_of(
                    run, volume.dims, volume.scalar_type, **values
                )
            pictures = notes.pictures
    return [measured.get(run) or _absent(run, volume) for run in runs], pictures


def _is_present(run: Run, labels: list[str]) -> bool:
    technique = TECHNIQUES[run.technique]
    return technique.peer or technique.representation in labels


def _absent(run: Run, volume: OpenVolume) -> Record:
    label = TECHNIQUES[run.technique].representation
    reason = f'no representation "{label}" in this build'
    outcome = {"status": UNSUPPORTED, "reason": reason}
    return record_of(run, volume.dims, volume.scalar_type, **outcome)


def _execute(
    study: Study,
    volume: OpenVolume,
    function: TransferFunction,
    runs: list[Run],
    folder: Path,
    notes: FilterNotes,
) -> tuple[list[dict[str, Any]], str]:
    """Execute the filter once for all runs, so that it can measure them in turns.

    Return its rows, and what to tell of a run that is not among them.
    """
    maker = getattr(servermanager.filters, FILTER_PROXY, None)
    if maker is None:
        raise BenchError(f"the plugin has no filter {FILTER_PROXY}")
    producer = producer_of(volume)
    bench = maker(Input=producer)
    try:
        _set_properties(bench, study, volume, function, runs)
        _set_factors(bench, runs, notes.watch)
        # A view shows pictures of its own; the filter's are for studies without one.
        bench.PictureFolder = str(folder) if study.paths == (ENGINE,) else ""
        inner = bench.GetClientSideObject()
        inner.AddObserver(
            "ProgressEvent", lambda *_: notes.watch(inner.GetProgress() * len(runs))
        )
        inner.AddObserver("UserEvent", notes.take)
        with ErrorLog() as log:
            bench.UpdatePipeline()
        rows = rows_of(inner.GetOutputDataObject(0))
        return rows, log.text() or "the filter returned no row for this run"
    finally:
        del bench
        simple.Delete(producer)


def _set_properties(
    bench: Any,
    study: Study,
    volume: OpenVolume,
    function: TransferFunction,
    runs: list[Run],
) -> None:
    values = function.in_values(*volume.range)
    bench.Array = ["POINTS", volume.array]
    bench.ImageSize = list(runs[0].scene.image_size)
    bench.TerminationThreshold = study.termination_threshold
    bench.RaySetUp = study.ray_set_up
    bench.BlendMode = runs[0].scene.blend_mode
    bench.Shade = int(runs[0].scene.lighting)
    bench.LightingDamping = study.lighting_damping
    bench.OpacityPoints = [number for point in values.opacity for number in point]
    bench.ColorPoints = [number for point in values.color for number in point]
    bench.ScalarOpacityUnitDistance = values.unit_distance(volume.spacing, volume.dims)
    bench.CameraPath = study.camera.path
    bench.CameraSeed = study.camera.seed
    bench.Frames = study.camera.frames
    bench.Elevation = study.camera.elevation_degrees
    _set_zoom(bench, study.camera.zoom)
    bench.WarmUpFrames = study.timing.warm_up_frames
    bench.MinimumFrames = study.timing.minimum_frames
    bench.RelativeNoise = study.timing.relative_noise
    bench.TimeLimit = study.timing.time_limit_s
    bench.CoolDown = study.timing.cool_down_ms
    bench.ErrorViews = study.error.views
    bench.Reference = study.error.reference
    bench.ReferenceStepVoxels = study.error.reference_step_voxels
    bench.ErrorImageSize = list(study.error.image_size or (0, 0))


def _set_factors(bench: Any, runs: list[Run], watch: Watch) -> None:
    """List every run as a variant, so that the filter measures these and no others."""
    bench.Techniques = list(dict.fromkeys(run.technique for run in runs))
    bench.Variants = [
        variant_text(run.technique, run.integrator, run.step_voxels, run.settings)
        + earlier_text(run, watch)
        for run in runs
    ]


def _set_zoom(bench: Any, zoom: float) -> None:
    if bench.GetProperty("Zoom") is not None:
        bench.Zoom = zoom
    elif zoom != 1:
        raise BenchError(
            f"the filter {FILTER_PROXY} knows no zoom, but camera.zoom is {zoom:g}"
        )


def _unknown(reason: str) -> dict[str, Any]:
    return {"status": FAILED, "reason": reason}


def _answers(row: dict[str, Any], run: Run) -> bool:
    """Tell whether a table row is that run; a peer has no integrator or step of a study's."""
    if row["technique"] != run.technique:
        return False
    if json.loads(row["settings"] or "{}") != dict(run.settings):
        return False
    if TECHNIQUES[run.technique].peer:
        return True
    same_step = math.isclose(row["step_voxels"], run.step_voxels, rel_tol=1e-6)
    return same_step and row["integrator"] == run.integrator
