"""Measured profiles of the techniques, in Markdown, from results of Data/Measurements."""

import json
import math
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MEASURED = ROOT / "Data" / "Measurements"
# Each with what it is for; their times do not compare with each other's.
FILES = {
    "demo-llvmpipe.json": "All techniques in a ParaView view (`./run demo`)",
    "opengl-llvmpipe.json": "The OpenGL techniques by themselves (`./run bench opengl --quick`)",
}
BASE = "single-pass"
PATHS = {"engine": "by itself", "view": "in a view, still"}
INTRODUCTION = """# Measured profiles

Frame times are relative to Single Pass of the same run, scene, size, integrator and step: 2 takes twice as
long. Times and errors are geometric means over all scenes that both were measured on, samples those a
frame takes, relative too. What a run has measured stands in `Data/Measurements`; a technique that is
missing has no results there.
"""


def markdown() -> str:
    """Return the page."""
    parts = [INTRODUCTION]
    for name, title in FILES.items():
        results = json.loads((MEASURED / name).read_text(encoding="utf-8"))
        machine = results["context"]
        parts.append(
            f"## {title}\n\n`{name}`: {machine['cores']} cores, {machine['cpu']}; "
            f"{machine['gl_renderer']}; {machine['date'][:10]}.\n"
        )
        parts.append(_table(results["runs"]))
    return "\n".join(parts)


def _scene(run: dict) -> tuple:
    keys = ("dataset", "transfer_function", "integrator", "step_voxels", "blend_mode")
    return (*(run[key] for key in keys), tuple(run["image_size"]), run["path"])


def _table(runs: list[dict]) -> str:
    done = [one for one in runs if one["status"] == "ok" and not one.get("settings")]
    base = {_scene(one): one for one in done if one["technique"] == BASE}
    ratios: dict[tuple[str, str], list[list[float]]] = defaultdict(lambda: [[], [], []])
    for one in done:
        first = base.get(_scene(one))
        if first and one["path"] in PATHS:
            kept = ratios[one["technique"], one["path"]]
            kept[0].append(
                _ratio(one["frame_ms"]["median"], first["frame_ms"]["median"])
            )
            kept[1].append(_ratio(one["samples_taken"], first["samples_taken"]))
            kept[2].append(one["error"]["rmse"] or math.nan)
    lines = [
        "| Technique | Path | Scenes | Frame time | Samples | RMSE |",
        "|---|---|---|---|---|---|",
    ]
    for (technique, path), (times, samples, errors) in sorted(ratios.items()):
        cells = [_mean(times, ".2f"), _mean(samples, ".2f"), _mean(errors, ".1e")]
        lines.append(
            f"| {technique} | {PATHS[path]} | {len(times)} | {' | '.join(cells)} |"
        )
    return "\n".join(lines) + "\n"


def _ratio(value: float | None, base: float | None) -> float:
    return value / base if value and base else math.nan


def _mean(values: list[float], form: str) -> str:
    """Return the geometric mean of what was measured; a dash if nothing was."""
    known = [one for one in values if one > 0]
    if not known:
        return "-"
    return format(math.exp(sum(map(math.log, known)) / len(known)), form)
