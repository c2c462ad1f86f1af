"""The process that measures, apart from the one that keeps what is measured.

A technique that crashes or hangs takes this process down and no more: who was at work is known, so
that one run is given up and all others go on in a new process. `run_worker` is the far side; it ends
with its parent, however that ends.
"""

import ctypes
import importlib
import os
import pickle
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np

from .datasets import VolumeFile
from .error import ImageError
from .errors import BenchError
from .kept_pictures import Pictures
from .results import Context, FrameLog
from .study import Run, Study
from .watch import Watch

SCRIPT = Path(__file__).resolve().parent.parent / "worker.py"
SESSION = "volumebench.session:open_session"
HANG_LIMIT_S = 600.0
SHARE_INTERVAL_S = 0.5
_DEATH_SIGNAL_OPTION = 1  # PR_SET_PDEATHSIG of prctl


class WorkerEnded(BenchError):
    """The process is gone; `run` was at work, None where it was nobody's work."""

    def __init__(self, message: str, run: Run | None) -> None:
        super().__init__(message)
        self.run = run


@dataclass(frozen=True)
class Opened:
    """What the parent knows of a volume that the worker holds."""

    file: VolumeFile
    dims: tuple[int, int, int]
    scalar_type: str


@dataclass
class Known:
    """What was measured of the runs of a request before."""

    logs: dict[Run, FrameLog] = field(default_factory=dict)
    errors: dict[Run, ImageError] = field(default_factory=dict)


class WorkerSession:
    """Stands in for a session.Session that another process holds."""

    def __init__(
        self,
        study: Study,
        plugin: Path | None,
        session: str = SESSION,
        hang_limit_s: float = HANG_LIMIT_S,
    ) -> None:
        self._start = (session, study, plugin)
        self._hang_limit_s = hang_limit_s
        self._process: subprocess.Popen | None = None
        self._pipe: Connection | None = None
        self._context = self._ask("context", (), Watch())

    def context(self) -> Context:
        """Return what the figures depend on beside the study."""
        return self._context

    def open_volume(self, file: VolumeFile) -> Opened:
        """Have the worker read a volume."""
        dims, scalar_type = self._ask("open_volume", (file,), Watch())
        return Opened(file, dims, scalar_type)

    def run_engine(
        self, volume: Opened, function: Any, runs: list[Run], watch: Watch
    ) -> Any:
        """Measure the runs of one scene through the benchmark filter."""
        return self._ask("run_engine", (volume.file, function, runs), watch)

    def run_view(
        self, volume: Opened, function: Any, runs: list[Run], watch: Watch
    ) -> Any:
        """Measure the runs of one scene in a render view."""
        return self._ask("run_view", (volume.file, function, runs), watch)

    def run_remote(
        self, volume: Opened, function: Any, runs: list[Run], watch: Watch
    ) -> Any:
        """Measure the runs of one scene that a server draws."""
        return self._ask("run_remote", (volume.file, function, runs), watch)

    def run_start(self, volume: Opened, function: Any, watch: Any) -> Any:
        """Measure the first pictures of a volume."""
        return self._ask("run_start", (volume.file, function), watch)

    def close(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._pipe.close()
            self._process = None

    def _ask(self, name: str, arguments: tuple, watch: Any) -> Any:
        """Have the worker do something; return its answer, or raise its fault."""
        if self._process is None:
            self._open()
        at_work: tuple[Run | None, str] = (None, name.replace("_", " "))
        self._send((name, arguments, _known(arguments, watch)), at_work)
        while True:
            kind, *content = self._next(at_work)
            if kind == "answer":
                return content[0]
            if kind == "fault":
                raise BenchError(content[0])
            if kind == "begin":
                at_work = tuple(content)
            if kind == "share":
                watch(*content)
            else:
                getattr(watch, kind)(*content)

    def _open(self) -> None:
        self._pipe, far = Pipe()
        command = [own_interpreter(), str(SCRIPT), str(far.fileno()), str(os.getpid())]
        self._process = subprocess.Popen(
            command, pass_fds=[far.fileno()], stdin=subprocess.DEVNULL
        )
        far.close()
        self._send(self._start, (None, "starting"))

    def _send(self, message: Any, at_work: tuple[Run | None, str]) -> None:
        try:
            self._pipe.send(message)
        except OSError:
            raise self._ended(at_work) from None

    def _next(self, at_work: tuple[Run | None, str]) -> tuple:
        """Return the next message; no sign of life for the limit ends the process."""
        try:
            # Counted, not read off a clock: nothing is told while all processes are stopped.
            for _ in range(max(round(self._hang_limit_s / 0.5), 1)):
                if self._pipe.poll(0.5):
                    return self._pipe.recv()
        except (EOFError, OSError, pickle.UnpicklingError):
            raise self._ended(at_work) from None
        self.close()
        raise WorkerEnded(
            f"hung: no sign of life for {self._hang_limit_s:g} s, at work on "
            f"{at_work[1]}; its process was ended",
            at_work[0],
        )

    def _ended(self, at_work: tuple[Run | None, str]) -> WorkerEnded:
        code = self._process.wait()
        self.close()
        return WorkerEnded(
            f"crashed: its process ended with {_ending(code)}, at work on {at_work[1]}",
            at_work[0],
        )


def _known(arguments: tuple, watch: Any) -> Known:
    runs = arguments[2] if len(arguments) > 2 else []
    errors = {run: watch.earlier_error(run) for run in runs}
    return Known(
        {run: watch.earlier_log(run) for run in runs},
        {run: error for run, error in errors.items() if error is not None},
    )


def _ending(code: int) -> str:
    if code >= 0:
        return f"exit code {code}"
    try:
        return signal.Signals(-code).name
    except ValueError:
        return f"signal {-code}"


def own_interpreter() -> str:
    """Return the program that runs this: sys.executable names none within pvpython."""
    return os.readlink("/proc/self/exe")


class _Teller(Watch):
    """Sends every note to the parent."""

    def __init__(self, pipe: Connection, known: Known) -> None:
        self._pipe = pipe
        self._known = known
        self._shared_s = 0.0

    def __call__(self, partial_runs: float) -> None:
        now_s = time.monotonic()
        if now_s - self._shared_s > SHARE_INTERVAL_S:
            self._shared_s = now_s
            self._pipe.send(("share", partial_runs))

    def begin(self, run: Run | None, work: str) -> None:
        self._pipe.send(("begin", run, work))

    def frames(self, run: Run, log: FrameLog) -> None:
        self._pipe.send(("frames", run, log))

    def error(self, run: Run, error: ImageError) -> None:
        self._pipe.send(("error", run, error))

    def picture(self, run: Run, picture: np.ndarray) -> None:
        self._pipe.send(("picture", run, picture))

    def reference(self, pictures: Pictures) -> None:
        self._pipe.send(("reference", pictures))

    def done(self, run: Run, values: dict[str, Any]) -> None:
        self._pipe.send(("done", run, values))

    def earlier_log(self, run: Run) -> FrameLog:
        return self._known.logs.get(run, FrameLog())

    def earlier_error(self, run: Run) -> ImageError | None:
        return self._known.errors.get(run)


class _Worker:
    """Answers requests with a session; holds the volume that was read last."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe = pipe
        name, study, plugin = pipe.recv()
        module, _, function = name.partition(":")
        self._session = getattr(importlib.import_module(module), function)(
            study, plugin
        )
        self._file: VolumeFile | None = None
        self._volume: Any = None

    def answer(self, name: str, arguments: tuple, known: Known) -> Any:
        """Return what the session answers."""
        if name == "context":
            return self._session.context()
        volume = self._opened(arguments[0])
        if name == "open_volume":
            return volume.dims, volume.scalar_type
        watch = _Teller(self._pipe, known)
        return getattr(self._session, name)(volume, *arguments[1:], watch)

    def _opened(self, file: VolumeFile) -> Any:
        if file != self._file:
            self._volume = None  # before the next takes as much memory
            self._volume = self._session.open_volume(file)
            self._file = file
        return self._volume


def run_worker(handle: int, parent: int) -> None:
    """Answer the requests that come through a pipe until its other end is closed."""
    ctypes.CDLL(None).prctl(_DEATH_SIGNAL_OPTION, signal.SIGKILL)
    if os.getppid() != parent:
        return  # it ended before we asked to be told
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)  # the parent decides when we end
    pipe = Connection(handle)
    worker: _Worker | None = None
    while True:
        try:
            if worker is None:
                worker = _Worker(pipe)
            request = pipe.recv()
        except EOFError:
            return
        except Exception as fault:  # the parent is waiting for an answer
            pipe.recv()
            pipe.send(("fault", str(fault) or type(fault).__name__))
            return
        try:
            message = ("answer", worker.answer(*request))
        except Exception as fault:  # the study goes on with the next scene
            message = ("fault", str(fault) or type(fault).__name__)
        sys.stdout.flush()
        pipe.send(message)
