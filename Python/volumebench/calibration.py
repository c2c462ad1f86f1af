"""The ceilings of a machine, measured by volumebench-run --calibrate, beside the rows of a study."""

from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from .errors import BenchError
from .json_file import check_schema, read_json
from .results import Context, Record
from .summary import million_samples_per_second, number, sampling_text
from .tables import Table
from .techniques import TECHNIQUES

_SAME_MACHINE = ("host", "cpu", "gl_renderer")
_SMALL_TYPES = ("int8", "uint8", "int16", "uint16")  # stored as 16-bit texels
_CEILING_PATHS = {
    **dict.fromkeys(
        ("single-pass", "multi-pass", "slices", "slices-threaded"), "gl-fragment"
    ),
    **dict.fromkeys(("paraview-volume", "vtk-gpu"), "gl-fragment"),
    "compute": "gl-compute",
}


def load_calibration(path: Path) -> dict[str, Any]:
    """Return what results.json keeps of a calibration: its machine and the ceilings.

    A ceiling is the highest median of trilinear fetches a second, over sizes and directions.
    """
    document = read_json(path)
    check_schema(document, "calibration_schema.json", path)
    ceilings: dict[str, dict[str, float]] = {}
    for row in document["fetches"]:
        if row["kind"] == "trilinear":
            formats = ceilings.setdefault(row["path"], {})
            rate = row["per_second"]["median"]
            formats[row["format"]] = max(rate, formats.get(row["format"], 0))
    context = document["context"]
    return {
        "date": context["date"],
        **{name: context[name] for name in _SAME_MACHINE},
        "samples_per_second": ceilings,
    }


def with_calibration(context: Context, calibration: dict[str, Any]) -> Context:
    """Return the context with the calibration, which must be of the same machine."""
    name = _difference(context, calibration)
    if name is not None:
        here, there = asdict(context)[name], calibration[name]
        raise BenchError(
            f'--calibration: its "{name}" is {there}, that of the results {here}; '
            "the ceilings of another machine say nothing here"
        )
    return replace(context, calibration=calibration)


def keep_calibration(context: Context, earlier: Context) -> Context:
    """Return the context with the calibration of earlier rows, if that is of the same machine."""
    calibration = earlier.calibration
    if calibration is None or _difference(context, calibration) is not None:
        return context
    return replace(context, calibration=calibration)


def _difference(context: Context, calibration: dict[str, Any]) -> str | None:
    here = asdict(context)
    return next(
        (name for name in _SAME_MACHINE if here[name] != calibration[name]), None
    )


def ceiling_of(context: Context, record: Record) -> float | None:
    """Return the samples a second that the path of a row could fetch at most, if known."""
    if context.calibration is None or record.technique not in _CEILING_PATHS:
        return None
    formats = context.calibration["samples_per_second"]
    format_name = "R16" if record.scalar_type in _SMALL_TYPES else "R32F"
    return formats.get(_CEILING_PATHS[record.technique], {}).get(format_name)


def ceiling_table(context: Context, records: list[Record]) -> Table | None:
    """Return the samples a second of each row as a share of its ceiling."""
    rows = []
    for record in records:
        ceiling = ceiling_of(context, record)
        rate = million_samples_per_second(record)
        if ceiling is None or rate is None:
            continue
        rows.append(
            (
                record.run().scene.title(),
                record.path,
                TECHNIQUES[record.technique].title,
                sampling_text(record),
                number(rate, ".0f"),
                number(ceiling / 1e6, ".0f"),
                number(1e8 * rate / ceiling, ".1f", " %"),
            )
        )
    header = ("scene", "path", "technique", "sampling")
    header += ("Msamples/s", "ceiling", "share")
    title = "Samples a second against what the device can fetch (a sample is one trilinear fetch)"
    return Table(title, header, tuple(rows), 4) if rows else None
