"""The source VolumeStability: rows from its cases, one clear error from bad settings, abort; and
the study of it from the command line."""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from paraview import servermanager, simple
from patience import patient_s
from support import ERRORS, PLUGIN, run_checks

ROOT = Path(__file__).resolve().parents[2]


def rows_of(source: Any) -> list[dict[str, Any]]:
    source.UpdatePipeline()
    table = servermanager.Fetch(source)
    names = [table.GetColumnName(index) for index in range(table.GetNumberOfColumns())]
    return [
        {name: table.GetValueByName(row, name).ToString() for name in names}
        for row in range(table.GetNumberOfRows())
    ]


def check_rows() -> None:
    source = simple.VolumeStability()
    source.Techniques = ["single-pass", "vtk-gpu"]
    source.Integrators = ["Left", "Midpoint"]
    source.Cases = [2, 30]
    rows = rows_of(source)
    assert not ERRORS.messages, ERRORS.take()
    found = [(row["case"], row["technique"], row["integrator"]) for row in rows]
    assert found == [
        (case, *who)
        for case in ("2", "30")
        for who in (
            ("single-pass", "Left"),
            ("single-pass", "Midpoint"),
            ("vtk-gpu", ""),
        )
    ], found
    assert [row["status"] for row in rows[:2]] == ["fail", "pass"], rows
    assert float(rows[1]["error"]) <= float(rows[1]["limit"]) == 1e-6
    assert [row["status"] for row in rows[3:]] == ["pass", "pass", "not-applicable"]
    assert all(row["reason"].endswith(".") for row in rows)


def check_bad_settings() -> None:
    for name, value, cause in (
        ("Techniques", ["warp"], "warp"),
        ("Integrators", ["Simpson"], "Simpson"),
        ("Cases", [4711], "4711"),
    ):
        source = simple.VolumeStability(Cases=[1])
        setattr(source, name, value)
        assert rows_of(source) == []
        messages = ERRORS.take()
        assert len(messages) == 1 and cause in messages[0], messages
        assert "Nothing tried: " in messages[0], messages


def check_abort() -> None:
    source = simple.VolumeStability(Techniques=["single-pass"], Cases=[1, 2, 3])
    source.Integrators = ["Midpoint"]
    inner = source.GetClientSideObject()
    shares: list[float] = []

    def stop(*_: Any) -> None:
        shares.append(inner.GetProgress())
        inner.SetAbortExecute(int(inner.GetProgress() > 0))

    inner.AddObserver("ProgressEvent", stop)
    rows = rows_of(source)
    assert [row["case"] for row in rows] == ["1"], rows
    # The pipeline itself tells begin and end.
    assert shares[:1] == [0] and abs(shares[1] - 1 / 3) < 1e-6 and len(shares) == 3


def check_study_of_the_command_line() -> None:
    with tempfile.TemporaryDirectory() as folder:
        study = Path(folder) / "tiny.json"
        document = {"schema": 1, "kind": "stability", "name": "tiny", "cases": [1, 33]}
        study.write_text(json.dumps(document), encoding="utf-8")
        out = Path(folder) / "out"
        command = [
            sys.executable if "pvpython" in sys.executable else "pvpython",
            str(ROOT / "Python" / "bench.py"),
            *(str(study), "--quick", "--out", str(out)),
            *("--techniques", "single-pass,vtk-gpu", "--plugin", PLUGIN),
        ]
        ran = subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=patient_s(200),
            env=dict(os.environ),
        )
        assert ran.returncode == 0, ran.stderr
        assert "fails case" not in ran.stdout, ran.stdout
        results = json.loads((out / "stability.json").read_text(encoding="utf-8"))
        assert results["context"]["gl_renderer"], results["context"]
        assert [case["number"] for case in results["cases"]] == [1, 33]
        assert all(row["status"] == "pass" for row in results["rows"] if row["meant"])
        assert (out / "stability.html").is_file()
        assert (out / "plots" / "stability.png").is_file()


if __name__ == "__main__":
    run_checks(dict(globals()))
