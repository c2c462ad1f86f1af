// Images cut to a part of their extent, and put together again from parts.
#ifndef volumebench_ImagePieces_h
#define volumebench_ImagePieces_h

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkImageData;

namespace volumebench
{
using Images = std::vector<vtkSmartPointer<vtkImageData>>;

/// The extent (of points) without the layers of cells that another block or rank holds as well.
void OwnExtentOf(vtkImageData* image, int own[6]);

/// The part of an image in an extent that lies in its own.
vtkSmartPointer<vtkImageData> PieceOf(vtkImageData* image, const int extent[6]);

/// Points from the first to the last index along each axis.
using Extent = std::array<int, 6>;

/// Whether the images lie on one lattice and fill a box without sharing a cell, whatever their
/// values.
bool FillBox(const Images& images);

/// Whether two images have more than a face in common; of those whose axes have the same
/// directions.
bool AnyOverlap(const Images& images);

/// The box round images on one lattice, counted from the origin of another on it.
Extent BoxRound(const Images& images, vtkImageData* base);

/// Equal for images whose arrays can be joined.
std::size_t SignatureOfArrays(vtkImageData* image);

/// One image in place of pieces that lie on one lattice, have the same arrays and fill a box
/// without overlapping, with the first one's field data; the pieces as they are otherwise. Takes
/// memory for a copy of all.
Images Joined(const Images& pieces);
}

#endif
