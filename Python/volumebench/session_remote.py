"""Path `remote`: a render view whose volume lies with, and is drawn by, a pvserver of our own."""

import ctypes
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from paraview import simple
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

from .errors import BenchError
from .orbit import CameraPose
from .session_view import ViewStage
from .worker import own_interpreter

START_LIMIT_S = 60.0
END_LIMIT_S = 20.0
_LISTENS = "Accepting connection"
_DEATH_SIGNAL_OPTION = 1  # PR_SET_PDEATHSIG of prctl


class RemoteStage(ViewStage):
    """Shows what a server draws; errors are taken from the server's own float pictures."""

    capture_proxy = "VolumeBenchmarkServerCapture"
    _reader: Any = None
    _is_ahead = False  # the camera here, of that of the server

    def close(self) -> None:
        """Delete the view and everything shown in it, on the server too."""
        reader, self._reader = self._reader, None
        super().close()
        if reader is not None:
            simple.Delete(reader)

    def place(self, pose: CameraPose) -> None:
        """Set the camera of the next picture, of which the server hears with that picture."""
        super().place(pose)
        self._is_ahead = True

    def render(self, pose: CameraPose, interactive: bool) -> None:
        """Set the camera and wait for the server's picture."""
        super().render(pose, interactive)
        self._is_ahead = False

    def _make_producer(self) -> Any:
        """Return a source on the server; all share the data that one reader holds there."""
        if self._reader is None:
            path = Path(self._folder.name) / "volume.vti"
            _write_image(self._volume.image, path)
            self._reader = simple.XMLImageDataReader(FileName=[str(path)])
        return simple.PassArrays(
            Input=self._reader, PointDataArrays=[self._volume.array]
        )

    def _write_picture(self) -> None:
        if self._is_ahead:
            self._view.SMProxy.StillRender()
            self._is_ahead = False
        super()._write_picture()
        self._capture.UpdatePropertyInformation()  # an answer: the command has none


def _write_image(image: Any, path: Path) -> None:
    writer = vtkXMLImageDataWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(image)
    writer.SetCompressorTypeToNone()
    # Appended data cannot be read back with the expat of Debian 12's security updates.
    writer.SetDataModeToBinary()
    if not writer.Write():
        raise BenchError(f"{path}: cannot be written for the server")


@contextmanager
def connected_server(plugin: Path) -> Iterator[None]:
    """Be the client of a server that has the plugin, and afterwards a session of our own again."""
    with tempfile.TemporaryDirectory(prefix="volumebench-") as folder:
        log = Path(folder) / "pvserver.log"
        port = _free_port()
        process = _start_server(port, log)
        try:
            _wait_for(process, log)
            simple.Connect("127.0.0.1", port)
            simple.LoadPlugin(str(plugin), remote=True)
            yield
        finally:
            simple.Disconnect()
            simple.Connect()  # only now the old connection is closed
            _end(process)


def _start_server(port: int, log: Path) -> subprocess.Popen:
    beside = Path(own_interpreter()).with_name("pvserver")
    program = str(beside) if beside.is_file() else shutil.which("pvserver")
    if program is None:
        raise BenchError(f"path remote: there is no pvserver beside {beside.parent}")
    with open(log, "wb") as stream:
        return subprocess.Popen(
            [program, f"--server-port={port}"],
            stdin=subprocess.DEVNULL,
            stdout=stream,
            stderr=subprocess.STDOUT,
            preexec_fn=_end_with_parent,
        )


def _end_with_parent() -> None:
    ctypes.CDLL(None).prctl(_DEATH_SIGNAL_OPTION, signal.SIGKILL)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def _wait_for(process: subprocess.Popen, log: Path) -> None:
    end_s = time.monotonic() + START_LIMIT_S
    while _LISTENS not in (said := log.read_text(errors="replace")):
        if process.poll() is not None or time.monotonic() > end_s:
            reason = (said.strip().splitlines() or ["it says nothing"])[-1]
            raise BenchError(f"path remote: pvserver did not start: {reason}")
        time.sleep(0.05)


def _end(process: subprocess.Popen) -> None:
    """It ends by itself when its client leaves."""
    try:
        process.wait(timeout=END_LIMIT_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
