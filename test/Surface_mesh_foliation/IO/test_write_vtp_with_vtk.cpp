// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/temporary_folder.h"
#include "include/vtp_file.h"
#include "include/vtp_writers.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace test_write_vtp_with_vtk {

// VTK reads from the files what the other reader of the tests reads from them, and what is in them
// is tested there.

namespace {

using smf_test::Example;
using smf_test::Vtp_file;

void expect_cells(vtkCellArray* found, const Vtp_file::Cells& expected)
{
  ASSERT_EQ(found->GetNumberOfCells(), static_cast<vtkIdType>(expected.size()));
  vtkNew<vtkIdList> points;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    found->GetCellAtId(static_cast<vtkIdType>(i), points);
    ASSERT_EQ(points->GetNumberOfIds(), static_cast<vtkIdType>(expected[i].size()));
    for (std::size_t j = 0; j < expected[i].size(); ++j)
      EXPECT_EQ(points->GetId(static_cast<vtkIdType>(j)), static_cast<vtkIdType>(expected[i][j]));
  }
}

void expect_arrays(vtkDataSetAttributes* found,
                   const std::map<std::string, Vtp_file::Numbers>& expected,
                   const std::map<std::string, std::string>& types)
{
  EXPECT_EQ(found->GetNumberOfArrays(), static_cast<int>(expected.size()));
  for (const auto& [name, numbers] : expected)
  {
    vtkDataArray* array = found->GetArray(name.c_str());
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), 1);
    ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(numbers.size())) << name;
    EXPECT_EQ(vtkDoubleArray::SafeDownCast(array) != nullptr, types.at(name) == "Float64") << name;
    EXPECT_EQ(vtkIntArray::SafeDownCast(array) != nullptr, types.at(name) == "Int32") << name;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      EXPECT_EQ(array->GetComponent(static_cast<vtkIdType>(i), 0), numbers[i]) << name;
  }
}

void expect_equal(const std::string& file_name)
{
  const Vtp_file expected(file_name);
  vtkNew<vtkXMLPolyDataReader> reader;
  ASSERT_TRUE(reader->CanReadFile(file_name.c_str()));
  reader->SetFileName(file_name.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0u);
  vtkPolyData* found = reader->GetOutput();
  ASSERT_EQ(found->GetNumberOfPoints(), static_cast<vtkIdType>(expected.points.size()));
  for (std::size_t i = 0; i < expected.points.size(); ++i)
    for (int k : {0, 1, 2})
      EXPECT_EQ(found->GetPoint(static_cast<vtkIdType>(i))[k],
                expected.points[i][static_cast<std::size_t>(k)]);
  expect_cells(found->GetVerts(), expected.vertices);
  expect_cells(found->GetLines(), expected.lines);
  expect_cells(found->GetPolys(), expected.polygons);
  EXPECT_EQ(found->GetNumberOfStrips(), 0);
  expect_arrays(found->GetPointData(), expected.point_arrays, expected.types);
  expect_arrays(found->GetCellData(), expected.cell_arrays, expected.types);
}

class Vtp_file_of_example : public ::testing::TestWithParam<Example>
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Vtp_file_of_example,
                         ::testing::ValuesIn(smf_test::example_systems()),
                         smf_test::name_of_example);

TEST_P(Vtp_file_of_example, is_read_by_vtk)
{
  const smf_test::Temporary_folder folder;
  const smf_test::Vtp_writers<> writers(GetParam());
  for (const auto& [what, write] : writers.all())
  {
    SCOPED_TRACE(what);
    write(folder.file_name(what));
    expect_equal(folder.file_name(what));
  }
}

} // namespace

} // namespace test_write_vtp_with_vtk
