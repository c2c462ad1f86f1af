"""Blocks of image data that the test places on ranks, in composite data sets of all kinds."""

from typing import Any

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkDataObjectTypes

# Places blocks of one field, 10 long and 16 wide, on ranks: those along x that this rank holds are
# named by an expression of `rank` and `ranks`, as (place, voxels per unit of length).
SCRIPT = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkUniformGrid
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
rank, ranks = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
FINE = {fine}


def field(x, y, z):
    return 150 + 60 * np.sin(0.35 * x) * np.cos(0.3 * y) + 50 * np.cos(0.4 * z + 0.1 * x)


def block_at(place):
    image = vtkUniformGrid()
    fine = 2 if place in FINE else 1
    first = int(10 * place * fine)
    image.SetSpacing(3 * [1 / fine])
    image.SetExtent(first, first + 10 * fine, 0, 16 * fine, 0, 16 * fine)
    axes = [np.arange(16 * fine + 1), np.arange(16 * fine + 1), np.arange(first, first + 10 * fine + 1)]
    z, y, x = (values / fine for values in np.meshgrid(*axes, indexing="ij"))
    values = (field(x, y, z) {change}).astype(np.float32)
    for name in ["RTData", *({other})]:
        array = numpy_to_vtk(values.ravel(), deep=True)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    return image


held = [(place, block_at(place)) for place in ({held})]
output = self.GetOutputDataObject(0)
if output.IsA("vtkPartitionedDataSet"):
    for number, (place, block) in enumerate(held):
        output.SetPartition(number, block)
elif output.IsA("vtkMultiBlockDataSet"):
    output.SetNumberOfBlocks(4)
    for place, block in held:
        output.SetBlock(int(place), block)
else:
    PLACES = {places}
    levels = [[place for place in PLACES if (place in FINE) == fine] for fine in (False, True)]
    output.Initialize(2, [len(level) for level in levels])
    for place, block in held:
        fine = int(place in FINE)
        output.SetDataSet(fine, levels[fine].index(place), block)
"""

IN_ORDER = "[p for p in range(4) if p * ranks // 4 == rank]"


def blocks_held(
    held: str = IN_ORDER,
    kind: str = "vtkPartitionedDataSet",
    fine: tuple[float, ...] = (),
    places: tuple[float, ...] = (0, 1, 2, 3),
    other: str = "[]",
    change: str = "",
) -> Any:
    """Return a data set of which each rank holds the blocks at the places that `held` names.

    Those at the places `fine` have twice as many points to a length. The expression `other` names
    more arrays of this rank's blocks, and what `change` says is done to all values.
    """
    source = simple.ProgrammableSource()
    source.SMProxy.GetProperty("OutputDataSetType").SetElement(
        0, vtkDataObjectTypes.GetTypeIdFromClassName(kind)
    )
    source.Script = SCRIPT.format(
        held=held, fine=fine, places=places, other=other, change=change
    )
    source.UpdatePipeline()
    return source
