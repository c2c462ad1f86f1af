"""The pictures of a scene on disk, with an index file that the report reads."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from .errors import StudyError
from .json_file import read_json, write_atomically
from .pictures import BLACK, amplification, difference_image, over, write_png
from .results import Record
from .study import Run, Scene
from .technique_settings import settings_text
from .techniques import TECHNIQUES
from .kept_pictures import Pictures

FOLDER = "pictures"
INDEX = "index.json"


@dataclass(frozen=True)
class Picture:
    """One picture file with what it shows; the files stand in the pictures folder."""

    title: str
    caption: str
    file: str
    difference_file: str | None = None


@dataclass(frozen=True)
class Gallery:
    """The pictures of one scene; all differences are amplified by the same factor."""

    scene: str
    pictures: tuple[Picture, ...]
    factor: int | None = None


def write_gallery(
    folder: Path, scene: Scene, pictures: Pictures, records: list[Record]
) -> None:
    """Write one PNG per technique, the reference and the differences; update the index."""
    target = folder / FOLDER
    target.mkdir(parents=True, exist_ok=True)
    truth = pictures.references[0] if pictures.references else None
    factor = None
    if truth is not None:
        images = [picture for _, picture in pictures.by_technique.values()]
        factor = min(amplification(image - truth) for image in images)
    items = []
    if truth is not None:
        file = f"{scene.file_stem()}-truth.png"
        write_png(target / file, over(truth, BLACK))
        items.append(Picture("Reference", pictures.label or "", file))
    items += [
        _write_picture(target, run, image, truth, factor, records)
        for run, image in pictures.by_technique.values()
    ]
    _update_index(target, Gallery(scene.title(), tuple(items), factor))


def _write_picture(
    target: Path,
    run: Run,
    image: np.ndarray,
    truth: np.ndarray | None,
    factor: int | None,
    records: list[Record],
) -> Picture:
    stem = f"{run.scene.file_stem()}-{run.technique}"
    write_png(target / f"{stem}.png", over(image, BLACK))
    difference_file = None
    if truth is not None and factor is not None:
        difference_file = f"{stem}-difference.png"
        write_png(target / difference_file, difference_image(image, truth, factor))
    record = next(item for item in records if item.run().key() == run.key())
    title = TECHNIQUES[run.technique].title
    return Picture(title, _caption(record), f"{stem}.png", difference_file)


def _caption(record: Record) -> str:
    parts = []
    if record.step_voxels is not None:
        parts.append(f"{record.integrator}, step {record.step_voxels:g} voxel")
    if record.settings:
        parts.append(settings_text(record.settings))
    if record.frame_ms.median is not None:
        parts.append(f"{record.frame_ms.median:.0f} ms")
    if record.error.rmse is not None:
        parts.append(f"RMSE {record.error.rmse:.1e}")
    size = record.error.image_size
    if size and size != record.image_size:
        parts.append(f"picture {size[0]} x {size[1]}")
    return ", ".join(parts)


def _update_index(target: Path, gallery: Gallery) -> None:
    kept = [
        item for item in read_galleries(target.parent) if item.scene != gallery.scene
    ]
    document = [asdict(item) for item in (*kept, gallery)]
    write_atomically(target / INDEX, json.dumps(document, indent=1) + "\n")


def read_galleries(folder: Path) -> list[Gallery]:
    """Return the galleries of an output folder; none if it has no pictures."""
    index = folder / FOLDER / INDEX
    if not index.is_file():
        return []
    try:
        return [
            Gallery(
                item["scene"],
                tuple(Picture(**picture) for picture in item["pictures"]),
                item["factor"],
            )
            for item in read_json(index)
        ]
    except (KeyError, TypeError):
        raise StudyError(f"{index}: is not an index of pictures") from None


def forget_galleries(folder: Path) -> None:
    """Drop the index, so that a new study shows no picture of an earlier one."""
    (folder / FOLDER / INDEX).unlink(missing_ok=True)
