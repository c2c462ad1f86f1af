"""Reads volume files into VTK image data; needs VTK, but nothing of ParaView."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from vtkmodules.util import numpy_support
from vtkmodules.util.vtkConstants import VTK_STRING
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
    ".nhdr": vtkNrrdReader,
    ".mhd": vtkMetaImageReader,
    ".mha": vtkMetaImageReader,
    ".vti": vtkXMLImageDataReader,
    ".nii": vtkNIFTIImageReader,
    ".gz": vtkNIFTIImageReader,
}
PLUGIN_FORMATS = {".pvm": "PVMReader", ".dat": "VoreenReader"}  # by proxy
PluginReaders = Mapping[str, Callable[[], Any]]  # what makes a reader, by extension


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


def open_volume(
    file: VolumeFile, plugin_readers: PluginReaders | None = None
) -> OpenVolume:
    """Read a volume; anything that is no 3-D scalar image is an error that names the file.

    Formats that VTK lacks need the readers of the plugin, by extension.
    """
    image = _read(file, plugin_readers or {})
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


def _read(file: VolumeFile, plugin_readers: PluginReaders) -> vtkImageData:
    if file.path.suffix in PLUGIN_FORMATS:
        return _read_by_plugin(file, plugin_readers)
    reader = _raw_reader(file.raw) if file.raw else _READERS[file.path.suffix]()
    if not file.raw and hasattr(reader, "CanReadFile"):
        if not reader.CanReadFile(str(file.path)):
            raise BenchError(f"{file.path}: cannot be read as {_kind(file)}")
    image, faults = _updated(reader, file)
    if faults or not image.GetNumberOfPoints():
        raise BenchError(f"{file.path}: cannot be read as {_kind(file)}")
    return image


def _read_by_plugin(file: VolumeFile, plugin_readers: PluginReaders) -> vtkImageData:
    """Read by a reader whose errors name the file and its fault themselves."""
    if file.path.suffix not in plugin_readers:
        raise BenchError(f"{file.path}: {file.path.suffix} files need the plugin")
    image, faults = _updated(plugin_readers[file.path.suffix](), file)
    if faults:
        raise BenchError(faults[0].rpartition("): ")[2])
    return image


def _updated(reader: Any, file: VolumeFile) -> tuple[vtkImageData, list[str]]:
    """Return what a reader gives and the errors that it reports, which are not printed."""
    faults: list[str] = []

    def keep(_caller: Any, _event: str, message: str = "") -> None:
        faults.append(message)

    keep.CallDataType = VTK_STRING
    reader.AddObserver("ErrorEvent", keep)
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        reader.SetFileName(str(file.path))
        reader.Update()
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
    image = vtkImageData()
    image.ShallowCopy(reader.GetOutputDataObject(0))
    return image, faults


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
