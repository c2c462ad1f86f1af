"""What is to be known of the machine beside its graphics; None where it does not tell."""

import os
import platform
import subprocess
from pathlib import Path
from typing import Any

_REPOSITORY = Path(__file__).resolve().parents[2]
_GOVERNOR = Path("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor")


def machine_facts() -> dict[str, Any]:
    """Return the fields of results.Context that any program can find out."""
    return {
        "host": platform.node() or None,
        "cpu": cpu_name(),
        "cores": len(os.sched_getaffinity(0)),
        "os": _os_name(),
        "kernel": platform.release() or None,
        "memory_gb": round(
            os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") / 1024**3, 1
        ),
        "cpu_governor": _text(_GOVERNOR),
        "load_average": round(os.getloadavg()[0], 2),
        "source": _source(),
    }


def cpu_name() -> str | None:
    """Return the name of the processor."""
    text = _text(Path("/proc/cpuinfo")) or ""
    names = [line for line in text.splitlines() if line.startswith("model name")]
    return names[0].partition(":")[2].strip() if names else platform.processor() or None


def _os_name() -> str | None:
    try:
        return platform.freedesktop_os_release().get("PRETTY_NAME")
    except OSError:
        return None


def _text(path: Path) -> str | None:
    try:
        return path.read_text(encoding="utf-8").strip()
    except OSError:
        return None


def _source() -> str | None:
    """Return the commit of a checkout; None of sources without one."""

    def git(*arguments: str) -> str:
        command = ["git", "-C", str(_REPOSITORY), *arguments]
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=20, check=True
        )
        return done.stdout.strip()

    try:
        changed = "+" if git("status", "--porcelain", "--untracked-files=no") else ""
        return git("rev-parse", "--short=12", "HEAD") + changed
    except (OSError, subprocess.SubprocessError):
        return None
