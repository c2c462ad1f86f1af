"""Finds a volume by name: built in, generated, or a file in the user's data folder."""

import math
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from .errors import StudyError
from .generated_volume import GeneratedVolume
from .generators import GENERATORS, write_volume
from .json_file import check_schema, read_json
from .study import Dataset, Study

MRI_FILE = Path("/usr/share/mricron/templates/ch2.nii.gz")
# A .raw file may belong to a header, so it comes last.
EXTENSIONS = (
    *(".nrrd", ".nhdr", ".mhd", ".mha", ".vti", ".nii", ".nii.gz"),
    *(".pvm", ".dat", ".raw"),
)
SCALAR_BYTES = {
    "int8": 1,
    "uint8": 1,
    "int16": 2,
    "uint16": 2,
    "int32": 4,
    "uint32": 4,
    "float32": 4,
    "float64": 8,
}


@dataclass(frozen=True)
class RawLayout:
    """What a .raw file does not say of itself; read from the .json file beside it."""

    dims: tuple[int, int, int]
    scalar_type: str
    spacing: tuple[float, float, float] = (1.0, 1.0, 1.0)
    byte_order: str = "little"


@dataclass(frozen=True)
class VolumeFile:
    """Where a volume lies and how it is to be read."""

    name: str
    path: Path
    raw: RawLayout | None = None
    upright: bool = False


def with_stand_ins(study: Study, data_folder: Path | None) -> Study:
    """Return the study with generated volumes in place of those that have no file here."""
    stand_ins = {
        dataset.name: replace(
            dataset,
            name=dataset.otherwise,
            otherwise=None,
            stands_for=dataset.name,
        )
        for dataset in study.datasets
        if dataset.otherwise and find_file(dataset.name, data_folder) is None
    }
    return study.with_datasets(stand_ins) if stand_ins else study


def fitting_memory(study: Study, free_gb: float | None) -> Study:
    """Return the study without the volumes that need more memory than is free, with a note."""
    if free_gb is None:
        return study
    for dataset in study.datasets:
        if (dataset.memory_gb or 0) > free_gb:
            note = (
                f"{dataset.name} is left out: it takes {dataset.memory_gb:g} GB of memory, and "
                f"{free_gb:.0f} are free."
            )
            study = study.without_datasets({dataset.name}, note)
    if not study.datasets:
        raise StudyError(f"{study.name}: no volume fits the {free_gb:.0f} GB of memory")
    return study


def free_memory_gb() -> float | None:
    """Return how much memory this machine can give, if it tells."""
    try:
        lines = Path("/proc/meminfo").read_text(encoding="ascii").splitlines()
    except OSError:
        return None
    found = [line.split()[1] for line in lines if line.startswith("MemAvailable:")]
    return int(found[0]) / 1024**2 if found else None


def find_file(name: str, data_folder: Path | None) -> Path | None:
    """Return the file of a volume in the data folder, if there is one."""
    if data_folder is None:
        return None
    candidates = [data_folder / f"{name}{extension}" for extension in EXTENSIONS]
    return next((path for path in candidates if path.is_file()), None)


def find_volume(dataset: Dataset, data_folder: Path | None, cache: Path) -> VolumeFile:
    """Return the file of a dataset; a generated one is written into the cache folder."""
    name = dataset.name
    is_stand_in = dataset.otherwise is None and dataset.generator
    if is_stand_in or name in GENERATORS:
        return VolumeFile(name, write_volume(_generator(dataset), cache))
    path = find_file(name, data_folder)
    if path is not None:
        raw = read_raw_layout(path) if path.suffix == ".raw" else None
        return VolumeFile(name, path, raw)
    if name == "mri":
        return _built_in_mri()
    looked = (
        f"in {data_folder}" if data_folder else "nowhere: no --data folder is given"
    )
    raise StudyError(
        f'dataset "{name}": no file {name} with extension '
        f'{", ".join(item[1:] for item in EXTENSIONS)}; looked {looked}; '
        f'built in: {", ".join(["mri", *GENERATORS])}'
    )


def _generator(dataset: Dataset) -> GeneratedVolume:
    kind = GENERATORS[dataset.generator or dataset.name]
    given = asdict(dataset)
    known = (name for name in kind.parameters() if given[name] is not None)
    return kind(**{name: given[name] for name in known})


def _built_in_mri() -> VolumeFile:
    if not MRI_FILE.is_file():
        raise StudyError(
            f'dataset "mri": {MRI_FILE} is missing; install the package mricron-data'
        )
    return VolumeFile("mri", MRI_FILE, upright=True)


def read_raw_layout(path: Path) -> RawLayout:
    """Read NAME.json beside NAME.raw and check it against the size of the file."""
    sidecar = path.with_suffix(".json")
    if not sidecar.is_file():
        raise StudyError(
            f"{path}: {sidecar.name} is missing beside it; it gives dims and scalar_type"
        )
    document = read_json(sidecar)
    check_schema(document, "raw_volume_schema.json", sidecar)
    layout = RawLayout(
        tuple(document["dims"]),
        document["scalar_type"],
        tuple(float(value) for value in document.get("spacing", (1, 1, 1))),
        document.get("byte_order", "little"),
    )
    expected = math.prod(layout.dims) * SCALAR_BYTES[layout.scalar_type]
    actual = path.stat().st_size
    if actual != expected:
        size = " x ".join(str(count) for count in layout.dims)
        raise StudyError(
            f"{path}: has {actual} bytes, but {sidecar.name} says {size} of "
            f"{layout.scalar_type}, that is {expected} bytes"
        )
    return layout
