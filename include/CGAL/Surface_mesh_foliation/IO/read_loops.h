// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_READ_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_READ_LOOPS_H

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/all_vertices.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// Reads a loops file, one line at a time; a problem names the file and line.
template <class TriangleMesh, class NamedParameters>
class Loops_reader
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Traits::vertex_descriptor;

public:
  Loops_reader(const TriangleMesh& mesh,
               const NamedParameters& np,
               std::vector<vertex_descriptor> numbered_vertices,
               Poles_and_loops<TriangleMesh>& result)
    : m_mesh(mesh), m_np(np), m_vertices(std::move(numbered_vertices)), m_result(result)
  {}

  void read(std::istream& input, const std::string& name)
  {
    std::string line;
    for (std::size_t number = 1; std::getline(input, line); ++number)
    {
      m_place = name + ":" + std::to_string(number) + ": ";
      std::istringstream words(line.substr(0, line.find('#')));
      std::string kind;
      if (words >> kind)
        read_line(kind, words);
    }
    if (input.bad())
      throw_file_problem(name, ": cannot be read");
  }

private:
  [[noreturn]] void refuse(const std::string& what) const { throw_file_problem(m_place, what); }

  void read_line(const std::string& kind, std::istream& words)
  {
    try
    {
      if (kind == "cycle")
        m_result.add_loop(loop_from_edge_cycle(read_vertices(words), m_mesh));
      else if (kind == "through")
        m_result.add_loop(loop_through_vertices(read_vertices(words), m_mesh, m_np));
      else if (kind == "separate")
        add_separating_loops(read_vertices(words));
      else if (kind == "plane")
        add_plane_section(words);
      else if (kind == "crossing")
        m_result.add_loop(read_crossings(words));
      else
        refuse("unknown kind of loop " + internal::quoted(kind) +
               "; known are cycle, through, separate, plane and crossing");
    }
    catch (const Invalid_loops_exception& exception)
    {
      Problem problem = exception.problem();
      problem.message = m_place + problem.message;
      throw Invalid_loops_exception(std::move(problem));
    }
  }

  void add_separating_loops(const std::vector<vertex_descriptor>& inside)
  {
    std::vector<Loop<TriangleMesh>> loops;
    loops_around_vertices(inside, m_mesh, std::back_inserter(loops));
    if (loops.empty())
      refuse("these vertices have no boundary");
    for (Loop<TriangleMesh>& loop : loops)
      m_result.add_loop(std::move(loop));
  }

  void add_plane_section(std::istream& words)
  {
    std::array<double, 4> plane;
    std::string word;
    for (double& coefficient : plane)
      if (!(words >> word) || parse_number(word, coefficient) != Parse_status::OK ||
          !std::isfinite(coefficient))
        refuse("a plane needs four finite numbers and a vertex");
    const std::vector<vertex_descriptor> near = read_vertices(words);
    if (near.size() != 1)
      refuse("a plane needs four finite numbers and a vertex");
    m_result.add_loop(plane_section_loop(m_mesh, plane, near[0], m_np));
  }

  Loop<TriangleMesh> read_crossings(std::istream& words) const
  {
    Loop<TriangleMesh> result;
    std::string source, target, position;
    while (words >> source)
    {
      Crossing<TriangleMesh> crossing = {Traits::null_halfedge(), 0};
      if (!(words >> target >> position) ||
          parse_number(position, crossing.position) != Parse_status::OK)
        refuse("a crossing needs two vertices and a number");
      const auto [h, exists] = halfedge(vertex(source), vertex(target), m_mesh);
      if (!exists)
        refuse(text("no edge joins the vertices ", source, " and ", target));
      crossing.halfedge = h;
      result.push_back(crossing);
    }
    return result;
  }

  std::vector<vertex_descriptor> read_vertices(std::istream& words) const
  {
    std::vector<vertex_descriptor> result;
    std::string word;
    while (words >> word)
      result.push_back(vertex(word));
    if (result.empty())
      refuse("no vertex is given");
    return result;
  }

  vertex_descriptor vertex(const std::string& word) const
  {
    std::size_t v = 0;
    if (parse_number(word, v) != Parse_status::OK)
      refuse(internal::quoted(word) + " is not a vertex index");
    if (v >= m_vertices.size())
      refuse("there is no vertex " + std::to_string(v) + "; the mesh has " +
             std::to_string(m_vertices.size()));
    if (m_vertices[v] == Traits::null_vertex())
      refuse("vertex " + std::to_string(v) + " is no vertex of the repaired mesh");
    return m_vertices[v];
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  std::vector<vertex_descriptor> m_vertices; // by number
  Poles_and_loops<TriangleMesh>& m_result;
  std::string m_place;
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads loops from a text file and appends them to `loops`, with height 1. Each line is one of
- `cycle v0 v1 ...`: the edge cycle through these vertices, pushed off to its left
  (`loop_from_edge_cycle()`);
- `through v0 v1 ...`: the shortest loop along edges through these vertices
  (`loop_through_vertices()`);
- `separate v0 v1 ...`: the boundary of this set of vertices, one loop per boundary curve
  (`loops_around_vertices()`);
- `plane a b c d v`: the curve of the plane section `ax + by + cz + d = 0` nearest to vertex `v`
  (`plane_section_loop()`);
- `crossing u0 v0 t0 u1 v1 t1 ...`: the loop that crosses the edge from `u0` to `v0` at `t0` (0 at
  `u0`, 1 at `v0`) from left to right, then the edge from `u1` to `v1`, and so on; `v0`, `v1`, ...
  lie to its left (`Crossing`), as `write_loops()` writes it;
- an empty line. A `#` begins a comment.

A vertex is given by its position in `vertices(mesh)`, from 0, or in `numbered_vertices`.

\param file_name the name of the file
\param mesh a triangle mesh
\param loops the loops to append to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` as value
      type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{numbered_vertices}
    \cgalParamDescription{the vertices that the numbers in the file mean, for example those of the
      file that the mesh was repaired from; a null vertex where there is none}
    \cgalParamType{`std::vector` of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{`vertices(mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_file_exception, Invalid_loops_exception with a message of the form
  `FILE:LINE: what is wrong`; the loops of the lines before that one have been appended
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void read_loops(const std::string& file_name,
                const TriangleMesh& mesh,
                Poles_and_loops<TriangleMesh>& loops,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::numbered_vertices_t>(
    np);
  std::ifstream input(file_name);
  if (!input)
    internal::throw_file_problem(file_name, ": cannot be opened");
  const auto points = internal::select<CGAL::internal_np::vertex_point_t>(np);
  internal::Loops_reader<TriangleMesh, std::decay_t<decltype(points)>> reader(
    mesh, points,
    choose_parameter(get_parameter(np, internal_np::numbered_vertices),
                     internal::all_vertices(mesh)),
    loops);
  reader.read(input, file_name);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_READ_LOOPS_H
