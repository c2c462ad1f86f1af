#include "vtkVolumeBenchStability.h"

#include "Names.h"
#include "Stability/StabilityRun.h"
#include "Stability/StabilityTable.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <stdexcept>

vtkStandardNewMacro(vtkVolumeBenchStability);

vtkVolumeBenchStability::vtkVolumeBenchStability()
{
  this->SetNumberOfInputPorts(0);
}

vtkVolumeBenchStability::~vtkVolumeBenchStability() = default;

void vtkVolumeBenchStability::AddTechnique(const char* id)
{
  this->Techniques.emplace_back(id ? id : "");
  this->Modified();
}

void vtkVolumeBenchStability::ClearTechniques()
{
  this->Techniques.clear();
  this->Modified();
}

void vtkVolumeBenchStability::AddIntegrator(const char* name)
{
  this->Integrators.emplace_back(name ? name : "");
  this->Modified();
}

void vtkVolumeBenchStability::ClearIntegrators()
{
  this->Integrators.clear();
  this->Modified();
}

void vtkVolumeBenchStability::AddCase(int number)
{
  this->Cases.push_back(number);
  this->Modified();
}

void vtkVolumeBenchStability::ClearCases()
{
  this->Cases.clear();
  this->Modified();
}

int vtkVolumeBenchStability::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkTable* table = vtkTable::GetData(outputVector, 0);
  try
  {
    volumebench::StabilitySettings settings;
    settings.Techniques = this->Techniques;
    for (const std::string& name : this->Integrators)
    {
      settings.Integrators.push_back(volumebench::IntegratorNames().NumberOf(name));
    }
    settings.Cases = this->Cases;
    settings.Quick = this->Quick;
    const auto results = volumebench::RunStability(settings,
      [this](double share)
      {
        this->UpdateProgress(share);
        return this->GetAbortExecute() == 0;
      });
    volumebench::FillStabilityTable(results, table);
  }
  catch (const std::exception& error)
  {
    // The pipeline goes on with an empty table: a failure would add a second, vaguer error.
    vtkErrorMacro("Nothing tried: " << error.what());
    table->Initialize();
  }
  return 1;
}

void vtkVolumeBenchStability::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Techniques:";
  for (const std::string& id : this->Techniques)
  {
    os << " " << id;
  }
  os << "\n" << indent << "Integrators:";
  for (const std::string& name : this->Integrators)
  {
    os << " " << name;
  }
  os << "\n" << indent << "Cases:";
  for (const int number : this->Cases)
  {
    os << " " << number;
  }
  os << "\n" << indent << "Quick: " << this->Quick << "\n";
}
