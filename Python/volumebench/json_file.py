"""Strict reading and atomic writing of files: every fault is one line with file and place."""

import json
import math
import os
import tempfile
from pathlib import Path
from typing import Any

import jsonschema

from .errors import BenchError, OutputError, StudyError

_SCHEMA_FOLDER = Path(__file__).resolve().parent


def read_json(path: Path) -> Any:
    """Read strict JSON: no duplicate keys, no NaN; a fault names line and column."""
    text = _read_text(path)

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        keys = [key for key, _ in pairs]
        for key in keys:
            if keys.count(key) > 1:
                raise StudyError(
                    f'{path}: key "{key[:40]}" appears twice in one object'
                )
        return dict(pairs)

    def number(token: str) -> float:
        value = float(token)
        if not math.isfinite(value):
            raise StudyError(f"{path}: {token[:40]} is not a finite number")
        return value

    try:
        return json.loads(
            text, object_pairs_hook=unique, parse_float=number, parse_constant=number
        )
    except json.JSONDecodeError as fault:
        place = f"line {fault.lineno}, column {fault.colno}"
        raise StudyError(f"{path}: {place}: not valid JSON: {fault.msg}") from None
    except ValueError as fault:  # a whole number of thousands of digits
        raise StudyError(f"{path}: not valid JSON: {fault}") from None
    except RecursionError:
        raise StudyError(f"{path}: nested too deeply to be read") from None


def _read_text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except OSError as fault:
        raise StudyError(f"{path}: cannot be read: {fault.strerror}") from None
    except UnicodeDecodeError as fault:
        raise StudyError(f"{path}: not UTF-8 text (byte {fault.start})") from None


def check_schema(document: Any, schema_name: str, path: Path) -> None:
    """Validate against a schema file of this package; report the first fault by its key."""
    schema = json.loads((_SCHEMA_FOLDER / schema_name).read_text(encoding="utf-8"))
    validator = jsonschema.Draft7Validator(schema)
    faults = sorted(validator.iter_errors(document), key=_fault_order)
    if faults:
        raise StudyError(f"{path}: {_describe(faults[0])}")


def _fault_order(fault: jsonschema.ValidationError) -> tuple[bool, int, str]:
    """Put a wrong schema number first: it explains all other faults."""
    key = _key_of(fault)
    return (key != "schema", len(fault.absolute_path), key)


def _key_of(fault: jsonschema.ValidationError) -> str:
    key = ""
    for part in fault.absolute_path:
        key += f"[{part}]" if isinstance(part, int) else f".{part}"
    return key.lstrip(".")


def _describe(fault: jsonschema.ValidationError) -> str:
    key = _key_of(fault)
    place = f'"{key}": ' if key else ""
    expected = fault.schema.get("description")
    hint = f" (expected: {expected})" if expected else ""
    message = fault.message
    if len(message) > 200:
        message = message[:120] + " ... " + message[-70:]
    return place + message + hint


def write_atomically(path: Path, content: bytes | str) -> None:
    """Write through a temporary file that is renamed, so that no reader meets half a file."""
    data = content.encode("utf-8") if isinstance(content, str) else content
    temporary = None
    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        temporary = Path(name)
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fsync(stream.fileno())
        temporary.chmod(0o644)
        temporary.replace(path)
        _sync_folder(path.parent)
    except OSError as fault:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
        raise OutputError(f"{path}: cannot be written: {fault.strerror}") from None


def _sync_folder(folder: Path) -> None:
    """Have the disk know the new name before anything relies on it."""
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def make_writable_folder(folder: Path) -> None:
    """Create the folder and prove that a file can be written there, before hours are spent."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder) as probe:
            probe.write(b"x")
    except OSError as fault:
        raise BenchError(
            f"{folder}: output folder is not writable: {fault.strerror}"
        ) from None
