// Debian's build of VTK runs vtkSMPTools on one core unless told otherwise.
#ifndef volumebench_AllCores_h
#define volumebench_AllCores_h

#include "vtkSMPTools.h"

#include <string>

namespace volumebench
{
/// vtkSMPTools::For on all cores: by threads where the backend in use is Sequential, else by that.
template <typename Functor>
void ForOnAllCores(vtkIdType first, vtkIdType last, vtkIdType grain, Functor& functor)
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::LocalScope(vtkSMPTools::Config(backend == "Sequential" ? "STDThread" : backend),
    [&] { vtkSMPTools::For(first, last, grain, functor); });
}

template <typename Functor>
void ForOnAllCores(vtkIdType first, vtkIdType last, vtkIdType grain, const Functor& functor)
{
  Functor own = functor;
  ForOnAllCores(first, last, grain, own);
}
}

#endif
