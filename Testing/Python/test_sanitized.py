"""The script that tests run under with the sanitizers tells our faults from those of others."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[1] / "Support" / "sanitized.py"
LIBRARY = """
#include <cstdlib>
extern "C" {
void lose() { volatile char* lost = static_cast<char*>(std::malloc(1000)); lost[0] = 1; }
void free_twice()
{
  void* block = std::malloc(4);
  std::free(block);
  std::free(block);
}
}
"""
CALL = "import ctypes, sys; [getattr(ctypes.CDLL(sys.argv[1]), name)() for name in sys.argv[2:]]"


def library(folder: Path) -> Path:
    folder.mkdir()
    source, made = folder / "faults.cxx", folder / "libfaults.so"
    source.write_text(LIBRARY)
    command = ["g++", "-shared", "-fPIC", str(source), "-o", str(made)]
    subprocess.run(command, check=True)
    return made


def sanitizer() -> str:
    name = ["g++", "-print-file-name=libasan.so"]
    found = subprocess.run(name, check=True, capture_output=True, text=True).stdout
    return os.path.realpath(found.strip())


Call = Callable[..., subprocess.CompletedProcess]


@pytest.fixture
def call(tmp_path: Path) -> Call:
    """Return what calls functions of a library as a foreign program does, in a build or beside it."""
    paths = {name: library(tmp_path / name) for name in ("ours", "theirs")}

    def run(whose: str, *functions: str) -> subprocess.CompletedProcess:
        script = [sys.executable, str(SCRIPT), str(tmp_path / "ours")]
        program = ["/usr/bin/python3", "-c", CALL, str(paths[whose]), *functions]
        return subprocess.run(
            [*script, "--preload", sanitizer(), *program],
            capture_output=True,
            text=True,
        )

    return run


def test_memory_that_a_function_of_ours_loses_is_a_failure(call: Call) -> None:
    done = call("ours", "lose")
    assert done.returncode == 1
    assert "1000 byte(s)" in done.stdout and " in lose " in done.stdout, done.stdout


def test_memory_that_others_lose_is_none(call: Call) -> None:
    done = call("theirs", "lose")
    assert (done.returncode, done.stdout) == (0, "")


@pytest.mark.parametrize("whose", ["ours", "theirs"])
def test_every_other_report_is_a_failure(call: Call, whose: str) -> None:
    done = call(whose, "free_twice")
    assert done.returncode == 1
    assert "attempting double-free" in done.stdout, done.stdout


def test_what_fails_fails_with_its_own_code(call: Call) -> None:
    assert call("ours", "no_such_function").returncode == 1
    assert call("ours").returncode == 0


def test_a_search_for_leaks_that_died_is_tried_again(tmp_path: Path) -> None:
    """The second run, which does not look at what threads have of their own, leaves no report."""
    program = tmp_path / "program.py"
    program.write_text(
        "import os, pathlib\n"
        "report = os.environ['ASAN_OPTIONS'].split('log_path=')[1].split(':')[0]\n"
        "if 'use_tls=0' not in os.environ['LSAN_OPTIONS']:\n"
        "    pathlib.Path(report + '.1').write_text(\n"
        "        'LeakSanitizer has encountered a fatal error')\n"
    )
    command = [sys.executable, str(SCRIPT), str(tmp_path), sys.executable, str(program)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0 and "tried again" in done.stdout, done.stdout
    always = program.read_text().replace("if 'use_tls=0' not in", "if True or")
    program.write_text(always)
    assert subprocess.run(command, capture_output=True).returncode == 1
