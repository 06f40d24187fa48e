// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Loaded_mesh.h"

#include "arrays.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/openings.h>
#include <CGAL/Surface_mesh_foliation/parts.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace smf_engine {

namespace {

auto any_surface()
{
  return SMF::parameters::allow_openings(true).allow_parts(true);
}

std::string counted(std::size_t number, const char* one, const char* several)
{
  return std::to_string(number) + ' ' + (number == 1 ? one : several);
}

// what a repair would report of a file; empty if it would do nothing or does not help
std::string reports_of_repair(const std::string& file)
{
  std::string result;
  try
  {
    const SMF::Repaired_soup repaired = SMF::repair_polygon_soup(SMF::read_polygon_soup(file));
    if (SMF::check_triangle_soup(repaired.soup, any_surface()).empty())
      for (const std::string& line : SMF::descriptions(repaired.report))
        result += (result.empty() ? "" : ", ") + line;
  }
  catch (const SMF::Foliation_exception&) // that cannot be repaired
  {}
  return result;
}

[[noreturn]] void refuse_file(const std::string& file,
                              const SMF::Foliation_exception& exception,
                              const std::string& advice)
{
  SMF::Problem problem = exception.problem();
  if (problem.message.find(file) != 0)
    problem.message.insert(0, file + ": ");
  problem.message += advice;
  throw SMF::Invalid_mesh_exception(problem);
}

void read_strictly(const std::string& file, Mesh& mesh)
{
  try
  {
    SMF::triangle_soup_to_triangle_mesh(SMF::read_triangle_soup(file), mesh, any_surface());
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    const std::string reports = reports_of_repair(file);
    refuse_file(file, exception,
                reports.empty() ? "" : "; switch on repair, which would report: " + reports);
  }
}

void read_and_repair(const std::string& file, Mesh& mesh, std::vector<std::string>& report)
{
  const SMF::Repaired_soup repaired = SMF::repair_polygon_soup(SMF::read_polygon_soup(file));
  report = SMF::descriptions(repaired.report);
  try
  {
    SMF::triangle_soup_to_triangle_mesh(repaired.soup, mesh, any_surface());
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    refuse_file(file, exception, ", even after the repair");
  }
}

// Vertices and faces keep their order.
SMF::Triangle_soup soup_of_part(const SMF::Mesh_part<Mesh>& part, const Mesh& mesh)
{
  SMF::Triangle_soup soup;
  std::vector<std::size_t> number(mesh.number_of_vertices());
  for (const Vertex v : vertices(part))
  {
    const Point& p = mesh.point(v);
    number[v] = soup.points.size();
    soup.points.push_back({p.x(), p.y(), p.z()});
  }
  for (const Face f : faces(part))
  {
    const std::array<Vertex, 3> corners = corners_of(f, mesh);
    soup.triangles.push_back({number[corners[0]], number[corners[1]], number[corners[2]]});
  }
  return soup;
}

std::size_t number_of_parts(Mesh& mesh)
{
  auto part = mesh.add_property_map<Face, std::size_t>("f:part", 0).first;
  const std::size_t number = CGAL::Polygon_mesh_processing::connected_components(mesh, part);
  mesh.remove_property_map(part);
  return number;
}

void keep_largest_part(const std::string& file, Mesh& mesh, std::vector<std::string>& report)
{
  const std::size_t number = number_of_parts(mesh);
  if (number == 1)
    return;
  if (number == mesh.number_of_faces())
    throw SMF::Invalid_mesh_exception(
      {SMF::Problem_kind::NOT_CONNECTED,
       file + ": the mesh is " + std::to_string(number) +
         " faces, of which no two share an edge; switch on repair, which merges vertices at equal "
         "positions",
       {},
       {},
       {}});
  const auto part = SMF::mesh_parts(mesh, SMF::parameters::number_of_parts(1)).front();
  Mesh largest;
  SMF::triangle_soup_to_triangle_mesh(soup_of_part(part, mesh), largest, any_surface());
  mesh = std::move(largest);
  report.push_back("of " + std::to_string(number) + " parts the largest was kept, with " +
                   counted(mesh.number_of_faces(), "face", "faces"));
}

void fill_openings(bool fills_all, Loaded_mesh& loaded)
{
  loaded.is_filled = loaded.mesh.add_property_map<Face, bool>("f:filled", false).first;
  if (CGAL::is_closed(loaded.mesh))
    return;
  const auto parameters = SMF::parameters::filled_face_map(loaded.is_filled);
  const std::size_t number =
    fills_all
      ? SMF::fill_openings(loaded.mesh,
                           parameters.max_opening_length(std::numeric_limits<double>::infinity()))
      : SMF::fill_openings(loaded.mesh, parameters);
  if (number > 0)
    loaded.report.push_back(counted(number, "opening was filled", "openings were filled"));
}

} // namespace

Loaded_mesh::Loaded_mesh(const std::string& file, bool repairs, bool fills_openings)
{
  if (repairs)
    read_and_repair(file, mesh, report);
  else
    read_strictly(file, mesh);
  keep_largest_part(file, mesh, report);
  fill_openings(fills_openings, *this);
  std::vector<SMF::Opening<Mesh>> all;
  SMF::openings(mesh, std::back_inserter(all));
  for (const SMF::Opening<Mesh>& opening : all)
    openings.push_back(opening.border);
}

std::size_t Loaded_mesh::genus() const
{
  // with a face in each opening
  const std::size_t faces = mesh.number_of_faces() + openings.size();
  return (2 + mesh.number_of_edges() - mesh.number_of_vertices() - faces) / 2;
}

Doubles Loaded_mesh::positions() const
{
  return positions_of(mesh);
}

Indices Loaded_mesh::triangles() const
{
  return triangles_of(mesh);
}

Indices Loaded_mesh::edges() const
{
  Indices result;
  result.reserve(2 * mesh.number_of_edges());
  for (const Edge e : mesh.edges())
    for (const unsigned int end : {0, 1})
      result.push_back(mesh.vertex(e, end));
  return result;
}

std::vector<Indices> Loaded_mesh::vertices_of_openings() const
{
  std::vector<Indices> result;
  for (const Halfedge border : openings)
  {
    result.emplace_back();
    for (const Vertex v : CGAL::vertices_around_face(border, mesh))
      result.back().push_back(v);
  }
  return result;
}

} // namespace smf_engine
