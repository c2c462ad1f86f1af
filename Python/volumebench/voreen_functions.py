"""Voreen's transfer functions (.tfi): read to and written from our own.

A key has an intensity from 0 to 1 over the function's domain, and a colour with alpha, each from 0 to
255; a split key has another colour from there on. Values below the first and above the last key have
the colour of that key, values outside of the threshold are transparent. Alpha holds over a 200th of
the box.
"""

import math
import xml.etree.ElementTree as xml
from dataclasses import dataclass
from pathlib import Path

from .control_points import JUMP_WIDTH, Point, ascending, rescaled, value_at
from .errors import StudyError
from .json_file import write_atomically
from .transfer_functions import NORMALIZED, TransferFunction

UNIT_DISTANCE_EDGES = 1 / 200
MAXIMUM_BYTES = 1 << 24
_ALPHA_OF_MODE = {"0": 0.0, "1": None, "2": 1.0}  # None: that of the keys
_BOOLEANS = {"true": True, "1": True, "false": False, "0": False}


@dataclass(frozen=True)
class Key:
    """Red, green, blue and alpha from 0 to 1, below and from an intensity on."""

    intensity: float
    below: Point
    above: Point


def read_tfi(path: Path, full_scale: float | None = None) -> TransferFunction:
    """Read one file.

    Without `full_scale`, its domain is stretched over the scalar range of whatever is shown. Else it
    is a share of that value, which stands for 1: 255 for volumes of 8 bits, 65535 for those of 16.
    """
    element = _function_element(path)
    alpha = _alpha_mode(element, path)
    low, high = _pair(element, "domain", path)
    if _number(element, "gammaValue", 1.0, path) != 1:
        raise StudyError(f"{path}: gammaValue is not 1; only that can be read")
    keys = sorted(_keys(element, path), key=lambda key: key.intensity)
    color = ascending([(key.intensity, key.below[:3], key.above[:3]) for key in keys])
    opacity = ascending([(key.intensity, key.below[3:], key.above[3:]) for key in keys])
    if alpha is not None:
        opacity = ((0.0, alpha), (1.0, alpha))
    opacity = _within(opacity, *_pair(element, "threshold", path, 0, 1))
    function = TransferFunction(
        path.stem, "", NORMALIZED, opacity, color, None, UNIT_DISTANCE_EDGES
    )
    if full_scale is None:
        return function
    return function.in_values(low * full_scale, high * full_scale)


def write_tfi(
    function: TransferFunction, path: Path, full_scale: float | None = None
) -> None:
    """Write one file; colours and alpha are rounded to 255ths.

    A function over scalar values needs the value that stands for 1 (`full_scale`).
    """
    low, high = 0.0, 1.0
    opacity, color = function.opacity, function.color
    if function.domain != NORMALIZED:
        if full_scale is None:
            raise StudyError(
                f"{path}: {function.name} is over scalar values, and nothing says which of them "
                "stands for 1"
            )
        if not 0 < full_scale < math.inf:
            raise StudyError(f"{path}: the full scale {full_scale:g} is not above 0")
        places = [point[0] for point in (*opacity, *color)]
        low, high = min(places), max(places)
        opacity, color = rescaled(opacity, low, high), rescaled(color, low, high)
        low, high = low / full_scale, high / full_scale
    root = xml.Element("VoreenData", version="1")
    kind = "TransFuncIntensity"
    element = xml.SubElement(root, kind, type=kind)
    xml.SubElement(element, "alphaMode", value="1")
    xml.SubElement(element, "gammaValue", value="1")
    xml.SubElement(element, "domain", x=repr(low), y=repr(high))
    xml.SubElement(element, "threshold", x="0", y="1")
    keys = xml.SubElement(element, "Keys")
    for key in _joined_keys(opacity, color):
        _add_key(keys, key)
    xml.indent(root, "    ")
    text = xml.tostring(root, encoding="unicode")
    write_atomically(path, f'<?xml version="1.0" ?>\n{text}\n')


def _function_element(path: Path) -> xml.Element:
    try:
        with path.open("rb") as stream:
            content = stream.read(MAXIMUM_BYTES + 1)
    except OSError as fault:
        raise StudyError(f"{path}: cannot be read: {fault.strerror}") from None
    if len(content) > MAXIMUM_BYTES:
        raise StudyError(f"{path}: has more than {MAXIMUM_BYTES} bytes")
    if b"<!DOCTYPE" in content or b"<!ENTITY" in content:
        raise StudyError(f"{path}: declares entities, which no transfer function does")
    try:
        root = xml.fromstring(content)
    except (xml.ParseError, ValueError, LookupError) as fault:
        raise StudyError(f"{path}: not valid XML: {fault}") from None
    for element in root.iter():
        if element.find("Keys") is not None:
            return element
    raise StudyError(f"{path}: holds no Keys: no transfer function of one dimension")


def _alpha_mode(element: xml.Element, path: Path) -> float | None:
    """Return the alpha of all keys, or None where each has its own."""
    mode = element.find("alphaMode")
    if mode is not None:
        text = mode.get("value", "")
        if text not in _ALPHA_OF_MODE:
            raise StudyError(f'{path}: alphaMode "{text[:40]}" is not 0, 1 or 2')
        return _ALPHA_OF_MODE[text]
    ignored = element.find("ignoreAlpha")
    return 1.0 if ignored is not None and _boolean(ignored, path) else None


def _keys(element: xml.Element, path: Path) -> list[Key]:
    keys = [
        _key(item, f"key {index}", path)
        for index, item in enumerate(element.find("Keys").findall("key"), 1)
    ]
    if not keys:
        raise StudyError(f"{path}: Keys has no key")
    return keys


def _key(item: xml.Element, where: str, path: Path) -> Key:
    intensity = item.find("intensity")
    if intensity is None:
        raise StudyError(f"{path}: {where}: intensity is missing")
    place = _attribute(intensity, "value", f"{where}: intensity", path)
    if not 0 <= place <= 1:
        raise StudyError(f"{path}: {where}: intensity {place:g} is not from 0 to 1")
    below = _color(item, "colorL", where, path)
    split = item.find("split")
    if split is not None and _boolean(split, path):
        return Key(place, below, _color(item, "colorR", where, path))
    return Key(place, below, below)


def _color(item: xml.Element, name: str, where: str, path: Path) -> Point:
    element = item.find(name)
    if element is None:
        raise StudyError(f"{path}: {where}: {name} is missing")
    values = [
        _attribute(element, channel, f"{where}: {name}", path) for channel in "rgba"
    ]
    for value in values:
        if not 0 <= value <= 255:
            raise StudyError(f"{path}: {where}: {name}: {value:g} is not from 0 to 255")
    return tuple(value / 255 for value in values)


def _boolean(element: xml.Element, path: Path) -> bool:
    text = element.get("value", "")
    if text.lower() not in _BOOLEANS:
        raise StudyError(
            f'{path}: {element.tag} "{text[:40]}" is neither true nor false'
        )
    return _BOOLEANS[text.lower()]


def _attribute(element: xml.Element, name: str, where: str, path: Path) -> float:
    text = element.get(name)
    try:
        value = float(text)
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        told = f'"{text[:40]}" is no number' if text is not None else "is missing"
        raise StudyError(f"{path}: {where}: {name} {told}")
    return value


def _number(element: xml.Element, name: str, default: float, path: Path) -> float:
    found = element.find(name)
    return default if found is None else _attribute(found, "value", name, path)


def _pair(
    element: xml.Element,
    name: str,
    path: Path,
    least: float = -math.inf,
    most: float = math.inf,
) -> tuple[float, float]:
    """Return two ascending numbers, from 0 to 1 unless they are given."""
    found = element.find(name)
    if found is None:
        return 0.0, 1.0
    low, high = (_attribute(found, axis, name, path) for axis in "xy")
    if not (low < high and math.isfinite(high - low)):
        raise StudyError(f"{path}: {name} from {low:g} to {high:g} does not ascend")
    if low < least or high > most:
        raise StudyError(f"{path}: {name} from {low:g} to {high:g} leaves 0 to 1")
    return low, high


def _within(opacity: tuple[Point, ...], low: float, high: float) -> tuple[Point, ...]:
    """Return the opacity with nothing below `low` and above `high`."""
    nothing = (0.0,)
    steps = [(x, (alpha,), (alpha,)) for x, alpha in opacity if low < x < high]
    begin, end = value_at(opacity, low), value_at(opacity, high)
    before = [(0.0, nothing, nothing), (low, nothing, begin)] if low > 0 else []
    after = [(high, end, nothing), (1.0, nothing, nothing)] if high < 1 else []
    if not before:
        before = [(x, (alpha,), (alpha,)) for x, alpha in opacity if x == low]
    if not after:
        after = [(x, (alpha,), (alpha,)) for x, alpha in opacity if x == high]
    return ascending([*before, *steps, *after])


def _joined_keys(opacity: tuple[Point, ...], color: tuple[Point, ...]) -> list[Key]:
    """Return a key at each point of either; two as close as a jump are one split key."""
    keys: list[Key] = []
    for x in sorted({point[0] for point in (*opacity, *color)}):
        values = (*value_at(color, x), *value_at(opacity, x))
        if keys and x - keys[-1].intensity < 1.5 * JUMP_WIDTH:
            keys[-1] = Key(x, keys[-1].below, values)
        else:
            keys.append(Key(x, values, values))
    return keys


def _add_key(keys: xml.Element, key: Key) -> None:
    element = xml.SubElement(keys, "key", type="TransFuncMappingKey")
    split = key.below != key.above
    xml.SubElement(element, "intensity", value=repr(key.intensity))
    xml.SubElement(element, "split", value=str(split).lower())
    colors = (("colorL", key.below), ("colorR", key.above))
    for name, values in colors[: 1 + split]:
        bytes_of = {c: str(round(v * 255)) for c, v in zip("rgba", values)}
        xml.SubElement(element, name, bytes_of)
