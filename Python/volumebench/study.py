"""A study: factors and settings, expanded into an ordered list of runs."""

from dataclasses import asdict, dataclass, field, replace
from itertools import product
from pathlib import Path
from typing import Any

from .errors import StudyError
from .technique_settings import Settings
from .techniques import DEFAULT_PATHS, ENGINE, PARAVIEW, TECHNIQUES, find_technique

COMPOSITE = "Composite"
CELL_EXACT = "Cell Exact"
FINE_STEPS = "Fine Steps"
SPEED = "speed"
SCALING = "scaling"
EQUAL_ERROR = "equal-error"
BLEND_MODES = (COMPOSITE, "Maximum", "Minimum", "Average", "Gradient")


@dataclass(frozen=True)
class Dataset:
    """A volume by name; dims, type, extent, share, seed and spacing apply to generated ones only.

    A generated one bears its generator's name, or names its `generator`. Where no file of a name is
    found, the generated volume `otherwise` takes its place and says in `stands_for` whose place
    that is. `image_sizes` are taken in place of the study's, and where less than `memory_gb` of
    memory is free, the study goes on without the volume.
    """

    name: str
    dims: tuple[int, int, int] | None = None
    scalar_type: str | None = None
    extent: float | None = None
    share: float | None = None
    seed: int | None = None
    spacing: tuple[float, float, float] | None = None
    generator: str | None = None
    image_sizes: tuple[tuple[int, int], ...] | None = None
    memory_gb: float | None = None
    otherwise: str | None = None
    stands_for: str | None = None


@dataclass(frozen=True)
class Camera:
    """A path of `frames` pictures; see orbit.py. `seed` is that of path random."""

    path: str = "orbit-y"
    frames: int = 36
    elevation_degrees: float = 20.0
    zoom: float = 1.0
    seed: int = 0


@dataclass(frozen=True)
class Timing:
    """When to stop measuring frames of one run, and how long to rest before each block of them."""

    warm_up_frames: int = 2
    minimum_frames: int = 12
    relative_noise: float = 0.02
    time_limit_s: float = 10.0
    cool_down_ms: float = 0.0


@dataclass(frozen=True)
class ErrorSettings:
    """At how many views of the orbit the error is measured (0: nowhere) and against what.

    The pictures are as large as the timed ones, or of a size of their own.
    """

    views: int = 2
    reference: str = CELL_EXACT
    reference_step_voxels: float = 0.03125
    image_size: tuple[int, int] | None = None


@dataclass(frozen=True)
class Scene:
    """What is looked at: a volume through a transfer function, blended and lit, at a picture size."""

    dataset: str
    transfer_function: str
    image_size: tuple[int, int]
    blend_mode: str = COMPOSITE
    lighting: bool = False

    def title(self) -> str:
        """Return the name for readers."""
        width, height = self.image_size
        blending = "" if self.blend_mode == COMPOSITE else f", {self.blend_mode}"
        blending += ", shaded" if self.lighting else ""
        return f"{self.dataset}, {self.transfer_function}, {width} x {height}{blending}"

    def file_stem(self) -> str:
        """Return the name for files."""
        width, height = self.image_size
        blending = "" if self.blend_mode == COMPOSITE else f"-{self.blend_mode.lower()}"
        blending += "-shaded" if self.lighting else ""
        return f"{self.dataset}-{self.transfer_function}-{width}x{height}{blending}"


@dataclass(frozen=True)
class ScenePattern:
    """Picks the scenes that have all the given values."""

    dataset: str | None = None
    transfer_function: str | None = None
    image_size: tuple[int, int] | None = None
    blend_mode: str | None = None

    def matches(self, scene: Scene) -> bool:
        """Tell whether the scene is one of those."""
        return all(
            value is None or getattr(scene, name) == value
            for name, value in vars(self).items()
        )


@dataclass(frozen=True)
class Run:
    """One row of the results: a technique with its settings, in a scene, on a path."""

    study: str
    scene: Scene
    technique: str
    integrator: str | None
    step_voxels: float | None
    view: str
    path: str
    settings: Settings = ()

    def key(self) -> tuple[Any, ...]:
        """Return what tells two rows of one results file apart."""
        sampling = (self.technique, self.integrator, self.step_voxels)
        settings = tuple(sorted(self.settings))
        return (self.study, self.scene, *sampling, settings, self.view, self.path)


@dataclass(frozen=True)
class Sweep:
    """Runs that differ along some axes only: a product of its own, of some techniques."""

    techniques: tuple[str, ...]
    paths: tuple[str, ...]
    integrators: tuple[str, ...]
    step_voxels: tuple[float, ...]
    settings: dict[str, tuple[Any, ...]] = field(default_factory=dict)
    datasets: tuple[str, ...] = ()  # none: all of the study

    def has(self, technique: str, scene: Scene, path: str) -> bool:
        """Tell whether the sweep has runs of the technique there."""
        inside = not self.datasets or scene.dataset in self.datasets
        return inside and technique in self.techniques and path in self.paths


@dataclass(frozen=True)
class Start:
    """What else is measured of some volumes: their first picture, and that after an edit."""

    datasets: tuple[Dataset, ...]
    transfer_function: str
    techniques: tuple[str, ...]
    image_size: tuple[int, int]
    step_voxels: float = 1.0
    repeats: int = 5
    edits: int = 3


@dataclass(frozen=True)
class Series:
    """Scenes that differ in one factor, over which growth is fitted.

    Runs are compared at an RMSE, interpolated, or else at one integrator and step.
    """

    title: str
    factor: str
    datasets: tuple[str, ...]
    rmse: float | None = None
    integrator: str = "Midpoint"
    step_voxels: float = 1.0


@dataclass(frozen=True)
class Study:
    """All factors and settings of one study file."""

    name: str
    datasets: tuple[Dataset, ...]
    transfer_functions: dict[str, tuple[str, ...]]
    techniques: tuple[str, ...]
    description: str = ""
    notes: tuple[str, ...] = ()
    integrators: tuple[str, ...] = ("Midpoint",)
    step_voxels: tuple[float, ...] = (1.0,)
    image_sizes: tuple[tuple[int, int], ...] = ((500, 500),)
    blend_modes: tuple[str, ...] = (COMPOSITE,)
    technique_settings: dict[str, dict[str, tuple[Any, ...]]] = field(
        default_factory=dict
    )
    technique_settings_scenes: tuple[ScenePattern, ...] = ()
    sweeps: tuple[Sweep, ...] = ()
    paths: tuple[str, ...] = DEFAULT_PATHS
    camera: Camera = field(default_factory=Camera)
    timing: Timing = field(default_factory=Timing)
    error: ErrorSettings = field(default_factory=ErrorSettings)
    termination_threshold: float = 0.001
    ray_set_up: str = "Box"
    lighting: tuple[bool, ...] = (False,)
    lighting_damping: float = 0.0
    report: str | None = None
    paper: dict[str, Any] | None = None
    start: Start | None = None
    series: tuple[Series, ...] = ()
    folder: Path | None = None
    shortened: "Study | None" = None

    def scenes(self) -> list[Scene]:
        """Return the scenes in study order."""
        return [
            Scene(dataset.name, name, size, blend_mode, lit)
            for dataset in self.datasets
            for name in self.transfer_functions[dataset.name]
            for size in dataset.image_sizes or self.image_sizes
            for blend_mode in self.blend_modes
            for lit in self.lighting
        ]

    def runs(self) -> list[Run]:
        """Return the full factorial, or that of each sweep; peers have no integrator or step."""
        view = self.camera.path
        found = [
            Run(self.name, scene, technique, integrator, step, view, path, settings)
            for scene in self.scenes()
            for path in self.paths
            for technique in self.techniques
            if path in find_technique(technique, self.name).paths
            for sweep in self._sweeps_of(technique, scene, path)
            for integrator, step in self._samplings(technique, sweep)
            for settings in _combinations(sweep.settings)
        ]
        return list(dict.fromkeys(found))

    def _sweeps_of(self, technique: str, scene: Scene, path: str) -> list[Sweep]:
        """Return the sweeps of a technique; without any, one with the factors of the study."""
        if self.sweeps:
            return [sweep for sweep in self.sweeps if sweep.has(technique, scene, path)]
        settings = self._settings(technique, scene)
        return [
            Sweep((technique,), (path,), self.integrators, self.step_voxels, settings)
        ]

    def _samplings(
        self, technique: str, sweep: Sweep
    ) -> list[tuple[str | None, float | None]]:
        if find_technique(technique, self.name).peer:
            return [(None, None)]
        return list(product(sweep.integrators, sweep.step_voxels))

    def _settings(self, technique: str, scene: Scene) -> dict[str, tuple[Any, ...]]:
        """Return all values, or the first alone where the settings do not vary."""
        given = self.technique_settings.get(technique, {})
        patterns = self.technique_settings_scenes
        varied = not patterns or any(item.matches(scene) for item in patterns)
        return given if varied else {name: item[:1] for name, item in given.items()}

    def dataset(self, name: str) -> Dataset:
        """Return the dataset of that name."""
        return next(dataset for dataset in self.datasets if dataset.name == name)

    def error_size(self, scene: Scene) -> tuple[int, int]:
        """Return the size of the pictures that errors are measured on."""
        return self.error.image_size or scene.image_size

    def settings(self) -> dict[str, Any]:
        """Return what all rows of one results file must share, as plain JSON values."""
        return {
            "study": self.name,
            "datasets": {item.name: _plain(asdict(item)) for item in self.datasets},
            "camera": asdict(self.camera),
            "timing": asdict(self.timing),
            "error": _plain(asdict(self.error)),
            "termination_threshold": self.termination_threshold,
            "ray_set_up": self.ray_set_up,
            "lighting": list(self.lighting)
            if len(self.lighting) > 1
            else self.lighting[0],
            "lighting_damping": self.lighting_damping,
        } | ({"start": _plain(asdict(self.start))} if self.start else {})

    def only(self, techniques: list[str]) -> "Study":
        """Return the study with these techniques in place of its own."""
        for technique in techniques:
            find_technique(technique, "--techniques")
        chosen = tuple(dict.fromkeys(techniques))
        shortened = self.shortened and replace(self.shortened, techniques=chosen)
        return with_runs(replace(self, techniques=chosen, shortened=shortened))

    def quick(self) -> "Study":
        """Return what the study itself calls quick, or else its extremes with short timing."""
        return self.shortened or self._extremes()

    def _extremes(self) -> "Study":
        timing = self.timing
        names = self.transfer_functions
        return replace(
            self,
            datasets=_ends(self.datasets),
            transfer_functions={key: _ends(value) for key, value in names.items()},
            step_voxels=_extremes(self.step_voxels, float),
            image_sizes=_extremes(self.image_sizes, lambda size: size[0] * size[1]),
            timing=replace(
                timing,
                minimum_frames=min(timing.minimum_frames, 4),
                relative_noise=max(timing.relative_noise, 0.1),
                time_limit_s=min(timing.time_limit_s, 1.0),
            ),
            error=replace(self.error, views=min(self.error.views, 1)),
        )

    def with_datasets(self, datasets: dict[str, Dataset]) -> "Study":
        """Return the study with other datasets in place of those of the given names."""

        def named(name: str | None) -> str | None:
            return datasets[name].name if name in datasets else name

        functions = self.transfer_functions
        return replace(
            self,
            datasets=tuple(datasets.get(item.name, item) for item in self.datasets),
            transfer_functions={named(key): item for key, item in functions.items()},
            technique_settings_scenes=tuple(
                replace(item, dataset=named(item.dataset))
                for item in self.technique_settings_scenes
            ),
            sweeps=tuple(
                replace(item, datasets=tuple(map(named, item.datasets)))
                for item in self.sweeps
            ),
            series=tuple(
                replace(item, datasets=tuple(map(named, item.datasets)))
                for item in self.series
            ),
        )

    def without_datasets(self, names: set[str], note: str) -> "Study":
        """Return the study without some volumes, and with a note that says why."""
        return replace(
            self,
            datasets=tuple(item for item in self.datasets if item.name not in names),
            notes=(*self.notes, note),
        )


def _combinations(settings: dict[str, tuple[Any, ...]]) -> list[Settings]:
    return [tuple(zip(settings, values)) for values in product(*settings.values())]


def _plain(value: Any) -> Any:
    """Return what JSON makes of nested values: lists in place of tuples."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value


def _ends(items: tuple[Any, ...]) -> tuple[Any, ...]:
    return items if len(items) < 3 else (items[0], items[-1])


def _extremes(items: tuple[Any, ...], order: Any) -> tuple[Any, ...]:
    lowest, highest = min(items, key=order), max(items, key=order)
    return tuple(item for item in items if item in (lowest, highest))


def with_runs(study: Study, path: Path | None = None) -> Study:
    """Return the study if it has runs; it is an error if not."""
    if not study.runs():
        raise StudyError(
            f'{path or study.name}: no run is left: techniques {", ".join(study.techniques)} do '
            f'not exist in paths {", ".join(study.paths)} (ParaView\'s Volume: '
            f"{', '.join(TECHNIQUES[PARAVIEW].paths)}; VTK's own mappers: {ENGINE})"
        )
    return study
