"""The command that writes a generated volume: python3 Python/generate.py NAME --out FILE.mhd ..."""

import argparse
import sys
from pathlib import Path
from typing import Any

from .errors import BenchError
from .generated_volume import GeneratedVolume, byte_count
from .generators import GENERATORS, META_TYPES, write_volume_as

LIMITS = {"extent": (1, 10), "share": (0, 1)}  # above the first, at most the second
MAXIMUM_DIMENSION = 4096
MAXIMUM_SEED = 2**31 - 1


def parse(arguments: list[str] | None) -> argparse.Namespace:
    """Return the options; faults of form end the program with a usage line."""
    parser = argparse.ArgumentParser(
        prog="generate.py", description="Writes a generated volume as .mhd with .raw."
    )
    parser.add_argument("name", choices=list(GENERATORS), metavar="NAME")
    parser.add_argument("--out", type=Path, metavar="FILE.mhd")
    parser.add_argument("--dims", type=int, nargs=3, metavar=("X", "Y", "Z"))
    parser.add_argument("--scalar-type", choices=list(META_TYPES))
    parser.add_argument("--spacing", type=float, nargs=3, metavar=("X", "Y", "Z"))
    parser.add_argument("--seed", type=int)
    parser.add_argument("--extent", type=float)
    parser.add_argument("--share", type=float)
    return parser.parse_args(arguments)


def generator_of(options: argparse.Namespace) -> GeneratedVolume:
    """Return the volume that the options describe; an option that it does not have is an error."""
    kind = GENERATORS[options.name]
    given: dict[str, Any] = {
        name: tuple(value) if isinstance(value, list) else value
        for name, value in vars(options).items()
        if name not in ("name", "out") and value is not None
    }
    for name, value in given.items():
        option = "--" + name.replace("_", "-")
        if name not in kind.parameters():
            raise BenchError(f'{option} does not apply to "{options.name}"')
        _check(option, name, value)
    return kind(**given)


def _check(option: str, name: str, value: Any) -> None:
    if name == "dims" and not all(2 <= count <= MAXIMUM_DIMENSION for count in value):
        raise BenchError(f"{option}: each must be from 2 to {MAXIMUM_DIMENSION}")
    if name == "spacing" and not all(0 < length < float("inf") for length in value):
        raise BenchError(f"{option}: each must be above 0")
    if name == "seed" and not 0 <= value <= MAXIMUM_SEED:
        raise BenchError(f"{option}: {value} is not from 0 to {MAXIMUM_SEED}")
    if name in LIMITS and not LIMITS[name][0] < value <= LIMITS[name][1]:
        low, high = LIMITS[name]
        raise BenchError(f"{option}: {value:g} is not above {low} and at most {high}")


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; bad input is one line on stderr and exit code 2."""
    options = parse(arguments)
    try:
        volume = generator_of(options)
        header = options.out or Path(f"{volume.file_stem()}.mhd")
        if header.suffix != ".mhd":
            raise BenchError(f"--out: {header} does not end in .mhd")
        for file in (header, header.with_suffix(".raw")):
            file.unlink(missing_ok=True)
        write_volume_as(volume, header)
    except BenchError as fault:
        print(f"error: {fault}", file=sys.stderr)
        return 2
    except OSError as fault:
        print(f"error: {header}: {fault.strerror}", file=sys.stderr)
        return 2
    size = " x ".join(str(count) for count in volume.dims)
    print(f"{header}: {size} {volume.scalar_type}, {byte_count(volume)} bytes")
    return 0
