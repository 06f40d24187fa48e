// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_EMBEDDING_H
#define CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_EMBEDDING_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Arc_embedding.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
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

  /// by arc: the radii of the sampled leaves, the root mean square distances of their points to
  /// their centroids (for a circle, its radius)
  std::vector<std::vector<double>> leaf_radii;

  /// by node: the radius of the critical leaf, defined likewise; 0 for a pole at a vertex
  std::vector<double> node_radii;
};

namespace internal {

using Embedding_parameters = Parameter_list<internal_np::number_of_samples_t,
                                            internal_np::use_uniform_levels_t,
                                            internal_np::max_chord_deviation_t,
                                            internal_np::number_of_smoothing_steps_t>;

template <class Number>
int checked_count(Number number, const std::string& of_what)
{
  const int result = user_count(number);
  require_parameter(result >= 0, "the number of ", of_what, " is negative");
  return result;
}

template <class PointType>
PointType to_point(const Point& p)
{
  return PointType(p[0], p[1], p[2]);
}

// Moves all points except the ends to the means of themselves and their neighbors, with weights 1,
// 2 and 1: waves of two points vanish, and longer ones fade slowly.
inline void smooth(std::vector<Point>& polyline, int number_of_steps)
{
  for (int step = 0; step < number_of_steps; ++step)
  {
    Point before = polyline.front(); // the original position of the point before the current one
    for (std::size_t j = 1; j + 1 < polyline.size(); ++j)
    {
      const Point here = polyline[j];
      polyline[j] = coordinates(Eigen::Vector3d(to_vector(before) / 4 + to_vector(here) / 2 +
                                                to_vector(polyline[j + 1]) / 4));
      before = here;
    }
  }
}

// appends the arc through the samples between the points of two nodes
template <class PointType>
void append_arc(const std::vector<Arc_embedding::Sample>& samples,
                const Point& first,
                const Point& last,
                int number_of_smoothing_steps,
                Reeb_graph_embedding<PointType>& embedding)
{
  embedding.levels.emplace_back();
  embedding.leaf_lengths.emplace_back();
  embedding.leaf_radii.emplace_back();
  std::vector<Point> polyline = {first};
  for (const Arc_embedding::Sample& sample : samples)
  {
    embedding.levels.back().push_back(sample.level);
    embedding.leaf_lengths.back().push_back(sample.length);
    embedding.leaf_radii.back().push_back(sample.radius);
    polyline.push_back(sample.point);
  }
  polyline.push_back(last);
  smooth(polyline, number_of_smoothing_steps);
  embedding.arc_polylines.emplace_back();
  for (const Point& p : polyline)
    embedding.arc_polylines.back().push_back(to_point<PointType>(p));
}

} // namespace internal

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
      distinguished}
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
  \cgalParamNBegin{max_chord_deviation}
    \cgalParamDescription{More leaves are sampled, in the middle between others, where the centroid
      of a leaf between them is farther from their chord than this number times the radius of the
      leaf. So arcs have as many samples as their shape needs.}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{infinity: no more leaves are sampled}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_smoothing_steps}
    \cgalParamDescription{how many times the polylines are smoothed. A step moves each point except
      the two ends to the mean, \f$(p_{i-1} + 2 p_i + p_{i+1}) / 4\f$, of itself and its neighbors.
      Levels, lengths and radii remain those of the leaves.}
    \cgalParamType{`int`, not negative}
    \cgalParamDefault{`0`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_parameter_exception if the number of samples or of smoothing steps is negative, or
  the deviation is not positive

The time is linear in the size of the mesh and the sizes of the sampled leaves, and in the number of
smoothing steps times the number of samples.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point> reeb_graph_embedding(
  const Measured_foliation<TriangleMesh>& foliation,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Point = typename Loop_system<TriangleMesh>::Point;
  internal::check_parameters<internal::Embedding_parameters>(np);
  const int number = internal::checked_count(
    choose_parameter(get_parameter(np, internal_np::number_of_samples), 20), "samples");
  const int steps = internal::checked_count(
    choose_parameter(get_parameter(np, internal_np::number_of_smoothing_steps), 0),
    "smoothing steps");
  const double deviation = choose_parameter(get_parameter(np, internal_np::max_chord_deviation),
                                            std::numeric_limits<double>::infinity());
  internal::require_parameter(deviation > 0, internal::text("the largest deviation of a chord is ",
                                                            deviation, ", not positive"));

  const internal::Arc_embedding embedding(foliation.state(), foliation.extraction().refined_mesh);
  auto samples = choose_parameter(get_parameter(np, internal_np::use_uniform_levels), false)
                   ? embedding.uniform_samples(number)
                   : embedding.even_samples(number);
  if (std::isfinite(deviation))
    samples = embedding.refined(std::move(samples), deviation);

  Reeb_graph_embedding<Point> result;
  for (const internal::Centroid& node : embedding.nodes())
  {
    result.node_points.push_back(internal::to_point<Point>(node.point()));
    result.node_radii.push_back(node.radius());
  }
  for (std::size_t a = 0; a < samples.size(); ++a)
    internal::append_arc(samples[a], embedding.nodes()[foliation.system().node(a, 0)].point(),
                         embedding.nodes()[foliation.system().node(a, 1)].point(), steps, result);
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_REEB_GRAPH_EMBEDDING_H
