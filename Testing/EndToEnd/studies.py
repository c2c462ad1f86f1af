"""Tiny versions of the studies speed and scaling, through the command line of the package."""

import json
import sys
from html import unescape
from pathlib import Path
from typing import Any

from support import ERRORS, run_checks, temporary_folder

REPOSITORY = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "Python"))

from volumebench.__main__ import main  # noqa: E402
from volumebench.results import read_results  # noqa: E402
from volumebench.start import read_start  # noqa: E402

SHORT = {
    "warm_up_frames": 1,
    "minimum_frames": 3,
    "relative_noise": 1,
    "time_limit_s": 0.3,
}
VIEWS = {"path": "three-views", "frames": 3, "zoom": 1.3}


def shell(name: str, edge: int, **more: Any) -> dict[str, Any]:
    facts = {"name": name, "generator": "shell", "dims": [edge] * 3, "share": 0.3}
    return facts | {"scalar_type": "uint8"} | more


def run_study(folder: Path, study: dict[str, Any]) -> str:
    """Measure a study into the folder and return its report."""
    file = folder / "study.json"
    shared = {"schema": 1, "camera": VIEWS, "timing": SHORT, "ray_set_up": "Rasterised"}
    file.write_text(json.dumps(shared | study), encoding="utf-8")
    assert main([str(file), "--out", str(folder / "out")]) == 0
    faults = [line for line in ERRORS.take() if " left  " not in line]  # the progress
    assert not faults, faults
    return unescape((folder / "out" / "report.html").read_text(encoding="utf-8"))


def check_speed() -> None:
    study = {
        "name": "tiny-speed",
        "report": "speed",
        "datasets": [shell("hollow", 24)],
        "transfer_functions": ["shell-wall"],
        "techniques": ["single-pass", "paraview-volume"],
        "sweeps": [
            {
                "techniques": ["single-pass"],
                "step_voxels": [0.125],
                "settings": {"jitter": [1], "termination_threshold": [0.5]},
            },
            {"techniques": ["single-pass"], "step_voxels": [2, 1, 0.5, 0.25, 0.125]},
            {"techniques": ["paraview-volume"]},
        ],
        "image_sizes": [[48, 36]],
        "paths": ["view"],
        "error": {"views": 3, "reference_step_voxels": 0.125},
        "start": {
            "datasets": [shell("first", 32, scalar_type="float32")],
            "transfer_function": "shell-haze",
            "techniques": ["single-pass", "paraview-volume"],
            "image_size": [48, 36],
            "repeats": 2,
            "edits": 2,
        },
    }
    with temporary_folder() as folder:
        report = run_study(folder, study)
        _, records = read_results(folder / "out" / "results.json")
        ours, theirs = read_start(folder / "out")
    lead = report.partition('<p class="lead">')[2].partition("</p>")[0]
    assert lead.startswith("At ParaView's own error, VolumeBench draws still"), lead
    assert 'alt="Frame-time ratio against' in report
    assert "Picture after an edit" in report
    assert [row.status for row in records] == ["ok"] * 7
    inaccurate, *rows = [row for row in records if row.technique == "single-pass"]
    expect_rows_of_view(rows)
    own = min(row.error.rmse for row in rows)
    print(f"  RMSE {own:.1e}, with settings of its own {inaccurate.error.rmse:.1e}")
    assert inaccurate.error.rmse > 10 * own, "settings reach their run and no other"
    assert "jitter" in inaccurate.features
    assert all("jitter" in row.left_out for row in rows)
    assert ours.technique == "single-pass" and theirs.status == ours.status == "ok"
    assert ours.first_ms.median > ours.still_ms.median > 0, ours
    assert ours.setup_ms.upload > 0 and ours.bytes_on_device >= 4 * 32**3
    assert theirs.bytes_on_device is None and theirs.volume_bytes == 4 * 32**3


def expect_rows_of_view(rows: list[Any]) -> None:
    """Samples double as the step halves, errors fall, and what our mapper tells is there."""
    ordered = sorted(rows, key=lambda row: -row.step_voxels)
    for coarse, fine in zip(ordered, ordered[1:]):
        assert 1.7 < fine.samples_taken / coarse.samples_taken < 2.3, fine
        assert fine.error.rmse < coarse.error.rmse, fine
    assert all(row.left_out and row.bytes_on_device for row in rows)


def check_path_remote() -> None:
    """What a server draws is what one process draws, by its errors, samples and notes."""
    study = {
        "name": "tiny-remote",
        "datasets": [shell("hollow", 24)],
        "transfer_functions": ["shell-wall"],
        "techniques": ["single-pass", "slices", "paraview-volume"],
        "step_voxels": [1, 0.5],
        "image_sizes": [[48, 36]],
        "paths": ["view", "remote"],
        "error": {"views": 2, "reference_step_voxels": 0.125},
    }
    with temporary_folder() as folder:
        report = run_study(folder, study)
        _, records = read_results(folder / "out" / "results.json")
    assert "remote: client and server" in report
    by_path = {
        path: [row for row in records if row.path == path] for path in study["paths"]
    }
    assert [len(rows) for rows in by_path.values()] == [5, 5]
    for here, there in zip(*by_path.values()):
        name = f"{here.technique}, step {here.step_voxels}"
        assert (there.technique, there.step_voxels) == (
            here.technique,
            here.step_voxels,
        )
        assert here.status == there.status == "ok", f"{name}: {there.reason}"
        print(f"  {name}: RMSE {here.error.rmse:.3e} and {there.error.rmse:.3e}")
        assert abs(there.error.rmse - here.error.rmse) <= 1e-6, name
        assert there.samples_taken == here.samples_taken > 0, name
        assert there.left_out == here.left_out, name
        assert there.frame_ms.median > 0 and there.frames >= 3, name


def check_tutorial() -> None:
    """The study of Documentation/first-study.md, and what the page says of its errors."""
    with temporary_folder() as folder:
        assert main(["tutorial", "--out", str(folder)]) == 0
        ERRORS.take()
        _, records = read_results(folder / "results.json")
    assert len(records) == 36 and all(row.status == "ok" for row in records)
    for row in records:
        assert row.frames >= 12 and len(row.frame_log.ms) == row.frames, row
    curve = [
        row.error.rmse
        for row in records
        if (row.dataset, row.transfer_function, row.technique)
        == ("waves", "bucky-translucent", "single-pass")
    ]
    print(f"  RMSE at steps 2, 1 and 0.5: {curve}")
    assert 3 < curve[0] / curve[1] < 5 and 3 < curve[1] / curve[2] < 5, curve


def check_scaling() -> None:
    edges = (16, 24, 36, 54)
    names = [f"edge-{edge}" for edge in edges]
    study = {
        "name": "tiny-scaling",
        "report": "scaling",
        "datasets": [
            *(shell(name, edge, share=1) for name, edge in zip(names, edges)),
            shell("huge", 64, memory_gb=1e6),
            shell("sizes", 24, image_sizes=[[32, 32], [64, 64], [128, 128]]),
        ],
        "transfer_functions": ["shell-wall"],
        "techniques": ["single-pass"],
        "step_voxels": [1],
        "image_sizes": [[64, 64]],
        "paths": ["engine"],
        "error": {"views": 0},
        "series": [
            {"title": "Edges", "factor": "edge", "datasets": [*names, "huge"]},
            {"title": "Sizes", "factor": "pixels", "datasets": ["sizes"]},
        ],
    }
    with temporary_folder() as folder:
        report = run_study(folder, study)
        _, records = read_results(folder / "out" / "results.json")
    assert len(records) == 7 and all(row.status == "ok" for row in records)
    assert "huge is left out: it takes 1e+06 GB" in report
    assert 'alt="Edges"' in report and 'alt="Sizes"' in report
    expected = {("Edges", "samples"): 1, ("Sizes", "samples"): 1}
    expected[("Sizes", "bytes on the device")] = 0
    for (series, quantity), exponent in expected.items():
        found = exponent_in(report, series, quantity)
        print(f"  {series}, {quantity}: {found:g}")
        assert abs(found - exponent) < 0.1, (series, quantity)


def exponent_in(report: str, series: str, quantity: str) -> float:
    """Return an exponent from the first table of the report."""
    row = report.partition(f"<td>{series}</td><td>Single Pass</td><td>{quantity}</td>")
    assert row[1], f"no row of {series}, {quantity}"
    cells = row[2].partition("</tr>")[0]
    return float(cells.rpartition('<td class="n">')[2].split()[0])


if __name__ == "__main__":
    run_checks(dict(globals()))
