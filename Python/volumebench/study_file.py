"""Reads a study from JSON; every fault is one line that names file, key and value."""

from pathlib import Path
from typing import Any

from .errors import StudyError
from .generators import GENERATORS
from .json_file import check_schema, read_json
from .paper_check import paper_faults
from .orbit import FIXED_ANGLES, THREE_VIEWS
from .study import Camera, Dataset, ErrorSettings, ScenePattern, Series, Start, Study
from .study import Sweep, Timing, with_runs
from .technique_settings import TECHNIQUE_SETTINGS, settings_of_technique
from .techniques import DEFAULT_PATHS, VIEW, find_technique

STUDY_FOLDER = Path(__file__).resolve().parent.parent / "Studies"
_GROUPS = {"camera": Camera, "timing": Timing, "error": ErrorSettings}
_PLAIN_KEYS = (
    *("description", "termination_threshold", "ray_set_up"),
    *("lighting_damping", "report", "paper"),
)
_ANY_VOLUME = ("name", "otherwise", "generator", "image_sizes", "memory_gb")
_LIST_KEYS = ("integrators", "paths", "blend_modes", "notes")


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
    quick = document.pop("quick", None)
    _check_names(document, quick or {}, path)
    shortened = None
    if quick is not None:
        shortened = study_from(_shortened(document, quick, path), path)
    study = study_from(document, path, shortened)
    _check_patterns(study, path)
    _check_paper(study, path)
    return study


def _shortened(
    document: dict[str, Any], quick: dict[str, Any], path: Path
) -> dict[str, Any]:
    """Return the document with the values that "quick" gives in place of its own."""
    result = document | {
        key: document.get(key, {}) | value if key in _GROUPS else value
        for key, value in quick.items()
    }
    if "datasets" in quick:
        named = {item["name"]: item for item in document["datasets"]}
        for name in quick["datasets"]:
            if name not in named:
                raise StudyError(
                    f'{path}: "quick.datasets": "{name}" is not a dataset of this study'
                )
        result["datasets"] = [named[name] for name in quick["datasets"]]
        given = result["transfer_functions"]
        if isinstance(given, dict) and "transfer_functions" not in quick:
            kept = {key: given[key] for key in given if key in quick["datasets"]}
            result["transfer_functions"] = kept
    if "paper" in document and "image_sizes" in quick:
        _stand_for_sizes(result, document["image_sizes"], quick["image_sizes"])
    return result


def _stand_for_sizes(
    result: dict[str, Any], sizes: list[list[int]], smaller: list[list[int]]
) -> None:
    """Where a quick cut has as many sizes of pictures, each answers for one that a paper names."""
    if len(sizes) == len(smaller):
        result["paper"] = _with_sizes(result["paper"], list(zip(sizes, smaller)))
    here, there = (
        ", ".join(f"{width} x {height}" for width, height in item)
        for item in (smaller, sizes)
    )
    note = (
        f"This quick cut draws {here} pixels in place of {there}: its times do not compare "
        "with the paper's, its ratios do."
    )
    result["notes"] = [*result.get("notes", ()), note]


def _with_sizes(part: Any, pairs: list[tuple[list[int], list[int]]]) -> Any:
    """Return a part of a document with other sizes of pictures in its selectors."""
    if isinstance(part, list):
        return [_with_sizes(item, pairs) for item in part]
    if not isinstance(part, dict):
        return part
    found = {key: _with_sizes(value, pairs) for key, value in part.items()}
    if "image_size" in found:
        size = found["image_size"]
        found["image_size"] = next((new for old, new in pairs if old == size), size)
    return found


def study_from(
    document: dict[str, Any], path: Path, shortened: Study | None = None
) -> Study:
    """Build the study of an already validated document; `path` is named in errors."""
    for technique in document["techniques"]:
        find_technique(technique, f'{path}: "techniques"')
    datasets = _datasets(document, path)
    values: dict[str, Any] = {
        "name": document["name"],
        "datasets": datasets,
        "transfer_functions": _transfer_functions(document, datasets, path),
        "techniques": tuple(document["techniques"]),
        "technique_settings": _technique_settings(
            document.get("technique_settings", {}), "technique_settings", path
        ),
        "sweeps": _sweeps(document, path),
        "series": tuple(
            Series(**_with_tuples(item)) for item in document.get("series", ())
        ),
        "start": _start(document.get("start"), path),
        "technique_settings_scenes": tuple(
            ScenePattern(**_with_tuples(item))
            for item in document.get("technique_settings_scenes", ())
        ),
        "folder": path.resolve().parent,
        "shortened": shortened,
    }
    values |= {key: document[key] for key in _PLAIN_KEYS if key in document}
    values |= {key: tuple(document[key]) for key in _LIST_KEYS if key in document}
    if "step_voxels" in document:
        values["step_voxels"] = tuple(float(step) for step in document["step_voxels"])
    if "image_sizes" in document:
        values["image_sizes"] = tuple(tuple(size) for size in document["image_sizes"])
    if "lighting" in document:
        values["lighting"] = _one_or_more(document["lighting"])
    for key, group in _GROUPS.items():
        values[key] = group(**_with_tuples(document.get(key, {})))
    _check_views(values["error"], values["camera"], path)
    return with_runs(Study(**values), path)


def _with_tuples(values: dict[str, Any]) -> dict[str, Any]:
    return {key: _tuples(value) for key, value in values.items()}


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def _one_or_more(value: Any) -> tuple[Any, ...]:
    return tuple(value) if isinstance(value, list) else (value,)


def _start(item: dict[str, Any] | None, path: Path) -> Start | None:
    if item is None:
        return None
    where = f'{path}: "start.techniques"'
    for technique in item["techniques"]:
        if VIEW not in find_technique(technique, where).paths:
            raise StudyError(f'{where}: "{technique}" is not drawn in a ParaView view')
    datasets = tuple(_dataset(given, path) for given in item["datasets"])
    return Start(**_with_tuples(item) | {"datasets": datasets})


def _check_names(document: dict[str, Any], quick: dict[str, Any], path: Path) -> None:
    """Sweeps and series name datasets of the study; a quick one may leave out some of them."""
    names = [item["name"] for item in document["datasets"]]
    for part, prefix in ((document, ""), (quick, "quick.")):
        for key in ("sweeps", "series"):
            for index, item in enumerate(part.get(key, ())):
                for name in item.get("datasets", ()):
                    if name not in names:
                        raise StudyError(
                            f'{path}: "{prefix}{key}[{index}].datasets": "{name}" is not a '
                            "dataset of this study"
                        )


def _check_views(error: ErrorSettings, camera: Camera, path: Path) -> None:
    if camera.path == THREE_VIEWS and camera.frames != len(FIXED_ANGLES):
        raise StudyError(
            f'{path}: "camera.frames": the path {THREE_VIEWS} has {len(FIXED_ANGLES)} frames, '
            f"not {camera.frames}"
        )
    if error.views > camera.frames:
        raise StudyError(
            f'{path}: "error.views": {error.views} views do not fit an orbit of '
            f'{camera.frames} frames ("camera.frames")'
        )


def _check_patterns(study: Study, path: Path) -> None:
    scenes = study.scenes()
    for index, pattern in enumerate(study.technique_settings_scenes):
        if not any(pattern.matches(scene) for scene in scenes):
            given = ", ".join(
                f"{key} {value}" for key, value in vars(pattern).items() if value
            )
            raise StudyError(
                f'{path}: "technique_settings_scenes[{index}]": no scene of this study has '
                f"{given}"
            )


def _check_paper(study: Study, path: Path) -> None:
    """Each conclusion has what its kind needs, and every selector picks a run of the study."""
    for place, problem in paper_faults(study):
        raise StudyError(f'{path}: "paper.{place}": {problem}')


def _datasets(document: dict[str, Any], path: Path) -> tuple[Dataset, ...]:
    datasets = tuple(_dataset(item, path) for item in document["datasets"])
    names = [item.name for item in datasets]
    names += [item.otherwise for item in datasets if item.otherwise]
    for name in names:
        if names.count(name) > 1:
            raise StudyError(f'{path}: "datasets": "{name}" is listed twice')
    return datasets


def _dataset(item: dict[str, Any], path: Path) -> Dataset:
    values = _with_tuples(item)
    name = values["name"]
    generated = values.get("generator", values.get("otherwise", name))
    where = f'{path}: "datasets"'
    for key in ("otherwise", "generator"):
        if key in values and generated not in GENERATORS:
            raise StudyError(
                f'{where}: "{key}" of dataset "{name}" is "{generated}"; '
                f'it must be a generated volume: {", ".join(GENERATORS)}'
            )
    extra = [key for key in values if key not in _ANY_VOLUME]
    if extra and generated not in GENERATORS:
        raise StudyError(
            f'{where}: "{extra[0]}" of dataset "{name}" applies only to '
            f'generated volumes: {", ".join(GENERATORS)}'
        )
    known = GENERATORS[generated].parameters() if extra else ()
    for key in extra:
        if key not in known:
            raise StudyError(f'{where}: "{key}" does not apply to "{generated}"')
    return Dataset(**values)


def _technique_settings(
    given: dict[str, Any], key: str, path: Path
) -> dict[str, dict[str, tuple[Any, ...]]]:
    for technique, settings in given.items():
        where = f'{path}: "{key}.{technique}"'
        find_technique(technique, where)
        known = settings_of_technique(technique)
        for name, values in settings.items():
            if name not in known:
                offered = f"it has {', '.join(known)}" if known else "it has none"
                raise StudyError(
                    f'{where}: technique "{technique}" has no setting "{name}"; {offered}'
                )
            _check_values(f'{where[:-1]}.{name}"', name, values)
    return {
        technique: {name: tuple(values) for name, values in settings.items()}
        for technique, settings in given.items()
    }


def _sweeps(document: dict[str, Any], path: Path) -> tuple[Sweep, ...]:
    """Return the sweeps; what one does not give is that of the study."""
    sweeps = []
    for index, item in enumerate(document.get("sweeps", ())):
        key = f"sweeps[{index}]"
        techniques = item.get("techniques", document["techniques"])
        for technique in techniques:
            if technique not in document["techniques"]:
                raise StudyError(
                    f'{path}: "{key}.techniques": "{technique}" is not among "techniques"'
                )
        settings = item.get("settings", {})
        given = {technique: settings for technique in techniques if settings}
        checked = _technique_settings(given, f"{key}.settings", path)
        sweeps.append(
            Sweep(
                tuple(techniques),
                tuple(item.get("paths", document.get("paths", DEFAULT_PATHS))),
                tuple(
                    item.get("integrators", document.get("integrators", ("Midpoint",)))
                ),
                tuple(
                    float(step)
                    for step in item.get(
                        "step_voxels", document.get("step_voxels", (1,))
                    )
                ),
                checked[techniques[0]] if settings else {},
                tuple(item.get("datasets", ())),
            )
        )
    return tuple(sweeps)


def _check_values(where: str, name: str, values: list[Any]) -> None:
    setting = TECHNIQUE_SETTINGS[name]
    for value in values:
        if not setting.accepts(value):
            raise StudyError(
                f"{where}: {value!r} is not a value of it (expected: {setting.choice()})"
            )


def _transfer_functions(
    document: dict[str, Any], datasets: tuple[Dataset, ...], path: Path
) -> dict[str, tuple[str, ...]]:
    names = [dataset.name for dataset in datasets]
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
