"""`./run test` runs every test but the long ones; with --long, these too, after all else."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Stands in for what runs, and writes it down.
RECORDING_TOOLS = """
set -euo pipefail
root=$1 python=python
source "$2/Tools/tests.sh"
build() { mkdir -p "$root/build/$1/Testing"; echo "build $*"; }
choose_display() { :; }
guard() { echo "$*" >&2; "$@"; }
logged() { echo '1 tests passed in 1s' >"$1"; [[ "$*" != *"$FAILS"* ]]; }
shift 2
"""


def output(*command: str) -> str:
    return subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout


def ctest_names(*options: str) -> set[str]:
    listed = json.loads(output("ctest", *options, "--show-only=json-v1"))
    return {test["name"] for test in listed["tests"]}


def pytest_names(*options: str) -> set[str]:
    command = (sys.executable, "-m", "pytest", "Testing/Python", "--collect-only", "-q")
    return {line for line in output(*command, *options).splitlines() if "::" in line}


def check_apart(every: set[str], quick: set[str], long: set[str]) -> None:
    assert long and quick, "one of the shares has no test"
    assert not quick & long, f"in both: {quick & long}"
    assert quick | long == every, f"in none: {every - quick - long}"
    print(f"  {len(quick)} quick, {len(long)} long")


def check_ctest() -> None:
    folder = ("--test-dir", "build/dev")
    long = ctest_names("--preset", "long")
    check_apart(ctest_names(*folder), ctest_names("--preset", "dev"), long)
    assert long == ctest_names(*folder, "-L", "^Long$")


def check_pytest() -> None:
    quick = pytest_names()
    assert quick == pytest_names("-m", "not long"), "the default is another share"
    check_apart(pytest_names("-m", ""), quick, pytest_names("-m", "long"))


def commands_of_run(
    *options: str, fails: str = "nothing", function: str = "run_tests"
) -> tuple[list[str], int]:
    """Return what `./run test` would start, in order, and its exit status."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [
                *("bash", "-c", f"{RECORDING_TOOLS}\n{function} \"$@\"", "recording-tools"),
                *(folder, str(ROOT), *options),
            ],
            capture_output=True,
            text=True,
            env={"PATH": "/usr/bin:/bin", "FAILS": fails},
        )
    lines = [line.partition(".log ")[2] for line in done.stderr.splitlines()]
    return lines, done.returncode


def check_run() -> None:
    pytest = "python -m pytest Testing/Python -q -m"
    quick = ["ctest --preset dev -j2", f"{pytest} not long"]
    long = ["ctest --preset long", f"{pytest} long"]
    assert commands_of_run() == (quick, 0), commands_of_run()
    assert commands_of_run("--long") == (quick + long, 0), commands_of_run("--long")
    for command in quick + long:
        started, status = commands_of_run("--long", fails=command)
        assert started == quick + long, f"{command} fails: {started}"
        assert status == 1, f"{command} fails, and ./run test does not"
    for fails in ("nothing", "ctest"):
        started, status = commands_of_run(fails=fails, function="run_sanitized")
        assert started == ["ctest --preset asan -j2"], started
        assert status == (fails != "nothing"), f"sanitized, {fails} fails: {status}"


if __name__ == "__main__":
    for check in (check_ctest, check_pytest, check_run):
        print(check.__name__, flush=True)
        check()
    print("PASSED")
