"""Damaged transfer functions: a function or one line that names the file, never anything else.

As many files of each kind as the environment variable VOLUMEBENCH_FUZZ_FILES says, 400 without it;
10000 among the long tests.
"""

import json
import os
import random
from pathlib import Path

import pytest
from test_transfer_function_files import DATA, PRESETS, RAMP, key, preset, tfi
from volumebench.errors import BenchError
from volumebench.paraview_presets import read_presets
from volumebench.transfer_functions import TransferFunction, load_transfer_function
from volumebench.transfer_functions import save_transfer_function
from volumebench.voreen_functions import read_tfi

COUNT = int(os.environ.get("VOLUMEBENCH_FUZZ_FILES", "400"))
NUMBERS = (b"0", b"-1", b"1e999", b"nan", b"9" * 5000, b"", b'"', b"<", b"[", b"true")


def damaged(content: bytes, numbers: random.Random) -> bytes:
    """Return the content after one to three changes."""
    data = bytearray(content)
    for _ in range(numbers.randint(1, 3)):
        place = numbers.randrange(len(data) + 1)
        length = numbers.randrange(1, 60)
        change = numbers.randrange(6)
        if change == 0:
            data[place : place + 1] = bytes([numbers.randrange(256)])
        elif change == 1:
            del data[place : place + length]
        elif change == 2:
            data[place:place] = data[place : place + length]
        elif change == 3:
            data[place : place + 1] = numbers.choice(NUMBERS)
        elif change == 4 and numbers.random() < 0.2:
            del data[place:]
        else:
            swap_numbers(data, numbers)
    return bytes(data)


def swap_numbers(data: bytearray, numbers: random.Random) -> None:
    """Put a hostile number in the place of a digit."""
    digits = [i for i, sign in enumerate(data) if chr(sign).isdigit()]
    if digits:
        place = numbers.choice(digits)
        data[place : place + 1] = numbers.choice(NUMBERS)


def check_sound(functions: list[TransferFunction], folder: Path) -> None:
    """What is read must be as our own files are: in order, finite, from 0 to 1."""
    for function in functions:
        save_transfer_function(function, folder / "own.json")
        load_transfer_function(folder / "own.json")


def good_files(kind: str) -> list[bytes]:
    if kind == "tfi":
        split = key(0.25, (1, 2, 3, 4)) + key(0.5, (5, 6, 7, 8), (255, 254, 253, 252))
        more = '<alphaMode value="1"/><domain x="0" y="1"/><threshold x="0.1" y="0.9"/>'
        files = [tfi(RAMP).encode(), tfi(split, more).encode()]
        return files + [path.read_bytes() for path in sorted(DATA.glob("*.tfi"))]
    lab = preset(ColorSpace="Lab", Name="other")
    files = [json.dumps(preset()).encode(), json.dumps([lab, preset()]).encode()]
    return files + ([PRESETS.read_bytes()] if PRESETS.is_file() else [])


def read_all(kind: str, path: Path) -> list[TransferFunction]:
    return [read_tfi(path)] if kind == "tfi" else read_presets(path)


@pytest.mark.parametrize("count", [COUNT, pytest.param(10000, marks=pytest.mark.long)])
@pytest.mark.parametrize("kind", ["tfi", "json"])
def test_damaged_files_are_read_or_refused(kind, count, tmp_path):
    numbers = random.Random(20153)
    files = good_files(kind)
    path = tmp_path / f"damaged.{kind}"
    refused = 0
    for _ in range(count):
        path.write_bytes(damaged(numbers.choice(files), numbers))
        try:
            functions = read_all(kind, path)
        except BenchError as fault:
            refused += 1
            told = str(fault)
            assert told.startswith(f"{path}: ") and len(told) > len(str(path)) + 10
            assert "\n" not in told and len(told) < len(str(path)) + 400
        else:
            check_sound(functions, tmp_path)
    print(f"{kind}: {refused} of {count} files refused")
    assert 0.2 * count < refused < count
