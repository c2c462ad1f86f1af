"""A server that is killed while it draws: ParaView's window neither hangs nor crashes, but says so."""

import os
import signal
import tempfile
import threading

import support
import window
from paraview import simple
from parallel import server
from PyQt5.QtCore import QTimer
from PyQt5.QtWidgets import QLabel
from remote import connect, wavelet

SAID = "The server side has disconnected"


def check_the_window_says_that_its_server_died() -> None:
    tempfile.tempdir = os.environ["HOME"]  # which goes, as this never returns
    with support.temporary_folder() as folder:
        file = folder / "server"
        keep_id = ["sh", "-c", f'echo $$ > {file}; exec "$@"', "sh"]
        with server(keep_id) as port:
            connect(port)
            wavelet("Volume Reference")
            end_with_the_dialog()
            simple.GetActiveView().GetActiveCamera().Azimuth(5)
            server_id = int(file.read_text())
            threading.Timer(0.5, os.kill, (server_id, signal.SIGKILL)).start()
            simple.Render()
    raise AssertionError("ParaView did not notice")


def end_with_the_dialog() -> None:
    """Leave with what the next dialog says: ParaView leaves when it is answered."""
    timer = QTimer(window.main_window())

    def look() -> None:
        dialog = window.application().activeModalWidget()
        if dialog:
            said = " ".join(one.text() for one in dialog.findChildren(QLabel))
            window.report(f"PASSED: {said}" if SAID in said else f"FAILED: {said}")
            os._exit(0 if SAID in said else 1)

    timer.timeout.connect(look)
    timer.start(200)
