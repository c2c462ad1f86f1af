// Fills a table column by column from a list of results.
#ifndef volumebench_TableColumns_h
#define volumebench_TableColumns_h

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <string>
#include <vector>

namespace volumebench
{
template <typename Row>
class TableColumns
{
public:
  /// Both must outlive this.
  TableColumns(const std::vector<Row>& rows, vtkTable* table)
    : Rows(rows)
    , Table(table)
  {
  }

  /// `get` turns a row into a std::string.
  template <typename Get>
  void Text(const char* name, Get get)
  {
    this->Add<vtkStringArray>(name, get);
  }

  /// `get` turns a row into a number; NaN is what was not measured.
  template <typename Get>
  void Number(const std::string& name, Get get)
  {
    this->Add<vtkDoubleArray>(name.c_str(), get);
  }

private:
  template <typename Array, typename Get>
  void Add(const char* name, Get get)
  {
    vtkNew<Array> column;
    column->SetName(name);
    for (const Row& row : this->Rows)
    {
      column->InsertNextValue(get(row));
    }
    this->Table->AddColumn(column);
  }

  const std::vector<Row>& Rows;
  vtkTable* Table;
};
}

#endif
