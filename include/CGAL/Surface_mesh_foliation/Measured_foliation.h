// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_MEASURED_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_MEASURED_FOLIATION_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/certify.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

template <class TriangleMesh>
struct Foliation_data
{
  Foliation_data(const Loop_system<TriangleMesh>& loop_system, std::vector<double> weights)
    : system(loop_system), state(system.data().flat, std::move(weights))
  {}

  Foliation_data(const Loop_system<TriangleMesh>& loop_system,
                 std::vector<double> weights,
                 Deck_cocycle deck)
    : system(loop_system), state(system.data().flat, std::move(weights), std::move(deck))
  {}

  Loop_system<TriangleMesh> system; // keeps alive what `state` refers to
  Foliation_state state;
  Foliation_statistics statistics;
  std::optional<Extraction> extraction; // when the solver has ended

  // what is wrong with the extraction
  std::vector<Problem> problems() const { return certify(state, *extraction); }
};

// also while the solver has not yet ended
template <class TriangleMesh, class EdgeValueMap>
void write_edge_values(const Loop_system<TriangleMesh>& system,
                       const Foliation_state& state,
                       EdgeValueMap map)
{
  for (int e = 0; e < state.mesh().number_of_edges(); ++e)
    if (system.data().mesh_index.has_edge(e))
      put(map, system.data().mesh_index.edge_descriptor_of(e), length_of_edge(state, e));
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

is a measured foliation [Section 3.2 of the paper] in the class of a loop system, as an equivariant
map from the mesh to the tree dual to the lifts of the loops: each vertex lies in an arc or at a
node, and each edge runs through a sequence of half-arcs. Its foliation value is the length of that
path.

It contains everything that the later stages need. Copies share their contents.

\tparam TriangleMesh see `Loop_system`
*/
template <class TriangleMesh>
class Measured_foliation
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

  /// is an arc or a node, given by its number in the loop system.
  struct Cell
  {
    bool is_arc;
    std::size_t index;
  };

  /// is a passage of a path between an arc and the node at one of its ends.
  struct Passage
  {
    std::size_t arc;
    int end;
  };

  /// returns the loop system that the foliation belongs to.
  const Loop_system<TriangleMesh>& system() const { return m_data->system; }

  /// returns the mesh.
  const TriangleMesh& mesh() const { return system().mesh(); }

  /// returns statistics on how the solver ended.
  const Foliation_statistics& statistics() const { return m_data->statistics; }

  /// returns the arc or node that a vertex lies in.
  Cell cell(vertex_descriptor v) const
  {
    const int i = index(v);
    return state().is_at_node(i) ? Cell{false, static_cast<std::size_t>(state().node(i))}
                                 : Cell{true, static_cast<std::size_t>(state().arc(i))};
  }

  /// returns the distance of a vertex from end 0 of its arc, strictly between 0 and the height of
  /// the arc; 0 if it lies at a node.
  double parameter(vertex_descriptor v) const { return state().parameter(index(v)); }

  /// returns the passages of the image of a halfedge, from source to target: empty if both lie in
  /// one lift of a cell; otherwise passages out of an arc and into an arc alternate. (Around a
  /// handle a path may leave an arc and come back to it.)
  std::vector<Passage> path(halfedge_descriptor h) const
  {
    const int i = m_data->system.data().mesh_index.index(h);
    std::vector<Passage> result;
    for (int j = 0; j < state().word_size(internal::edge_of(i)); ++j)
    {
      const internal::Letter letter = state().letter(i, j);
      result.push_back({static_cast<std::size_t>(state().arc_of_letter(letter)), letter.end()});
    }
    return result;
  }

  /// returns `path(halfedge(e, mesh()))`.
  std::vector<Passage> path(edge_descriptor e) const { return path(halfedge(e, mesh())); }

  /// returns the foliation value of an edge: the transverse measure of the leaves that cross it.
  double edge_value(edge_descriptor e) const
  {
    return internal::length_of_edge(state(), m_data->system.data().mesh_index.edge_index(e));
  }

  /// returns the sum of weight times foliation value over the edges that the middle leaf of an arc
  /// crosses; in the harmonic foliation it is the same for every leaf of the arc.
  double flux(std::size_t arc) const { return m_data->extraction->flux[arc]; }

  /// \cond SKIP_IN_MANUAL
  explicit Measured_foliation(std::shared_ptr<const internal::Foliation_data<TriangleMesh>> data)
    : m_data(std::move(data))
  {}
  const internal::Foliation_state& state() const { return m_data->state; }
  const internal::Extraction& extraction() const { return *m_data->extraction; }
  /// \endcond

private:
  int index(vertex_descriptor v) const { return m_data->system.data().mesh_index.index(v); }

  std::shared_ptr<const internal::Foliation_data<TriangleMesh>> m_data;
};

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

writes the foliation values of all edges to a property map, in linear time.

\tparam EdgeValueMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a type constructible from
  `double` as value type
*/
template <class TriangleMesh, class EdgeValueMap>
void edge_values(const Measured_foliation<TriangleMesh>& foliation, EdgeValueMap map)
{
  internal::write_edge_values(foliation.system(), foliation.state(), map);
}

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

writes the cells and parameters of all vertices to property maps, in linear time. What
`Measured_foliation::cell()` and `Measured_foliation::parameter()` return for one vertex is written
as the same three numbers that `write_foliation_vtp()` writes; either the arc or the node is -1.

\tparam VertexArcMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a signed integer type as
  value type
\tparam VertexNodeMap the same
\tparam VertexParameterMap a model of `WritablePropertyMap` with the same key type and a type
  constructible from `double` as value type
\param foliation the foliation
\param arc_map where the arc that a vertex lies in is written, by its number in the loop system, or
  -1 if the vertex lies at a node
\param node_map where the node that a vertex lies at is written, by its number in the loop system,
  or -1 if the vertex lies in an arc
\param parameter_map where the distance of a vertex from end 0 of its arc is written, in units of
  the transverse measure: strictly between 0 and the height of the arc, and 0 at a node
*/
template <class TriangleMesh, class VertexArcMap, class VertexNodeMap, class VertexParameterMap>
void vertex_cells(const Measured_foliation<TriangleMesh>& foliation,
                  VertexArcMap arc_map,
                  VertexNodeMap node_map,
                  VertexParameterMap parameter_map)
{
  for (const auto v : vertices(foliation.mesh()))
  {
    const auto cell = foliation.cell(v);
    const int index = static_cast<int>(cell.index);
    put(arc_map, v, cell.is_arc ? index : -1);
    put(node_map, v, cell.is_arc ? -1 : index);
    put(parameter_map, v, foliation.parameter(v));
  }
}

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

writes the arcs and parameters of all vertices to property maps, like the overload that also writes
nodes.
*/
template <class TriangleMesh, class VertexArcMap, class VertexParameterMap>
void vertex_cells(const Measured_foliation<TriangleMesh>& foliation,
                  VertexArcMap arc_map,
                  VertexParameterMap parameter_map)
{
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  vertex_cells(foliation, arc_map, CGAL::Constant_property_map<Vertex, int>(), parameter_map);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_MEASURED_FOLIATION_H
