"""A study with a made-up session in a worker: long_run.py STUDY FOLDER [OPTIONS of bench.py]."""

import os
import signal
import sys
import time
from functools import partial
from pathlib import Path

import volumebench.__main__ as program
from fakes import FakeVolume
from volumebench.error import ImageError
from volumebench.errors import BenchError
from volumebench.kept_pictures import Pictures
from volumebench.measure import StopRule, shuffled
from volumebench.orbit import block_frames
from volumebench.results import Context, FrameLog, record_of, times
from volumebench.worker import WorkerSession

BLOCK = 3
FRAME_S = 0.003
FAULTY = ("single-pass", "Left", 1.0, "view")


class SlowSession:
    """Measures as the filter does: in turns, block by block, telling each one."""

    def __init__(self, study, folder: Path) -> None:
        self._study = study
        self._folder = folder
        self._fault = os.environ["VOLUMEBENCH_TEST_FAULT"]
        if self._fault == "no-session":
            raise BenchError("the plugin is not for this machine")

    def context(self) -> Context:
        return Context(date="2020-01-01", cores=2)

    def open_volume(self, file):
        return FakeVolume()

    def run_engine(self, volume, function, runs, watch):
        return self._measure(volume, runs, watch), Pictures()

    def run_view(self, volume, function, runs, watch):
        self._measure(volume, runs, watch)
        return [], Pictures()

    def _measure(self, volume, runs, watch):
        logs = {run: FrameLog() for run in runs}
        for run, log in logs.items():
            log.extend(watch.earlier_log(run))
        turn = 0
        while open_runs := [run for run in runs if not self._is_over(logs[run])]:
            for run in shuffled(open_runs, turn):
                self._block(run, logs[run], watch)
            turn += 1
        return [self._finish(volume, run, logs[run], watch) for run in runs]

    def _is_over(self, log) -> bool:
        rule = StopRule(self._study.timing, list(log.ms))
        return rule.is_finished()

    def _block(self, run, log, watch) -> None:
        watch.begin(run, "frames")
        self._go_wrong(run, len(log.ms))
        frames = self._study.camera.frames
        before = len(log.ms)
        for frame in block_frames(before // BLOCK, BLOCK, frames)[before % BLOCK :]:
            time.sleep(FRAME_S)
            with open(self._folder / "drawn", "a", encoding="ascii") as stream:
                stream.write(f"{frame}\n")
            log.extend(FrameLog([frame], [1000 * FRAME_S], [None]))
        watch.frames(run, log.since(before))

    def _go_wrong(self, run, frames: int) -> None:
        if frames < BLOCK or FAULTY != (
            *(run.technique, run.integrator, run.step_voxels, run.path),
        ):
            return
        (self._folder / "worker").write_text(str(os.getpid()))
        if self._fault == "crash":
            os.kill(os.getpid(), signal.SIGSEGV)
        if self._fault == "hang":
            time.sleep(600)

    def _finish(self, volume, run, log, watch):
        watch.begin(run, "stages")
        error = watch.earlier_error(run)
        if error is None:
            error = ImageError(rmse=0.01 / (run.step_voxels or 1))
            watch.error(run, error)
        values = times(log) | {"error": error}
        watch.done(run, values)
        return record_of(run, volume.dims, volume.scalar_type, **values)


def open_session(study, folder):
    return SlowSession(study, folder)


if __name__ == "__main__":
    study_file, out, *options = sys.argv[1:]
    program.find_plugin = lambda _: Path(out)
    program.WorkerSession = partial(WorkerSession, session="long_run:open_session")
    sys.exit(program.main([study_file, "--out", out, *options]))
