// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_REFINED_MESH_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_REFINED_MESH_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The mesh cut along its critical leaves. Its first vertices are those of the mesh; then come the
// points where edges pass nodes, then the centers of tripods. Every face lies in one component.
// Faces have the order of those of the mesh that they are parts of, so those of caps come last.
struct Refined_mesh
{
  static constexpr int NONE = -1;

  struct Face
  {
    Triangle vertices;
    std::array<double, 3> t; // of the corners, in the arc of the face
    int arc = NONE;          // NONE: the entire face lies at a node
    int origin = NONE;       // the face of the mesh that it is a part of
    // A face of the mesh is cut into convex pieces, and these into fans of triangles that follow
    // each other in `faces`; `piece` is the first of them.
    int piece = NONE;
    std::array<bool, 3> is_critical = {false, false, false}; // side i joins corners i and i + 1
  };

  std::vector<Point> points;
  std::vector<int> node; // by vertex; NONE in an arc
  std::vector<Face> faces;
  // by vertex: the edge of the mesh that it was added on; NONE for those of the mesh and centers
  std::vector<int> edge_of_vertex;
  int first_center = 0;                              // centers are in the order of their faces
  int first_cap_vertex = 0, end_of_cap_vertices = 0; // the vertices in the middle of caps
  int first_cap_face = 0;

  bool is_cap_vertex(int v) const { return v >= first_cap_vertex && v < end_of_cap_vertices; }
  // the number of a vertex, which is in no cap, when vertices of caps are left out
  int number_without_caps(int v) const
  {
    return v < first_cap_vertex ? v : v - (end_of_cap_vertices - first_cap_vertex);
  }
};

inline std::vector<Point> points_without_caps(const Refined_mesh& refined)
{
  std::vector<Point> result = refined.points;
  result.erase(result.begin() + refined.first_cap_vertex,
               result.begin() + refined.end_of_cap_vertices);
  return result;
}

// without caps
inline Triangle_soup soup_of(const Refined_mesh& refined)
{
  Triangle_soup result;
  result.points = points_without_caps(refined);
  result.triangles.reserve(refined.first_cap_face);
  const auto corner = [&](int v) {
    return static_cast<std::size_t>(refined.number_without_caps(v));
  };
  for (int f = 0; f < refined.first_cap_face; ++f)
  {
    const auto& [a, b, c] = refined.faces[f].vertices;
    result.triangles.push_back({corner(a), corner(b), corner(c)});
  }
  return result;
}

// Cuts without tracing: in every triangle, the node points of equal rank on the two edges of a
// corner are joined, and those at the node of the center are joined to the center.
class Refinement
{
public:
  explicit Refinement(const Foliation_state& state)
    : m_state(state), m_first_point(state.mesh().number_of_edges() + 1, 0)
  {
    const Flat_mesh& mesh = state.mesh();
    m_result.points = mesh.points();
    m_result.first_cap_vertex = mesh.number_of_input_vertices();
    m_result.end_of_cap_vertices = mesh.number_of_vertices();
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      m_result.node.push_back(state.is_at_node(v) ? state.node(v) : Refined_mesh::NONE);
    m_result.edge_of_vertex.assign(mesh.number_of_vertices(), Refined_mesh::NONE);
    for (int e = 0; e < mesh.number_of_edges(); ++e)
      add_node_points(e);
    m_result.first_center = static_cast<int>(m_result.points.size());
    const std::vector<Cursor> cursors = places_of_blocks();
    m_result.points.resize(cursors.back().point);
    m_result.node.resize(cursors.back().point);
    m_result.edge_of_vertex.resize(cursors.back().point, Refined_mesh::NONE);
    m_result.faces.resize(cursors.back().face);
    state.executor()(mesh.number_of_faces(), [&](int block, int first, int last) {
      Cursor cursor = cursors[block];
      for (int f = first; f < last; ++f)
        cut(f, cursor);
      CGAL_assertion(cursor.face == cursors[block + 1].face);
      CGAL_assertion(cursor.point == cursors[block + 1].point);
    });
    m_result.first_cap_face = first_cap_face();
  }

  Refined_mesh&& result() && { return std::move(m_result); }

private:
  // a corner of a piece, and whether the side from it to the next is part of a critical leaf
  struct Corner
  {
    int vertex;
    double t;
    bool is_critical;
  };
  using Piece = std::vector<Corner>;

  // the positions of the next face and of the next point inside a face
  struct Cursor
  {
    int face, point;
  };

  // By block of the loop over the faces: the positions of its first face and point; then those of
  // the end.
  std::vector<Cursor> places_of_blocks() const
  {
    const int n = m_state.mesh().number_of_faces(), blocks = Executor::number_of_blocks(n);
    std::vector<Cursor> result(blocks + 1, {0, 0});
    m_state.executor()(n, [&](int block, int first, int last) {
      for (int f = first; f < last; ++f)
        count(f, result[block + 1]);
    });
    result[0].point = m_result.first_center;
    for (int block = 0; block < blocks; ++block)
    {
      result[block + 1].face += result[block].face;
      result[block + 1].point += result[block].point;
    }
    return result;
  }

  // Caps lie at nodes, so none of their faces is cut.
  int first_cap_face() const
  {
    const Flat_mesh& mesh = m_state.mesh();
    return static_cast<int>(m_result.faces.size()) -
           (mesh.number_of_faces() - mesh.number_of_input_faces());
  }

  // Adds the numbers of faces and inner points that cut() makes of f: n - 2 faces for a piece with
  // n corners.
  void count(int f, Cursor& numbers) const
  {
    if (lies_in_one_arc(f))
    {
      ++numbers.face;
      return;
    }
    const Tripod tripod(m_state, f);
    int faces = 0, corners_left = 0; // the latter of the piece in the middle
    for (int i : {0, 1, 2})
    {
      const int strips = nodes_before(tripod.out(i), tripod.leg(i));
      faces += strips > 0 ? 2 * strips - 1 : 0;
      corners_left += strips > 0 ? 2 : 1;
    }
    if (tripod.is_zero())
      faces = 1;
    else if (tripod.is_center_arc())
      faces += corners_left - 2;
    else
      for (int i : {0, 1, 2})
        if (tripod.leg(i) > 0)
        {
          const bool is_cut = nodes_before(tripod.out(i), tripod.leg(i)) > 0;
          faces += (is_cut ? 2 : 1) + (tripod.is_singular() ? 3 : 2) - 2;
        }
    numbers.face += faces;
    numbers.point += tripod.is_singular() ? 1 : 0;
  }

  // the number of node cells strictly between cell 0 and the given cell along h
  int nodes_before(int h, int cell) const
  {
    if (cell == 0)
      return 0;
    return m_state.is_at_node(m_state.mesh().source(h)) ? (cell - 1) / 2 : cell / 2;
  }

  // the cell of the k-th of them
  int cell_of_node(int h, int k) const
  {
    return 2 * k + (m_state.is_at_node(m_state.mesh().source(h)) ? 2 : 1);
  }

  // puts a point where the image of edge e passes a node, in proportion to length
  void add_node_points(int e)
  {
    const int h = halfedge_of(e), n = m_state.word_size(e);
    const int u = m_state.mesh().source(h), v = m_state.mesh().target(h);
    m_first_point[e + 1] = m_first_point[e] + nodes_before(h, n);
    const double length = length_of_edge(m_state, e);
    double way = 0;
    for (int k = 0; k < nodes_before(h, n); ++k)
    {
      const int cell = cell_of_node(h, k);
      const Letter letter = m_state.letter(h, cell - 1);
      way += cell == 1 ? m_state.distance_to_end(letter, m_state.parameter(u))
                       : m_state.length_of_arc(letter);
      m_result.points.push_back(
        between(m_state.mesh().point(u), m_state.mesh().point(v), length > 0 ? way / length : 0.5));
      m_result.node.push_back(m_state.node_of_letter(letter));
      m_result.edge_of_vertex.push_back(e);
    }
  }

  // the vertex of the refined mesh at the k-th node passed along h
  int node_point(int h, int k) const
  {
    const int e = edge_of(h), size = m_first_point[e + 1] - m_first_point[e];
    return m_state.mesh().number_of_vertices() + m_first_point[e] +
           (is_forward(h) ? k : size - 1 - k);
  }

  void cut(int f, Cursor& cursor)
  {
    if (lies_in_one_arc(f))
      return add_whole(f, cursor);
    const Tripod tripod(m_state, f);
    std::array<Piece, 3> ends;
    for (int i : {0, 1, 2})
      ends[i] = cut_corner(f, tripod, i, cursor);
    if (tripod.is_zero())
      add_piece(
        f, Refined_mesh::NONE,
        {{tripod.corner(0), 0, true}, {tripod.corner(1), 0, true}, {tripod.corner(2), 0, true}},
        cursor);
    else if (tripod.is_center_arc())
      add_piece(f, tripod.arc_of_center(), joined(joined(ends[0], ends[1]), ends[2]), cursor);
    else
      add_pieces_around_node(f, tripod, ends, cursor);
  }

  // like most faces, whose edges pass no node
  bool lies_in_one_arc(int f) const
  {
    for (int h : m_state.mesh().halfedges(f))
      if (m_state.word_size(edge_of(h)) > 0 || m_state.is_at_node(m_state.mesh().source(h)))
        return false;
    return true;
  }

  void add_whole(int f, Cursor& cursor)
  {
    Refined_mesh::Face& face = m_result.faces[cursor.face];
    const std::array<int, 3> halfedges = m_state.mesh().halfedges(f);
    for (int i : {0, 1, 2})
    {
      face.vertices[i] = m_state.mesh().source(halfedges[i]);
      face.t[i] = m_state.parameter(face.vertices[i]);
    }
    face.arc = m_state.arc(face.vertices[0]);
    face.origin = f;
    face.piece = cursor.face++;
  }

  // Cuts off the strips of a corner that end before the center cell. Either the vertex or the last
  // cut remains at the corner, as part of the boundary of the next piece.
  Piece cut_corner(int f, const Tripod& tripod, int i, Cursor& cursor)
  {
    const int h = tripod.out(i), g = tripod.other_out(i), v = tripod.corner(i);
    Piece rest = {{v, parameter_at_corner(tripod, i), false}};
    for (int k = 0; k < nodes_before(h, tripod.leg(i)); ++k)
    {
      const int p = node_point(h, k), q = node_point(g, k), cell = cell_of_node(h, k);
      const double t = parameter_of_passage(m_state, h, cell - 1);
      add_piece(f, arc_of_cell(m_state, h, cell - 1), joined(rest, {{p, t, true}, {q, t, false}}),
                cursor);
      const double next = parameter_of_passage(m_state, h, cell);
      rest = {{q, next, true}, {p, next, false}};
    }
    return rest;
  }

  // the parameter of corner i in the first arc of its leg
  double parameter_at_corner(const Tripod& tripod, int i) const
  {
    if (!m_state.is_at_node(tripod.corner(i)))
      return m_state.parameter(tripod.corner(i));
    return tripod.leg(i) == 0 ? 0 : parameter_of_passage(m_state, tripod.out(i), 0);
  }

  static Piece joined(Piece first, const Piece& second)
  {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  // One piece per leg, between the last cut of its corner and the critical leaf through the center.
  void add_pieces_around_node(int f,
                              const Tripod& tripod,
                              const std::array<Piece, 3>& ends,
                              Cursor& cursor)
  {
    int center = Refined_mesh::NONE;
    if (tripod.is_singular())
    {
      center = cursor.point++;
      m_result.points[center] = centroid(m_result.points[center_on_edge(tripod, 0)],
                                         m_result.points[center_on_edge(tripod, 1)],
                                         m_result.points[center_on_edge(tripod, 2)]);
      m_result.node[center] = tripod.node_of_center();
    }
    for (int i : {0, 1, 2})
    {
      if (tripod.leg(i) == 0)
        continue;
      const int h = tripod.out(i), last = tripod.leg(i) - 1;
      const double t = parameter_of_passage(m_state, h, last);
      Piece piece = joined(ends[i], {{center_on_edge(tripod, i), t, true}});
      if (center != Refined_mesh::NONE)
        piece.push_back({center, t, true});
      piece.push_back({center_on_edge(tripod, (i + 2) % 3), t, false});
      add_piece(f, arc_of_cell(m_state, h, last), piece, cursor);
    }
  }

  // where the center, a node, lies on the edge from corner i to the next: at a corner, or between
  int center_on_edge(const Tripod& tripod, int i) const
  {
    if (tripod.leg(i) == 0)
      return tripod.corner(i);
    if (tripod.leg((i + 1) % 3) == 0)
      return tripod.corner((i + 1) % 3);
    return node_point(tripod.out(i), nodes_before(tripod.out(i), tripod.leg(i)));
  }

  // triangulates a convex piece as a fan
  void add_piece(int f, int arc, const Piece& piece, Cursor& cursor)
  {
    const int n = static_cast<int>(piece.size()), first = cursor.face;
    for (int i = 1; i + 1 < n; ++i)
    {
      Refined_mesh::Face& face = m_result.faces[cursor.face++];
      face.piece = first;
      face.vertices = {piece[0].vertex, piece[i].vertex, piece[i + 1].vertex};
      face.t = {piece[0].t, piece[i].t, piece[i + 1].t};
      face.arc = arc;
      face.origin = f;
      face.is_critical = {i == 1 && piece[0].is_critical, piece[i].is_critical,
                          i + 2 == n && piece[i + 1].is_critical};
    }
  }

  const Foliation_state& m_state;
  std::vector<int> m_first_point; // by edge
  Refined_mesh m_result;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_REFINED_MESH_H
