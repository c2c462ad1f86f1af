// The check of technique cuda as JSON and as a table for the screen.
#ifndef volumebench_CudaReport_h
#define volumebench_CudaReport_h

#include "CUDA/CudaCheck.h"

#include <nlohmann/json.hpp>

#include <string>

namespace volumebench
{
nlohmann::ordered_json CudaDocument(const CudaCheck& check, const nlohmann::ordered_json& context);

std::string CudaTable(const CudaCheck& check);

/// Whether all pictures and turns are right.
bool IsRight(const CudaCheck& check);
}

#endif
