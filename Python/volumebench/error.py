"""The error of a picture: numbers that the filter proxy VolumeImageError measures."""

from dataclasses import dataclass

EIGHT_BIT_RMSE = 1.13e-3


@dataclass(frozen=True)
class ImageError:
    """Differences of linear premultiplied RGBA in the union footprint, and how they look.

    `mean` is picture less reference, with its sign. `ssim`, the percentage of pixels whose
    CIEDE2000 exceeds 1, and FLIP are of 8-bit pictures over black. None stands for not measured.
    """

    rmse: float | None = None
    linf: float | None = None
    p999: float | None = None
    psnr: float | None = None
    mean: float | None = None
    ssim: float | None = None
    delta_e_over_1_percent: float | None = None
    flip_mean: float | None = None
    flip_p99: float | None = None
    reference: str | None = None
    reference_uncertainty: float | None = None
    image_size: tuple[int, int] | None = None


MEASURES = (
    *("rmse", "linf", "p999", "psnr", "mean"),
    *("ssim", "delta_e_over_1_percent", "flip_mean", "flip_p99"),
)
