"""A copy of the project's source, from a git checkout or an unpacked archive, and its digest."""

import hashlib
import shutil
import subprocess
from pathlib import Path

NOT_SOURCE = ("build", "Results", ".git")


def copy_source(source: Path, target: Path) -> None:
    """Copy what belongs to the source; `target` must not exist."""
    files = _files_of_git(source)
    if files is None:
        shutil.copytree(source, target, symlinks=True, ignore=_ignore_in(source))
        return
    for name in files:
        if (source / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source / name, target / name)


def _files_of_git(source: Path) -> list[str] | None:
    """Return tracked and new files, or None where `source` is not the top of a checkout."""
    try:
        top = _git(source, "rev-parse", "--show-toplevel")
        if Path(top.strip()).resolve() != source.resolve():
            return None
        listed = _git(
            source, "ls-files", "-z", "--cached", "--others", "--exclude-standard"
        )
    except (OSError, subprocess.CalledProcessError):
        return None
    return [name for name in listed.split("\0") if name]


def _git(folder: Path, *words: str) -> str:
    return subprocess.run(
        ["git", "-C", str(folder), *words], check=True, capture_output=True, text=True
    ).stdout


def _ignore_in(source: Path):
    def ignore(folder: str, names: list[str]) -> list[str]:
        at_top = Path(folder).resolve() == source.resolve()
        return [name for name in names if at_top and name in NOT_SOURCE]

    return ignore


def digest(tree: Path) -> dict[str, str]:
    """Return the checksum of every file below the folder."""
    return {
        str(path.relative_to(tree)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in tree.rglob("*")
        if path.is_file()
    }
