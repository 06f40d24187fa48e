// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CONTOUR_SWEEP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CONTOUR_SWEEP_H

#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Cyclic_sequences.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Flat_scalar_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Vertex_order.h>
#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/lower_wedges.h>

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Computes the Reeb graph of a function by a sweep from below (compare Cole-McLaughlin et al.,
// Loops in Reeb graphs of 2-manifolds, 2004), which stores, for each contour of the level, not all
// edges that it crosses but only some of them, the *strands*, in their cyclic order along the
// contour, with larger values to the left.
//
// From every vertex except the minima, one strand descends for each wedge of lower neighbors: the
// edge to the first of them, counterclockwise. (At a maximum none is first; any will do.) A strand
// is alive between the levels of its ends.
//
// Lemma: every contour crosses a strand. Proof: let c be a contour in arc a. From the upper node of
// a, start in a wedge whose contour is in a and go down strands, any one at each vertex: as long as
// the walk is above the lower node of a, it stays in the annulus of a, and it has to leave the
// annulus below. It is monotone, so it crosses c, once. So no contour is lost, and the number of
// operations on sequences is O(n).
//
// At a regular vertex, the strands that begin replace the one that ends. At a simple saddle with
// the lower wedges p and q and the upper wedges P (the next one after p, counterclockwise) and Q,
// let P and Q also stand for the strands that begin there, clockwise, which is the order in which
// contours pass them. The contours (p A)(q B) of different arcs become (Q B P A), and a contour (p
// A q B) becomes (P A) and (Q B).
//
// A saddle of multiplicity m is unfolded into m steps: step i joins the first i + 1 lower wedges,
// which have become one that ends in the strand p, with the next one at the upper wedge between
// them.
class Contour_sweep
{
public:
  Contour_sweep(const Flat_mesh& mesh, const Vertex_order& order) : m_mesh(mesh), m_order(order)
  {
    m_graph.arc_of_vertex.resize(mesh.number_of_vertices());
    m_strand.assign(mesh.number_of_edges(), no_strand);
    mark_strands_of_maxima();
    for (int r = 0; r < order.size(); ++r)
      process(order.vertex(r));
  }

  Flat_scalar_reeb_graph take_graph() { return std::move(m_graph); }

private:
  static constexpr int no_strand = -1, future_strand = -2;

  int& strand(int halfedge) { return m_strand[edge_of(halfedge)]; }

  void mark_strands_of_maxima()
  {
    std::vector<bool> has_higher_neighbor(m_mesh.number_of_vertices(), false);
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
    {
      const int u = m_mesh.source(halfedge_of(e)), v = m_mesh.target(halfedge_of(e));
      has_higher_neighbor[m_order.rank(u) < m_order.rank(v) ? u : v] = true;
    }
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (!has_higher_neighbor[v])
        strand(m_mesh.ring(v)[0]) = future_strand;
  }

  // ===  The neighborhood of the vertex

  int before(int i) const { return i == 0 ? m_degree - 1 : i - 1; }
  int after(int i) const { return i + 1 == m_degree ? 0 : i + 1; }
  bool is_higher(int i) const { return m_neighbor_rank[i] > m_rank; }

  void process(int v)
  {
    m_vertex = v;
    m_rank = m_order.rank(v);
    m_ring = m_mesh.ring(v);
    m_degree = m_ring.size();
    m_neighbor_rank.clear();
    for (int h : m_ring)
      m_neighbor_rank.push_back(m_order.rank(m_mesh.target(h)));
    find_lower_wedges(m_neighbor_rank, m_rank, m_wedges);
    if (m_wedges.size() == 1)
      process_regular();
    else if (!m_wedges.empty())
      process_saddle();
    else if (is_higher(0))
      process_minimum();
    else
      process_maximum();
  }

  // whether a strand comes down the i-th edge
  bool begins_strand(int i)
  {
    return m_neighbor_rank[after(i)] > m_neighbor_rank[i] || strand(m_ring[i]) == future_strand;
  }

  // Lines up the strands that begin in the upper wedge before the i-th edge; the first one takes
  // the place of the strand `x`, or begins a sequence if there is no `x`. Returns the last one, the
  // root of its tree, or none.
  int begin_strands(int i, int x, int label)
  {
    int last = Cyclic_sequences::none;
    for (int j = before(i); is_higher(j); j = before(j))
    {
      if (begins_strand(j))
      {
        if (last != Cyclic_sequences::none)
          last = m_sequences.insert_after(last);
        else
          last = x != Cyclic_sequences::none ? x : m_sequences.make(label);
        strand(m_ring[j]) = last;
      }
      if (j == i) // around a minimum
        break;
    }
    return last;
  }

  void replace_strand(int x, int i)
  {
    if (begin_strands(i, x, -1) == Cyclic_sequences::none)
      m_sequences.erase(x);
  }

  // ===  Vertices

  void process_regular()
  {
    const int x = strand(m_ring[m_wedges[0]]);
    int piece = m_sequences.former_label(x);
    if (is_closed(piece))
      piece = m_sequences.label(x);
    m_graph.arc_of_vertex[m_vertex] = piece;
    replace_strand(x, m_wedges[0]);
  }

  void process_minimum()
  {
    const int piece = begin_piece(add_node(Critical_kind::MINIMUM, 0, 0), m_ring[0]);
    m_graph.arc_of_vertex[m_vertex] = piece;
    begin_strands(0, Cyclic_sequences::none, piece);
  }

  void process_maximum()
  {
    const int x = strand(m_ring[0]);
    CGAL_assertion(m_sequences.is_alone(x));
    m_graph.arc_of_vertex[m_vertex] = m_sequences.label(x);
    end_piece(m_sequences.label(x), add_node(Critical_kind::MAXIMUM, 0, 0));
    m_sequences.free(x);
  }

  void process_saddle()
  {
    const int p = strand(m_ring[m_wedges[0]]);
    m_graph.arc_of_vertex[m_vertex] = m_sequences.label(p);
    const int multiplicity = static_cast<int>(m_wedges.size()) - 1;
    for (int step = 0; step < multiplicity; ++step)
      process_simple_saddle(p, m_wedges[step + 1], step, step + 1 == multiplicity);
    replace_strand(p, m_wedges[0]);
  }

  // p: the strand of the lower wedges so far. i: where the next lower wedge begins
  void process_simple_saddle(int p, int i, int step, bool is_last)
  {
    const int node = add_node(Critical_kind::SADDLE, step, 1);
    const int q = strand(m_ring[i]);
    const bool is_split = m_sequences.are_in_one_sequence(p, q);
    end_piece(m_sequences.label(p), node);
    const int piece = begin_piece(node, m_ring[before(i)]);
    const int between = begin_strands(i, Cyclic_sequences::none, piece);
    const int after_p = m_sequences.cut_at(p);
    if (is_split)
    {
      const auto [after_p_before_q, after_q] = m_sequences.split_at(q);
      m_sequences.set_label(m_sequences.join(after_p_before_q, between), piece);
      const int first = m_wedges[0];
      const int other = begin_piece(node, m_ring[is_last ? before(first) : first]);
      m_sequences.set_label(m_sequences.join(after_q, p), other);
    }
    else
    {
      end_piece(m_sequences.label(q), node);
      const int after_q = m_sequences.cut_at(q);
      const int half = m_sequences.join(m_sequences.join(p, after_q), between);
      m_sequences.set_label(m_sequences.join(half, after_p), piece);
    }
    m_sequences.free(q);
  }

  // ===  The graph

  bool is_closed(int piece) const { return m_graph.arcs[piece].upper >= 0; }

  int add_node(Critical_kind kind, int step, int multiplicity)
  {
    m_graph.nodes.push_back({m_vertex, kind, step, multiplicity, 0});
    return static_cast<int>(m_graph.nodes.size()) - 1;
  }

  int begin_piece(int lower, int halfedge)
  {
    const int piece = static_cast<int>(m_graph.pieces.size());
    m_graph.pieces.push_back({m_vertex, -1, m_graph.nodes[lower].step, halfedge, -1});
    m_graph.arcs.push_back({lower, -1, piece, 0});
    return piece;
  }

  void end_piece(int piece, int upper)
  {
    m_graph.arcs[piece].upper = upper;
    m_graph.pieces[piece].upper_vertex = m_vertex;
  }

  const Flat_mesh& m_mesh;
  const Vertex_order& m_order;
  Flat_scalar_reeb_graph m_graph;
  Cyclic_sequences m_sequences; // of strands; labels are pieces
  std::vector<int> m_strand;    // by edge

  // the current vertex
  int m_vertex = -1, m_rank = -1, m_degree = 0;
  Flat_mesh::Ring m_ring{nullptr, nullptr};
  std::vector<int> m_neighbor_rank;
  std::vector<int> m_wedges; // where in the ring the wedges of lower neighbors begin
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CONTOUR_SWEEP_H
