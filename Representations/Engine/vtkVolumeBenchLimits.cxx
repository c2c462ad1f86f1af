#include "vtkVolumeBenchLimits.h"

void vtkVolumeBenchLimits::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MemoryBudgetMiB: " << this->MemoryBudgetMiB << "\n";
  os << indent << "InteractiveFrameMs: " << this->InteractiveFrameMs << "\n";
  os << indent << "PreviewedStillMs: " << this->PreviewedStillMs << "\n";
}
