"""The quick cut of a paper's study, by the command line alone: it ends within ten minutes on two cores,
no row fails, each conclusion has a verdict with figures, and its report opens in a browser.

For long runs only (label Long). The first argument names the study.
"""

import csv
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

REPOSITORY = Path(__file__).resolve().parents[2]
for folder in ("Python", "Testing/Support"):
    sys.path.insert(0, str(REPOSITORY / folder))

from browser import CHROMIUM, watched  # noqa: E402
from volumebench.study_file import find_study, load_study  # noqa: E402

MOST_SECONDS = 600
NEED_A_DEVICE = ("cuda", "opencl")


def measure(name: str, folder: Path) -> float:
    """Run the study without any data folder; return the seconds that it took."""
    begun = time.monotonic()
    command = [os.environ["VOLUMEBENCH_PVPYTHON"], str(REPOSITORY / "Python/bench.py")]
    subprocess.run([*command, name, "--quick", "--out", str(folder)], check=True)
    return time.monotonic() - begun


def check_rows(name: str, folder: Path) -> None:
    rows = json.loads((folder / "results.json").read_text(encoding="utf-8"))["runs"]
    assert len(rows) == len(load_study(find_study(name)).quick().runs())
    for row in rows:
        if row["status"] != "ok":
            assert row["status"] == "unsupported", row
            assert row["technique"] in NEED_A_DEVICE, row
        else:
            assert row["frames"] >= 6 and row["error"]["rmse"] is not None, row


def check_conclusions(name: str, folder: Path) -> None:
    with open(folder / "tables/conclusions.csv", encoding="utf-8", newline="") as file:
        verdicts = list(csv.DictReader(file))
    assert len(verdicts) == len(load_study(find_study(name)).paper["conclusions"])
    for found in verdicts:
        measured = found["measured here (95 %)"]
        if found["verdict"] == "not run":
            assert measured, found
        else:
            assert found["verdict"] in ("holds", "does not hold", "undecided"), found
            assert re.search(r"\d", measured) and "nan" not in measured, found


def check_report(folder: Path) -> None:
    assert CHROMIUM, "chromium is not installed"
    with tempfile.TemporaryDirectory() as own:
        seen = watched(folder / "report.html", Path(own))
    assert seen["errors"] == [] and seen["broken"] == [], seen
    assert seen["requests"] == [] and seen["images"] > 10, seen


def main(name: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        seconds = measure(name, Path(folder))
        print(f"{name}: {seconds:.0f} s")
        check_rows(name, Path(folder))
        check_conclusions(name, Path(folder))
        check_report(Path(folder))
    assert seconds < MOST_SECONDS, f"{name} took {seconds:.0f} s"


if __name__ == "__main__":
    main(sys.argv[1])
