"""The steps of "Add a technique" as CONTRIBUTING.md gives them: a file name, then its text."""

import re
from dataclasses import dataclass
from pathlib import Path

HEADING = "## Add a technique\n"
_STEP = re.compile(r"^`(?P<file>[^`\s]+)`\n\n?```\w*\n(?P<text>.*?)^```$", re.M | re.S)
_ROW = re.compile(
    r'volumebench_technique\((?P<id>\S+) CLASS \w+ LABEL "(?P<label>[^"]+)"\)'
)


@dataclass(frozen=True)
class Step:
    """One block of the recipe: all of a new file, or lines to add to an existing one."""

    file: str
    text: str


def read_steps(document: str) -> list[Step]:
    """Return the steps in the section of the recipe, none of its code blocks left out."""
    section = document.partition(HEADING)[2].partition("\n## ")[0]
    steps = [Step(match["file"], match["text"]) for match in _STEP.finditer(section)]
    assert steps, f'CONTRIBUTING.md has no code block under "{HEADING.strip()}"'
    fences = len(re.findall(r"^```", section, re.M))
    assert fences == 2 * len(steps), "a code block of the recipe lacks its file name"
    return steps


def follow(steps: list[Step], tree: Path) -> None:
    """Create the new files in the tree and add the lines to the existing ones."""
    for step in steps:
        path = tree / step.file
        before = path.read_text(encoding="utf-8") if path.is_file() else ""
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(before + step.text, encoding="utf-8")


def id_and_label(steps: list[Step]) -> tuple[str, str]:
    """Return what the recipe calls its technique, in studies and in ParaView."""
    rows = [match for step in steps for match in _ROW.finditer(step.text)]
    assert len(rows) == 1, f"the recipe adds {len(rows)} rows, not one"
    return rows[0]["id"], rows[0]["label"]
