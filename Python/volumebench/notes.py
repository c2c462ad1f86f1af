"""Notes that follow from the results: which techniques are slow, and where their time goes."""

from dataclasses import dataclass

from .results import OK, Record
from .study import Study
from .summary import in_scene, is_peer, million_samples, range_text, scenes_of
from .summary import stage_shares, standard_rows
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES

SLOW_FACTOR = 2.0


@dataclass(frozen=True)
class SlowRow:
    """A row beside that of single pass in the same scene, on the same path, at the same sampling."""

    record: Record
    base: Record

    def slower(self) -> float:
        """Return how many times as long the frame takes."""
        return self.record.frame_ms.median / self.base.frame_ms.median

    def more_samples(self) -> float | None:
        """Return how many times as many samples it takes, if both were counted."""
        ours, theirs = million_samples(self.record), million_samples(self.base)
        return ours / theirs if ours and theirs else None

    def slower_sample(self) -> float | None:
        """Return how many times as long one sample takes."""
        more = self.more_samples()
        return self.slower() / more if more else None


def slow_rows(records: list[Record]) -> list[SlowRow]:
    """Return each row of ours that takes over twice as long as that of single pass.

    Where a technique varies its settings, the first ones count.
    """
    return [
        row
        for scene in scenes_of(records)
        for row in _beside_single_pass(in_scene(records, scene))
        if row.slower() > SLOW_FACTOR
    ]


def _beside_single_pass(rows: list[Record]) -> list[SlowRow]:
    timed = [row for row in rows if row.status == OK and row.frame_ms.median]
    standard = standard_rows(timed)
    bases = {
        (row.path, row.integrator, row.step_voxels): row
        for row in standard
        if row.technique == REFERENCE_TECHNIQUE
    }
    pairs = []
    for row in standard:
        base = bases.get((row.path, row.integrator, row.step_voxels))
        if base is not None and base is not row and not is_peer(row):
            pairs.append(SlowRow(row, base))
    return pairs


def all_notes(study: Study, records: list[Record]) -> list[str]:
    """Return the notes of the study file, then one for each technique that is slow somewhere.

    Those of a paper's study stand beside its conclusions.
    """
    slow = slow_rows(records)
    techniques = dict.fromkeys(row.record.technique for row in slow)
    notes = [
        _note([row for row in slow if row.record.technique == technique], records)
        for technique in techniques
    ]
    return notes if study.paper else [*study.notes, *notes]


def _note(slow: list[SlowRow], records: list[Record]) -> str:
    scenes = len(scenes_of([row.record for row in slow]))
    text = (
        f"{TECHNIQUES[slow[0].record.technique].title} takes "
        f"{range_text([row.slower() for row in slow])} as long as "
        f"{TECHNIQUES[REFERENCE_TECHNIQUE].title} in {scenes} of "
        f"{len(scenes_of(records))} scenes."
    )
    return text + _sample_sentence(slow) + _stage_sentence(slow)


def _sample_sentence(slow: list[SlowRow]) -> str:
    counted = [row for row in slow if row.more_samples()]
    if not counted:
        return " Its samples were not counted."
    factors = [row.more_samples() for row in counted]
    more = range_text(factors, ".2f")
    if all(abs(factor - 1) < 0.005 for factor in factors):
        more = "just"
    cost = range_text([row.slower_sample() for row in counted])
    return f" It takes {more} as many samples, and each of them takes {cost} as long."


def _stage_sentence(slow: list[SlowRow]) -> str:
    """Name the stage that most of the time goes to, over all rows."""
    shares: dict[str, list[float]] = {}
    for row in slow:
        for name, share in stage_shares(row.record).items():
            shares.setdefault(name, []).append(share)
    if not shares:
        return " It has no stages to tell apart."
    name, largest = max(shares.items(), key=lambda item: sum(item[1]))
    low, high = f"{100 * min(largest):.0f}", f"{100 * max(largest):.0f}"
    share = low if low == high else f"{low} to {high}"
    return f" Of its stages, {name} takes {share} % of the time."
