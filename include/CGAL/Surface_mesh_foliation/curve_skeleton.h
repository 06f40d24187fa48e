// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_CURVE_SKELETON_H
#define CGAL_SURFACE_MESH_FOLIATION_CURVE_SKELETON_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Added_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/use.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationGraph
/// holds the properties of a vertex of a curve skeleton.
template <class TriangleMesh>
struct Curve_skeleton_point
{
  typename Loop_system<TriangleMesh>::Point point; ///< where it is

  /// the vertices of the mesh around it
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices;

  double radius = 0; ///< the radius of its leaf: the thickness of the shape there

  /// the node that it stands for, or the arc that its leaf lies in
  typename Measured_foliation<TriangleMesh>::Cell cell = {};

  /// the distance of its leaf from end 0 of the arc, one of `Reeb_graph_embedding::levels`; 0 if it
  /// is a node
  double level = 0;
};

/// \ingroup PkgSurfaceMeshFoliationGraph
/// is the default type of a curve skeleton. Code written for
/// `CGAL::Mean_curvature_flow_skeletonization::Skeleton` can use it.
template <class TriangleMesh>
using Curve_skeleton = boost::
  adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Curve_skeleton_point<TriangleMesh>>;

namespace internal {

template <class Bundle, class = void>
struct Has_radius : std::false_type
{};

template <class Bundle>
struct Has_radius<Bundle, std::void_t<decltype(std::declval<Bundle&>().radius = 0.)>>
  : std::true_type
{};

template <class Bundle, class Cell, class = void>
struct Has_cell_and_level : std::false_type
{};

template <class Bundle, class Cell>
struct Has_cell_and_level<Bundle,
                          Cell,
                          std::void_t<decltype(std::declval<Bundle&>().cell = std::declval<Cell>()),
                                      decltype(std::declval<Bundle&>().level = 0.)>>
  : std::true_type
{};

// The points of an embedding by number: first the nodes, then the samples between them, arc by arc.
template <class Point>
class Skeleton_numbers
{
public:
  template <class TriangleMesh>
  Skeleton_numbers(const Measured_foliation<TriangleMesh>& foliation,
                   const Reeb_graph_embedding<Point>& embedding)
    : m_embedding(embedding), m_first{embedding.node_points.size()}
  {
    const auto& system = foliation.system();
    require_parameter(embedding.node_points.size() == system.number_of_nodes() &&
                        embedding.levels.size() == system.number_of_arcs(),
                      "the embedding is that of another foliation");
    for (std::size_t a = 0; a < embedding.levels.size(); ++a)
      m_first.push_back(m_first[a] + embedding.levels[a].size());
  }

  std::size_t size() const { return m_first.back(); }
  std::size_t of_sample(std::size_t arc, std::size_t i) const { return m_first[arc] + i; }

  // the point whose level is nearest to that of a vertex; of equally near ones, the lower
  template <class TriangleMesh>
  std::size_t nearest(const Measured_foliation<TriangleMesh>& foliation,
                      typename boost::graph_traits<TriangleMesh>::vertex_descriptor v) const
  {
    const auto cell = foliation.cell(v);
    if (!cell.is_arc)
      return cell.index;
    const auto& system = foliation.system();
    const std::vector<double>& levels = m_embedding.levels[cell.index];
    const double t = foliation.parameter(v);
    const auto above = std::lower_bound(levels.begin(), levels.end(), t);
    const double next = above == levels.end() ? system.height(cell.index) : *above;
    const double previous = above == levels.begin() ? 0 : *(above - 1);
    const std::size_t i = above - levels.begin();
    if (t - previous <= next - t)
      return i == 0 ? system.node(cell.index, 0) : of_sample(cell.index, i - 1);
    return i == levels.size() ? system.node(cell.index, 1) : of_sample(cell.index, i);
  }

private:
  const Reeb_graph_embedding<Point>& m_embedding;
  std::vector<std::size_t> m_first; // by arc: the number of its first sample
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationGraph

writes to each vertex of the mesh the point of an embedded Reeb graph that stands for the surface
around it: the node if the vertex lies on a critical leaf; otherwise, among the samples of its arc
and the nodes at the ends of the arc, the one whose level is nearest to that of the vertex.

Points are numbered from 0: first the nodes, in the order of the loop system, then the samples, arc
by arc. So point number `p` is vertex `p` of `curve_skeleton()` in an empty graph.

\tparam VertexSampleMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `std::size_t` as value
  type
\param foliation the foliation
\param embedding an embedding of its Reeb graph
\param map where the numbers are written

\returns the number of points

\throws Invalid_parameter_exception if the embedding and the foliation have different numbers of
  nodes or arcs

The time is \f$O(n \log s)\f$ for \f$n\f$ vertices and \f$s\f$ samples in an arc.
*/
template <class TriangleMesh, class VertexSampleMap>
std::size_t vertex_samples(
  const Measured_foliation<TriangleMesh>& foliation,
  const Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point>& embedding,
  VertexSampleMap map)
{
  const internal::Skeleton_numbers<typename Loop_system<TriangleMesh>::Point> numbers(foliation,
                                                                                      embedding);
  for (const auto v : vertices(foliation.mesh()))
    put(map, v, numbers.nearest(foliation, v));
  return numbers.size();
}

/*!
\ingroup PkgSurfaceMeshFoliationGraph

appends an embedded Reeb graph to a graph as a curve skeleton: a vertex for each node and each
sampled leaf, in the order described at `vertex_samples()`, joined along the arcs, each with its
point, the arc or node that it belongs to, its level there, and the vertices of the mesh that belong
to it. Every vertex of the mesh belongs to exactly one vertex of the skeleton.

\tparam Skeleton a model of `boost::MutableGraph` and `boost::MutablePropertyGraph` that allows
  parallel edges and self-loops, whose bundled vertex property has the members `point`, a point, and
  `vertices`, a `std::vector` of vertex descriptors of the mesh, such as `Curve_skeleton` or
  `CGAL::Mean_curvature_flow_skeletonization<TriangleMesh>::%Skeleton`. A member `radius`, if there
  is one, is set too, and so are members `cell`, a `Measured_foliation::Cell`, and `level`, if there
  are both.
\param foliation the foliation
\param embedding an embedding of its Reeb graph
\param skeleton the graph to append to

\returns the vertex descriptors, by number

\throws Invalid_parameter_exception as `vertex_samples()`

If anything is thrown, `skeleton` is unchanged.

Time and memory are linear in the size of the result, except for `vertex_samples()`.
*/
template <class TriangleMesh, class Skeleton>
std::vector<typename boost::graph_traits<Skeleton>::vertex_descriptor> curve_skeleton(
  const Measured_foliation<TriangleMesh>& foliation,
  const Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point>& embedding,
  Skeleton& skeleton)
{
  using Point = typename Loop_system<TriangleMesh>::Point;
  using Cell = typename Measured_foliation<TriangleMesh>::Cell;
  using Vertex = typename boost::graph_traits<Skeleton>::vertex_descriptor;
  const internal::Skeleton_numbers<Point> numbers(foliation, embedding);
  internal::Added_nodes<Skeleton> added(skeleton, numbers.size());
  const auto add = [&](const Point& point, double radius, const Cell& cell, double level) {
    const Vertex result = added.add();
    auto& bundle = skeleton[result];
    using Bundle = std::decay_t<decltype(bundle)>;
    bundle.point = point;
    if constexpr (internal::Has_radius<Bundle>::value)
      bundle.radius = radius;
    else
      CGAL_USE(radius);
    if constexpr (internal::Has_cell_and_level<Bundle, Cell>::value)
    {
      bundle.cell = cell;
      bundle.level = level;
    }
    else
    {
      CGAL_USE(cell);
      CGAL_USE(level);
    }
    return result;
  };
  for (std::size_t r = 0; r < embedding.node_points.size(); ++r)
    add(embedding.node_points[r], embedding.node_radii[r], {false, r}, 0);
  for (std::size_t a = 0; a < embedding.levels.size(); ++a)
  {
    Vertex previous = added[foliation.system().node(a, 0)];
    for (std::size_t i = 0; i < embedding.levels[a].size(); ++i)
    {
      const Vertex next = add(embedding.arc_polylines[a][i + 1], embedding.leaf_radii[a][i],
                              {true, a}, embedding.levels[a][i]);
      add_edge(previous, next, skeleton);
      previous = next;
    }
    add_edge(previous, added[foliation.system().node(a, 1)], skeleton);
  }
  for (const auto v : vertices(foliation.mesh()))
    skeleton[added[numbers.nearest(foliation, v)]].vertices.push_back(v);
  return added.keep();
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_CURVE_SKELETON_H
