"""A ParaView session of a study; with session_engine, session_view and session_remote all that imports paraview."""

from collections.abc import Callable
from contextlib import closing
from datetime import datetime, timezone
from functools import partial
from pathlib import Path
from typing import Any

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkVersion

from .datasets import VolumeFile
from .errors import BenchError
from .kept_pictures import Pictures
from .machine import machine_facts
from .plugin_file import PLUGIN_NAME
from .results import Context, Record
from .session_engine import run_engine
from .session_remote import RemoteStage, connected_server
from .session_stability import run_stability
from .session_view import ViewStage
from .stability_study import StabilityStudy
from .start import StartRow, measure_start
from .study import Run, Scene, Study
from .techniques import TECHNIQUES
from .transfer_functions import TransferFunction
from .view_measure import Contestant, measure_view
from .volume_io import PLUGIN_FORMATS, OpenVolume, PluginReaders
from .volume_io import bytes_of, copy_of, open_volume
from .watch import Watch

_OPENCL = "opencl"


class Session:
    """Loads the plugin and measures runs for the runner, or tries stability cases."""

    def __init__(self, study: Study | None, plugin: Path) -> None:
        self._study = study
        try:
            simple.LoadPlugin(str(plugin), remote=False)
        except RuntimeError as fault:
            raise BenchError(f"plugin {plugin}: cannot be loaded: {fault}") from None
        self._plugin_version = _loaded_version()
        if self._plugin_version is None:
            raise BenchError(f"plugin {plugin}: ParaView did not load it")
        self._plugin = plugin
        used = study is not None and _OPENCL in study.techniques
        self._gl, self._labels, self._devices = _probe(used)

    def context(self) -> Context:
        """Return what the figures depend on beside the study."""
        gl = self._gl
        return Context(
            date=datetime.now(timezone.utc).isoformat(timespec="seconds"),
            gl_renderer=gl.GetRenderer() or None,
            gl_version=gl.GetVersion() or None,
            paraview=str(simple.GetParaViewSourceVersion()).split()[-1],
            vtk=vtkVersion.GetVTKVersion(),
            plugin=self._plugin_version,
            build_type=_build_type(self._plugin),
            **self._devices,
            **machine_facts(),
        )

    def open_volume(self, file: VolumeFile) -> OpenVolume:
        """Read a volume into memory."""
        return open_volume(file, plugin_readers())

    def run_engine(
        self,
        volume: OpenVolume,
        function: TransferFunction,
        runs: list[Run],
        watch: Watch,
    ) -> tuple[list[Record], Pictures]:
        """Measure the runs of one scene through the benchmark filter."""
        return run_engine(self._study, volume, function, runs, self._labels, watch)

    def run_stability(
        self, study: StabilityStudy, report: Callable[[float], None]
    ) -> list[dict[str, Any]]:
        """Try the cases of a stability study; `report` is told the share done."""
        return run_stability(study, report)

    def run_view(
        self,
        volume: OpenVolume,
        function: TransferFunction,
        runs: list[Run],
        watch: Watch,
    ) -> tuple[list[Contestant], Pictures]:
        """Measure the runs of one scene in a render view."""
        with closing(ViewStage(volume, function, runs[0].scene, self._study)) as stage:
            return measure_view(stage, runs, self._study, watch)

    def run_remote(
        self,
        volume: OpenVolume,
        function: TransferFunction,
        runs: list[Run],
        watch: Watch,
    ) -> tuple[list[Contestant], Pictures]:
        """Measure the runs of one scene in a render view that a server of our own draws."""
        with (
            connected_server(self._plugin),
            closing(RemoteStage(volume, function, runs[0].scene, self._study)) as stage,
        ):
            return measure_view(stage, runs, self._study, watch)

    def run_start(
        self,
        volume: OpenVolume,
        function: TransferFunction,
        report: Callable[[float], None],
    ) -> list[StartRow]:
        """Measure the first picture of a volume and those after edits, of each technique."""
        start = self._study.start
        scene = Scene(volume.name, start.transfer_function, start.image_size)

        def open_stage() -> ViewStage:
            return ViewStage(copy_of(volume), function, scene, self._study)

        volume_facts = (volume.name, volume.dims, volume.scalar_type)
        return [
            StartRow(*volume_facts, **values, volume_bytes=bytes_of(volume))
            for values in measure_start(open_stage, function, self._study, report)
        ]


class _ProxyReader:
    """A reader of the plugin, whose own methods ParaView's Python does not know."""

    def __init__(self, name: str) -> None:
        self._proxy = getattr(servermanager.sources, name)()
        self._reader = self._proxy.GetClientSideObject()

    def SetFileName(self, path: str) -> None:
        self._proxy.FileName = path

    def __getattr__(self, name: str) -> Any:
        return getattr(self._reader, name)


def plugin_readers() -> PluginReaders:
    """Return what makes the plugin's readers, by extension; the plugin must be loaded."""
    return {
        extension: partial(_ProxyReader, name)
        for extension, name in PLUGIN_FORMATS.items()
    }


def open_session(study: Study, plugin: Path) -> Session:
    """Return the session of a study; what the worker is told to open."""
    return Session(study, plugin)


def _probe(opencl_is_used: bool) -> tuple[Any, list[str], dict[str, str | None]]:
    """Return the OpenGL information, the representation labels and the devices of CUDA and OpenCL.

    They are those of a view that is deleted; OpenCL's is looked for if it is used.
    """
    view = simple.CreateRenderView()
    source = simple.Wavelet(WholeExtent=[0, 1, 0, 1, 0, 1])
    display = simple.Show(source, view, "UniformGridRepresentation")
    view.SMProxy.StillRender()
    gl = servermanager.vtkPVOpenGLInformation()
    gl.CopyFromObject(None)
    labels = list(display.GetProperty("Representation").Available)
    devices = {
        "cuda_device": _cuda_device(source),
        "opencl_device": _opencl_device(display) if opencl_is_used else None,
    }
    for proxy in (display, source, view):
        simple.Delete(proxy)
    return gl, labels, devices


def _cuda_device(source: Any) -> str | None:
    """Return the device that Volume CUDA takes; none where the build or the machine lacks it."""
    bench = servermanager.filters.VolumeBenchmark(Input=source)
    bench.UpdatePropertyInformation()
    return bench.GetProperty("CudaDevice").GetElement(0) or None


def _opencl_device(display: Any) -> str | None:
    """Return the device that Volume OpenCL takes unless it is told another."""
    display.SetRepresentationType(TECHNIQUES[_OPENCL].representation)
    display.SMProxy.UpdatePropertyInformation()
    devices = list(display.GetProperty("OpenclDevice").Available)
    return devices[1] if len(devices) > 1 else None


def _loaded_version() -> str | None:
    manager = servermanager.vtkSMProxyManager.GetProxyManager().GetPluginManager()
    plugins = manager.GetLocalInformation()
    for index in range(plugins.GetNumberOfPlugins()):
        if plugins.GetPluginName(index) == PLUGIN_NAME and plugins.GetPluginLoaded(
            index
        ):
            return plugins.GetPluginVersion(index)
    return None


def _build_type(plugin: Path) -> str | None:
    """Read CMake's cache of the build tree that the plugin lies in, if it lies in one."""
    for folder in plugin.resolve().parents:
        cache = folder / "CMakeCache.txt"
        if cache.is_file():
            for line in cache.read_text(encoding="utf-8").splitlines():
                if line.startswith("CMAKE_BUILD_TYPE:"):
                    return line.partition("=")[2] or None
    return None
