// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Pole.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Lifts.h>

#include "include/flat_meshes.h"
#include "include/flat_systems.h"
#include "include/random_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace test_deck_cocycle {

using namespace CGAL::Surface_mesh_foliation::internal;
using namespace smf_test;

namespace {

// the product of the elements around a vertex, counterclockwise
Group_word around(const Flat_mesh& mesh, const Deck_cocycle& deck, int v)
{
  Group_word result;
  for (int h : mesh.ring(v))
    result = deck.group().product(result, deck.element(opposite_of(h)));
  return result;
}

// The way from the frame of a vertex to that of an edge does not depend on the direction of the
// walk; poles have no frame.
void expect_transports_agree_with_walks(const Flat_mesh& mesh,
                                        const Deck_cocycle& deck,
                                        const std::set<int>& poles)
{
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
  {
    Group_word way; // clockwise
    for (int i = mesh.degree(v), h = mesh.ring(v)[0]; i > 0; --i)
    {
      if (poles.count(v) > 0)
      {
        EXPECT_EQ(deck.transport(h), 0);
      }
      else
      {
        const Group_word to_edge = is_forward(h) ? way : deck.group().product(way, deck.element(h));
        EXPECT_TRUE(deck.group().are_equal(to_edge, deck.word(deck.transport(h))));
        EXPECT_EQ(deck.transport(h) == 0, deck.word(deck.transport(h)).empty());
      }
      way = deck.group().product(way, deck.element(h));
      h = mesh.next(opposite_of(h));
    }
    EXPECT_EQ(way.empty(), poles.count(v) == 0);
  }
}

// a path of halfedges from v to a vertex at that distance, which does not meet the others
std::vector<int> path_from(const Flat_mesh& mesh, int v, int length, const std::set<int>& others)
{
  std::vector<int> queue = {v}, entry(mesh.number_of_vertices(), -1);
  std::set<int> reached = others;
  reached.insert(v);
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    std::vector<int> path;
    for (int h = entry[queue[i]]; h >= 0; h = entry[mesh.source(h)])
      path.insert(path.begin(), h);
    if (static_cast<int>(path.size()) == length)
      return path;
    for (int h : mesh.ring(queue[i]))
      if (reached.insert(mesh.target(h)).second)
      {
        entry[mesh.target(h)] = h;
        queue.push_back(mesh.target(h));
      }
  }
  return {};
}

// The deck translations of a loop around the source of a path that begins in the face to the right
// of each of its halfedges, and comes there along the right side of the path.
std::vector<Group_word> translations_along(const Flat_mesh& mesh,
                                           const Deck_cocycle& deck,
                                           const std::vector<int>& path)
{
  const Surface_group& group = deck.group();
  // from the face to the right of h counterclockwise around source(h) to that of `last`
  const auto way = [&](int h, int last) {
    Group_word result;
    do
    {
      result = group.product(result, deck.element(opposite_of(h)));
      h = mesh.rotate(h);
    } while (h != last);
    return result;
  };
  std::vector<Group_word> result = {way(path[0], path[0])};
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const int first = mesh.rotate(opposite_of(path[i - 1]));
    const Group_word step = first == path[i] ? Group_word() : way(first, path[i]);
    result.push_back(group.product(group.product(inverse(step), result.back()), step));
  }
  return result;
}

// whether nothing has changed but what a pole that was pushed along the path brings with it
void expect_is_pushed(const Flat_mesh& mesh,
                      const Deck_cocycle& before,
                      const Deck_cocycle& deck,
                      const std::vector<int>& path,
                      const std::set<int>& other_poles)
{
  std::set<int> poles = other_poles, on_path;
  poles.insert(mesh.target(path.back()));
  for (int h : path)
    on_path.insert(edge_of(h));
  for (int h = 0; h < mesh.number_of_halfedges(); ++h)
  {
    EXPECT_EQ(deck.element(h) == before.element(h), on_path.count(edge_of(h)) == 0);
    EXPECT_EQ(deck.is_identity(h), deck.element(h).empty());
  }
  expect_transports_agree_with_walks(mesh, deck, poles);
}

class Deck_cocycle_of_genus : public testing::TestWithParam<int>
{};

} // namespace

TEST_P(Deck_cocycle_of_genus, relations_hold_at_all_vertices_but_poles)
{
  const int genus = GetParam();
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(genus, 2)));
  for (int number_of_poles = genus == 0 ? 2 : 0; number_of_poles < 6; ++number_of_poles)
  {
    std::vector<Pole> poles;
    for (int p = 0; p < number_of_poles; ++p)
      poles.push_back({7 * p + 3});
    const Deck_cocycle deck(mesh, poles);
    EXPECT_EQ(deck.group().rank(), 2 * genus + (poles.empty() ? 0 : number_of_poles - 1));
    EXPECT_EQ(deck.group().is_free(), !poles.empty());
    for (int v = 0; v < mesh.number_of_vertices(); ++v)
    {
      const bool is_pole = v % 7 == 3 && v / 7 < number_of_poles;
      EXPECT_EQ(around(mesh, deck, v).empty(), !is_pole) << "vertex " << v;
    }
  }
}

TEST_P(Deck_cocycle_of_genus, transports_agree_with_walks_around_vertices)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(GetParam(), 1)));
  const Deck_cocycle deck(mesh, {{0}, {5}});
  expect_transports_agree_with_walks(mesh, deck, {0, 5});
}

TEST_P(Deck_cocycle_of_genus, is_known_from_its_elements)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(GetParam(), 1))), other = mesh;
  const std::vector<Pole> poles = {{0}, {5}};
  const Deck_cocycle deck(mesh, poles);
  std::vector<Group_word> elements;
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    elements.push_back(deck.element(halfedge_of(e)));
  const Deck_cocycle again(other, poles, deck.group(), elements), copy(other, deck);
  for (const Deck_cocycle* same : {&again, &copy})
  {
    EXPECT_EQ(same->group().rank(), deck.group().rank());
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      EXPECT_EQ(same->element(h), deck.element(h));
      EXPECT_EQ(same->is_identity(h), deck.element(h).empty());
      EXPECT_EQ(same->word(same->transport(h)), deck.word(deck.transport(h)));
      EXPECT_EQ(same->transport(h) == 0, deck.word(deck.transport(h)).empty());
    }
  }
}

// No loop crosses the line of a pole, and no vertex there has a frame.
TEST_P(Deck_cocycle_of_genus, nothing_changes_across_line_poles)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(GetParam(), 2)));
  std::vector<Pole> poles;
  std::set<int> on_poles;
  std::vector<int> lines;
  for (int first : {3, 30, 60})
  {
    const std::vector<int> line = path_from(mesh, first, 4, on_poles);
    std::vector<int> vertices = {first};
    for (int h : line)
      vertices.push_back(mesh.target(h));
    poles.emplace_back(vertices);
    on_poles.insert(vertices.begin(), vertices.end());
    lines.insert(lines.end(), line.begin(), line.end());
  }
  const Deck_cocycle deck(mesh, poles);
  EXPECT_EQ(deck.group().rank(), 2 * GetParam() + 2);
  for (int h : lines)
    EXPECT_TRUE(deck.is_identity(h));
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    if (on_poles.count(v) == 0)
    {
      EXPECT_TRUE(around(mesh, deck, v).empty());
    }
    else
    {
      for (int h : mesh.ring(v))
        EXPECT_EQ(deck.transport(h), 0);
    }
}

// The translations of a loop around the pole are given in either direction.
TEST_P(Deck_cocycle_of_genus, a_pole_is_pushed)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(GetParam(), 2)));
  bool has_different_translations = false;
  for (int first = 0; first < 80; ++first)
  {
    const std::set<int> others = {first + 1, first + 2};
    const Deck_cocycle before(mesh, {{first + 1}, {first}, {first + 2}});
    const std::vector<int> path = path_from(mesh, first, 3, others);
    ASSERT_EQ(path.size(), 3u);
    const std::vector<Group_word> translations = translations_along(mesh, before, path);
    has_different_translations |= translations[0] != translations[1];
    std::vector<Group_word> inverted;
    for (const Group_word& translation : translations)
      inverted.push_back(inverse(translation));
    for (const std::vector<Group_word>& given : {translations, inverted})
    {
      Deck_cocycle deck(mesh, before);
      deck.push_pole(path, given);
      expect_is_pushed(mesh, before, deck, path, others);
    }
  }
  EXPECT_TRUE(has_different_translations);
}

INSTANTIATE_TEST_SUITE_P(Genera, Deck_cocycle_of_genus, testing::Values(0, 1, 2, 3, 5));

// whichever edges carry the generators
TEST(Deck_cocycle, has_the_rank_of_the_surface_for_any_pole)
{
  Triangle_soup torus = soups::seven_vertex_torus();
  for (std::size_t i = 0; i < torus.triangles.size(); ++i)
  {
    // another face is the first one
    std::rotate(torus.triangles.begin(), torus.triangles.begin() + 1, torus.triangles.end());
    const Flat_mesh mesh = flat_mesh(torus);
    for (int pole = 0; pole < 7; ++pole)
    {
      const Deck_cocycle deck(mesh, {{pole}});
      EXPECT_EQ(deck.group().rank(), 2);
      std::set<int> generators;
      for (int h = 0; h < mesh.number_of_halfedges(); ++h)
        for (int letter : deck.element(h))
          generators.insert(letter);
      EXPECT_EQ(generators, (std::set<int>{-2, -1, 1, 2}));
    }
  }
}

// A line is one puncture: the product of the elements around the line as a whole is a generator or
// a product of conjugates of the others, never 1, and the rank counts it once.
TEST(Deck_cocycle, line_pole_is_one_puncture)
{
  const Mesh sphere = icosphere(2);
  const Flat_mesh mesh = flat_mesh(to_soup(sphere));
  const int a = mesh.target(mesh.ring(0)[0]);
  int b = -1;
  for (int h : mesh.ring(a))
    if (mesh.target(h) != 0 && mesh.find_halfedge(0, mesh.target(h)) < 0)
      b = mesh.target(h);
  const std::vector<Pole> poles = {{0, a, b}, {100}, {120}};
  const Deck_cocycle deck(mesh, poles);
  EXPECT_EQ(deck.group().rank(), 2);
  for (int v = 0; v < mesh.number_of_vertices(); ++v)
    if (v != 0 && v != a && v != b && v != 100 && v != 120)
    {
      EXPECT_TRUE(around(mesh, deck, v).empty());
    }
  const Flat_loop loop = tight_loop(mesh, poles[0], 0, 1);
  Group_word translation;
  for (const Flat_crossing& crossing : loop.crossings)
    translation = deck.group().product(translation, deck.element(crossing.halfedge));
  EXPECT_FALSE(translation.empty());
}

// Lifts are told apart by their names, and transport along a way and back is the identity.
TEST(Lifts_of_deck_cocycle, transport_is_invertible)
{
  const Flat_mesh mesh = flat_mesh(to_soup(genus_surface(3, 1)));
  for (const std::vector<Pole>& poles : {std::vector<Pole>{}, std::vector<Pole>{{0}, {9}}})
  {
    const Deck_cocycle deck(mesh, poles);
    Lifts lifts(deck);
    const int lift = lifts.intern(0, {1});
    EXPECT_EQ(lifts.intern(0, {1}), lift);
    EXPECT_NE(lifts.intern(1, {1}), lift);
    EXPECT_NE(lifts.intern(0, {2, 1, -2}), lift);
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const int there = lifts.transport(lift, deck.transport(h), false);
      EXPECT_EQ(lifts.transport(there, deck.transport(h), true), lift);
    }
  }
}

} // namespace test_deck_cocycle
