"""Small pieces that both paths of a session share: pipeline sources and caught errors."""

from typing import Any

from paraview import servermanager, simple
from paraview.modules.vtkRemotingCore import vtkPVSession
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkOutputWindow

from .volume_io import OpenVolume


def producer_of(volume: OpenVolume) -> Any:
    """Return a pipeline source that gives the volume in memory, without a copy."""
    producer = simple.TrivialProducer()
    producer.GetClientSideObject().SetOutput(volume.image)
    producer.UpdatePipeline()
    return producer


def client_proxy(group: str, name: str) -> Any:
    """Return a proxy whose object is in this process, also in a session with a server."""
    proxy = servermanager.ProxyManager().NewProxy(group, name)
    proxy.SetLocation(vtkPVSession.CLIENT)
    proxy.UpdateVTKObjects()
    return servermanager._getPyProxy(proxy)


def rows_of(table: Any) -> list[dict[str, Any]]:
    """Return the rows of a vtkTable, each as an object from column name to value."""
    names = [table.GetColumnName(index) for index in range(table.GetNumberOfColumns())]
    return [
        {name: _plain(table.GetValueByName(row, name)) for name in names}
        for row in range(table.GetNumberOfRows())
    ]


def _plain(variant: Any) -> Any:
    if variant.IsString():
        return variant.ToString()
    if variant.IsFloat() or variant.IsDouble():
        return variant.ToDouble()
    return variant.ToInt64() if variant.IsValid() else None


class ErrorLog:
    """Collects VTK's error messages while it is open."""

    def __init__(self) -> None:
        self._messages: list[str] = []
        self._window: Any = None
        self._tag = 0

    def __enter__(self) -> "ErrorLog":
        def keep(_caller: Any, _event: str, message: str = "") -> None:
            self._messages.append(message)

        keep.CallDataType = VTK_STRING
        self._window = vtkOutputWindow.GetInstance()
        self._tag = self._window.AddObserver("ErrorEvent", keep)
        return self

    def __exit__(self, *_: Any) -> None:
        self._window.RemoveObserver(self._tag)

    def text(self) -> str | None:
        """Return the first message on one line without VTK's preamble, or None."""
        if not self._messages:
            return None
        text = " ".join(self._messages[0].split())
        return text.rpartition("): ")[2][:400] or "ParaView reported an error"

    def take(self) -> str | None:
        """Return the first message and forget all."""
        text = self.text()
        self._messages.clear()
        return text
