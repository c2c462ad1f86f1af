"""Reads volume files into VTK image data; needs VTK, but nothing of ParaView."""

from dataclasses import dataclass, replace

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.vtkCommonCore import vtkLogger
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import (
    vtkImageReader2,
    vtkMetaImageReader,
    vtkNIFTIImageReader,
    vtkNrrdReader,
)
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from .datasets import RawLayout, VolumeFile
from .errors import BenchError
from .orbit import Bounds

_READERS = {
    ".nrrd": vtkNrrdReader,
    ".mhd": vtkMetaImageReader,
    ".vti": vtkXMLImageDataReader,
    ".nii": vtkNIFTIImageReader,
    ".gz": vtkNIFTIImageReader,
}


@dataclass(frozen=True)
class OpenVolume:
    """Image data in memory with what a study needs to know of it."""

    name: str
    image: vtkImageData
    array: str
    dims: tuple[int, int, int]
    scalar_type: str
    spacing: tuple[float, float, float]
    bounds: Bounds
    range: tuple[float, float]


def open_volume(file: VolumeFile) -> OpenVolume:
    """Read a volume; anything that is no 3-D scalar image is an error that names the file."""
    image = _read(file)
    if file.upright:
        image = upright(image)
    data = image.GetPointData()
    scalars = data.GetScalars() or data.GetArray(0)
    if scalars is None:
        raise BenchError(f"{file.path}: holds no point data")
    if scalars.GetNumberOfComponents() != 1:
        count = scalars.GetNumberOfComponents()
        raise BenchError(f"{file.path}: has {count} components a voxel; one is needed")
    if min(image.GetDimensions()) < 2:
        size = " x ".join(str(n) for n in image.GetDimensions())
        raise BenchError(f"{file.path}: is {size} voxels; each side needs two or more")
    low, high = scalars.GetFiniteRange()
    if low > high:
        raise BenchError(f"{file.path}: holds no finite value")
    if not scalars.GetName():
        scalars.SetName(file.name)
    data.SetActiveScalars(scalars.GetName())
    return OpenVolume(
        file.name,
        image,
        scalars.GetName(),
        image.GetDimensions(),
        numpy_support.vtk_to_numpy(scalars).dtype.name,
        image.GetSpacing(),
        image.GetBounds(),
        (low, high),
    )


def copy_of(volume: OpenVolume) -> OpenVolume:
    """Return the volume in memory of its own, with nothing known yet of its values."""
    image = vtkImageData()
    image.DeepCopy(volume.image)
    image.GetPointData().GetArray(volume.array).DataChanged()
    image.GetPointData().GetArray(volume.array).Modified()
    return replace(volume, image=image)


def bytes_of(volume: OpenVolume) -> int:
    """Return what the voxels take in memory."""
    voxels = volume.image.GetPointData().GetArray(volume.array)
    return voxels.GetNumberOfValues() * voxels.GetDataTypeSize()


def _read(file: VolumeFile) -> vtkImageData:
    reader = _raw_reader(file.raw) if file.raw else _READERS[file.path.suffix]()
    faults: list[str] = []
    reader.AddObserver("ErrorEvent", lambda *_: faults.append("the reader failed"))
    if not file.raw and hasattr(reader, "CanReadFile"):
        if not reader.CanReadFile(str(file.path)):
            raise BenchError(f"{file.path}: cannot be read as {_kind(file)}")
    reader.SetFileName(str(file.path))
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        reader.Update()
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutput())
    if faults or not image.GetNumberOfPoints():
        raise BenchError(f"{file.path}: cannot be read as {_kind(file)}")
    return image


def _kind(file: VolumeFile) -> str:
    """Return the extension that chose the reader, for messages."""
    return ".nii.gz" if file.path.suffix == ".gz" else file.path.suffix


def _raw_reader(layout: RawLayout) -> vtkImageReader2:
    reader = vtkImageReader2()
    reader.SetFileDimensionality(3)
    reader.FileLowerLeftOn()  # else VTK turns the rows upside down
    reader.SetDataExtent(
        0, layout.dims[0] - 1, 0, layout.dims[1] - 1, 0, layout.dims[2] - 1
    )
    reader.SetDataSpacing(layout.spacing)
    reader.SetDataScalarType(
        numpy_support.get_vtk_array_type(np.dtype(layout.scalar_type))
    )
    reader.SetNumberOfScalarComponents(1)
    if layout.byte_order == "little":
        reader.SetDataByteOrderToLittleEndian()
    else:
        reader.SetDataByteOrderToBigEndian()
    return reader


def upright(image: vtkImageData) -> vtkImageData:
    """Turn a NIfTI head so that y points to its crown and z out of its face.

    The axes (x, y, z) become (-x, z, y): a rotation, no mirror image; no voxel changes.
    """
    scalars = image.GetPointData().GetScalars()
    nx, ny, nz = image.GetDimensions()
    voxels = numpy_support.vtk_to_numpy(scalars).reshape(nz, ny, nx)
    turned = np.ascontiguousarray(voxels.transpose(1, 0, 2)[:, :, ::-1])
    array = numpy_support.numpy_to_vtk(turned.ravel(), deep=True)
    array.SetName(scalars.GetName())
    dx, dy, dz = image.GetSpacing()
    result = vtkImageData()
    result.SetDimensions(nx, nz, ny)
    result.SetSpacing(dx, dz, dy)
    result.GetPointData().SetScalars(array)
    return result
