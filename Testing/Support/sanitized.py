"""Runs a test that is built with the sanitizers; fails if any process under it made a report.

Usage: sanitized.py BUILD [--preload LIBRARY] COMMAND...
BUILD is the folder of our libraries: memory that others have lost is no failure unless a function of ours
asked for it. LIBRARY is the sanitizer's, for programs that are not built with it but load what is.
Environment: VOLUMEBENCH_ALL_LEAKS=1 shows the leaks of others as well.
"""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SUPPRESSIONS = Path(__file__).with_name("leaks.supp")
# The program behind each frame is needed to tell ours.
STACK = r"stack_trace_format='    #%n %F %S (%m+%o)'"
ADDRESS = "detect_stack_use_after_return=1:check_initialization_order=1:detect_leaks=1"
# How much longer tests wait for the programs that they start.
PATIENCE = "6"
# Of a block that a foreign program asked for only the function that did so is kept. What lies behind it in code
# without frame pointers are mostly no addresses, and each makes the sanitizer read all libraries anew: minutes.
SHORT = "malloc_context_size=2"
LEAKS = f"suppressions={SUPPRESSIONS}:print_suppressions=0:exitcode=0"
RECORD = re.compile(
    r"^(?:Direct|Indirect) leak of .*?(?=^\n|\Z)", re.MULTILINE | re.DOTALL
)
# Where what it knows of a thread's own storage is out of date, as some drivers leave it. That is no verdict on
# what was tested; without looking there it finds all, and maybe more.
TRACER_DIED = "LeakSanitizer has encountered a fatal error"
LEAK_REPORT = "ERROR: LeakSanitizer: detected memory leaks"


def environment(reports: str, preload: str) -> dict[str, str]:
    """Return the variables that send each process' reports to a file of its own."""
    common = f"log_path={reports}:log_exe_name=1:{STACK}"
    address = f"{ADDRESS}:{SHORT}" if preload else ADDRESS
    variables = {
        "ASAN_OPTIONS": f"{address}:{common}",
        "UBSAN_OPTIONS": f"print_stacktrace=1:{common}",
        "VOLUMEBENCH_PATIENCE": PATIENCE,
    }
    return {**os.environ, **variables, **({"LD_PRELOAD": preload} if preload else {})}


def complaint(report: str, build: str, preloaded: bool) -> str:
    """Return what of a report is a failure: all of it, but of leaks only ours.

    In a foreign program, what is lost only through another block belongs to whoever lost that one, such as
    Python, which frees little when it ends.
    """
    if LEAK_REPORT not in report:
        return report
    leaks = RECORD.findall(report)
    if preloaded:
        leaks = [leak for leak in leaks if leak.startswith("Direct")]
    if os.environ.get("VOLUMEBENCH_ALL_LEAKS") != "1":
        # Frames of drivers that are unloaded by now fall into gaps between ours, and have no name.
        ours = re.compile(rf"#\d+ in .*\({re.escape(build)}/")
        leaks = [leak for leak in leaks if ours.search(leak)]
    return "\n".join(leaks)


def run(build: str, preload: str, command: list[str]) -> int:
    status, found = once(build, preload, command, LEAKS)
    if any(TRACER_DIED in text for text in found.values()):
        print("sanitizer: the search for leaks died, and is tried again", flush=True)
        others = {name: text for name, text in found.items() if TRACER_DIED not in text}
        status, again = once(build, preload, command, f"{LEAKS}:use_tls=0")
        found = {**others, **again}
    for name, text in found.items():
        if text:
            print(f"sanitizer: {name}\n{text}", flush=True)
    if any(found.values()):
        return 1
    return status if status >= 0 else 128 - status


def once(
    build: str, preload: str, command: list[str], leaks: str
) -> tuple[int, dict[str, str]]:
    """Return the exit status of a run, and of each process what of its report is a failure."""
    with tempfile.TemporaryDirectory(prefix="volumebench-reports-") as folder:
        variables = environment(f"{folder}/report", preload)
        variables["LSAN_OPTIONS"] = leaks
        status = subprocess.run(command, env=variables, check=False).returncode
        found = {
            path.name: complaint(path.read_text(errors="replace"), build, bool(preload))
            for path in sorted(Path(folder).iterdir())
        }
    return status, found


def main(arguments: list[str]) -> int:
    build, *command = arguments
    preload = ""
    if command[0] == "--preload":
        _, preload, *command = command
    return run(build, preload, command)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
