#include "ExperimentNotes.h"

#include "JsonText.h"
#include "ResultTable.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

namespace volumebench
{
namespace
{
std::string Note(const std::string& event, int run, const JsonMember& more)
{
  return JsonObject({ { "event", JsonString(event) }, { "run", std::to_string(run) }, more });
}

template <typename Values, typename Text>
std::string List(const Values& values, Text text)
{
  std::string list;
  for (const auto value : values)
  {
    list += (list.empty() ? "" : ", ") + text(value);
  }
  return "[" + list + "]";
}

template <typename Value>
std::vector<Value> From(const std::vector<Value>& values, std::size_t first)
{
  return { values.begin() + static_cast<std::ptrdiff_t>(first), values.end() };
}

std::string RowJson(vtkTable* table)
{
  std::vector<JsonMember> members;
  for (vtkIdType i = 0; i < table->GetNumberOfColumns(); ++i)
  {
    vtkAbstractArray* column = table->GetColumn(i);
    auto* numbers = vtkDoubleArray::SafeDownCast(column);
    members.push_back({ column->GetName(),
      numbers ? JsonNumber(numbers->GetValue(0))
              : JsonString(vtkStringArray::SafeDownCast(column)->GetValue(0)) });
  }
  return JsonObject(members);
}
}

std::string BeginNote(int run, const std::string& work)
{
  return Note("begin", run, { "work", JsonString(work) });
}

std::string FrameLogJson(const std::vector<int>& frames, const std::vector<double>& framesMs,
  const std::vector<double>& gpuMs)
{
  return JsonObject({ { "frame", List(frames, [](int frame) { return std::to_string(frame); }) },
    { "ms", List(framesMs, JsonNumber) }, { "gpu_ms", List(gpuMs, JsonNumber) } });
}

std::string FramesNote(int run, const std::vector<int>& frames, const std::vector<double>& framesMs,
  const std::vector<double>& gpuMs, std::size_t first)
{
  const std::string log =
    FrameLogJson(From(frames, first), From(framesMs, first), From(gpuMs, first));
  return Note("frames", run, { "log", log });
}

std::string RowNote(
  const std::string& event, int run, const RunResult& result, const ExperimentSettings& settings)
{
  vtkNew<vtkTable> table;
  FillResultTable({ result }, settings, "", table);
  return Note(event, run, { "row", RowJson(table) });
}
}
