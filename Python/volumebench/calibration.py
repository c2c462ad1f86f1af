"""The ceilings of a machine, measured by volumebench-run --calibrate, beside the rows of a study."""

from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from .errors import BenchError
from .json_file import check_schema, read_json
from .results import OK, Context, Record
from .summary import (
    million_samples_per_second,
    number,
    sampling_text,
    stage_split,
)
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
_NATIVE_PATHS = ("cpu", "cpu-pairs")
_ON_PROCESSOR = ("llvmpipe", "softpipe", "swrast")  # renderers of OpenGL


def load_calibration(path: Path) -> dict[str, Any]:
    """Return what results.json keeps of a calibration: its machine and the ceilings.

    A ceiling is the highest median of trilinear fetches a second, over sizes and directions.
    """
    document = read_json(path)
    check_schema(document, "calibration_schema.json", path)
    ceilings: dict[str, dict[str, float]] = {}
    look_ups: dict[str, float] = {}
    for row in document["fetches"]:
        rate = row["per_second"]["median"]
        if row["kind"] == "trilinear":
            formats = ceilings.setdefault(row["path"], {})
            formats[row["format"]] = max(rate, formats.get(row["format"], 0))
        elif row["kind"] == "table":
            look_ups[row["path"]] = max(rate, look_ups.get(row["path"], 0))
    context = document["context"]
    return {
        "date": context["date"],
        **{name: context[name] for name in _SAME_MACHINE},
        "opencl_device": context["opencl_device"],
        "opencl_device_type": document["opencl_device_type"],
        "samples_per_second": ceilings,
        "look_ups_per_second": look_ups,
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
    if context.calibration is None:
        return None
    return _rate_of(context.calibration, _path_of(context, record), record)


def _path_of(context: Context, record: Record) -> str | None:
    if record.technique == "opencl":
        return _opencl_path(context.calibration, record)
    return _CEILING_PATHS.get(record.technique)


def sample_ceiling_of(context: Context, record: Record) -> float | None:
    """Return the samples a second at most if each also looks its colour up in a table, if known.

    A trilinear fetch and a look-up cannot be done in less than both take where nothing else is done.
    """
    ceiling = ceiling_of(context, record)
    if ceiling is None:
        return None
    look_ups = context.calibration.get("look_ups_per_second", {})
    look_up = look_ups.get(_path_of(context, record))
    return look_up and 1 / (1 / ceiling + 1 / look_up)


def native_ceiling_of(context: Context, record: Record) -> float | None:
    """Return what the processor fetches at most by its own instructions, of rows that it draws."""
    calibration = context.calibration
    if calibration is None or ceiling_of(context, record) is None:
        return None
    if record.technique == "opencl":
        on_processor = calibration.get("opencl_device_type") == "cpu"
    else:
        on_processor = calibration["gl_renderer"].startswith(_ON_PROCESSOR)
    if not on_processor:
        return None
    rates = [_rate_of(calibration, path, record) for path in _NATIVE_PATHS]
    return max(filter(None, rates), default=None)


def _rate_of(
    calibration: dict[str, Any], path: str | None, record: Record
) -> float | None:
    format_name = "R16" if record.scalar_type in _SMALL_TYPES else "R32F"
    return calibration["samples_per_second"].get(path, {}).get(format_name)


def _opencl_path(calibration: dict[str, Any], record: Record) -> str | None:
    """Return how a row of technique opencl fetches; None on another device than the measured one."""
    device = record.settings.get("opencl_device", "Auto")
    if device not in ("Auto", calibration.get("opencl_device")):
        return None
    if "simd-rays" in (record.features or ()):
        return "opencl-lanes"
    # As technique opencl chooses.
    has_images = "opencl-images" in calibration["samples_per_second"]
    on_processor = calibration.get("opencl_device_type") == "cpu"
    suits = "Buffers" if on_processor or not has_images else "Images"
    storage = record.settings.get("opencl_storage", "Auto")
    return f"opencl-{(suits if storage == 'Auto' else storage).lower()}"


def ceiling_table(context: Context, records: list[Record]) -> Table | None:
    """Return the samples a second of each row as a share of its ceiling and of the processor's."""
    rows = []
    for record in records:
        ceiling = ceiling_of(context, record)
        sample = sample_ceiling_of(context, record)
        native = native_ceiling_of(context, record)
        rate = million_samples_per_second(record)
        if ceiling is None or rate is None:
            continue
        rows.append(
            (
                *_row_titles(record),
                number(rate, ".0f"),
                number(ceiling / 1e6, ".0f"),
                number(1e8 * rate / ceiling, ".1f", " %"),
                number(sample and sample / 1e6, ".0f"),
                number(sample and 1e8 * rate / sample, ".1f", " %"),
                number(native and native / 1e6, ".0f"),
                number(native and 1e8 * rate / native, ".1f", " %"),
            )
        )
    header = ("scene", "path", "technique", "sampling")
    header += ("Msamples/s", "ceiling of fetches", "share")
    header += ("ceiling with table", "share of it", "native ceiling", "share of that")
    title = "Samples a second against what the device can fetch (a sample: one trilinear fetch)"
    return Table(title, header, tuple(rows), 4) if rows else None


def _row_titles(record: Record) -> tuple[str, ...]:
    return (
        record.run().scene.title(),
        record.path,
        TECHNIQUES[record.technique].title,
        sampling_text(record),
    )


def profile_table(context: Context, records: list[Record]) -> Table | None:
    """Return what of each row's frame its fetches would take at the ceilings, and what is left."""
    rows = []
    for record in records:
        ceiling = ceiling_of(context, record)
        native = native_ceiling_of(context, record)
        frame_ms = record.frame_ms.median
        samples = record.samples_taken
        if record.status != OK or not (ceiling and frame_ms and samples):
            continue
        fetch_ms = 1000 * samples / ceiling
        rows.append(
            (
                *_row_titles(record),
                number(frame_ms, ".1f"),
                stage_split(record),
                number(1e6 * frame_ms / samples, ".2f"),
                number(fetch_ms, ".1f"),
                number(native and 1000 * samples / native, ".1f"),
                number(frame_ms - fetch_ms, ".1f"),
            )
        )
    header = ("scene", "path", "technique", "sampling", "ms", "stages")
    header += ("ns a sample", "fetches, ms", "native, ms", "all else, ms")
    title = "A frame against its fetches alone, at their ceiling and at the processor's"
    return Table(title, header, tuple(rows), 4) if rows else None
