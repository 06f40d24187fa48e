// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_SINGULAR_PLACES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_SINGULAR_PLACES_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A vertex or a face with an index different from 0, at a node of T.
struct Singular_place
{
  bool is_face;
  int place; // vertex or face
  int index; // 2 center pole, 1 thorn pole, -m saddle of order m
  int node;
};

// The index of a vertex at a node is 2 - C + Z for C closed corners and Z zero spokes [3.2]. A
// corner is open iff the words of its two spokes begin with the same letter, which is an integer
// test.
inline int index_of_vertex(const Foliation_state& state, int v)
{
  int result = 2;
  for (int h : state.mesh().ring(v))
  {
    if (leg_at_source(state, h) == 0)
      --result;
    if (state.word_size(edge_of(h)) == 0)
      ++result;
  }
  return result;
}

// All singularities. They lie at nodes: the certificate guarantees that arcs have none. Where
// entire faces lie at a node, a connected set of such faces and zero edges counts as one
// singularity, at its pole, if there is one, or else at its first vertex, since only the sum of its
// indices is meaningful. So do the zero edges of a hair, see `is_end_of_hair()`.
class Singular_places
{
public:
  explicit Singular_places(const Foliation_state& state)
    : m_state(state), m_is_in_patch(state.mesh().number_of_vertices(), false)
  {
    const Flat_mesh& mesh = state.mesh();
    const std::vector<int> faces = collected_numbers<int>(
      state.executor(), mesh.number_of_faces(), [&](int f, std::vector<int>& list) {
        const Tripod tripod(state, f);
        if (tripod.is_singular() || tripod.is_zero())
          list.push_back(f);
      });
    for (int f : faces)
      add_face(f);
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (is_apart(v) && is_end_of_hair(v))
        add_patch(v);
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
      if (is_apart(v))
        add({false, v, index_of_vertex(state, v), state.node(v)});
  }

  const std::vector<Singular_place>& places() const { return m_places; }

private:
  void add(const Singular_place& place)
  {
    if (place.index != 0)
      m_places.push_back(place);
  }

  bool is_apart(int v) const { return m_state.is_at_node(v) && !m_is_in_patch[v]; }

  // Whether v, which is no pole, ends a critical leaf that consists of zero edges. An edge that has
  // a weight of 1e16 times those of others at v holds v closer to its other end than numbers tell.
  // (A vertex without zero edges is a patch of its own, with the same index.)
  bool is_end_of_hair(int v) const
  {
    return !m_state.is_fixed(v) && index_of_vertex(m_state, v) > 0;
  }

  void add_face(int f)
  {
    const Tripod tripod(m_state, f);
    if (tripod.is_singular())
      add({true, f, -1, tripod.node_of_center()});
    else if (tripod.is_zero() && !m_is_in_patch[tripod.corner(0)])
      add_patch(tripod.corner(0));
  }

  void add_patch(int first)
  {
    std::vector<int> patch = {first};
    m_is_in_patch[first] = true;
    int index = 0, number_of_zero_corners = 0;
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      index += index_of_vertex(m_state, patch[i]);
      for (int h : m_state.mesh().ring(patch[i]))
      {
        number_of_zero_corners += Tripod(m_state, m_state.mesh().face(h)).is_zero();
        const int v = m_state.mesh().target(h);
        if (m_state.word_size(edge_of(h)) == 0 && !m_is_in_patch[v])
        {
          m_is_in_patch[v] = true;
          patch.push_back(v);
        }
      }
    }
    const auto pole =
      std::find_if(patch.begin(), patch.end(), [&](int v) { return m_state.is_fixed(v); });
    // a face at a node has index 2 - 0 - 3 = -1 and three corners in the patch
    add({false, pole != patch.end() ? *pole : first, index - number_of_zero_corners / 3,
         m_state.node(first)});
  }

  const Foliation_state& m_state;
  std::vector<bool> m_is_in_patch;
  std::vector<Singular_place> m_places;
};

// Whether the spokes of a vertex inside an arc are arranged as around a regular point: those that
// go up are consecutive, and so are those that go down. Spokes shorter than `negligible` may count
// as either, since rounding decides where they go.
inline bool is_regular_in_arc(const Foliation_state& state, int v, double negligible)
{
  int first = 0, previous = 0, changes = 0;
  bool has_negligible = false;
  for (int h : state.mesh().ring(v))
  {
    const int u = state.mesh().target(h);
    int direction;
    if (state.word_size(edge_of(h)) > 0)
      direction = state.first_end(h) == 1 ? 1 : -1;
    else if (std::abs(state.parameter(u) - state.parameter(v)) < negligible)
    {
      has_negligible = true;
      continue;
    }
    else
      direction = state.parameter(u) > state.parameter(v) ? 1 : -1;
    changes += previous != 0 && direction != previous;
    first = first == 0 ? direction : first;
    previous = direction;
  }
  changes += previous != first;
  return changes == 2 || (changes == 0 && has_negligible);
}

// lengths in an arc below this one are rounding errors of the last solve
inline double negligible_length(const Foliation_state& state, int arc)
{
  constexpr double rounding = 1e-12;
  return rounding * state.system().height(arc);
}

// The vertices inside arcs that are not regular. A certified foliation has none.
inline std::vector<int> vertices_singular_in_arcs(const Foliation_state& state)
{
  return collected_numbers<int>(
    state.executor(), state.mesh().number_of_vertices(), [&](int v, std::vector<int>& list) {
      if (!state.is_at_node(v) &&
          !is_regular_in_arc(state, v, negligible_length(state, state.arc(v))))
        list.push_back(v);
    });
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_SINGULAR_PLACES_H
