// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_POLES_AND_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_POLES_AND_LOOPS_H

#include <CGAL/Surface_mesh_foliation/Loop.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationLoops

collects what the user wants a foliation to have: poles, loops and their heights. Nothing is checked
here; `Loop_system` and `validate()` do that.

A loop that hugs its pole is closer to it than any other loop, whatever the positions of crossings
say. The halfedges of loops must belong to the mesh.

Every pole has its pole loop, so poles and loops are numbered together, in the order of addition:
the number is the *loop id* that all results and error messages use.

\tparam TriangleMesh a model of `FaceGraph`
*/
template <class TriangleMesh>
class Poles_and_loops
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

  /// describes one loop.
  struct Entry
  {
    /// the vertices of the pole; empty if it is an opening, or if this is no pole loop
    std::vector<vertex_descriptor> pole;
    Loop<TriangleMesh> loop; ///< empty for a pole loop that hugs its pole
    double height;           ///< the transverse measure of its leaves
    /// a border halfedge of the opening that is the pole; null if the pole is no opening
    halfedge_descriptor border = boost::graph_traits<TriangleMesh>::null_halfedge();

    /// tells whether this is a pole loop.
    bool is_pole_loop() const
    {
      return !pole.empty() || border != boost::graph_traits<TriangleMesh>::null_halfedge();
    }
  };

  /// adds a center pole at a vertex, with the loop that hugs it, and returns the loop id.
  std::size_t add_pole(vertex_descriptor v, double height = 1) { return add({{v}, {}, height}); }

  /// adds a center pole at a vertex, with a user-defined loop around it, and returns the loop id.
  std::size_t add_pole(vertex_descriptor v, Loop<TriangleMesh> loop, double height = 1)
  {
    return add({{v}, std::move(loop), height});
  }

  /// adds a pole along a polyline of edges, whose ends become thorn poles, with the loop that hugs
  /// it, and returns the loop id. The vertices must form an induced path: two of them are joined by
  /// an edge if and only if they are consecutive.
  template <class VertexRange>
  std::size_t add_line_pole(const VertexRange& vertices, double height = 1)
  {
    return add(
      {std::vector<vertex_descriptor>(std::begin(vertices), std::end(vertices)), {}, height});
  }

  /// adds a pole along a polyline of edges, with a user-defined loop around it, and returns the
  /// loop id.
  template <class VertexRange>
  std::size_t add_line_pole(const VertexRange& vertices, Loop<TriangleMesh> loop, double height = 1)
  {
    return add({std::vector<vertex_descriptor>(std::begin(vertices), std::end(vertices)),
                std::move(loop), height});
  }

  /// adds an opening as a pole, with the loop that hugs it, and returns the loop id. Leaves run
  /// parallel to its border, which is the leaf at the end of its arc.
  /// \param border any halfedge of the border of the opening, without a face
  /// \param height the transverse measure of its leaves
  std::size_t add_border_pole(halfedge_descriptor border, double height = 1)
  {
    return add({{}, {}, height, border});
  }

  /// adds an opening as a pole, with a user-defined loop around it, and returns the loop id.
  std::size_t add_border_pole(halfedge_descriptor border,
                              Loop<TriangleMesh> loop,
                              double height = 1)
  {
    return add({{}, std::move(loop), height, border});
  }

  /// adds a loop that belongs to no pole and returns the loop id.
  std::size_t add_loop(Loop<TriangleMesh> loop, double height = 1)
  {
    return add({{}, std::move(loop), height});
  }

  /// changes the height of a loop.
  /// \pre `loop < size()`
  void set_height(std::size_t loop, double height) { m_entries[loop].height = height; }

  /// returns the number of loops, pole loops included.
  std::size_t size() const { return m_entries.size(); }

  /// returns all loops, ordered by id.
  const std::vector<Entry>& entries() const { return m_entries; }

private:
  std::size_t add(Entry entry)
  {
    m_entries.push_back(std::move(entry));
    return m_entries.size() - 1;
  }

  std::vector<Entry> m_entries;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_POLES_AND_LOOPS_H
