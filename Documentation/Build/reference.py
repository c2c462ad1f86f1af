"""The reference of all proxies and properties, in Markdown, from the plugin's server-manager XML."""

import re
import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

HERE = Path(__file__).resolve().parent
KINDS = {
    "representations": "Representation",
    "filters": "Filter",
    "sources": "Source",
    "views": "View",
    "misc": "For scripts",
}
TYPES = {
    "DoubleVectorProperty": "number",
    "IntVectorProperty": "whole number",
    "StringVectorProperty": "text",
    "InputProperty": "input",
    "ProxyProperty": "proxy",
    "Property": "command",
}
INTRODUCTION = """# Reference of properties

Made from the plugin's own descriptions, which ParaView shows as tooltips and under *Help*. *Row* is
the caption in the Properties panel; *advanced* rows need the gear beside the search field; a property
for scripts has no row. Python sets a property by its name: `display.StepVoxels = 0.5`.
"""


@dataclass(frozen=True)
class Property:
    name: str
    label: str
    kind: str
    default: str
    values: str
    panel: str
    shown_for: tuple[str, ...]
    text: str


@dataclass(frozen=True)
class Proxy:
    group: str
    name: str
    label: str
    text: str
    properties: tuple[Property, ...]


def plugin_xml() -> list[str]:
    """Return the texts of the plugin's XML files."""
    with tempfile.TemporaryDirectory(prefix="volumebench-xml-") as folder:
        listed = subprocess.run(
            ["cmake", "-P", str(HERE / "list_xml.cmake")],
            cwd=folder,
            check=True,
            capture_output=True,
            text=True,
        )
        return [Path(line).read_text() for line in listed.stdout.splitlines()]


def proxies(texts: list[str]) -> list[Proxy]:
    """Return all proxies that the XML defines."""
    found = []
    for text in texts:
        for group in ElementTree.fromstring(text).findall("ProxyGroup"):
            found += [
                _proxy(group.attrib["name"], element)
                for element in group
                if element.tag.endswith("Proxy") and "name" in element.attrib
            ]
    return found


def _proxy(group: str, element: Element) -> Proxy:
    name = element.attrib["name"]
    members = tuple(
        _property(one)
        for one in element
        if one.tag.endswith("Property") and "name" in one.attrib
    )
    return Proxy(
        group, name, element.get("label", spaced(name)), _words(element), members
    )


def _property(element: Element) -> Property:
    name = element.attrib["name"]
    return Property(
        name=name,
        label=element.get("label", spaced(name)),
        kind=TYPES.get(element.tag, element.tag),
        default=element.get("default_values", ""),
        values=_values(element),
        panel=_panel(element),
        shown_for=_shown_for(element),
        text=_words(element),
    )


def _words(element: Element) -> str:
    """Return an element's documentation, without the line breaks of the file."""
    found = element.find("Documentation")
    text = "" if found is None else found.text or found.get("long_help", "")
    return " ".join(text.split())


def spaced(name: str) -> str:
    """Return a caption as ParaView makes it of a name: StepVoxels is Step Voxels."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)


def _values(element: Element) -> str:
    """Return what a property can be set to."""
    names = [one.attrib["text"] for one in element.iter("Entry")]
    names += [
        one.attrib["value"]
        for domain in element.findall("StringListDomain")
        for one in domain.findall("String")
    ]
    if names:
        return ", ".join(names)
    if element.find("BooleanDomain") is not None:
        return "0 or 1"
    for tag in ("DoubleRangeDomain", "IntRangeDomain"):
        domain = element.find(tag)
        if domain is not None:
            low, high = domain.get("min"), domain.get("max")
            bounds = [f"from {low}" if low else "", f"to {high}" if high else ""]
            return " ".join(one for one in bounds if one)
    return ""


def _panel(element: Element) -> str:
    """Return where the panel has the property."""
    shown = element.get("panel_visibility", "default")
    if element.get("information_only") == "1":
        return "read-only" + (", advanced" if shown == "advanced" else "")
    return {"default": "", "advanced": "advanced", "never": "for scripts"}[shown]


def _shown_for(element: Element) -> tuple[str, ...]:
    """Return the representations that alone have the row; none if all have it."""
    return tuple(
        one.attrib["value"]
        for one in element.iter("PropertyWidgetDecorator")
        if one.get("property") == "Representation"
    )


def markdown(all_proxies: list[Proxy]) -> str:
    """Return the reference as one page."""
    parts = [INTRODUCTION]
    for proxy in all_proxies:
        kind = KINDS.get(proxy.group, proxy.group)
        parts.append(f"## {proxy.label}\n\n*{kind}, proxy* `{proxy.name}`\n")
        parts.append(proxy.text + "\n")
        parts += [_entry(one) for one in proxy.properties]
    return "\n".join(parts)


def _entry(one: Property) -> str:
    facts = [f"Row *{one.label}*" if one.panel != "for scripts" else ""]
    facts += [one.panel, one.kind]
    facts.append(f"default `{one.default}`" if one.default else "")
    facts.append(f"values: {one.values}" if one.values else "")
    if one.shown_for:
        facts.append("shown for " + ", ".join(one.shown_for))
    return (
        f"### `{one.name}`\n\n" + "; ".join(f for f in facts if f) + f"\n\n{one.text}\n"
    )
