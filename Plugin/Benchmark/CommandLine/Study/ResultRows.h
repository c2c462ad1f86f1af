// Rows of results.json, with the keys and the order of Python/volumebench/results.py.
#ifndef volumebench_ResultRows_h
#define volumebench_ResultRows_h

#include "Study.h"
#include "VolumeFile.h"

class vtkTable;

namespace volumebench
{
/// A row without a measurement: "failed" or "unsupported", and why. `volume` is null when it could
/// not be read.
Json RowWithout(const Study& study, const StudyRun& run, const OpenVolume* volume,
  const std::string& status, const std::string& reason);

/// The rows of a scene's runs from what the benchmark filter measured, one a run; `reason` is told
/// of a run that the table lacks.
std::vector<Json> RowsOf(const Study& study, const std::vector<StudyRun>& runs,
  const OpenVolume& volume, vtkTable* table, const std::string& reason);
}

#endif
