// A calibration as JSON and as a table for the screen.
#ifndef volumebench_CalibrationReport_h
#define volumebench_CalibrationReport_h

#include "Calibration.h"

#include <nlohmann/json.hpp>

#include <string>

namespace volumebench
{
/// The document that Python/volumebench/calibration_schema.json describes.
nlohmann::ordered_json CalibrationDocument(
  const Calibration& calibration, const nlohmann::ordered_json& context);

/// One line a path, format and order, a column a size, in millions of fetches a second.
std::string CalibrationTable(const Calibration& calibration);
}

#endif
