// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_EMBEDDING_H
#define CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_EMBEDDING_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Arc_embedding.h>
#include <CGAL/Surface_mesh_foliation/internal/user_count.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationGraph

is the Reeb graph of a foliation embedded in space [Section 5.4 of the paper].
*/
template <class Point>
struct Reeb_graph_embedding
{
  /// by node: the centroid of the critical leaf, weighted by length; a pole at a vertex is its own
  std::vector<Point> node_points;

  /// by arc: the point of the node at end 0, the centroids of sampled leaves, the point of the node
  /// at end 1
  std::vector<std::vector<Point>> arc_polylines;

  /// by arc: the levels of the sampled leaves, ascending
  std::vector<std::vector<double>> levels;

  /// by arc: the lengths of the sampled leaves
  std::vector<std::vector<double>> leaf_lengths;
};

/*!
\ingroup PkgSurfaceMeshFoliationGraph

embeds the Reeb graph of a foliation [Section 5.4]: nodes and arcs as centroids of leaves, weighted
by length.

\param foliation the foliation
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{number_of_samples}
    \cgalParamDescription{the number of leaves sampled in each arc; fewer where levels cannot be
      told
      apart}
    \cgalParamType{`int`, not negative}
    \cgalParamDefault{`20`}
  \cgalParamNEnd
  \cgalParamNBegin{use_uniform_levels}
    \cgalParamDescription{`true` samples at equal differences of the transverse measure, as the
      paper
      does; the samples crowd near poles, where the measure behaves like a logarithm of the
      distance. `false` spaces the samples evenly along the embedded arc.}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_parameter_exception if the number of samples is negative

The time is linear in the size of the mesh and the sizes of the sampled leaves.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point> reeb_graph_embedding(
  const Measured_foliation<TriangleMesh>& foliation,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Point = typename Loop_system<TriangleMesh>::Point;
  internal::check_parameters<internal_np::number_of_samples_t, internal_np::use_uniform_levels_t>(
    np);
  const int number =
    internal::user_count(choose_parameter(get_parameter(np, internal_np::number_of_samples), 20));
  if (number < 0)
    throw Invalid_parameter_exception(
      {Problem_kind::INVALID_PARAMETER, "the number of samples is negative", {}, {}, {}});

  const internal::Arc_embedding embedding(foliation.state(),
                                          foliation.certificate().refined_mesh());
  const auto samples = choose_parameter(get_parameter(np, internal_np::use_uniform_levels), false)
                         ? embedding.uniform_samples(number)
                         : embedding.even_samples(number);
  const auto point = [](const internal::Point& p) { return Point(p[0], p[1], p[2]); };

  Reeb_graph_embedding<Point> result;
  for (const internal::Point& p : embedding.node_points())
    result.node_points.push_back(point(p));
  for (std::size_t a = 0; a < samples.size(); ++a)
  {
    result.levels.emplace_back();
    result.leaf_lengths.emplace_back();
    result.arc_polylines.push_back({result.node_points[foliation.system().node(a, 0)]});
    for (const auto& sample : samples[a])
    {
      result.levels.back().push_back(sample.level);
      result.leaf_lengths.back().push_back(sample.length);
      result.arc_polylines.back().push_back(point(sample.point));
    }
    result.arc_polylines.back().push_back(result.node_points[foliation.system().node(a, 1)]);
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_EMBEDDING_H
