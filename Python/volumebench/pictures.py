"""PNG files from premultiplied float RGBA, and amplified difference images."""

import struct
import zlib
from pathlib import Path

import numpy as np

from .json_file import write_atomically

BLACK = (0.0, 0.0, 0.0)
AMPLIFICATIONS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)


def over(picture: np.ndarray, background: tuple[float, float, float]) -> np.ndarray:
    """Return 8-bit RGB of a premultiplied picture over a background, row 0 on top."""
    colour = picture[..., :3] + (1 - picture[..., 3:4]) * np.asarray(background)
    return np.rint(np.clip(np.nan_to_num(colour), 0, 1) * 255).astype(np.uint8)


def amplification(difference: np.ndarray) -> int:
    """Return the largest round factor that keeps 99.9 % of the difference below 1."""
    peak = float(np.percentile(np.abs(difference), 99.9))
    fitting = [factor for factor in AMPLIFICATIONS if factor * peak <= 1]
    return fitting[-1] if fitting else 1


def difference_image(picture: np.ndarray, truth: np.ndarray, factor: int) -> np.ndarray:
    """Return |picture - truth| of red, green and blue, amplified, as 8-bit RGB."""
    difference = np.abs(picture[..., :3] - truth[..., :3]) * factor
    return np.rint(np.clip(np.nan_to_num(difference), 0, 1) * 255).astype(np.uint8)


def png(rgb: np.ndarray) -> bytes:
    """Encode 8-bit RGB, row 0 on top."""
    height, width, _ = rgb.shape
    rows = np.zeros((height, 1 + width * 3), np.uint8)
    rows[:, 1:] = rgb.reshape(height, width * 3)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = (
        (b"IHDR", header),
        (b"IDAT", zlib.compress(rows.tobytes(), 6)),
        (b"IEND", b""),
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(name, data) for name, data in chunks)


def _chunk(name: bytes, data: bytes) -> bytes:
    checksum = zlib.crc32(name + data)
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", checksum)


def write_png(path: Path, rgb: np.ndarray) -> None:
    """Write 8-bit RGB as a PNG file."""
    write_atomically(path, png(rgb))
