// Images cut to a part of their extent, and put together again from parts.
#ifndef volumebench_ImagePieces_h
#define volumebench_ImagePieces_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkImageData;

namespace volumebench
{
using Images = std::vector<vtkSmartPointer<vtkImageData>>;

/// The extent (of points) without the layers of cells that another block or rank holds as well.
void OwnExtentOf(vtkImageData* image, int own[6]);

/// The part of an image in an extent that lies in its own.
vtkSmartPointer<vtkImageData> PieceOf(vtkImageData* image, const int extent[6]);

/// One image in place of pieces that lie on one lattice, have the same arrays and fill a box without
/// overlapping; the pieces as they are otherwise. Takes memory for a copy of all.
Images Joined(const Images& pieces);
}

#endif
