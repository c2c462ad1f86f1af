"""Distance of a picture to its reference, on linear premultiplied RGBA in float."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from .errors import BenchError

EIGHT_BIT_RMSE = 1.13e-3


@dataclass(frozen=True)
class ImageError:
    """RMSE, largest and 99.9 % difference, PSNR and what they were measured on.

    None stands for not measured.
    """

    rmse: float | None = None
    linf: float | None = None
    p999: float | None = None
    psnr: float | None = None
    reference: str | None = None
    reference_uncertainty: float | None = None
    image_size: tuple[int, int] | None = None


def compare(
    pairs: Iterable[tuple[np.ndarray, np.ndarray]],
    reference: str | None = None,
    uncertainty: float | None = None,
) -> ImageError:
    """Return the error over all pairs of (picture, reference), pooled.

    Only pixels that one of the two covers (alpha above 0) count: empty background would flatter
    the mean. PSNR takes 1 as the peak and is None for equal pictures.
    """
    pairs = list(pairs)
    differences = [footprint_difference(picture, truth) for picture, truth in pairs]
    pooled = np.concatenate(differences) if differences else np.empty(0)
    if not pooled.size:
        raise BenchError("no pixel is covered in the picture or in its reference")
    if not np.isfinite(pooled).all():
        raise BenchError(
            "the picture or its reference holds values that are not finite"
        )
    rmse = math.sqrt(float(np.mean(pooled**2)))
    return ImageError(
        rmse,
        float(pooled.max()),
        float(np.percentile(pooled, 99.9)),
        -20 * math.log10(rmse) if rmse > 0 else None,
        reference,
        uncertainty,
        pairs[0][0].shape[1::-1],
    )


def footprint_difference(picture: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Return the absolute differences of all four channels in the union footprint, flat."""
    if picture.shape != truth.shape:
        raise BenchError(
            f"pictures of different size: {picture.shape} and {truth.shape}"
        )
    footprint = (picture[..., 3] > 0) | (truth[..., 3] > 0)
    footprint |= ~np.isfinite(picture[..., 3]) | ~np.isfinite(truth[..., 3])
    difference = picture[footprint].astype(np.float64) - truth[footprint]
    return np.abs(difference).ravel()
