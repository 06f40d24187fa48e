// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_READ_WITH_VTK_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_READ_WITH_VTK_H

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/face_messages.h>

#include <vtkCell.h>
#include <vtkCellType.h>
#include <vtkDataSet.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// \file
/// This header needs VTK, and is not included by `Surface_mesh_foliation.h`.

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// Takes the messages of VTK instead of the standard output, and learns whether one is an error.
class Vtk_messages : public vtkOutputWindow
{
public:
  static Vtk_messages* New() { return new Vtk_messages; }

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override { has_error = true; }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}

  bool has_error = false;
};

// for a while
class Vtk_message_guard
{
public:
  explicit Vtk_message_guard(Vtk_messages* messages)
    : m_before(vtkOutputWindow::GetInstance()),
      m_verbosity_before(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkOutputWindow::SetInstance(messages);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // it would log them as well
  }
  Vtk_message_guard(const Vtk_message_guard&) = delete;
  Vtk_message_guard& operator=(const Vtk_message_guard&) = delete;
  ~Vtk_message_guard()
  {
    vtkOutputWindow::SetInstance(m_before);
    vtkLogger::SetStderrVerbosity(m_verbosity_before);
  }

private:
  vtkSmartPointer<vtkOutputWindow> m_before;
  vtkLogger::Verbosity m_verbosity_before;
};

// the faces of a cell: one, or the triangles of a strip; none for points and lines
inline std::vector<std::vector<std::size_t>> faces_of_vtk_cell(const std::string& file_name,
                                                               vtkIdType number,
                                                               vtkCell& cell)
{
  std::vector<std::size_t> corners;
  for (vtkIdType i = 0; i < cell.GetNumberOfPoints(); ++i)
    corners.push_back(static_cast<std::size_t>(cell.GetPointId(i)));
  switch (cell.GetCellType())
  {
  case VTK_EMPTY_CELL:
  case VTK_VERTEX:
  case VTK_POLY_VERTEX:
  case VTK_LINE:
  case VTK_POLY_LINE:
    return {};
  case VTK_TRIANGLE:
  case VTK_QUAD:
  case VTK_POLYGON:
    return {corners};
  case VTK_PIXEL: // a quadrangle in another order
    std::swap(corners[2], corners[3]);
    return {corners};
  case VTK_TRIANGLE_STRIP: {
    std::vector<std::vector<std::size_t>> result;
    for (std::size_t i = 2; i < corners.size(); ++i)
      result.push_back({corners[i - 2 + i % 2], corners[i - 1 - i % 2], corners[i]});
    return result;
  }
  default:
    throw_file_problem(file_name, ": cell ", number,
                       " is neither a polygon nor a point nor a line");
  }
}

template <class Reader>
Polygon_soup read_soup_with_vtk(const std::string& file_name)
{
  vtkNew<Vtk_messages> messages;
  const Vtk_message_guard guard(messages);
  vtkNew<Reader> reader;
  reader->SetFileName(file_name.c_str());
  if (!reader->CanReadFile(file_name.c_str()))
    throw_file_problem(file_name, ": cannot be read, or is no such file of VTK");
  reader->Update();
  vtkDataSet* const data = reader->GetOutputAsDataSet();
  if (data == nullptr || messages->has_error || reader->GetErrorCode() != 0)
    throw_file_problem(file_name, ": VTK cannot read it");
  Polygon_soup result;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> point;
    data->GetPoint(i, point.data());
    result.points.push_back(point);
  }
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
    for (auto& face : faces_of_vtk_cell(file_name, i, *data->GetCell(i)))
      result.polygons.push_back(std::move(face));
  for (std::size_t f = 0; f < result.polygons.size(); ++f)
    for (const std::size_t v : result.polygons[f])
      if (v >= result.points.size())
        throw_file_problem(file_name, ": ",
                           index_range_message(f, std::to_string(v), result.points.size()));
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads the vertices and faces of a polygon mesh from a file in VTK's XML formats, `.vtp` (PolyData)
or `.vtu` (UnstructuredGrid), with the library VTK. Points and lines are skipped.

\param file_name the name of the file

\returns the vertices and faces, in the order of the file

\throws Invalid_file_exception if VTK cannot read the file, or if it has cells of other kinds, such
  as tetrahedra

\sa `read_polygon_soup()`
*/
inline Polygon_soup read_polygon_soup_with_vtk(const std::string& file_name)
{
  return internal::file_extension(file_name) == ".vtu"
           ? internal::read_soup_with_vtk<vtkXMLUnstructuredGridReader>(file_name)
           : internal::read_soup_with_vtk<vtkXMLPolyDataReader>(file_name);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_READ_WITH_VTK_H
