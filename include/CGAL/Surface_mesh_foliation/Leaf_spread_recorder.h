// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_LEAF_SPREAD_RECORDER_H
#define CGAL_SURFACE_MESH_FOLIATION_LEAF_SPREAD_RECORDER_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

records how leaves spread over the surface from the loops during the Whitehead moves: a model of
`FoliationVisitor` for `whitehead_foliation()`. It is the paper's own way to find loops around
handles [Section 4.2.1], provided for comparison with `propose_loops()`.

A face is *covered* if leaves cross one of its edges. After each sweep, the time of each vertex
whose faces have now all been covered is set to the number of sweeps; that of a pole is 0. So the
boundary of the covered region after \f$ s \f$ sweeps is the level set of the times at
\f$ s + 1/2 \f$, and the places where it splits in two, or where two boundaries merge, are the
  saddles of the times: the critical moves of the paper. Its new loops are thus those that
  `propose_loops()` derives from the times:
\code{.cpp}
Leaf_spread_recorder recorder(system, values, times);
whitehead_foliation(system,
                    parameters::spread_by_rings(true)
                      .edge_value_map(values)
                      .visitor(std::ref(recorder)));
propose_loops(mesh, poles, parameters::vertex_scalar_map(times));
\endcode
Without `spread_by_rings(true)` leaves may run along a row of vertices in one sweep. Like the hop
distance, and unlike the geodesic distance that `propose_loops()` uses by default, the times depend
on the mesh and, among equal ones, on the order of its vertices: the limitation that the paper
names.

The recorder stops the solver when leaves have covered everything that they can reach.

\tparam TriangleMesh see `Loop_system`
\tparam EdgeValueMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and `double` as value type
\tparam VertexTimeMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a type constructible from
  `int` as value type
*/
template <class TriangleMesh, class EdgeValueMap, class VertexTimeMap>
class Leaf_spread_recorder
{
  using Traits = boost::graph_traits<TriangleMesh>;

public:
  /// begins a record; no sweep has been made yet.
  /// \param system the loop system of the solver
  /// \param edge_values the map that the solver gets as `edge_value_map`
  /// \param times the map to write to
  Leaf_spread_recorder(const Loop_system<TriangleMesh>& system,
                       EdgeValueMap edge_values,
                       VertexTimeMap times)
    : m_mesh(system.mesh()),
      m_edge_values(edge_values),
      m_times(times),
      m_has_time(get(CGAL::dynamic_vertex_property_t<bool>(), m_mesh))
  {
    for (const auto v : vertices(m_mesh))
    {
      put(m_has_time, v, false);
      ++m_number_of_vertices;
    }
    for (std::size_t p = 0; p < system.number_of_poles(); ++p)
      for (const auto v : system.pole_vertices(p))
        set_time(v, 0);
  }

  /// is called after each sweep, and returns whether leaves may still spread. In linear time.
  bool after_iteration(const Foliation_statistics& statistics)
  {
    const int time = static_cast<int>(statistics.number_of_iterations);
    const std::size_t before = m_number_with_time;
    for (const auto v : vertices(m_mesh))
      if (!get(m_has_time, v) && is_covered(v))
        set_time(v, time);
    m_idle_sweeps = m_number_with_time == before ? m_idle_sweeps + 1 : 0;
    // moves that were held back may begin after a sweep without any others
    const bool goes_on =
      m_number_with_time < m_number_of_vertices && m_idle_sweeps < max_idle_sweeps;
    if (!goes_on)
      for (const auto v : vertices(m_mesh))
        if (!get(m_has_time, v))
          set_time(v, time);
    return goes_on;
  }

private:
  static constexpr int max_idle_sweeps = 3;

  void set_time(typename Traits::vertex_descriptor v, int time)
  {
    put(m_times, v, time);
    put(m_has_time, v, true);
    ++m_number_with_time;
  }

  bool is_covered(typename Traits::vertex_descriptor v) const
  {
    for (const auto f : CGAL::faces_around_target(halfedge(v, m_mesh), m_mesh))
    {
      bool is_crossed = false;
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        is_crossed = is_crossed || get(m_edge_values, edge(h, m_mesh)) > 0;
      if (!is_crossed)
        return false;
    }
    return true;
  }

  const TriangleMesh& m_mesh;
  EdgeValueMap m_edge_values;
  VertexTimeMap m_times;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<bool>>::const_type
    m_has_time;
  std::size_t m_number_of_vertices = 0; // num_vertices() may count removed ones
  std::size_t m_number_with_time = 0;
  int m_idle_sweeps = 0;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_LEAF_SPREAD_RECORDER_H
