"""How time, set-up and memory grow along the series of a scaling study."""

from collections.abc import Callable
from dataclasses import dataclass

from .fits import PowerLaw, power_law
from .results import OK, Record
from .speed import Match, best_match
from .study import Scene, Series, Study
from .summary import PEER_DISTANCE, in_scene, is_peer, sample_distance
from .techniques import TECHNIQUES

FACTOR_TITLES = {
    "edge": "edge of the volume (voxels)",
    "pixels": "pixels of the picture",
    "share": "share of the box that holds anything",
}
SYMBOLS = {"edge": "edge", "pixels": "pixels", "share": "share"}
FRAME = "frame ms"
SAMPLES = "samples"


@dataclass(frozen=True)
class Growth:
    """A quantity of one technique over the factor of a series, (x, y) in order of x, and its fit."""

    series: Series
    technique: str
    quantity: str
    points: tuple[tuple[float, float], ...]

    def fit(self) -> PowerLaw | None:
        """Return the power law through the points; None of fewer than two."""
        return power_law(list(self.points))

    def exponent_text(self) -> str:
        """Return the exponent with its 95 % interval, for readers."""
        fit = self.fit()
        if fit is None:
            return "-"
        text = f"{fit.exponent:.2f}"
        return (
            f"{text} \u00b1 {fit.half_width:.2f}"
            if fit.half_width is not None
            else text
        )


def upload_and_tables(row: Record) -> float | None:
    """Return the milliseconds of set-up that depend on the data; compiling does not."""
    parts = (row.setup_ms.upload, row.setup_ms.tables, row.setup_ms.grid)
    known = [part for part in parts if part is not None]
    return sum(known) if known else None


QUANTITIES: dict[str, Callable[[Record], float | None]] = {
    FRAME: lambda row: row.frame_ms.median,
    "set-up ms": upload_and_tables,
    "bytes on the device": lambda row: row.bytes_on_device,
    SAMPLES: lambda row: row.samples_taken,
}
_MATCHED: dict[str, Callable[[Match], float | None]] = {
    FRAME: lambda match: match.ms,
    SAMPLES: lambda match: match.samples,
}


def growths(study: Study, records: list[Record]) -> list[Growth]:
    """Return every quantity of every technique along every series."""
    result = []
    for series in study.series:
        for technique in study.techniques:
            own = [row for row in records if row.technique == technique]
            found = _values(study, series, [row for row in own if row.status == OK])
            for quantity, points in found.items():
                if points:
                    ordered = tuple(sorted(points))
                    result.append(Growth(series, technique, quantity, ordered))
    return result


def _values(
    study: Study, series: Series, rows: list[Record]
) -> dict[str, list[tuple[float, float]]]:
    """Return the points of each quantity; what was not measured or is 0 has no logarithm."""
    found: dict[str, list[tuple[float, float]]] = {}
    for scene in series_scenes(study, series):
        inside = in_scene(rows, scene)
        x = factor_of(study, series, scene)
        for quantity, value in _quantities(series, inside).items():
            if value:
                found.setdefault(quantity, []).append((x, value))
    return found


def series_scenes(study: Study, series: Series) -> list[Scene]:
    """Return the scenes of a series; a volume may have been left out for want of memory."""
    return [scene for scene in study.scenes() if scene.dataset in series.datasets]


def factor_of(study: Study, series: Series, scene: Scene) -> float:
    """Return where a scene is along the series."""
    dataset = study.dataset(scene.dataset)
    if series.factor == "pixels":
        return float(scene.image_size[0] * scene.image_size[1])
    if series.factor == "share":
        return dataset.share
    width, height, depth = dataset.dims
    return round((width * height * depth) ** (1 / 3), 6)  # a cube has its own edge


def _quantities(series: Series, rows: list[Record]) -> dict[str, float | None]:
    if series.rmse is not None:
        match = best_match(rows, series.rmse)
        if match is None or match.is_bound:
            return {}
        return {name: value(match) for name, value in _MATCHED.items()}
    row = next((row for row in rows if _is_compared(series, row)), None)
    if row is None:
        return {}
    return {name: value(row) for name, value in QUANTITIES.items()}


def _is_compared(series: Series, row: Record) -> bool:
    if is_peer(row):
        return sample_distance(row) == PEER_DISTANCE
    sampling = (series.integrator, series.step_voxels)
    return not row.settings and (row.integrator, row.step_voxels) == sampling


def sentence(study: Study, records: list[Record]) -> str:
    """Return the sentence to quote: how the frame time of our first technique grows."""
    found = growths(study, records)
    parts = []
    for series in study.series:
        own = [
            item for item in found if item.series == series and item.quantity == FRAME
        ]
        if own and own[0].fit():
            at_error = f" (RMSE {series.rmse:g})" if series.rmse else ""
            parts.append(
                f"{series.title}{at_error}: {SYMBOLS[series.factor]}^({own[0].exponent_text()})"
            )
    if not parts:
        return "No series was measured at two places or more."
    first = TECHNIQUES[study.techniques[0]].title
    return f"The frame time of {first} grows as follows. {'; '.join(parts)}."


def remarks(study: Study, records: list[Record]) -> list[str]:
    """Return where a series lacks a point: no run there brackets its error."""
    found = []
    for series in study.series:
        for technique in study.techniques if series.rmse is not None else ():
            if TECHNIQUES[technique].peer:
                continue
            rows = [row for row in records if row.technique == technique]
            lacking = [
                scene.title()
                for scene in series_scenes(study, series)
                if not _quantities(series, in_scene(rows, scene))
            ]
            if lacking:
                found.append(
                    f"{series.title}: no two runs of {TECHNIQUES[technique].title} bracket an "
                    f"RMSE of {series.rmse:g} in {', '.join(lacking)}."
                )
    return found
