"""Measures the techniques of one render view in turns, so that machine noise hits all alike.

Only the stage (session_view.ViewStage) knows ParaView; this module decides what is shown when.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, Protocol

import numpy as np

from .error import ImageError
from .errors import BenchError
from .kept_pictures import Pictures
from .measure import StopRule, shuffled
from .sample_counts import SampleCount, mean_count
from .orbit import Bounds, CameraPose, block_frames, error_frame, orbit_pose
from .results import FAILED, OK, UNSUPPORTED, FrameLog, described_values, times
from .study import CELL_EXACT, FINE_STEPS, Run, Study
from .technique_settings import Settings
from .transfer_functions import TransferFunction
from .techniques import INTERACTIVE, PARAVIEW, REFERENCE_TECHNIQUE, REMOTE
from .techniques import TECHNIQUES, VIEW
from .watch import Watch

BLOCK_FRAMES = 4
# VTK's mapper needs some interactive frames until its automatic step has settled.
SETTLE_FRAMES = {VIEW: 1, INTERACTIVE: 3, REMOTE: 1}
EXACT_TECHNIQUE = "reference"
EXACT_LABEL = "cell-exact float64"
EXACT_REDUCTION = 8  # the check is made on a picture so much smaller
FINE_REDUCTION = 4
CHECK_STEPS = (
    4  # the check extrapolates from four times, twice and once the reference step
)


class Unsupported(BenchError):
    """This build or machine cannot run the technique; the message says why."""


@dataclass(frozen=True)
class Sampling:
    """What is set on a representation before it is shown."""

    technique: str
    integrator: str | None
    step_voxels: float | None
    termination_threshold: float
    settings: Settings = ()
    reference_method: str | None = None


class Stage(Protocol):
    """One render view on one volume; pictures are float premultiplied RGBA, row 0 on top."""

    bounds: Bounds

    def show(self, sampling: Sampling) -> None:
        ...

    def set_function(self, function: TransferFunction) -> None:
        ...

    def place(self, pose: CameraPose) -> None:
        ...

    def render(self, pose: CameraPose, interactive: bool) -> None:
        ...

    def capture(self) -> np.ndarray:
        ...

    def compare(self, pairs: list[tuple[np.ndarray, np.ndarray]]) -> ImageError:
        ...

    def count_samples(self) -> "SampleCount | None":
        ...

    def describe(self) -> dict[str, Any]:
        ...

    def can_capture(self) -> bool:
        ...

    def resize(self, size: tuple[int, int]) -> None:
        ...

    def take_errors(self) -> str | None:
        ...

    def close(self) -> None:
        ...


@dataclass
class Contestant:
    """One run with the frames measured so far and, in the end, its outcome."""

    run: Run
    rule: StopRule
    blocks: int = 0
    is_warm: bool = False  # in this process
    log: FrameLog = field(default_factory=FrameLog)
    status: str = OK
    reason: str | None = None
    error: ImageError = field(default_factory=ImageError)
    samples: SampleCount | None = None
    description: dict[str, Any] = field(default_factory=dict)

    def is_open(self) -> bool:
        """Tell whether another block is wanted."""
        return self.status == OK and not self.rule.is_finished()

    def go_on_from(self, log: FrameLog) -> None:
        """Take over the frames of an earlier measurement."""
        self.blocks = -(-len(log.ms) // BLOCK_FRAMES)
        for frame, frame_ms in zip(log.frame, log.ms):
            self.add(frame, frame_ms)

    def add(self, frame: int, frame_ms: float) -> None:
        """Take a timed frame."""
        self.rule.add(frame_ms)
        self.log.extend(FrameLog([frame], [frame_ms], [None]))

    def fail(self, fault: BenchError) -> None:
        """End the run with a reason; the study goes on."""
        self.status = UNSUPPORTED if isinstance(fault, Unsupported) else FAILED
        self.reason = str(fault)

    def values(self) -> dict:
        """Return what a record holds beyond the run itself."""
        measured = times(self.log) if self.status == OK else {}
        outcome = {"status": self.status, "reason": self.reason, "error": self.error}
        return outcome | measured | self._counts() | described_values(self.description)

    def _counts(self) -> dict[str, int | None]:
        counts = vars(self.samples) if self.samples else {}
        names = {
            "taken": "samples_taken",
            "skipped": "samples_skipped",
            "rays_terminated": "rays_terminated",
        }
        return {
            name: None if counts.get(part) is None else round(counts[part])
            for part, name in names.items()
        }


def measure_view(
    stage: Stage, runs: list[Run], study: Study, watch: Watch
) -> tuple[list[Contestant], Pictures]:
    """Measure all runs in interleaved blocks, then take the error of each."""
    contestants = [Contestant(run, StopRule(study.timing)) for run in runs]
    for contestant in contestants:
        contestant.go_on_from(watch.earlier_log(contestant.run))
    _measure_times(stage, contestants, study, watch)
    for contestant in contestants:
        if contestant.status == OK and _is_counted(contestant.run):
            watch.begin(contestant.run, "samples")
            _guarded(stage, contestant, study, _count_samples)
    scene = runs[0].scene
    size = study.error_size(scene)
    if size != scene.image_size:
        stage.resize(size)
    watch.begin(None, "the reference")
    pictures = _reference_pictures(stage, study, size)
    if pictures.references:
        watch.reference(pictures)
    for done, contestant in enumerate(contestants):
        if contestant.status == OK and stage.can_capture():
            watch.begin(contestant.run, "pictures")
            take = lambda *given: _take_error(*given, pictures, watch)
            _guarded(stage, contestant, study, take)
        watch.done(contestant.run, contestant.values())
        watch(0.7 * len(runs) + 0.3 * (done + 1))
    return contestants, pictures


def _measure_times(
    stage: Stage, contestants: list[Contestant], study: Study, watch: Watch
) -> None:
    """Let the contestants take turns until each has been measured long enough."""
    turn = 0
    while still_open := [item for item in contestants if item.is_open()]:
        for contestant in shuffled(still_open, seed=turn):
            watch.begin(contestant.run, "frames")
            before = len(contestant.log.ms)
            _guarded(stage, contestant, study, _run_block)
            if contestant.status == OK:
                watch.frames(contestant.run, contestant.log.since(before))
            watch(sum(_share(item, study) for item in contestants))
        turn += 1
    for contestant in contestants:
        if contestant.status == OK and not contestant.is_warm:
            watch.begin(contestant.run, "frames")
            _guarded(stage, contestant, study, _describe)  # timed by an earlier process


def _is_counted(run: Run) -> bool:
    """Tell whether samples are counted: of still pictures, and of all that ParaView's Volume shows."""
    return run.technique == PARAVIEW or run.path in (VIEW, REMOTE)


def _share(contestant: Contestant, study: Study) -> float:
    if not contestant.is_open():
        return 0.7
    return 0.7 * min(len(contestant.rule.frame_ms) / study.timing.minimum_frames, 0.9)


def _guarded(
    stage: Stage, contestant: Contestant, study: Study, work: Callable
) -> None:
    """Run a piece of work; whatever goes wrong ends this contestant only."""
    try:
        stage.take_errors()
        work(stage, contestant, study)
        if fault := stage.take_errors():
            raise BenchError(fault)
    except BenchError as fault:
        contestant.fail(fault)
    except Exception as fault:  # a proxy may raise anything; the study goes on
        contestant.fail(BenchError(f"{type(fault).__name__}: {fault}"))


def sampling_of(run: Run, study: Study) -> Sampling:
    """Return what is to be set for a run."""
    return Sampling(
        run.technique,
        run.integrator,
        run.step_voxels,
        dict(run.settings).get("termination_threshold", study.termination_threshold),
        run.settings,
    )


def _run_block(stage: Stage, contestant: Contestant, study: Study) -> None:
    """Show the contestant, let it settle, and time a block of frames."""
    run, camera = contestant.run, study.camera
    interactive = run.path == INTERACTIVE
    frames = block_frames(contestant.blocks, BLOCK_FRAMES, camera.frames)
    time.sleep(study.timing.cool_down_ms / 1000)
    stage.show(sampling_of(run, study))
    pose = orbit_pose(frames[0], camera.frames, stage.bounds, camera)
    warm_up = 0 if contestant.is_warm else study.timing.warm_up_frames
    _settle(stage, pose, run.path, warm_up, study)
    contestant.is_warm = True
    contestant.blocks += 1
    for frame in frames:
        pose = orbit_pose(frame, camera.frames, stage.bounds, camera)
        start_s = time.perf_counter()
        stage.render(pose, interactive)
        contestant.add(frame, (time.perf_counter() - start_s) * 1000)
        if contestant.rule.spent_s() >= study.timing.time_limit_s:
            break
    contestant.description = stage.describe()


def _describe(stage: Stage, contestant: Contestant, study: Study) -> None:
    run = contestant.run
    stage.show(sampling_of(run, study))
    _settle(stage, _error_pose(stage, study, 0), run.path, 1, study)
    contestant.description = stage.describe()


def _settle(
    stage: Stage, pose: CameraPose, path: str, warm_up: int, study: Study
) -> None:
    """Render frames that do not count; slow ones end it, since only fast ones adapt."""
    start_s = time.perf_counter()
    for _ in range(max(SETTLE_FRAMES[path], warm_up)):
        stage.render(pose, path == INTERACTIVE)
        if time.perf_counter() - start_s > study.timing.time_limit_s / 4:
            break


def _count_samples(stage: Stage, contestant: Contestant, study: Study) -> None:
    """Count the samples of a frame, in the timed size; mean over the error views."""
    if not stage.can_capture():
        return
    run = contestant.run
    stage.show(sampling_of(run, study))
    counts = []
    for view in range(max(study.error.views, 1)):
        pose = _error_pose(stage, study, view)
        if TECHNIQUES[run.technique].peer:
            _settle(stage, pose, run.path, 1, study)
        else:
            stage.place(pose)  # ours adapts nothing over frames
        counts.append(stage.count_samples())
    if None not in counts:
        contestant.samples = mean_count(counts)


def _reference_pictures(stage: Stage, study: Study, size: tuple[int, int]) -> Pictures:
    """Render the references; what goes wrong leaves the errors absent, with a note."""
    pictures = Pictures()
    if not stage.can_capture():
        pictures.note = (
            "no float pictures: this plugin has no VolumeBenchmarkViewCapture"
        )
    elif study.error.views:
        try:
            _render_references(stage, study, size, pictures)
            pictures.note = stage.take_errors()
        except Exception as fault:  # a proxy may raise anything; times remain
            pictures.note = f"no reference: {fault}"
            pictures.references = []
    return pictures


def _render_references(
    stage: Stage, study: Study, size: tuple[int, int], pictures: Pictures
) -> None:
    """Render the reference of each view, and what it is checked with, as the filter does."""
    exact = study.error.reference == CELL_EXACT
    reduction = EXACT_REDUCTION if exact else FINE_REDUCTION
    stage.resize(tuple(max(side // reduction, 1) for side in size))
    try:
        pair = [_reference(stage, study, 0, check) for check in (False, True)]
    finally:
        stage.resize(size)
    pictures.uncertainty = stage.compare([tuple(pair)]).rmse
    pictures.references = [
        _reference(stage, study, view, False) for view in range(study.error.views)
    ]
    step = study.error.reference_step_voxels
    fine = f"{REFERENCE_TECHNIQUE} Midpoint step {step:g}"
    pictures.label = EXACT_LABEL if exact else fine


def _reference(stage: Stage, study: Study, view: int, check: bool) -> np.ndarray:
    stage.show(_reference_sampling(study, check))
    stage.render(_error_pose(stage, study, view), interactive=False)
    return stage.capture()


def _reference_sampling(study: Study, check: bool) -> Sampling:
    """Return how the reference is drawn, or what it is checked with."""
    step = study.error.reference_step_voxels
    if study.error.reference == FINE_STEPS:
        return Sampling(REFERENCE_TECHNIQUE, "Midpoint", step / 2 if check else step, 0)
    method = "Midpoint" if check else CELL_EXACT
    return Sampling(EXACT_TECHNIQUE, "Midpoint", CHECK_STEPS * step, 0, (), method)


def _error_pose(stage: Stage, study: Study, view: int) -> CameraPose:
    frames = study.camera.frames
    frame = error_frame(view, study.error.views, frames)
    return orbit_pose(frame, frames, stage.bounds, study.camera)


def _take_error(
    stage: Stage,
    contestant: Contestant,
    study: Study,
    pictures: Pictures,
    watch: Watch,
) -> None:
    """Capture the contestant at the error views and compare it with the references."""
    run = contestant.run
    stage.show(sampling_of(run, study))
    pairs = []
    for view in range(max(len(pictures.references), 1)):
        pose = _error_pose(stage, study, view)
        _settle(stage, pose, run.path, 1, study)
        picture = stage.capture()
        if not (picture[..., 3] > 0).any():
            raise BenchError("it drew nothing")
        if view == 0 and pictures.keep(run, picture):
            watch.picture(run, picture)
        if pictures.references:
            pairs.append((picture, pictures.references[view]))
    if pairs:
        contestant.error = replace(
            stage.compare(pairs),
            reference=pictures.label,
            reference_uncertainty=pictures.uncertainty,
        )
