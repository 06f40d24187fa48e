// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_LOOP_FAMILIES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_LOOP_FAMILIES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The pieces of a surface that is cut along disjoint loops, and the families of parallel loops
// between them, as a graph. Its operations describe what happens when loops are dropped.
//
// Every piece is planar, or counts as planar: a handle inside a piece is treated as filled.
class Loop_families
{
public:
  struct Piece
  {
    std::vector<int> families; // a family that leads from the piece back to itself is listed twice
    int number_of_poles = 0;
    bool is_alive = true;
  };

  using Weight = std::pair<double, int>; // compared in this order

  struct Family
  {
    std::array<int, 2> pieces;
    Weight weight; // of two families that become one, the heavier one is kept
    bool is_alive = true;
  };

  int add_piece()
  {
    m_pieces.emplace_back();
    return static_cast<int>(m_pieces.size()) - 1;
  }

  void add_pole(int piece) { ++m_pieces[piece].number_of_poles; }

  int add_family(int u, int v, Weight weight)
  {
    const int result = number_of_families();
    m_families.push_back({{u, v}, weight});
    m_pieces[u].families.push_back(result);
    m_pieces[v].families.push_back(result);
    return result;
  }

  int number_of_families() const { return static_cast<int>(m_families.size()); }
  int number_of_pieces() const { return static_cast<int>(m_pieces.size()); }
  const Family& family(int f) const { return m_families[f]; }

  // Drops a family: its two pieces become one, or its single piece gets a handle.
  void drop(int f)
  {
    const auto [u, v] = m_families[f].pieces;
    m_families[f].is_alive = false;
    remove(u, f);
    remove(v, f);
    if (u == v)
      return;
    for (int g : m_pieces[v].families)
    {
      replace_piece(g, v, u);
      m_pieces[u].families.push_back(g);
    }
    take_over(u, v);
  }

  // Drops all families that are superfluous [Section 4.2.2 of the paper]: contractible ones, and
  // all but one of those that are homotopic in the surface minus its poles. With poles as
  // punctures, a loop is contractible if it bounds a disk with at most one pole. In linear time, if
  // pieces have few families. What remains does not depend on the order, up to the choice of one
  // among homotopic families of the same weight.
  void reduce(bool uses_poles_as_punctures)
  {
    std::vector<int> pieces;
    for (int r = number_of_pieces() - 1; r >= 0; --r)
      pieces.push_back(r);
    while (!pieces.empty())
    {
      const int r = pieces.back();
      pieces.pop_back();
      const Piece& piece = m_pieces[r];
      const std::size_t degree = piece.families.size();
      if (!piece.is_alive)
        continue;
      if (degree == 1 && (!uses_poles_as_punctures || piece.number_of_poles <= 1))
        pieces.push_back(fill(r));
      else if (degree == 2 && piece.number_of_poles == 0 && piece.families[0] != piece.families[1])
        for (int s : join_families(r))
          pieces.push_back(s);
    }
  }

private:
  // A piece with one family becomes part of the other piece of the family, which is returned.
  int fill(int r)
  {
    const int f = m_pieces[r].families[0], s = other_piece(f, r);
    m_families[f].is_alive = false;
    remove(s, f);
    take_over(s, r);
    return s;
  }

  // The two families of an annulus become one. Returns the pieces that it now lies between.
  std::array<int, 2> join_families(int r)
  {
    int stays = m_pieces[r].families[0], ends = m_pieces[r].families[1];
    if (m_families[stays].weight < m_families[ends].weight)
      std::swap(stays, ends);
    const int s = other_piece(ends, r);
    m_families[ends].is_alive = false;
    std::vector<int>& families = m_pieces[s].families;
    *std::find(families.begin(), families.end(), ends) = stays;
    replace_piece(stays, r, s);
    take_over(s, r);
    return m_families[stays].pieces;
  }

  int other_piece(int f, int r) const
  {
    const std::array<int, 2>& pieces = m_families[f].pieces;
    return pieces[0] == r ? pieces[1] : pieces[0];
  }

  void replace_piece(int f, int r, int s)
  {
    for (int& piece : m_families[f].pieces)
      if (piece == r)
        piece = s;
  }

  void remove(int r, int f)
  {
    std::vector<int>& families = m_pieces[r].families;
    families.erase(std::find(families.begin(), families.end(), f));
  }

  void take_over(int r, int from)
  {
    m_pieces[r].number_of_poles += m_pieces[from].number_of_poles;
    m_pieces[from] = {{}, 0, false};
  }

  std::vector<Piece> m_pieces;
  std::vector<Family> m_families;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_AUTOMATIC_LOOPS_LOOP_FAMILIES_H
