"""volumebench-run --calibrate without a display: what it writes, and its errors."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from patience import patient_s

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Python"))

from volumebench.calibration import load_calibration  # noqa: E402

PROGRAM = os.environ["VOLUMEBENCH_RUN"]
PATHS = ("gl-fragment", "gl-compute", "cpu", "cpu-pairs")
PATHS += ("opencl-lanes", "opencl-buffers", "opencl-images")  # of PoCL


def run(*arguments: str, **variables: str) -> subprocess.CompletedProcess:
    """Run the program as on a machine without an X server."""
    environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
    return subprocess.run(
        [PROGRAM, *arguments],
        env=environment | variables,
        capture_output=True,
        text=True,
        timeout=patient_s(200),
    )


def check_rows(document: dict) -> None:
    """Check that each path was measured in each way, with rates that make sense."""
    rows = {
        (row["path"], row["kind"], row["format"], row["order"], row["entries"])
        for row in document["fetches"]
    }
    assert len(rows) == len(document["fetches"]), "a row appears twice"
    sides = (16, 64)
    for side in sides:
        for order in ("axis", "oblique", "rays"):
            for format_name in ("R16", "R32F"):
                for path in PATHS:
                    assert (path, "trilinear", format_name, order, side) in rows
        assert ("gl-compute", "texel", "R8", "oblique", side) in rows
    assert ("gl-fragment", "table", "RGBA32F", "axis", 1024) in rows
    assert {row["path"] for row in document["copies"]} == {"gl", "cpu"}
    spreads = [row["per_second"] for row in document["fetches"]]
    spreads += [row["bytes_per_second"] for row in document["copies"]]
    for spread in spreads:
        assert 0 < spread["min"] <= spread["q1"] <= spread["median"], spread
        assert spread["median"] <= spread["q3"] <= spread["max"], spread
    # No device fetches a sample in a femtosecond, and none takes a tenth of a millisecond.
    assert all(1e4 < spread["median"] < 1e15 for spread in spreads), spreads


def check_calibration(folder: Path) -> None:
    path = folder / "calibration.json"
    done = run("--calibrate", "--quick", "--out", str(path))
    assert done.returncode == 0, done.stderr
    kept = load_calibration(path)  # also checks the schema
    assert set(kept["samples_per_second"]) == set(PATHS)
    assert kept["opencl_device"] and kept["opencl_device_type"] == "cpu", kept
    check_rows(json.loads(path.read_text()))
    assert "gl-fragment trilinear R16 axis" in done.stdout, done.stdout
    assert kept["gl_renderer"] in done.stdout
    assert [file.name for file in folder.iterdir()] == ["calibration.json"]


def check_without_opencl(folder: Path) -> None:
    """Check that a machine without OpenCL is calibrated without it."""
    path = folder / "calibration.json"
    nowhere = {"OCL_ICD_VENDORS": str(folder / "none")}
    done = run("--calibrate", "--quick", "--out", str(path), **nowhere)
    assert done.returncode == 0, done.stderr
    kept = load_calibration(path)
    assert not [name for name in kept["samples_per_second"] if "opencl" in name]
    assert kept["opencl_device"] is None and kept["opencl_device_type"] is None


def check_fault(cause: str, *arguments: str, **variables: str) -> None:
    """Check for exit code 2 and one line that holds the cause."""
    done = run(*arguments, **variables)
    print(f"  {done.stderr.strip()}")
    assert done.returncode == 2, done
    lines = [line for line in done.stderr.splitlines() if "libEGL warning" not in line]
    assert len(lines) == 1 and lines[0].startswith("error: "), done.stderr
    assert cause in lines[0], done.stderr


def main() -> None:
    with tempfile.TemporaryDirectory(prefix="volumebench-test-") as name:
        folder = Path(name)
        missing = folder / "missing" / "calibration.json"
        check_fault(str(missing), "--calibrate", "--out", str(missing))
        out = str(folder / "c.json")
        check_fault("--calibrate takes", "--calibrate", "study.json")
        check_fault("no EGL device 99", "--calibrate", "--out", out, "--device", "99")
        # A vendor that is not there: libglvnd then finds no driver at all.
        nowhere = {"__EGL_VENDOR_LIBRARY_FILENAMES": str(folder / "none.json")}
        check_fault("no EGL display", "--calibrate", "--out", out, **nowhere)
        assert not list(folder.iterdir()), "an error left a file"
        check_calibration(folder)
        check_without_opencl(folder)
    print("calibrate: passed")


if __name__ == "__main__":
    main()
