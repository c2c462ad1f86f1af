#include "Scene/ScalarStatistics.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace volumebench;

namespace
{
// Long enough for several blocks and some values over.
vtkSmartPointer<vtkDataArray> RampOf(int type, vtkIdType count)
{
  vtkSmartPointer<vtkDataArray> values;
  values.TakeReference(vtkDataArray::CreateDataArray(type));
  values->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->SetComponent(i, 0, static_cast<double>(5 + (i * 7919) % 101));
  }
  return values;
}
}

TEST(ScalarStatistics, FindTheEndsWhereverTheyAre)
{
  constexpr vtkIdType Count = 20011;
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    for (vtkIdType place = 0; place < Count; place += 997)
    {
      auto values = RampOf(type, Count);
      values->SetComponent(place, 0, 3.0);
      values->SetComponent(Count - 1 - place, 0, 120.0);
      const ScalarStatistics found = ComputeStatistics(values, 0);
      ASSERT_EQ(found.Low, 3.0) << type << " at " << place;
      ASSERT_EQ(found.High, 120.0) << type << " at " << place;
      ASSERT_TRUE(found.AllFinite && found.AnyFinite);
    }
  }
}

TEST(ScalarStatistics, LeaveOutWhatIsNotFiniteWhereverItIs)
{
  constexpr vtkIdType Count = 20011;
  for (const double bad : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    for (const int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      for (vtkIdType place = 0; place < Count; place += 997)
      {
        auto values = RampOf(type, Count);
        values->SetComponent((place + Count / 2) % Count, 0, 3.0);
        values->SetComponent(place, 0, bad);
        const ScalarStatistics found = ComputeStatistics(values, 0);
        ASSERT_EQ(found.Low, 3.0) << bad << " at " << place;
        ASSERT_EQ(found.High, 105.0) << bad << " at " << place;
        ASSERT_FALSE(found.AllFinite);
      }
    }
  }
}

TEST(ScalarStatistics, AreOfOneComponentOrOfTheMagnitude)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(2);
  for (int i = 0; i < 9000; ++i)
  {
    vectors->InsertNextTuple2(3.0 * i, -4.0 * i);
  }
  EXPECT_EQ(ComputeStatistics(vectors, 0).High, 3.0 * 8999);
  EXPECT_EQ(ComputeStatistics(vectors, 1).Low, -4.0 * 8999);
  EXPECT_EQ(ComputeStatistics(vectors, -1).High, 5.0 * 8999);
  vectors->SetComponent(17, 1, std::nan(""));
  EXPECT_TRUE(ComputeStatistics(vectors, 0).AllFinite);
  EXPECT_FALSE(ComputeStatistics(vectors, -1).AllFinite);
}
