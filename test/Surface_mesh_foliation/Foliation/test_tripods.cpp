// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The images of triangles and the places of singularities, on octahedra and the torus of seven
// vertices, where they are known.

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>

#include "include/flat_states.h"
#include "include/flat_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace test_tripods {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

// ===  Tripod.h

TEST(Tripod, around_a_node_inside_a_triangle)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  const Tripod between_poles(state, face_of(system.mesh, 0, 2, 4));
  for (int i : {0, 1, 2})
  {
    EXPECT_EQ(between_poles.leg(i), 2);
    EXPECT_EQ(system.mesh.source(between_poles.out(i)), between_poles.corner(i));
    EXPECT_EQ(system.mesh.source(between_poles.other_out(i)), between_poles.corner(i));
    EXPECT_EQ(system.mesh.target(between_poles.other_out(i)), between_poles.corner((i + 2) % 3));
  }
  EXPECT_TRUE(between_poles.is_singular());
  EXPECT_FALSE(between_poles.is_center_arc());
  EXPECT_EQ(between_poles.node_of_center(), 3);

  const Tripod at_one_pole(state, face_of(system.mesh, 0, 3, 5)); // its center is at two corners
  for (int i : {0, 1, 2})
    EXPECT_EQ(at_one_pole.leg(i), at_one_pole.corner(i) == 0 ? 2 : 0);
  EXPECT_FALSE(at_one_pole.is_singular());
  EXPECT_FALSE(at_one_pole.is_zero());
  EXPECT_EQ(at_one_pole.node_of_center(), 3);
  EXPECT_TRUE(Tripod(state, face_of(system.mesh, 3, 1, 5)).is_zero());
}

TEST(Tripod, around_an_arc)
{
  const Equator e({0.5, 1, 1, 1.5});
  const Tripod tripod(e.state, face_of(e.system.mesh, 3, 0, 4));
  for (int i : {0, 1, 2})
    EXPECT_EQ(tripod.leg(i), tripod.corner(i) == 4 ? 1 : 0);
  EXPECT_TRUE(tripod.is_center_arc());
  EXPECT_EQ(tripod.arc_of_center(), 0);
  EXPECT_FALSE(tripod.is_singular());
  EXPECT_FALSE(tripod.is_zero());
}

TEST(Tripod, inside_an_arc_is_not_at_a_node)
{
  const Flat_loop_system system =
    flat_system(soups::midpoint_subdivided(soups::octahedron()), {{4}, {5}});
  Foliation_state state(system, unit_weights(system));
  grow_fronts(state);
  const int f = system.mesh.face(system.mesh.ring(0)[0]); // no corner is a pole
  const Tripod tripod(state, f);
  for (int i : {0, 1, 2})
    EXPECT_EQ(tripod.leg(i), 0);
  EXPECT_TRUE(tripod.is_center_arc());
  EXPECT_FALSE(tripod.is_zero());
  EXPECT_FALSE(tripod.is_singular());
}

TEST(Tripod, length_from_one_arc_into_the_next)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  Foliation_state state(system, unit_weights(system));
  Directions directions;
  find_directions(state, 1, directions);
  for (Letter letter : directions.letters)
    if (state.arc_of_letter(letter) == 2)
      state.move_into_arc(1, letter, 0.25);
  ASSERT_EQ(state.arc(1), 2);
  const int h = system.mesh.find_halfedge(1, 2); // from arc 2 over node 3 through arc 1 to its pole
  ASSERT_EQ(state.word_size(edge_of(h)), 3);
  EXPECT_EQ(arc_of_cell(state, h, 0), 2);
  EXPECT_EQ(node_of_cell(state, h, 1), 3);
  EXPECT_EQ(arc_of_cell(state, h, 2), 1);
  EXPECT_EQ(length_up_to(state, h, 0, 0.75), 0.5);
  EXPECT_EQ(length_up_to(state, h, 2, 0.5), 1.25);
  EXPECT_EQ(length_up_to(state, opposite_of(h), 3, 0.25), 1.75); // as long as the edge
}

TEST(Tripod, cells_along_an_edge_that_spans_two_arcs)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  const int h = system.mesh.find_halfedge(2, 4); // pole 1, arc 1, node 3, arc 2, pole 2
  ASSERT_EQ(state.word_size(edge_of(h)), 4);
  for (int cell = 0; cell <= 4; ++cell)
    EXPECT_EQ(is_cell_arc(state, h, cell), cell % 2 == 1);
  EXPECT_EQ(node_of_cell(state, h, 0), 1);
  EXPECT_EQ(arc_of_cell(state, h, 1), 1);
  EXPECT_EQ(node_of_cell(state, h, 2), 3);
  EXPECT_EQ(arc_of_cell(state, h, 3), 2);
  EXPECT_EQ(node_of_cell(state, h, 4), 2);
  EXPECT_EQ(arc_of_cell(state, opposite_of(h), 1), 2); // from the other end
  EXPECT_EQ(parameter_of_passage(state, h, 0), 0);
  EXPECT_EQ(parameter_of_passage(state, h, 1), 1);
  EXPECT_EQ(parameter_of_passage(state, h, 2), 1); // end 1 of arc 2
  EXPECT_EQ(parameter_of_passage(state, h, 3), 0);
  EXPECT_EQ(length_up_to(state, h, 1, 0.25), 0.25);
  EXPECT_EQ(length_up_to(state, h, 3, 0.25), 1.75);
  const Equator e({0.5, 1, 1, 1.5});
  EXPECT_EQ(length_up_to(e.state, e.system.mesh.find_halfedge(0, 3), 0, 1.25), 0.75);
  EXPECT_EQ(length_up_to(e.state, e.system.mesh.find_halfedge(3, 0), 0, 1.25), 0.25);
}

// ===  Singular_places.h

namespace {

using Places = std::vector<std::pair<int, int>>;

Places vertices_and_indices(const Foliation_state& state)
{
  Places result;
  const Singular_places all(state);
  for (const Singular_place& place : all.places())
    if (!place.is_face)
      result.emplace_back(place.place, place.index);
  return result;
}

void expect_places(const Foliation_state& state,
                   const std::vector<std::pair<int, int>>& faces_and_indices,
                   const std::vector<std::pair<int, int>>& vertices_and_indices)
{
  std::vector<std::pair<int, int>> faces, vertices;
  const Singular_places all(state);
  for (const Singular_place& place : all.places())
  {
    (place.is_face ? faces : vertices).emplace_back(place.place, place.index);
    EXPECT_EQ(place.node, place.is_face ? Tripod(state, place.place).node_of_center()
                                        : state.node(place.place));
  }
  EXPECT_EQ(faces, faces_and_indices);
  EXPECT_EQ(vertices, vertices_and_indices);
}

} // namespace

TEST(Singular_places, of_two_poles)
{
  const Equator e({0.5, 1, 1, 1.5});
  expect_places(e.state, {}, {{4, 2}, {5, 2}});
}

TEST(Singular_places, zero_faces_count_with_their_neighborhood)
{
  const Flat_loop_system system = octahedron_with_three_poles();
  const Foliation_state state(system, unit_weights(system));
  for (int v : {1, 3, 5})
    EXPECT_EQ(index_of_vertex(state, v), 0); // four closed corners, two zero spokes
  // the zero face has index -1, at the first of its corners; the tripod another one
  const int tripod = face_of(system.mesh, 0, 2, 4);
  const int first = system.mesh.source(system.mesh.halfedge_of_face(face_of(system.mesh, 3, 1, 5)));
  std::vector<std::pair<int, int>> vertices = {{first, -1}, {0, 2}, {2, 2}, {4, 2}};
  expect_places(state, {{tripod, -1}}, vertices);
}

namespace {

// The octahedron with midpoints, and poles at its corners 1, 3 and 5. All other vertices are at the
// node.
class Octahedron_with_midpoints
{
public:
  int middle(int a, int b) const
  {
    for (int h : mesh.ring(a))
      if (mesh.find_halfedge(mesh.target(h), b) >= 0)
        return mesh.target(h);
    ADD_FAILURE() << "not neighbors: " << a << ' ' << b;
    return 0;
  }

  // moves vertices one by one, each into the arc in which its edge to the other one begins
  void move(const std::vector<std::pair<int, int>>& vertices_and_neighbors)
  {
    for (const auto& [v, neighbor] : vertices_and_neighbors)
      state.move_into_arc(v, state.first_letter(mesh.find_halfedge(v, neighbor)), 0.5);
  }

private:
  const Flat_loop_system m_system =
    flat_system(soups::midpoint_subdivided(soups::octahedron()), {{1}, {3}, {5}});

public:
  const Flat_mesh& mesh = m_system.mesh;
  Foliation_state state{m_system, unit_weights(m_system)};
};

} // namespace

// The critical leaf ends at v, with an edge to u of length zero that is in no face of length zero.
TEST(Singular_places, ends_of_hairs_count_with_what_they_grow_from)
{
  // the second time with other corners in these roles, so that v comes before u
  for (const auto& [a, b, c, d, e, f] :
       {std::array{0, 1, 2, 3, 4, 5}, std::array{2, 3, 4, 5, 0, 1}})
  {
    Octahedron_with_midpoints o;
    const auto middle = [&](int i, int j) { return o.middle(i, j); };
    const int v = middle(d, e), u = middle(b, d);
    EXPECT_EQ(v < u, e == 0);
    o.move({{v, d}, {e, v}, {middle(b, e), v}, {middle(a, d), d}, {middle(a, e), v}});
    o.state.move_to_node(v, o.state.half_arc(v, 1));
    o.move({{middle(d, f), f}, {middle(b, f), b}, {middle(a, f), f}, {middle(c, f), f}});
    o.move({{middle(b, c), b}, {middle(c, e), e}, {a, middle(a, d)}, {c, middle(b, c)}});
    o.move({{middle(a, c), a}});
    EXPECT_EQ(index_of_vertex(o.state, v), 1);
    EXPECT_EQ(index_of_vertex(o.state, u), -2);
    EXPECT_EQ(vertices_and_indices(o.state), (Places{{v, -1}, {1, 2}, {3, 2}, {5, 2}}));
  }
}

// The same, but for one vertex that lies in another arc, so that a leaf goes on at the middle of 3
// and 4.
TEST(Singular_places, a_leaf_through_an_edge_of_length_zero_is_no_hair)
{
  Octahedron_with_midpoints o;
  const auto middle = [&](int i, int j) { return o.middle(i, j); };
  const int v = middle(3, 4), u = middle(1, 3);
  o.move({{v, 3}, {4, v}, {middle(1, 4), 1}, {middle(0, 3), 3}, {middle(0, 4), v}});
  o.state.move_to_node(v, o.state.half_arc(v, 1));
  o.move({{middle(3, 5), 5}, {middle(1, 5), 1}, {middle(0, 5), 5}, {middle(2, 5), 5}});
  o.move({{middle(1, 2), 1}, {middle(2, 4), 4}, {0, middle(0, 3)}, {2, middle(1, 2)}});
  o.move({{middle(0, 2), 0}});
  EXPECT_EQ(index_of_vertex(o.state, v), 0);
  EXPECT_EQ(index_of_vertex(o.state, u), -1);
  EXPECT_EQ(vertices_and_indices(o.state), (Places{{1, 2}, {3, 2}, {5, 2}, {u, -1}}));
}

TEST(Singular_places, a_hair_ends_at_the_first_vertex)
{
  Octahedron_with_midpoints o;
  const auto middle = [&](int i, int j) { return o.middle(i, j); };
  const int u = middle(0, 5);
  o.move({{middle(0, 3), 3}, {0, middle(0, 3)}, {middle(0, 2), 0}, {middle(0, 4), 0}});
  o.state.move_to_node(0, o.state.half_arc(0, 1));
  o.move({{middle(3, 5), 5}, {middle(2, 5), 5}, {middle(1, 5), 5}, {middle(3, 4), 3}});
  o.move({{middle(1, 3), 3}, {middle(1, 4), 1}, {middle(1, 2), 1}, {4, middle(3, 4)}});
  o.move({{2, middle(1, 2)}, {middle(2, 4), 4}});
  EXPECT_EQ(index_of_vertex(o.state, 0), 1);
  EXPECT_EQ(index_of_vertex(o.state, u), -1);
  EXPECT_EQ(vertices_and_indices(o.state), (Places{{1, 2}, {3, 2}, {5, 2}}));
}

// A fuzzer found it: vertices that weights hold at a pole, with faces of length zero, the first of
// which may begin at any vertex.
TEST(Singular_places, zero_faces_at_a_pole_count_as_the_pole)
{
  int number_that_begin_elsewhere = 0;
  for (const int pole : {1, 3, 5})
    for (int i = 0; i < 4; ++i)
    {
      Octahedron_with_midpoints o;
      const int h = o.mesh.ring(pole)[i], g = opposite_of(o.mesh.next(h)),
                f = opposite_of(o.mesh.next(g));
      const int u = o.mesh.target(h), v = o.mesh.source(g), w = o.mesh.source(f),
                corner = o.mesh.target(o.mesh.next(f));
      if (o.state.is_fixed(corner))
        continue;
      o.move({{u, pole}, {v, pole}, {w, u}, {corner, u}});
      for (const int moved : {u, v, w, corner})
        o.state.move_to_node(moved, o.state.half_arc(moved, 0));
      const int first = std::min({o.mesh.face(h), o.mesh.face(g), o.mesh.face(f)});
      const Tripod tripod(o.state, first);
      ASSERT_TRUE(tripod.is_zero());
      number_that_begin_elsewhere += tripod.corner(0) != pole;
      const Places places = vertices_and_indices(o.state);
      EXPECT_TRUE(std::count(places.begin(), places.end(), std::pair(pole, 2)));
    }
  EXPECT_GT(number_that_begin_elsewhere, 0);
}

TEST(Singular_places, of_a_torus_without_pole)
{
  const Flat_loop_system system = torus_with_one_loop();
  const Foliation_state state(system, unit_weights(system));
  for (int v = 0; v < 7; ++v) // two closed corners beside each of two zero spokes
    EXPECT_EQ(index_of_vertex(state, v), 0);
  expect_places(state, {}, {});
}

TEST(Is_regular_in_arc, looks_at_the_order_of_spokes)
{
  // vertex 0 has four neighbors, none of them a pole
  const Flat_loop_system system =
    flat_system(soups::midpoint_subdivided(soups::octahedron()), {{4}, {5}});
  Foliation_state state(system, unit_weights(system));
  grow_fronts(state);
  const Flat_mesh::Ring ring = system.mesh.ring(0);
  ASSERT_EQ(ring.size(), 4);
  const auto is_regular = [&](const std::vector<double>& t, double negligible = 1e-12) {
    state.set_parameter(0, 1);
    for (int i = 0; i < 4; ++i)
      state.set_parameter(system.mesh.target(ring[i]), t[i]);
    return is_regular_in_arc(state, 0, negligible);
  };
  EXPECT_TRUE(is_regular({1.5, 1.5, 0.5, 0.5}));
  EXPECT_TRUE(is_regular({0.5, 1.5, 0.5, 0.5}));
  EXPECT_FALSE(is_regular({1.5, 1.5, 1.5, 1.5})); // an extremum
  EXPECT_FALSE(is_regular({0.5, 0.5, 0.5, 0.5}));
  EXPECT_FALSE(is_regular({1.5, 0.5, 1.5, 0.5})); // a saddle
  EXPECT_TRUE(is_regular({1.5, 1, 1.5, 0.5}));    // the short spoke may go down
  EXPECT_TRUE(is_regular({1, 1.5, 1.5, 1.5}));
  EXPECT_TRUE(is_regular({1, 1, 1, 1}));
  EXPECT_FALSE(is_regular({1, 1.5, 0.5, 1.5}, 0)); // no spoke is negligible: equal means down
  EXPECT_FALSE(is_regular({1, 1, 1, 1}, 0));
  EXPECT_TRUE(is_regular({1.5, 0.5, 1.5, 1.001}, 0.01) && !is_regular({1.5, 0.5, 1.5, 0.5}, 0.01));
}

TEST(Is_regular_in_arc, spokes_over_the_ends_of_the_arc_are_known_without_lengths)
{
  for (double t : {0.5, 1., 1.5})
  {
    const Equator e({1, t, t, 2 - t});
    EXPECT_TRUE(is_regular_in_arc(e.state, 0, 0));
    EXPECT_TRUE(is_regular_in_arc(e.state, 0, 10)); // only the poles count, one on each side
    EXPECT_EQ(negligible_length(e.state, 0), 1e-12 * 2);
  }
}

} // namespace test_tripods
