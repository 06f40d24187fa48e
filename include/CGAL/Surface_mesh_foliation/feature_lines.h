// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FEATURE_LINES_H
#define CGAL_SURFACE_MESH_FOLIATION_FEATURE_LINES_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Blade_lines.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Normal_spreads.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationFeatures
/// is the width of blades that `detect_feature_lines()` looks for by default.
inline constexpr double default_blade_width = 0.06;

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

finds the rims of fins, wings and other blades, to be used as line poles [Section 4.2.1 of the
paper], and outputs one polyline per blade.

A point belongs to a blade if the part of the surface within a small ball around it has two sides:
their normals cancel, but all of them are nearly parallel, unlike those around a thin limb. The line
of a blade follows its rim, where normals cancel within a ball of a third of the radius, and is the
longest path along it between two vertices.

Each line is an induced path of at least two vertices and no two lines have a vertex in common, so
that `Poles_and_loops::add_line_pole()` accepts all of them; the ends of a line become thorn poles.
Poles that `detect_feature_poles()` finds on a blade, at its tip for instance, should then be left
out.

\tparam TriangleMesh see `Loop_system`
\param mesh a mesh that `Loop_system` accepts
\param out an output iterator for
  `std::vector<boost::graph_traits<TriangleMesh>::%vertex_descriptor>`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below. Lengths are given as multiples of the square root of the area of the surface.

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{as for `Loop_system`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{blade_width}
    \cgalParamDescription{the radius of the ball: blades are thinner than this}
    \cgalParamType{`double`, positive and finite}
    \cgalParamDefault{`default_blade_width`, 0.06}
  \cgalParamNEnd
  \cgalParamNBegin{blade_flatness}
    \cgalParamDescription{the least mean square of the unit normals in the ball along the direction
      in which it is largest: 1 for parallel sides, 1/2 for a thin limb with a round section}
    \cgalParamType{`double`, between 0 and 1}
    \cgalParamDefault{0.7}
  \cgalParamNEnd
  \cgalParamNBegin{least_line_length}
    \cgalParamDescription{the least length of a line}
    \cgalParamType{`double`, positive and finite}
    \cgalParamDefault{0.15}
  \cgalParamNEnd
  \cgalParamNBegin{decimation_threshold}
    \cgalParamDescription{the largest number of vertices of a mesh that is examined as it is. For a
      larger one, the places where normals cancel are found on a copy decimated to 10000 vertices;
      the lines still run along edges of the mesh itself.}
    \cgalParamType{`int`, at least 1000}
    \cgalParamDefault{20000}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the output iterator

\throws Invalid_mesh_exception if `Loop_system` would
\throws Invalid_parameter_exception if a parameter is out of its range

The time is proportional to the number of vertices in all balls together, plus \f$O(n \log n)\f$;
for a mesh that is decimated, it is \f$O(n \log n)\f$.
*/
template <class TriangleMesh,
          class LineOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
LineOutputIterator detect_feature_lines(
  const TriangleMesh& mesh,
  LineOutputIterator out,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using internal::require_parameter;
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::blade_width_t,
                             internal_np::blade_flatness_t, internal_np::least_line_length_t,
                             internal_np::decimation_threshold_t>(np);
  const double width =
    choose_parameter(get_parameter(np, internal_np::blade_width), default_blade_width);
  const double flatness = choose_parameter(get_parameter(np, internal_np::blade_flatness), 0.7);
  const double length = choose_parameter(get_parameter(np, internal_np::least_line_length), 0.15);
  const int threshold = internal::user_count(
    choose_parameter(get_parameter(np, internal_np::decimation_threshold), 20000));
  require_parameter(width > 0 && std::isfinite(width),
                    "the width of blades is not positive and finite");
  require_parameter(flatness >= 0 && flatness <= 1,
                    "the flatness of blades is not between 0 and 1");
  require_parameter(length > 0 && std::isfinite(length),
                    "the least length of a line is not positive and finite");
  require_parameter(threshold >= 1000, "the decimation threshold is below 1000 vertices");
  const auto checked = internal::Checked_mesh<TriangleMesh>::without_halfedges(mesh, np);
  checked.require_no_opening();
  const internal::Mesh_index<TriangleMesh>& mesh_index = checked.index;
  const internal::Flat_mesh& flat = checked.flat;
  const std::vector<internal::Point> points = internal::points_of_unit_size(flat);
  internal::Blade_measures measures = internal::blade_measures(flat, points, width, threshold);
  const double least_length = length * measures.unit;
  const internal::Blade_lines blades(flat, points, std::move(measures), flatness, least_length);
  for (const std::vector<int>& line : blades.lines())
  {
    std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> result;
    for (int v : line)
      result.push_back(mesh_index.vertex(v));
    *out++ = result;
  }
  return out;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FEATURE_LINES_H
