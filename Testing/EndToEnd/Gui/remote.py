"""ParaView's window as the client of a server, which draws as the window does."""

import numpy as np
import support
import window
from paraview import simple
from parallel import server
from PyQt5.QtWidgets import QAbstractButton, QTextEdit
from window import apply, messages, represent, row, settle, trigger, view_picture

SAME_PICTURE = 1e-3
TECHNIQUE = "Volume Compute"


def connect(port: int, with_plugin: bool = True) -> None:
    """Become a client; ParaView makes a new view."""
    simple.Connect("127.0.0.1", port)
    if with_plugin:
        support.load_plugin(remote=True)
    simple.GetActiveViewOrCreate("RenderView")
    settle(300)


def leave() -> None:
    """Leave the server, which then ends."""
    simple.Disconnect()
    simple.Connect()
    simple.GetActiveViewOrCreate("RenderView")
    settle(300)


def wavelet(label: str) -> None:
    trigger("Sources", "Alphabetical", "Wavelet")
    apply()
    represent(label)


def take_messages() -> list[str]:
    """Return ParaView's messages, and clear them away."""
    taken = messages()
    pane = window.dock("outputWidgetDock")
    for button in pane.findChildren(QAbstractButton):
        if button.text() == "Clear" or button.objectName() == "clearButton":
            button.click()
    assert not messages(), "the messages cannot be cleared"
    return taken


def told() -> str:
    """Return what the rows of the last picture say in words, with its time behind them."""
    frame_ms = simple.GetDisplayProperties().GetProperty("LastFrameMs").GetData()
    assert frame_ms > 0, frame_ms
    return row("LeftOutText").findChild(QTextEdit).toPlainText()


def check_a_server_draws_the_same() -> None:
    wavelet(TECHNIQUE)
    ours, said_here = view_picture(), told()
    with server() as port:
        connect(port)
        wavelet(TECHNIQUE)
        theirs, said_there = view_picture(), told()
        view = simple.GetActiveView().GetClientSideObject()
        assert view.GetUseDistributedRenderingForRender(), "the client drew"
        leave()
    assert np.ptp(ours) > 0.1, "nothing is drawn"
    error = support.rmse(theirs, ours)
    assert error <= SAME_PICTURE, f"RMSE {error:.5f} is more than {SAME_PICTURE}"
    assert said_there == said_here != "", f"{said_there}, not {said_here}"


def check_a_server_without_the_plugin_is_named() -> None:
    with server() as port:
        connect(port, with_plugin=False)
        trigger("Sources", "Alphabetical", "Wavelet")
        apply()
        said = take_messages()
        leave()
    ours = [text for text in said if "The server has no plugin VolumeBench" in text]
    assert len(ours) == 1 and "Manage Plugins > Remote" in ours[0], said
