"""Notes that follow from the results: which techniques are slow, and where their time goes."""

from .results import OK, Record
from .study import Study
from .summary import (
    in_scene,
    is_peer,
    million_samples,
    sampling_text,
    scenes_of,
    stage_split,
    standard_rows,
)
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES

SLOW_FACTOR = 2.0


def all_notes(study: Study, records: list[Record]) -> list[str]:
    """Return the notes of the study file, then those that follow from its results."""
    return [*study.notes, *slow_notes(records)]


def slow_notes(records: list[Record]) -> list[str]:
    """Name each technique that takes over twice the time of single pass in a scene, with causes.

    Both have the same integrator, step and path; where settings vary, the first ones count.
    """
    return [
        _note(row, base)
        for scene in scenes_of(records)
        for row, base in _pairs(in_scene(records, scene))
        if row.frame_ms.median > SLOW_FACTOR * base.frame_ms.median
    ]


def _pairs(rows: list[Record]) -> list[tuple[Record, Record]]:
    """Return each row of a scene with that of single pass under the same conditions."""
    timed = [row for row in rows if row.status == OK and row.frame_ms.median]
    bases = {
        (row.path, row.integrator, row.step_voxels): row
        for row in timed
        if row.technique == REFERENCE_TECHNIQUE
    }
    pairs = []
    for row in standard_rows(timed):
        base = bases.get((row.path, row.integrator, row.step_voxels))
        if base is not None and base is not row and not is_peer(row):
            pairs.append((row, base))
    return pairs


def _note(row: Record, base: Record) -> str:
    ours, theirs = row.frame_ms.median, base.frame_ms.median
    text = (
        f"{row.run().scene.title()}, path {row.path}: {TECHNIQUES[row.technique].title} "
        f"({sampling_text(row)}) takes {ours / theirs:.1f} times as long as "
        f"{TECHNIQUES[base.technique].title}, {ours:.1f} ms against {theirs:.1f} ms."
    )
    stages = stage_split(row)
    text += f" Stages: {stages}." if stages else " It has no stages to tell apart."
    return text + _sample_sentence(row, base, ours / theirs)


def _sample_sentence(row: Record, base: Record, slower: float) -> str:
    ours, theirs = million_samples(row), million_samples(base)
    if not ours or not theirs:
        return " Its samples were not counted."
    more = ours / theirs
    if abs(more - 1) < 0.005:
        return f" Both take as many samples, {ours:.2f} million."
    return (
        f" It takes {more:.2f} times as many samples ({ours:.2f} against {theirs:.2f} million), "
        f"so that the time for a sample is {slower / more:.1f} times as long."
    )
