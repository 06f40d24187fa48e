// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_EXAMPLE_SYSTEMS_H
#define SMF_TEST_EXAMPLE_SYSTEMS_H

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "system_items.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

// A dozen small loop systems, one of each sort, that can be put on a mesh of any type.

namespace smf_test {

namespace SMF = CGAL::Surface_mesh_foliation;

// ===  The examples

struct Example
{
  std::string name;
  Triangle_soup soup;
  std::vector<Item> items;
};

// the vertex that lies farthest in a direction
inline std::size_t extreme_vertex(const Triangle_soup& soup, const soups::Point& direction)
{
  const auto is_before = [&](const soups::Point& p, const soups::Point& q) {
    return soups::dot(p, direction) < soups::dot(q, direction);
  };
  return static_cast<std::size_t>(
    std::max_element(soup.points.begin(), soup.points.end(), is_before) - soup.points.begin());
}

// the vertices of row i of soups::torus(m, n, ...), around the tube
inline std::vector<std::size_t> meridian(std::size_t i, std::size_t n)
{
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < n; ++j)
    result.push_back(i * n + j);
  return result;
}

// the vertices of column j of soups::torus(m, n, ...), around the axis
inline std::vector<std::size_t> longitude(std::size_t j, std::size_t m, std::size_t n)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < m; ++i)
    result.push_back(i * n + j);
  return result;
}

inline std::vector<Item> pole_items(const std::vector<std::size_t>& vertices)
{
  std::vector<Item> result;
  for (const std::size_t vertex : vertices)
    result.push_back({Item::POLE, {vertex}});
  return result;
}

// a plate with two holes in a row along x, and the planes that cut its handles or its middle
struct Double_torus
{
  explicit Double_torus(std::size_t resolution = 2) : soup(soups::genus_surface(2, resolution))
  {
    const double r = static_cast<double>(resolution);
    const double x = 2.5 * r, y = 1.5 * r;
    const std::size_t left = extreme_vertex(soup, {-1, 0, 0});
    const std::size_t right = extreme_vertex(soup, {1, 0, 0});
    std::size_t inner = 0;
    for (std::size_t v = 0; v < soup.points.size(); ++v)
      if (soups::distance(soup.points[v], {x, y, r / 2}) <
          soups::distance(soup.points[inner], {x, y, r / 2}))
        inner = v;
    left_handle = {Item::PLANE, {left}, 1, {0, 1, 0, -y - 1e-3}};
    middle_bridge = {Item::PLANE, {inner}, 1, {0, 1, 0, -y - 1e-3}};
    right_handle = {Item::PLANE, {right}, 1, {0, 1, 0, -y - 1e-3}};
    waist = {Item::PLANE, {inner}, 1, {1, 0, 0, -x - 1e-3}};
  }

  Triangle_soup soup;
  Item left_handle, middle_bridge, right_handle, waist;
};

inline Example theta_example()
{
  const Double_torus torus;
  return {"theta", torus.soup, {torus.left_handle, torus.middle_bridge, torus.right_handle}};
}

inline Example dumbbell_example()
{
  const Double_torus torus;
  return {"dumbbell", torus.soup, {torus.left_handle, torus.waist, torus.right_handle}};
}

inline std::vector<Example> example_systems()
{
  std::vector<Example> result;
  result.push_back({"limbs", soups::limbed_sphere(5, 3), pole_items(soups::limb_tips(5, 3))});
  const Triangle_soup sphere = soups::icosphere(2);
  const std::size_t top = extreme_vertex(sphere, {0, 0, 1});
  const std::size_t bottom = extreme_vertex(sphere, {0, 0, -1});
  result.push_back({"two poles", sphere, pole_items({top, bottom})});
  const std::size_t m = 14, n = 9;
  const Triangle_soup torus = soups::torus(m, n, 3, 1);
  result.push_back({"torus without pole", torus, {{Item::CYCLE, meridian(3, n), 2.5}}});
  result.push_back({"torus with poles",
                    torus,
                    {{Item::POLE, {0}},
                     {Item::POLE, {7 * n + 4}, 0.3},
                     {Item::CYCLE, meridian(3, n), 2},
                     {Item::CYCLE, meridian(10, n)}}});
  result.push_back(
    {"self-arc and pole", torus, {{Item::POLE, {5}}, {Item::CYCLE, meridian(9, n)}}});
  result.push_back(theta_example());
  result.push_back(dumbbell_example());
  const Triangle_soup three_holes = soups::genus_surface(3, 2);
  result.push_back({"genus in a region", three_holes,
                    pole_items({extreme_vertex(three_holes, {1, 1, 0}),
                                extreme_vertex(three_holes, {-1, -1, 0})})});
  result.push_back({"line pole",
                    soups::torus(m, n, 3, 1),
                    {{Item::LINE_POLE, {0, n, 2 * n, 3 * n}, 1.5}, {Item::CYCLE, meridian(8, n)}}});
  result.push_back({"tetrahedron", soups::tetrahedron(), pole_items({0, 1, 2, 3})});
  result.push_back({"adjacent poles", soups::octahedron(), pole_items({0, 2, 4})});
  return result;
}

inline std::vector<Example> make_all_example_systems()
{
  std::vector<Example> result = example_systems();
  result.push_back({"more limbs", soups::limbed_sphere(7, 4), pole_items(soups::limb_tips(7, 4))});
  result.back().items[2].height = 0.01;
  const Double_torus torus(3);
  result.push_back({"all loops",
                    torus.soup,
                    {{Item::POLE, {7}, 4},
                     torus.left_handle,
                     torus.middle_bridge,
                     torus.right_handle,
                     {Item::LINE_POLE, {100}, 20}}});
  result.push_back(
    {"rough surface", soups::noisy(soups::genus_surface(4, 3), 0.3, 5), pole_items({3, 200, 201})});
  // two poles at the end of one limb: on the others the parameters are equal to rounding
  const Triangle_soup limbs = soups::limbed_sphere(5, 4);
  const std::size_t tip = soups::limb_tips(5, 4)[1];
  const auto at_tip = std::find_if(limbs.triangles.begin(), limbs.triangles.end(),
                                   [&](const auto& triangle) { return triangle[0] == tip; });
  result.push_back({"plateaus", limbs, pole_items({tip, (*at_tip)[1], (*at_tip)[2]})});
  std::vector<std::size_t> all(16);
  std::iota(all.begin(), all.end(), std::size_t(0));
  result.push_back({"poles everywhere", soups::torus(4, 4, 3, 1), pole_items(all)});
  return result;
}

// these and some larger ones, which take more iterations; made once, though many suites use them
inline const std::vector<Example>& all_example_systems()
{
  static const std::vector<Example> result = make_all_example_systems();
  return result;
}

// ===  An example put on a mesh, and solved

inline void PrintTo(const Example& example, std::ostream* out)
{
  *out << example.name;
}

// for INSTANTIATE_TEST_SUITE_P
inline std::string name_of_example(const ::testing::TestParamInfo<Example>& info)
{
  std::string name = info.param.name;
  for (char& c : name)
    c = c == ' ' || c == '-' ? '_' : c;
  return name;
}

// `mesh` stays where it is, as system and foliation refer to it.
template <class TriangleMesh = Mesh>
struct Solved_example
{
  explicit Solved_example(const Example& example)
    : mesh(new TriangleMesh(to_mesh<TriangleMesh>(example.soup))), // a copy may be reordered
      input(poles_and_loops(example.items, *mesh)),
      system(*mesh, input),
      foliation(SMF::harmonic_foliation(system))
  {}

  std::unique_ptr<TriangleMesh> mesh;
  SMF::Poles_and_loops<TriangleMesh> input;
  SMF::Loop_system<TriangleMesh> system;
  SMF::Measured_foliation<TriangleMesh> foliation;
};

} // namespace smf_test

#endif // SMF_TEST_EXAMPLE_SYSTEMS_H
