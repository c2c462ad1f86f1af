"""Paths `view` and `interactive`: one ParaView render view with one display per technique."""

import json
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from paraview import servermanager, simple

from .error import ImageError
from .errors import BenchError
from .orbit import Bounds, CameraPose
from .paraview_functions import set_function
from .session_error import Pair, compare_pictures
from .session_support import ErrorLog, producer_of
from .study import COMPOSITE, Scene, Study
from .technique_settings import TECHNIQUE_SETTINGS
from .techniques import TECHNIQUES
from .transfer_functions import TransferFunction
from .sample_counts import SampleCount, sample_count
from .view_measure import Sampling, Unsupported
from .volume_io import OpenVolume

CAPTURE_PROXY = "VolumeBenchmarkViewCapture"


class ViewStage:
    """A render view of exactly the picture size, black, with nothing but the volume in it."""

    capture_proxy = CAPTURE_PROXY

    def __init__(
        self,
        volume: OpenVolume,
        function: TransferFunction,
        scene: Scene,
        study: Study,
    ) -> None:
        self.bounds: Bounds = volume.bounds
        self._volume = volume
        self._function = function.in_values(*volume.range)
        self._scene = scene
        self._study = study
        self._view = _plain_view(scene.image_size)
        self._producers: dict[str, Any] = {}
        self._displays: dict[str, Any] = {}
        self._shown = ""
        self._before: dict[str, dict[str, Any]] = {}
        self._folder = tempfile.TemporaryDirectory(prefix="volumebench-")
        self._capture = self._make_capture()
        self._log = ErrorLog().__enter__()

    def close(self) -> None:
        """Delete the view and everything shown in it."""
        self._log.__exit__()
        self._capture = None
        for display in self._displays.values():
            simple.Delete(display)
        for producer in self._producers.values():
            simple.Delete(producer)
        simple.Delete(self._view)
        self._folder.cleanup()

    def take_errors(self) -> str | None:
        """Return what VTK complained about since the last call."""
        return self._log.take()

    def show(self, sampling: Sampling) -> None:
        """Make the technique of a run the only visible one, with the sampling of the run."""
        if sampling.technique not in self._displays:
            self._displays[sampling.technique] = self._make_display(sampling.technique)
        for technique, display in self._displays.items():
            display.Visibility = int(technique == sampling.technique)
        self._shown = sampling.technique
        if not TECHNIQUES[sampling.technique].peer:
            display = self._displays[sampling.technique]
            display.RaySetUp = self._study.ray_set_up
            display.InteractiveFrameTime = 0  # as good as still ones
            self._set_settings(display, sampling)
            display.Integrator = sampling.integrator
            display.StepVoxels = sampling.step_voxels
            display.TerminationThreshold = sampling.termination_threshold
            if sampling.reference_method is not None:
                _set(display, "ReferenceMethod", sampling.reference_method)

    def _set_settings(self, display: Any, sampling: Sampling) -> None:
        """Set what the run names, and what other runs of its technique named as it was before."""
        before = self._before.setdefault(sampling.technique, {})
        given = {
            TECHNIQUE_SETTINGS[name].property: value
            for name, value in sampling.settings
        }
        for name, value in (before | given).items():
            if name not in before and display.GetProperty(name) is not None:
                before[name] = display.GetPropertyValue(name)
            _set(display, name, value)

    def set_function(self, function: TransferFunction) -> None:
        """Give what is shown another transfer function."""
        self._function = function.in_values(*self._volume.range)
        display = self._displays[self._shown]
        set_function(display, self._volume.array, self._function)

    def place(self, pose: CameraPose) -> None:
        """Set the camera of the next picture."""
        renderer = self._view.GetClientSideObject().GetRenderer()
        camera = renderer.GetActiveCamera()
        camera.SetPosition(pose.position)
        camera.SetFocalPoint(pose.focal_point)
        camera.SetViewUp(pose.view_up)
        camera.SetViewAngle(pose.view_angle_degrees)
        renderer.ResetCameraClippingRange()

    def render(self, pose: CameraPose, interactive: bool) -> None:
        """Set the camera and render one frame to its end."""
        self.place(pose)
        if interactive:
            self._view.SMProxy.InteractiveRender()
        else:
            self._view.SMProxy.StillRender()
        self._view.GetRenderWindow().WaitForCompletion()

    def can_capture(self) -> bool:
        """Tell whether the plugin brings float pictures of a view."""
        return self._capture is not None

    def capture(self) -> np.ndarray:
        """Return the picture of the view as float premultiplied RGBA, row 0 on top."""
        path = Path(self._folder.name) / "capture.rgba32f"
        path.unlink(missing_ok=True)
        self._capture.FileName = str(path)
        self._capture.UpdateVTKObjects()
        self._write_picture()
        width, height = self._view.GetRenderWindow().GetSize()
        if not path.is_file():
            raise BenchError(
                self._log.text() or f"{self.capture_proxy} wrote no picture"
            )
        values = np.fromfile(path, "<f4")
        if values.size != width * height * 4:
            raise BenchError(
                f"{self.capture_proxy} wrote {values.size} values, not {width} x {height} x 4"
            )
        return values.reshape(height, width, 4)[::-1].copy()

    def count_samples(self) -> SampleCount | None:
        """Return the samples that the picture takes.

        None where neither VTK's GPU mapper nor ours draws, or ours does not count.
        """
        self._capture.CountSamples = 1
        try:
            picture = self.capture()
        finally:
            self._capture.CountSamples = 0
            self._capture.UpdateVTKObjects()
        return sample_count(picture, self._is_peer_shown())

    def describe(self) -> dict[str, Any]:
        """Return what our mapper tells of its last frame, by columns; nothing of a peer's."""
        if self._capture is None or self._is_peer_shown():
            return {}
        self._capture.UpdatePropertyInformation()
        return json.loads(self._capture.GetProperty("Description").GetData())

    def _is_peer_shown(self) -> bool:
        return TECHNIQUES[self._shown].peer

    def compare(self, pairs: list[Pair]) -> ImageError:
        """Return the error over all pairs of (picture, reference), pooled."""
        return compare_pictures(pairs)

    def resize(self, size: tuple[int, int]) -> None:
        """Render pictures of this size from now on."""
        _set_size(self._view, list(size))

    def _make_capture(self) -> Any:
        maker = getattr(servermanager.misc, self.capture_proxy, None)
        if maker is None:
            return None
        capture = maker()
        capture.View = self._view
        return capture

    def _make_producer(self) -> Any:
        """Return a pipeline source of the volume, for one display."""
        return producer_of(self._volume)

    def _write_picture(self) -> None:
        """Have the picture written by the process that draws."""
        self._capture.SMProxy.InvokeCommand("Capture")

    def _make_display(self, technique: str) -> Any:
        """Show the volume once more, with the representation of the technique."""
        producer = self._make_producer()
        display = simple.Show(producer, self._view, "UniformGridRepresentation")
        try:
            self._set_up(display, technique)
        except Unsupported:
            simple.Delete(display)
            simple.Delete(producer)
            raise
        self._producers[technique] = producer
        return display

    def _set_up(self, display: Any, technique: str) -> None:
        label = TECHNIQUES[technique].representation
        if label not in display.GetProperty("Representation").Available:
            raise Unsupported(f'no representation "{label}" in this build')
        display.SetRepresentationType(label)
        simple.ColorBy(display, ("POINTS", self._volume.array))
        display.SetScalarBarVisibility(self._view, False)
        display.Shade = int(self._scene.lighting)
        display.ScalarOpacityUnitDistance = self._function.unit_distance(
            self._volume.spacing, self._volume.dims
        )
        set_function(display, self._volume.array, self._function)
        self._set_scene(display, technique)

    def _set_scene(self, display: Any, technique: str) -> None:
        """Set blend mode and damping, which a build or a peer may lack."""
        blend_mode, damping = self._scene.blend_mode, self._study.lighting_damping
        if not TECHNIQUES[technique].peer:
            if blend_mode != COMPOSITE or display.GetProperty("TechniqueBlendMode"):
                _set(display, "TechniqueBlendMode", blend_mode)
            if damping or display.GetProperty("LightingDamping"):
                _set(display, "LightingDamping", damping)
        elif blend_mode not in display.GetProperty("BlendMode").Available:
            title = TECHNIQUES[technique].title
            raise Unsupported(f"{title} offers no blend mode {blend_mode}")
        else:
            display.BlendMode = blend_mode


def _set(display: Any, name: str, value: Any) -> None:
    if display.GetProperty(name) is None:
        raise Unsupported(f"the representation has no property {name} in this build")
    setattr(display, name, value)


def _plain_view(size: tuple[int, int]) -> Any:
    view = simple.CreateRenderView()
    view.UseColorPaletteForBackground = 0
    view.BackgroundColorMode = "Single Color"
    view.Background = [0, 0, 0]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseFXAA = 0
    _set_size(view, list(size))
    return view


def _set_size(view: Any, size: list[int]) -> None:
    """Resize the view; a window system may give less than it was asked for."""
    view.ViewSize = size
    view.SMProxy.StillRender()
    actual = list(view.GetRenderWindow().GetSize())
    if actual != size:
        simple.Delete(view)
        raise BenchError(
            f"the view is {actual[0]} x {actual[1]} pixels, not {size[0]} x {size[1]}"
        )
