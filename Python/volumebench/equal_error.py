"""How much faster than single pass at equal error: every technique, scene and path of a sweep."""

import math
from dataclasses import dataclass

from .results import Record
from .speed import Match, best_match
from .study import Scene
from .summary import in_scene, is_peer, number, range_text, scenes_of
from .tables import Table
from .techniques import REFERENCE_TECHNIQUE, TECHNIQUES
from .work_precision import geometric_mean

LEVELS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5)  # RMSE


@dataclass(frozen=True)
class Pair:
    """A technique beside single pass in a scene, at an RMSE that both reach."""

    scene: Scene
    path: str
    rmse: float
    base: Match
    other: Match

    def factor(self) -> float:
        """Return how many times as long single pass takes."""
        return self.base.ms / self.other.ms

    def interval(self) -> tuple[float, float]:
        """Return the ends of its 95 % interval."""
        width = math.exp(math.hypot(self.base.half_width, self.other.half_width))
        return self.factor() / width, self.factor() * width

    def is_faster(self) -> bool | None:
        """Tell whether the technique is, or is not; None where the interval leaves it open."""
        low, high = self.interval()
        is_slower = high < 1 and not self.other.is_bound
        return True if low > 1 else (False if is_slower else None)

    def bound(self) -> str:
        """Return the word before a factor that one of both ends of the curves is the source of."""
        return "at least " if self.other.is_bound else ""


def pairs(records: list[Record]) -> list[Pair]:
    """Return what can be compared.

    Single pass must have been measured on both sides of an error: where its fastest run is more
    accurate than that, its time there is not known, only that it is not needed.
    """
    ours = [row for row in records if not is_peer(row)]
    return [
        pair
        for scene in scenes_of(ours)
        for path in dict.fromkeys(row.path for row in in_scene(ours, scene))
        for pair in _pairs_of(
            scene, path, [row for row in in_scene(ours, scene) if row.path == path]
        )
    ]


def _pairs_of(scene: Scene, path: str, rows: list[Record]) -> list[Pair]:
    by_technique: dict[str, list[Record]] = {}
    for row in rows:
        by_technique.setdefault(row.technique, []).append(row)
    bases = by_technique.pop(REFERENCE_TECHNIQUE, [])
    found = []
    for others in by_technique.values():
        for rmse in LEVELS:
            base, other = best_match(bases, rmse), best_match(others, rmse)
            if base and other and not base.is_bound:
                found.append(Pair(scene, path, rmse, base, other))
    return found


def sentence(records: list[Record]) -> str:
    """Return the sentence to quote: each technique over all its pairs."""
    base = TECHNIQUES[REFERENCE_TECHNIQUE].title
    found: dict[str, list[Pair]] = {}
    for pair in pairs(records):
        found.setdefault(pair.other.record.technique, []).append(pair)
    if not found:
        return (
            f"No technique reached an error that {base} was measured on both sides of."
        )
    return " ".join(
        _technique_sentence(TECHNIQUES[name].title, base, items)
        for name, items in found.items()
    )


def _technique_sentence(title: str, base: str, items: list[Pair]) -> str:
    factors = [pair.factor() for pair in items]
    verdicts = [pair.is_faster() for pair in items]
    scenes = len({pair.scene for pair in items})
    return (
        f"At equal error {title} has {geometric_mean(factors):.2f} times the frame rate of {base} "
        f"(geometric mean over {len(items)} errors in {scenes} {'scene' if scenes == 1 else 'scenes'}; "
        f"{range_text(factors, '.2f')}): faster at {verdicts.count(True)} of them, slower at "
        f"{verdicts.count(False)}, undecided at {verdicts.count(None)}."
    )


def equal_error_table(records: list[Record]) -> Table | None:
    """Return one row for each pair."""
    base = TECHNIQUES[REFERENCE_TECHNIQUE].title
    header = ("scene", "path", f"{base}'s variant", "other variant", "RMSE")
    header += (f"{base}'s ms", "other ms", "frame rate", "95 % interval")
    rows = tuple(map(_row, pairs(records)))
    return Table(f"Beside {base} at equal error", header, rows, 4) if rows else None


def _row(pair: Pair) -> tuple[str, ...]:
    return (
        pair.scene.title(),
        pair.path,
        pair.base.variant(),
        pair.other.variant(),
        number(pair.rmse, ".0e"),
        number(pair.base.ms, ".1f"),
        number(pair.other.ms, ".1f"),
        f"{pair.bound()}{pair.factor():.2f}x",
        "{:.2f} to {:.2f}".format(*pair.interval()),
    )
