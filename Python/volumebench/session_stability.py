"""Tries the stability cases through the source proxy VolumeStability."""

from collections.abc import Callable
from typing import Any

from paraview import servermanager

from .errors import BenchError
from .session_support import ErrorLog, rows_of
from .stability_study import StabilityStudy

SOURCE_PROXY = "VolumeStability"


def run_stability(
    study: StabilityStudy, report: Callable[[float], None]
) -> list[dict[str, Any]]:
    """Execute the source; return the rows of its table, or raise what it complains of.

    `report` is told the share done.
    """
    maker = getattr(servermanager.sources, SOURCE_PROXY, None)
    if maker is None:
        raise BenchError(f"the plugin has no source {SOURCE_PROXY}")
    source = maker()
    source.Techniques = list(study.techniques)
    source.Integrators = list(study.integrators)
    source.Cases = list(study.cases)
    source.Quick = int(study.short)
    inner = source.GetClientSideObject()
    inner.AddObserver("ProgressEvent", lambda *_: report(inner.GetProgress()))
    try:
        with ErrorLog() as log:
            source.UpdatePipeline()
        rows = rows_of(inner.GetOutputDataObject(0))
    finally:
        del source
    if not rows:
        raise BenchError(log.text() or f"{SOURCE_PROXY} returned no rows")
    return rows
