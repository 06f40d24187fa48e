// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate refuses what has been extracted from a foliation if that is wrong, and the
// foliation is not.

#include "include/spoiled_foliations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace test_certificate_of_extraction {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

using smf_test::expect_problem_among;
using smf_test::vertex_deep_in_arc;

class Certificate_of_extraction : public smf_test::Spoiled_four_poles
{};

} // namespace

TEST_F(Certificate_of_extraction, critical_leaf_at_no_node)
{
  Extraction extraction(spoiled.state);
  std::vector<int>& node = extraction.refined_mesh.node;
  int v = 0;
  while (extraction.leaf_graph.leaf_of_vertex(v) < 0)
    ++v;
  node[v] = Refined_mesh::NONE;
  expect_problem_among(certify(spoiled.state, extraction),
                       "vertex " + std::to_string(v) + " of a critical leaf lies at no node");
}

TEST_F(Certificate_of_extraction, each_node_without_its_singularities)
{
  for (const int node : same)
  {
    Extraction extraction(spoiled.state);
    std::vector<Singular_place>& places = extraction.singular_places;
    places.erase(std::remove_if(places.begin(), places.end(),
                                [&](const Singular_place& place) { return place.node == node; }),
                 places.end());
    expect_problem_among(certify(spoiled.state, extraction),
                         "the indices at node " + std::to_string(node) + " add up to 0 instead of");
  }
}

TEST_F(Certificate_of_extraction, each_arc_without_its_middle_leaf)
{
  for (const std::size_t arc : {0, 1, 2, 3})
  {
    Extraction extraction(spoiled.state);
    extraction.middle_leaves[arc].clear();
    expect_problem_among(
      certify(spoiled.state, extraction),
      "the middle leaf of arc " + std::to_string(arc) + " is not homotopic to its loop", {}, {arc});
  }
}

// One leaf is that of the arc, and one is not; the latter is one of arc 2, whose lifts have wrong
// names.
TEST_F(Certificate_of_extraction, middle_leaf_beside_the_right_one)
{
  spoiled.take(solved.foliation.state(), same, same, [](int arc, const Group_word& name) {
    Group_word result = name;
    if (arc == 2)
      result.insert(result.end(), name.begin(), name.end());
    return result;
  });
  Extraction extraction(spoiled.state);
  extraction.middle_leaves[3].insert(extraction.middle_leaves[3].end(),
                                     extraction.middle_leaves[2].begin(),
                                     extraction.middle_leaves[2].end());
  expect_problem_among(certify(spoiled.state, extraction),
                       "the middle leaf of arc 3 is not homotopic to its loop", {}, {3});
}

TEST_F(Certificate_of_extraction, component_with_a_handle)
{
  Extraction extraction(spoiled.state);
  auto& component = const_cast<Leaf_graph::Component&>(extraction.leaf_graph.components()[0]);
  component.euler_characteristic = -2;
  const int arc = extraction.refined_mesh.faces[component.first_face].arc;
  expect_problem_among(certify(spoiled.state, extraction),
                       "is not an annulus: Euler characteristic -2, 2 ends", {},
                       {static_cast<std::size_t>(arc)});
}

TEST_F(Certificate_of_extraction, thorn_that_is_not_given)
{
  Extraction extraction(spoiled.state);
  const int v = vertex_deep_in_arc(spoiled.state, 1);
  extraction.singular_places.push_back({false, v, 1, 4});
  expect_problem_among(certify(spoiled.state, extraction),
                       "vertex " + std::to_string(v) +
                         " is a pole of index 1 that is not among the poles given",
                       {static_cast<std::size_t>(v)});
}

TEST_F(Certificate_of_extraction, component_in_no_arc)
{
  Extraction extraction(spoiled.state);
  const int first = extraction.leaf_graph.components()[0].first_face;
  const int other = extraction.leaf_graph.components()[1].first_face;
  extraction.refined_mesh.faces[first].arc = Refined_mesh::NONE;
  expect_problem_among(certify(spoiled.state, extraction), "a component lies in no arc");
  extraction.refined_mesh.faces[first].arc = extraction.refined_mesh.faces[other].arc;
  expect_problem_among(certify(spoiled.state, extraction), "has several components", {},
                       {static_cast<std::size_t>(extraction.refined_mesh.faces[other].arc)});
}

} // namespace test_certificate_of_extraction
