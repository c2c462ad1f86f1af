"""Cuts of a study by the command line: some of its volumes, fewer frames. Its notes tell of them."""

from dataclasses import replace

from .errors import StudyError
from .orbit import THREE_VIEWS
from .study import Study, with_runs


def of_datasets(study: Study, names: list[str]) -> Study:
    """Return the study of these volumes alone; a name that it does not have is an error."""
    known = [dataset.name for dataset in study.datasets]
    for name in names:
        if name not in known:
            raise StudyError(
                f'--datasets: "{name}" is not a dataset of {study.name}; it has '
                f"{', '.join(known)}"
            )
    others = [name for name in known if name not in names]
    if not others:
        return study
    note = f"Cut to {', '.join(names)}; the study also has {', '.join(others)}."
    return with_runs(study.without_datasets(set(others), note))


def with_frames(study: Study, frames: int) -> Study:
    """Return the study with so many frames on the camera's path, each run one turn at least."""
    camera, timing = study.camera, study.timing
    if camera.path == THREE_VIEWS:
        raise StudyError(f"--frames: the path {THREE_VIEWS} has frames of its own")
    if frames < study.error.views:
        raise StudyError(
            f"--frames {frames}: {study.name} measures errors at {study.error.views} of them"
        )
    note = (
        f"Cut to {frames} frames a turn and one turn a run; the study has {camera.frames} frames "
        f"a turn and at least {timing.minimum_frames} a run."
    )
    return replace(
        study,
        camera=replace(camera, frames=frames),
        timing=replace(timing, minimum_frames=frames),
        notes=(*study.notes, note),
    )
