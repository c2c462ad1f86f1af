/**
 * @class   vtkVolumeBenchStability
 * @brief   tries techniques with the numbered stability cases
 *
 * A source without input: every case makes its own scene, draws it in a window of the source's own
 * and compares the picture with what it must be. The output is a table with one row per case,
 * technique and integrator; see Stability/StabilityTable.h for its columns. An empty list of
 * techniques, integrators or cases stands for all that there is.
 */
#ifndef vtkVolumeBenchStability_h
#define vtkVolumeBenchStability_h

#include "VolumeBenchBenchmarkModule.h"

#include "vtkTableAlgorithm.h"

#include <string> // for names
#include <vector> // for lists

class VOLUMEBENCHBENCHMARK_EXPORT vtkVolumeBenchStability : public vtkTableAlgorithm
{
public:
  static vtkVolumeBenchStability* New();
  vtkTypeMacro(vtkVolumeBenchStability, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Ids of techniques and of VTK's own mappers, vtk-gpu and vtk-fixed-point. Default: all.
   */
  void AddTechnique(const char* id);
  void ClearTechniques();
  ///@}

  ///@{
  /**
   * Names of integrators. Default: all.
   */
  void AddIntegrator(const char* name);
  void ClearIntegrators();
  ///@}

  ///@{
  /**
   * Numbers of cases. Default: all.
   */
  void AddCase(int number);
  void ClearCases();
  ///@}

  ///@{
  /**
   * Leaves out what takes long within a case. Default off.
   */
  vtkSetMacro(Quick, bool);
  vtkGetMacro(Quick, bool);
  vtkBooleanMacro(Quick, bool);
  ///@}

protected:
  vtkVolumeBenchStability();
  ~vtkVolumeBenchStability() override;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* output) override;

private:
  vtkVolumeBenchStability(const vtkVolumeBenchStability&) = delete;
  void operator=(const vtkVolumeBenchStability&) = delete;

  std::vector<std::string> Techniques;
  std::vector<std::string> Integrators;
  std::vector<int> Cases;
  bool Quick = false;
};

#endif
