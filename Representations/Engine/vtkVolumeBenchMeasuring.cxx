#include "vtkVolumeBenchMeasuring.h"

void vtkVolumeBenchMeasuring::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CountSamples: " << this->CountSamples << "\n";
  os << indent << "Show: " << this->Show << "\n";
  os << indent << "TimeStages: " << this->TimeStages << "\n";
  os << indent << "TimeFrames: " << this->TimeFrames << "\n";
}
