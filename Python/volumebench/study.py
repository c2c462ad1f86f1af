"""A study: factors and settings read from JSON, expanded into an ordered list of runs."""

from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from .errors import StudyError
from .json_file import check_schema, read_json
from .techniques import INTERACTIVE, PATHS, VIEW, find_technique

STUDY_FOLDER = Path(__file__).resolve().parent.parent / "Studies"
GENERATED_DATASETS = ("lemniscate",)


@dataclass(frozen=True)
class Dataset:
    """A volume by name; the other values apply to generated volumes only."""

    name: str
    dims: tuple[int, int, int] | None = None
    scalar_type: str | None = None
    extent: float | None = None


@dataclass(frozen=True)
class Camera:
    """One revolution of `frames` pictures about the vertical axis of the volume."""

    path: str = "orbit-y"
    frames: int = 36
    elevation_degrees: float = 20.0
    zoom: float = 1.0


@dataclass(frozen=True)
class Timing:
    """When to stop measuring frames of one run."""

    warm_up_frames: int = 2
    minimum_frames: int = 12
    relative_noise: float = 0.02
    time_limit_s: float = 10.0


@dataclass(frozen=True)
class ErrorSettings:
    """At how many views of the orbit the error is measured (0: nowhere) and against what."""

    views: int = 2
    reference_step_voxels: float = 0.03125


@dataclass(frozen=True)
class Scene:
    """What is looked at: one volume through one transfer function at one picture size."""

    dataset: str
    transfer_function: str
    image_size: tuple[int, int]

    def title(self) -> str:
        """Return the name for readers."""
        width, height = self.image_size
        return f"{self.dataset}, {self.transfer_function}, {width} x {height}"

    def file_stem(self) -> str:
        """Return the name for files."""
        width, height = self.image_size
        return f"{self.dataset}-{self.transfer_function}-{width}x{height}"


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

    def key(self) -> tuple[Any, ...]:
        """Return what tells two rows of one results file apart."""
        scene = (
            self.scene.dataset,
            self.scene.transfer_function,
            self.scene.image_size,
        )
        sampling = (self.technique, self.integrator, self.step_voxels)
        return (self.study, *scene, *sampling, self.view, self.path)


@dataclass(frozen=True)
class Study:
    """All factors and settings of one study file."""

    name: str
    datasets: tuple[Dataset, ...]
    transfer_functions: dict[str, tuple[str, ...]]
    techniques: tuple[str, ...]
    description: str = ""
    integrators: tuple[str, ...] = ("Midpoint",)
    step_voxels: tuple[float, ...] = (1.0,)
    image_sizes: tuple[tuple[int, int], ...] = ((500, 500),)
    paths: tuple[str, ...] = PATHS
    camera: Camera = field(default_factory=Camera)
    timing: Timing = field(default_factory=Timing)
    error: ErrorSettings = field(default_factory=ErrorSettings)
    termination_threshold: float = 0.001
    ray_set_up: str = "Box"
    folder: Path | None = None

    def scenes(self) -> list[Scene]:
        """Return the scenes in study order."""
        return [
            Scene(dataset.name, name, size)
            for dataset in self.datasets
            for name in self.transfer_functions[dataset.name]
            for size in self.image_sizes
        ]

    def runs(self) -> list[Run]:
        """Return the full factorial; a peer appears once a scene and path."""
        return [
            Run(self.name, scene, technique, integrator, step, self.camera.path, path)
            for scene in self.scenes()
            for path in self.paths
            for technique in self.techniques
            if path in find_technique(technique, self.name).paths
            for integrator, step in self._samplings(technique)
        ]

    def _samplings(self, technique: str) -> list[tuple[str | None, float | None]]:
        if find_technique(technique, self.name).peer:
            return [(None, None)]
        return [(name, step) for name in self.integrators for step in self.step_voxels]

    def dataset(self, name: str) -> Dataset:
        """Return the dataset of that name."""
        return next(dataset for dataset in self.datasets if dataset.name == name)

    def settings(self) -> dict[str, Any]:
        """Return what all rows of one results file must share, as plain JSON values."""
        return {
            "study": self.name,
            "datasets": {item.name: _plain(asdict(item)) for item in self.datasets},
            "camera": asdict(self.camera),
            "timing": asdict(self.timing),
            "error": asdict(self.error),
            "termination_threshold": self.termination_threshold,
            "ray_set_up": self.ray_set_up,
        }

    def only(self, techniques: list[str]) -> "Study":
        """Return the study with these techniques in place of its own."""
        for technique in techniques:
            find_technique(technique, "--techniques")
        return _with_runs(replace(self, techniques=tuple(dict.fromkeys(techniques))))

    def quick(self) -> "Study":
        """Return the study cut to the extremes of each factor, with short timing."""
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


def _plain(values: dict[str, Any]) -> dict[str, Any]:
    return {
        key: list(value) if isinstance(value, tuple) else value
        for key, value in values.items()
    }


def _ends(items: tuple[Any, ...]) -> tuple[Any, ...]:
    return items if len(items) < 3 else (items[0], items[-1])


def _extremes(items: tuple[Any, ...], order: Any) -> tuple[Any, ...]:
    lowest, highest = min(items, key=order), max(items, key=order)
    return tuple(item for item in items if item in (lowest, highest))


def find_study(text: str) -> Path:
    """Return the study file: a path, or the name of one under Python/Studies."""
    candidates = [Path(text), STUDY_FOLDER / text, STUDY_FOLDER / f"{text}.json"]
    for candidate in candidates:
        if candidate.is_file():
            return candidate
    known = ", ".join(sorted(path.stem for path in STUDY_FOLDER.glob("*.json")))
    raise StudyError(
        f'study "{text}" is neither a file nor a name under Python/Studies; names: {known}'
    )


def load_study(path: Path) -> Study:
    """Read, validate and return a study."""
    document = read_json(path)
    check_schema(document, "study_schema.json", path)
    return study_from(document, path)


def study_from(document: dict[str, Any], path: Path) -> Study:
    """Build the study of an already validated document; `path` is named in errors."""
    for technique in document["techniques"]:
        find_technique(technique, f'{path}: "techniques"')
    datasets = tuple(_dataset(item, path) for item in document["datasets"])
    values = {
        "name": document["name"],
        "datasets": datasets,
        "transfer_functions": _transfer_functions(document, datasets, path),
        "techniques": tuple(document["techniques"]),
        "folder": path.resolve().parent,
    }
    for key in ("description", "termination_threshold", "ray_set_up"):
        if key in document:
            values[key] = document[key]
    for key in ("integrators", "paths"):
        if key in document:
            values[key] = tuple(document[key])
    if "step_voxels" in document:
        values["step_voxels"] = tuple(float(step) for step in document["step_voxels"])
    if "image_sizes" in document:
        values["image_sizes"] = tuple(tuple(size) for size in document["image_sizes"])
    groups = {"camera": Camera, "timing": Timing, "error": ErrorSettings}
    for key, group in groups.items():
        values[key] = group(**document.get(key, {}))
    _check_views(values["error"], values["camera"], path)
    return _with_runs(Study(**values), path)


def _check_views(error: ErrorSettings, camera: Camera, path: Path) -> None:
    if error.views > camera.frames:
        raise StudyError(
            f'{path}: "error.views": {error.views} views do not fit an orbit of '
            f'{camera.frames} frames ("camera.frames")'
        )


def _dataset(item: dict[str, Any], path: Path) -> Dataset:
    values = dict(item)
    extra = [key for key in values if key != "name"]
    if extra and values["name"] not in GENERATED_DATASETS:
        generated = ", ".join(GENERATED_DATASETS)
        raise StudyError(
            f'{path}: "datasets": "{extra[0]}" of dataset "{values["name"]}" applies only to '
            f"generated volumes: {generated}"
        )
    if "dims" in values:
        values["dims"] = tuple(values["dims"])
    return Dataset(**values)


def _transfer_functions(
    document: dict[str, Any], datasets: tuple[Dataset, ...], path: Path
) -> dict[str, tuple[str, ...]]:
    names = [dataset.name for dataset in datasets]
    for name in names:
        if names.count(name) > 1:
            raise StudyError(f'{path}: "datasets": "{name}" is listed twice')
    given = document["transfer_functions"]
    if isinstance(given, list):
        return {name: tuple(given) for name in names}
    for name in given:
        if name not in names:
            raise StudyError(
                f'{path}: "transfer_functions": "{name}" is not a dataset of this study'
            )
    for name in names:
        if name not in given:
            raise StudyError(
                f'{path}: "transfer_functions": nothing is given for dataset "{name}"'
            )
    return {name: tuple(given[name]) for name in names}


def _with_runs(study: Study, path: Path | None = None) -> Study:
    if not study.runs():
        raise StudyError(
            f'{path or study.name}: no run is left: techniques {", ".join(study.techniques)} do '
            f'not exist in paths {", ".join(study.paths)} (ParaView\'s Volume: {VIEW} and '
            f"{INTERACTIVE}; VTK's own mappers: engine)"
        )
    return study
