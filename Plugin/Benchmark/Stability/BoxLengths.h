// The box of constant extinction in which a pixel's opacity tells the length of its ray.
#ifndef volumebench_BoxLengths_h
#define volumebench_BoxLengths_h

#include "Stability/Shot.h"
#include "Stability/Trial.h"

#include <string>

namespace volumebench
{
constexpr double BoxExtinction = 0.3; // at spacing 1

/// A field of zeros over 8 x 6 x 10 cells.
vtkSmartPointer<vtkImageData> MakeBoxImage();

/// Draws and notes the worst difference from 1 - exp(-extinction * L) and its colour, with L the
/// exact length of each pixel's ray in the image's bounds, in the data's own units when the actor
/// has a matrix. A hundred thousandth of a pixel to either side is allowed for: floats place no ray
/// that only grazes better.
void NoteBoxLengths(Trial& trial, const Shot& shot, double limit, const std::string& what,
  double extinction = BoxExtinction);
}

#endif
