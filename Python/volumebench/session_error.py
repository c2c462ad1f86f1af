"""Compares float pictures through the filter proxy VolumeImageError."""

import math
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

from .error import MEASURES, ImageError
from .errors import BenchError
from .session_support import ErrorLog, client_proxy

FILTER_PROXY = "VolumeImageError"
Pair = tuple[np.ndarray, np.ndarray]


def compare_pictures(pairs: list[Pair]) -> ImageError:
    """Return the error over all pairs of (picture, reference), pooled; each [y, x, RGBA] in float.

    PSNR is None for equal pictures.
    """
    producers = [[_producer_of(item) for item in pair] for pair in pairs]
    pictures, references = (list(side) for side in zip(*producers))
    with ErrorLog() as log:
        compare = client_proxy("filters", FILTER_PROXY)
        compare.Pictures, compare.References = pictures, references
        filter_here = compare.GetClientSideObject()
        filter_here.Update()
        table = filter_here.GetOutputDataObject(0)
        reason = log.text()
    if reason or table.GetNumberOfRows() != 1:
        raise BenchError(reason or f"{FILTER_PROXY} gave no row")
    measured = {name: _value(table, name) for name in MEASURES}
    if measured["rmse"] is None:
        raise BenchError(
            "no pixel is covered in the picture or in its reference, or some value there is not "
            "finite"
        )
    return ImageError(**measured, image_size=pairs[0][0].shape[1::-1])


def _producer_of(picture: np.ndarray) -> Any:
    producer = client_proxy("sources", "TrivialProducer")
    producer.GetClientSideObject().SetOutput(_image(picture))
    return producer


def _image(picture: np.ndarray) -> vtkImageData:
    height, width, channels = picture.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    bottom_up = np.ascontiguousarray(picture[::-1], np.float32)
    values = numpy_to_vtk(bottom_up.reshape(-1, channels), deep=True)
    image.GetPointData().SetScalars(values)
    return image


def _value(table: Any, name: str) -> float | None:
    value = table.GetValueByName(0, f"error.{name}").ToDouble()
    return value if math.isfinite(value) else None
