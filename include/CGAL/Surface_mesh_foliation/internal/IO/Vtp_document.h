// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_VTP_DOCUMENT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_VTP_DOCUMENT_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Points, cells and numbers that belong to them, for a file in VTK's XML format for PolyData. All
// arrays are text with 17 digits, so that readers get every number back.
class Vtp_document
{
public:
  void add_point(const Point& p)
  {
    append_number(m_points, p[0]);
    m_points += ' ';
    append_number(m_points, p[1]);
    m_points += ' ';
    append_number(m_points, p[2]);
    m_points += '\n';
    ++m_number_of_points;
  }

  template <class PointType>
  void add_point(const PointType& p)
  {
    add_point(Point{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
  }

  std::size_t number_of_points() const { return m_number_of_points; }

  // Cells are numbered in the order vertices, lines, polygons, each in the order of addition.
  void add_vertex(std::size_t point) { m_vertices.add({point}); }
  void add_line(const std::vector<std::size_t>& points) { m_lines.add(points); }
  void add_polygon(const std::vector<std::size_t>& points) { m_polygons.add(points); }

  // by point
  template <class Number>
  void add_point_array(const std::string& name, const std::vector<Number>& numbers)
  {
    CGAL_assertion(numbers.size() == m_number_of_points);
    m_point_arrays += array(name, numbers);
  }

  // by cell
  template <class Number>
  void add_cell_array(const std::string& name, const std::vector<Number>& numbers)
  {
    CGAL_assertion(numbers.size() == m_vertices.size() + m_lines.size() + m_polygons.size());
    m_cell_arrays += array(name, numbers);
  }

  void write(std::ostream& output) const
  {
    output << "<?xml version=\"1.0\"?>\n"
              "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
              "<PolyData>\n<Piece NumberOfPoints=\""
           << m_number_of_points << "\" NumberOfVerts=\"" << m_vertices.size()
           << "\" NumberOfLines=\"" << m_lines.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
           << m_polygons.size() << "\">\n<PointData>\n"
           << m_point_arrays << "</PointData>\n<CellData>\n"
           << m_cell_arrays << "</CellData>\n<Points>\n"
           << "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\""
              " format=\"ascii\">\n"
           << m_points << "</DataArray>\n</Points>\n";
    m_vertices.write("Verts", output);
    m_lines.write("Lines", output);
    m_polygons.write("Polys", output);
    output << "</Piece>\n</PolyData>\n</VTKFile>\n";
  }

private:
  class Cells
  {
  public:
    void add(const std::vector<std::size_t>& points)
    {
      m_points.insert(m_points.end(), points.begin(), points.end());
      m_ends.push_back(m_points.size());
    }

    std::size_t size() const { return m_ends.size(); }

    void write(const char* name, std::ostream& output) const
    {
      output << '<' << name << ">\n"
             << array("connectivity", m_points) << array("offsets", m_ends) << "</" << name
             << ">\n";
    }

  private:
    std::vector<std::size_t> m_points, m_ends;
  };

  static const char* type(double) { return "Float64"; }
  static const char* type(int) { return "Int32"; }
  static const char* type(std::size_t) { return "Int64"; }

  static void append(std::string& text, double number) { append_number(text, number); }
  static void append(std::string& text, int number) { text += std::to_string(number); }
  static void append(std::string& text, std::size_t number) { text += std::to_string(number); }

  template <class Number>
  static std::string array(const std::string& name, const std::vector<Number>& numbers)
  {
    constexpr std::size_t numbers_per_line = 12;
    std::string text = std::string("<DataArray type=\"") + type(Number()) + "\" Name=\"" + name +
                       "\" format=\"ascii\">\n";
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      append(text, numbers[i]);
      text += (i + 1) % numbers_per_line == 0 || i + 1 == numbers.size() ? '\n' : ' ';
    }
    return text + "</DataArray>\n";
  }

  std::size_t m_number_of_points = 0;
  std::string m_points, m_point_arrays, m_cell_arrays;
  Cells m_vertices, m_lines, m_polygons;
};

inline void write_vtp(const std::string& file_name, const Vtp_document& document)
{
  write_file(file_name, [&](std::ostream& output) { document.write(output); });
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_VTP_DOCUMENT_H
