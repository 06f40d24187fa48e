// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_SPOILED_FOLIATIONS_H
#define SMF_TEST_SPOILED_FOLIATIONS_H

#include "example_systems.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/certify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

// Foliations that can be spoiled, and what the certificate says of them.

namespace smf_test {

namespace internal = CGAL::Surface_mesh_foliation::internal;

inline void expect_problem_among(const std::vector<SMF::Problem>& problems,
                                 const std::string& message,
                                 const std::vector<std::size_t>& vertices = {},
                                 const std::vector<std::size_t>& loops = {})
{
  std::string all;
  for (const SMF::Problem& problem : problems)
  {
    EXPECT_EQ(problem.kind, SMF::Problem_kind::CERTIFICATE_FAILURE);
    if (problem.message.find(message) == std::string::npos)
      all += problem.message + '\n';
    else
    {
      EXPECT_EQ(problem.vertices, vertices);
      EXPECT_EQ(problem.loops, loops);
      return;
    }
  }
  ADD_FAILURE() << "not found: " << message << "; but there is\n" << all;
}

// A state of an example's loop system that can be spoiled.
class Spoiled
{
public:
  explicit Spoiled(const Example& example)
    : m_mesh(to_mesh(example.soup)),
      m_system(m_mesh, poles_and_loops(example.items, m_mesh)),
      state(m_system.data().flat, internal::mean_value_weights(m_system.data().flat.mesh))
  {}

  // Takes over a foliation of the mesh, with other arcs (by number), other nodes and other names of
  // lifts.
  void take(
    const internal::Foliation_state& from,
    const std::vector<int>& arcs,
    const std::vector<int>& nodes,
    const std::function<internal::Group_word(int, const internal::Group_word&)>& name =
      [](int, const internal::Group_word& same) { return same; })
  {
    const auto lift = [&](int old) {
      const int arc = from.lifts().arc(old);
      return state.lift(arcs.at(arc), name(arc, from.lifts().name(old)));
    };
    internal::Tree_map map = from.map();
    for (internal::Cell& cell : map.cell)
      cell = cell.is_node() ? internal::Cell::at_node(nodes.at(cell.node()))
                            : internal::Cell::arc(lift(cell.lift()));
    map.paths = internal::Tree_paths(from.mesh().number_of_edges());
    for (int e = 0; e < from.mesh().number_of_edges(); ++e)
      for (int i = 0; i < from.word_size(e); ++i)
      {
        const internal::Letter letter = from.letter(internal::halfedge_of(e), i);
        map.paths.push_back(e, internal::Letter(lift(letter.lift()), letter.end()));
      }
    state.set_map(std::move(map));
  }

  // as it is
  void take(const internal::Foliation_state& from)
  {
    std::vector<int> all(from.system().nodes.size() + from.system().loops.size());
    std::iota(all.begin(), all.end(), 0);
    take(from, all, all);
  }

  std::vector<SMF::Problem> problems() const
  {
    return internal::certify(state, internal::Extraction(state));
  }

  void expect_problem(const std::string& message,
                      const std::vector<std::size_t>& vertices = {},
                      const std::vector<std::size_t>& loops = {}) const
  {
    expect_problem_among(problems(), message, vertices, loops);
  }

private:
  Mesh m_mesh;
  SMF::Loop_system<Mesh> m_system;

public:
  internal::Foliation_state state;
};

// whether a vertex and all its neighbors lie in one arc
inline bool is_deep_in_arc(const internal::Foliation_state& state, int v, int arc)
{
  const auto ring = state.mesh().ring(v);
  return !state.is_at_node(v) && state.arc(v) == arc &&
         std::all_of(ring.begin(), ring.end(),
                     [&](int h) { return state.word_size(internal::edge_of(h)) == 0; });
}

inline int vertex_deep_in_arc(const internal::Foliation_state& state, int arc)
{
  for (int v = 0; v < state.mesh().number_of_vertices(); ++v)
    if (is_deep_in_arc(state, v, arc))
      return v;
  ADD_FAILURE() << "no vertex";
  return 0;
}

// arcs 0 to 3 of the poles meet at node 4
inline Example four_poles()
{
  const Triangle_soup sphere = soups::icosphere(3);
  return {"four poles", sphere, pole_items({0, 1, 2, 3})};
}

class Spoiled_four_poles : public ::testing::Test
{
protected:
  Spoiled_four_poles() : solved(four_poles()), spoiled(four_poles())
  {
    spoiled.take(solved.foliation.state());
  }

  const std::vector<int> same = {0, 1, 2, 3, 4};
  Solved_example<> solved;
  Spoiled spoiled;
};

} // namespace smf_test

#endif // SMF_TEST_SPOILED_FOLIATIONS_H
