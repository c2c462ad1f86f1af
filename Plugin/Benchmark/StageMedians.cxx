#include "StageMedians.h"

#include "JsonText.h"
#include "Statistics.h"

namespace volumebench
{
std::vector<StageTime> MedianStages(const std::vector<std::vector<StageTime>>& frames)
{
  std::vector<StageTime> medians;
  if (frames.empty())
  {
    return medians;
  }
  for (const StageTime& stage : frames.front())
  {
    std::vector<double> values;
    for (const std::vector<StageTime>& frame : frames)
    {
      for (const StageTime& other : frame)
      {
        if (other.Name == stage.Name)
        {
          values.push_back(other.Ms);
        }
      }
    }
    medians.push_back({ stage.Name, Summarize(values).Median });
  }
  return medians;
}

std::string StagesJson(const std::vector<StageTime>& stages)
{
  std::vector<JsonMember> members;
  for (const StageTime& stage : stages)
  {
    members.push_back({ stage.Name, JsonNumber(stage.Ms) });
  }
  return members.empty() ? std::string() : JsonObject(members);
}
}
