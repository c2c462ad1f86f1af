"""A stage and a session without ParaView: a disc whose error follows step and integrator."""

import math
from dataclasses import dataclass

import numpy as np
from volumebench.error import ImageError
from volumebench.errors import BenchError
from volumebench.results import Context, FrameLog, record_of, times
from volumebench.start import StartRow, measure_start
from volumebench.kept_pictures import Pictures
from volumebench.sample_counts import SampleCount
from volumebench.view_measure import Sampling, Unsupported
from volumebench.view_measure import measure_view
from volumebench.watch import Watch


PICTURE_WIDTH = 40  # of the small study
CHECK_ERROR = 1e-3  # of the renderer that the reference is checked with


class FakeStage:
    """Draws a disc; remembers what was shown and rendered."""

    def __init__(self, captures: bool = True, broken: str | None = None) -> None:
        self.bounds = (0, 1, 0, 1, 0, 1)
        self.captures = captures
        self.broken = broken
        self.sampling: Sampling | None = None
        self.shown: list[Sampling] = []
        self.rendered: list[tuple[Sampling, tuple, bool]] = []
        self.functions: list = []
        self.closed = False
        self.side = 16
        self.complaint: str | None = None

    def show(self, sampling: Sampling) -> None:
        if sampling.technique == "opencl":
            raise Unsupported('no representation "Volume OpenCL" in this build')
        self.sampling = sampling
        self.shown.append(sampling)

    def set_function(self, function) -> None:
        self.functions.append(function)

    def close(self) -> None:
        self.closed = True

    def place(self, pose) -> None:
        self.pose = pose

    def render(self, pose, interactive: bool) -> None:
        if self.sampling.technique == self.broken:
            raise RuntimeError("the driver is gone")
        if self.sampling.technique == "compute":
            self.complaint = "compute shader did not compile"
        self.rendered.append((self.sampling, pose.position, interactive))

    def capture(self) -> np.ndarray:
        axis = np.linspace(-1, 1, self.side + 2)[1:-1]
        disc = (axis[:, None] ** 2 + axis[None, :] ** 2 < 0.8).astype(np.float32)
        if self.sampling.technique == "slices":
            disc[:] = 0
        error = disc * self._error()
        return np.dstack([disc * 0.5 + error, disc * 0.25, disc * 0.1, disc])

    def _error(self) -> float:
        step = self.sampling.step_voxels
        if self.sampling.technique == "reference":
            return CHECK_ERROR if self.sampling.reference_method == "Midpoint" else 0.0
        if step is None:
            return 0.01
        return (
            0.02 * step**2 if self.sampling.integrator == "Midpoint" else 0.02 * step
        )

    def count_samples(self) -> SampleCount:
        return SampleCount(1000.0 * self.side)

    def describe(self) -> dict:
        if self.sampling.step_voxels is None:
            return {}
        return {
            "left_out": "lighting clipping",
            "setup_ms.upload": 3.0,
            "setup_ms.grid": math.nan,
            "bytes_on_device": 4096.0,
        }

    def compare(self, pairs) -> ImageError:
        """RMSE inside the disc alone, and the size."""
        inside = [truth[..., 3] > 0 for _, truth in pairs]
        squares = [
            np.mean((picture[disc] - truth[disc]) ** 2)
            for (picture, truth), disc in zip(pairs, inside)
        ]
        height, width, _ = pairs[0][0].shape
        rmse = float(np.sqrt(np.mean(squares)))
        return ImageError(rmse=rmse, image_size=(width, height))

    def can_capture(self) -> bool:
        return self.captures

    def resize(self, size: tuple[int, int]) -> None:
        self.side = 16 * size[0] // PICTURE_WIDTH

    def take_errors(self) -> str | None:
        complaint, self.complaint = self.complaint, None
        return complaint


@dataclass
class FakeVolume:
    dims: tuple = (8, 8, 16)
    scalar_type: str = "uint16"


class FakeSession:
    """Answers as session.Session does, with made-up times."""

    def __init__(self, study, stage=None, engine_fault=None, volume_fault=None):
        self.study = study
        self.stage = stage or FakeStage()
        self.engine_fault = engine_fault
        self.volume_fault = volume_fault
        self.measured: list = []
        self.served: list = []
        self.starts = 0

    def context(self) -> Context:
        return Context(date="2020-01-01", cores=2, gl_renderer="none")

    def open_volume(self, file):
        if self.volume_fault:
            raise BenchError(self.volume_fault)
        return FakeVolume()

    def run_engine(self, volume, function, runs, watch):
        self.measured += runs
        if self.engine_fault:
            raise RuntimeError(self.engine_fault)
        return [self._record(volume, run) for run in runs], Pictures()

    def run_view(self, volume, function, runs, watch):
        self.measured += runs
        quiet = Watch()  # the times that are told are not the made-up ones
        contestants, pictures = measure_view(self.stage, runs, self.study, quiet)
        for run, picture in pictures.by_technique.values():
            watch.picture(run, picture)
        if pictures.references:
            watch.reference(pictures)
        return [self._with_time(item) for item in contestants], pictures

    def run_remote(self, volume, function, runs, watch):
        self.served += runs
        return self.run_view(volume, function, runs, watch)

    def run_start(self, volume, function, report):
        self.starts += 1
        found = measure_start(FakeStage, function, self.study, report)
        return [StartRow("shell", volume.dims, "uint16", **values) for values in found]

    def _with_time(self, contestant):
        contestant.log = fake_log(contestant.run)
        return contestant

    def _record(self, volume, run):
        values = times(fake_log(run))
        return record_of(run, volume.dims, volume.scalar_type, **values)


def fake_log(run) -> FrameLog:
    return FrameLog([0, 1, 2, 3], [frame_ms(run) + i for i in range(4)], [None] * 4)


def frame_ms(run) -> float:
    if run.step_voxels is None:
        return 240.0 if run.path != "interactive" else 60.0
    return 15 + 35 / run.step_voxels
