// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_LOOPS_H

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/all_vertices.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes loops to a text file from which `read_loops()` reads the same loops: one line
`crossing u0 v0 t0 u1 v1 t1 ...` for each.

\param file_name the name of the file
\param mesh the mesh that the loops lie on
\param loops the loops
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{numbered_vertices}
    \cgalParamDescription{the vertices that the numbers in the file mean, as for `read_loops()`}
    \cgalParamType{`std::vector` of `boost::graph_traits<TriangleMesh>::%vertex_descriptor`}
    \cgalParamDefault{`vertices(mesh)`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_file_exception if the file cannot be written, or if a vertex has no number

The time is linear in the size of the mesh and the lengths of the loops.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_loops(const std::string& file_name,
                 const TriangleMesh& mesh,
                 const std::vector<Loop<TriangleMesh>>& loops,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Traits = boost::graph_traits<TriangleMesh>;
  internal::check_parameters<internal_np::numbered_vertices_t>(np);
  constexpr int no_number = -1;
  const auto number = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
  for (const auto v : vertices(mesh))
    put(number, v, no_number);
  const std::vector<typename Traits::vertex_descriptor> numbered_vertices = choose_parameter(
    get_parameter(np, internal_np::numbered_vertices), internal::all_vertices(mesh));
  int next_number = 0;
  for (const auto v : numbered_vertices)
  {
    if (v != Traits::null_vertex() && get(number, v) == no_number)
      put(number, v, next_number);
    ++next_number;
  }
  const auto text_of = [&](const typename Traits::vertex_descriptor v) {
    if (get(number, v) == no_number)
      internal::throw_file_problem(file_name,
                                   ": a loop crosses an edge at a vertex without number");
    return std::to_string(get(number, v));
  };
  std::string text;
  for (const Loop<TriangleMesh>& loop : loops)
  {
    text += "crossing";
    for (const Crossing<TriangleMesh>& crossing : loop)
    {
      text += ' ' + text_of(source(crossing.halfedge, mesh)) + ' ' +
              text_of(target(crossing.halfedge, mesh)) + ' ';
      internal::append_number(text, crossing.position);
    }
    text += '\n';
  }
  internal::write_file(file_name, [&](std::ostream& output) { output << text; });
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_LOOPS_H
