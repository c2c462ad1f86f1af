"""volumebench-run measures a study without a display as pvpython measures it with one."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from patience import patient_s

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Python"))

from volumebench.datasets import with_stand_ins  # noqa: E402
from volumebench.results import read_results  # noqa: E402
from volumebench.stability_study import is_stability_study  # noqa: E402
from volumebench.study_file import STUDY_FOLDER, load_study  # noqa: E402
from volumebench.technique_settings import (  # noqa: E402
    TECHNIQUE_SETTINGS,
    settings_of_technique,
)

PROGRAM = os.environ["VOLUMEBENCH_RUN"]
PVPYTHON = os.environ["VOLUMEBENCH_PVPYTHON"]
MOST_DIFFERENCE = 1e-6  # of errors, between the two programs

# Nothing is left at its default, so that the errors tell if the program heeds it.
STUDY = {
    "schema": 1,
    "name": "small",
    "datasets": [
        {"name": "lemniscate", "dims": [20, 20, 40]},
        {"name": "bucky", "otherwise": "ball"},
        {"name": "own"},
        {
            "name": "thin",
            "generator": "shell",
            "dims": [12, 14, 16],
            "share": 0.2,
            "image_sizes": [[40, 36]],
        },
    ],
    "transfer_functions": {
        "lemniscate": ["lemniscate-shells"],
        "bucky": ["bucky-opaque"],
        "own": ["ramp"],
        "thin": ["edges"],
    },
    "techniques": [
        *("single-pass", "compute", "opencl", "vtk-gpu", "cuda", "paraview-volume")
    ],
    "technique_settings": {"single-pass": {"table_size": [0, 64]}},
    "technique_settings_scenes": [{"dataset": "own"}],
    "step_voxels": [1, 0.5],
    "image_sizes": [[48, 40]],
    "paths": ["engine", "view"],
    "camera": {"frames": 8, "elevation_degrees": 35, "zoom": 1.3},
    "timing": {
        "warm_up_frames": 1,
        "minimum_frames": 2,
        "relative_noise": 1,
        "time_limit_s": 5,
    },
    "error": {
        "views": 2,
        "image_size": [40, 30],
        "reference": "Fine Steps",
        "reference_step_voxels": 0.0625,
    },
    "blend_modes": ["Composite", "Maximum"],
    "termination_threshold": 0.2,
    "ray_set_up": "Rasterised",
    "lighting": True,
    "lighting_damping": 0.02,
}
RAMP = {
    "schema": 1,
    "name": "ramp",
    "domain": "normalized",
    "opacity": [[0, 0], [0.5, 0.25], [1, 1]],
    "color": [[0, 0, 0, 1], [1, 1, 0, 0]],
    "unit_distance_voxels": 2,
}


def program(*arguments: object) -> subprocess.CompletedProcess:
    """Run the program as on a machine without an X server."""
    environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    return execute([PROGRAM, *arguments], environment)


def bench(python: str, *arguments: object) -> subprocess.CompletedProcess:
    """Run the Python package, under pvpython or without ParaView."""
    return execute([python, ROOT / "Python" / "bench.py", *arguments], dict(os.environ))


def execute(command: list, environment: dict) -> subprocess.CompletedProcess:
    texts = [str(part) for part in command]
    return subprocess.run(
        texts, env=environment, capture_output=True, text=True, timeout=patient_s(250)
    )


def write_inputs(folder: Path) -> Path:
    """Write a study, its transfer function and a volume with uneven voxels; return the study."""
    (folder / "ramp.json").write_text(json.dumps(RAMP))
    edges = {key: RAMP[key] for key in RAMP if key != "unit_distance_voxels"}
    edges |= {"name": "edges", "unit_distance_edges": 0.25}
    (folder / "edges.json").write_text(json.dumps(edges))
    data = folder / "data"
    data.mkdir()
    dims, voxels = [9, 10, 11], bytearray()
    for i in range(9 * 10 * 11):
        voxels += (i * 7919 % 4001).to_bytes(2, "little")
    (data / "own.raw").write_bytes(voxels)
    layout = {"dims": dims, "scalar_type": "int16", "spacing": [1, 1.5, 2]}
    (data / "own.json").write_text(json.dumps(layout))
    path = folder / "study.json"
    path.write_text(json.dumps(STUDY))
    return path


def check_same_rows(folder: Path, study: Path) -> None:
    """Measure with both and compare; then let the Python package finish the program's results."""
    ours, theirs = folder / "ours", folder / "theirs"
    inputs = ("--data", folder / "data")
    done = program(study, "--out", ours, *inputs)
    assert done.returncode == 0, done.stderr
    # VTK's warnings would tell that the window is not what VTK expects.
    assert "WARN" not in done.stderr and "ERR" not in done.stderr, done.stderr
    there = bench(PVPYTHON, study, "--out", theirs, *inputs)
    assert there.returncode == 0, there.stderr
    read = [read_results(place / "results.json") for place in (ours, theirs)]
    (context, rows), (there_context, expected) = read
    assert context.gl_renderer in done.stdout and context.paraview is None
    assert context.opencl_device == there_context.opencl_device, context
    assert ": " in context.opencl_device, context
    keys = [[row.run().key() for row in records] for records in (rows, expected)]
    assert keys[0] == keys[1], "other rows, or in another order"
    compared = [
        compare(*pair) for pair in zip(rows, expected) if pair[0].path == "engine"
    ]
    assert sum(compared) == 2 * (4 * (2 + 2 + 2 + 1) + 2), compared
    views = {row.status for row in rows if row.path == "view"}
    assert views == {"unsupported"}, views
    check_report(study, ours, inputs)


def compare(row, expected) -> int:
    """Check one row of path engine against that of pvpython; return 1 if it was measured."""
    assert row.status == expected.status, (row, expected)
    if row.status != "ok":
        assert "cuda" in row.reason, row.reason
        return 0
    for name in ("dims", "scalar_type", "features", "left_out", "samples_taken"):
        assert getattr(row, name) == getattr(expected, name), (name, row, expected)
    assert row.stand_in_for == expected.stand_in_for
    assert row.frames >= 2 and row.frame_ms.median > 0 and row.setup_ms.upload != 0, row
    ours, theirs = vars(row.error), vars(expected.error)
    for name, value in theirs.items():
        if isinstance(value, float):
            allowed = MOST_DIFFERENCE * max(1, value if name == "psnr" else 1)
            assert abs(ours[name] - value) <= allowed, (name, row, expected)
        else:
            assert ours[name] == value, (name, row, expected)
    assert row.error.rmse > 0
    return 1


def check_report(study: Path, folder: Path, inputs: tuple) -> None:
    """Let the Python package make the report, without ParaView."""
    done = bench(sys.executable, study, "--out", folder, "--resume", *inputs)
    assert done.returncode == 0, done.stderr
    assert (folder / "report.html").stat().st_size > 10_000


def listed(study: Path, *options: str) -> list[dict]:
    done = program(study, "--list", *options)
    assert done.returncode == 0, (study, done.stderr)
    return [json.loads(line) for line in done.stdout.splitlines()]


def check_shipped_studies() -> None:
    """Check that all shipped studies have the runs that Python gives them."""
    count = 0
    for path in sorted(STUDY_FOLDER.glob("*.json")):
        if is_stability_study(path):
            continue
        study = load_study(path)
        for options, cut in (((), study), (("--quick",), study.quick())):
            expected = [as_row(run) for run in with_stand_ins(cut, None).runs()]
            assert listed(path, *options) == expected, (path, options)
            count += len(expected)
    assert count > 100, count


def check_settings(folder: Path) -> None:
    """Check that each technique has the settings that Python gives it, and no others."""
    values = {
        "work_group_shape": "16x8",
        "opencl_device": "Auto",
        "sample_distance_voxels": 0.25,
    }
    for name, setting in TECHNIQUE_SETTINGS.items():
        values.setdefault(name, setting.values[-1] if setting.values else 0)
        assert setting.accepts(values[name]), name
    path = folder / "settings.json"
    plain = {key: STUDY[key] for key in STUDY if not key.startswith("technique_")}
    for technique in (
        "single-pass",
        "compute",
        "opencl",
        "slices",
        "slices-threaded",
        "vtk-gpu",
    ):
        known = settings_of_technique(technique)
        assert known, technique
        for name, value in values.items():
            given = {"technique_settings": {technique: {name: [value]}}}
            path.write_text(json.dumps(plain | given | {"techniques": [technique]}))
            done = program(path, "--list", "--data", folder / "data")
            accepted = done.returncode == 0
            assert accepted == (name in known), (technique, name, done.stderr)


def as_row(run) -> dict:
    scene = run.scene
    return {
        "dataset": scene.dataset,
        "transfer_function": scene.transfer_function,
        "image_size": list(scene.image_size),
        "blend_mode": scene.blend_mode,
        "path": run.path,
        "technique": run.technique,
        "integrator": run.integrator,
        "step_voxels": run.step_voxels,
        "settings": dict(run.settings),
    }


def check_faults(folder: Path, study: Path) -> None:
    out = folder / "fault"

    def expect(cause: str, *arguments: object, code: int = 2) -> None:
        done = program(*arguments, "--out", out)
        text = done.stderr + done.stdout
        print(f"  {done.stderr.splitlines()[-1]}")
        assert done.returncode == code and cause in text, (arguments, done)
        assert code != 2 or len(done.stderr.splitlines()) == 1, done.stderr

    expect('study "nosuch"', "nosuch")
    expect('dataset "own": no file', study)
    expect(f"--data {folder / 'nowhere'}", study, "--data", folder / "nowhere")
    expect('unknown technique "gpu"', study, "--techniques", "gpu")
    bad = folder / "bad.json"
    bad.write_text(json.dumps(STUDY | {"image_sizes": [[48]]}))
    expect(f'{bad}: "image_sizes[0]"', bad)
    assert not out.exists(), "an error left a folder"
    bad.write_text(json.dumps(STUDY)[:-2])
    expect(f"{bad}: line 1, column", bad)
    (folder / "data" / "torn.mhd").write_text("ObjectType = Image\n")
    torn = {"datasets": [{"name": "torn"}], "transfer_functions": ["ramp"]}
    kept = {
        key: STUDY[key] for key in STUDY if not key.startswith("technique_settings")
    }
    bad.write_text(json.dumps(kept | torn))
    only = ("--data", folder / "data", "--techniques", "single-pass")
    # The rows of a view are not measured anyway, so that not all rows failed.
    expect("torn.mhd: cannot be read", bad, *only, code=0)


def main() -> None:
    with tempfile.TemporaryDirectory(prefix="volumebench-test-") as name:
        folder = Path(name)
        study = write_inputs(folder)
        check_shipped_studies()
        check_settings(folder)
        check_faults(folder, study)
        check_same_rows(folder, study)
    print("study_program: passed")


if __name__ == "__main__":
    main()
