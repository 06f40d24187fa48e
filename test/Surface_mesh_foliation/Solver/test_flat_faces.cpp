// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Faces that are flat up to rounding: vertices on edges, closed by a face that is nearly a segment,
// at midpoints, at random places, at poles, and needles of any height. Every system converges and
// is certified.

#include "generators/Random.h"
#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iterator>
#include <set>
#include <vector>

namespace test_flat_faces {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_test;

enum Kind { MIDPOINTS, RANDOM_PLACES, NEEDLES, AT_POLES };

// Splits a side of a face by a vertex on it, or close to it in the direction of the third corner,
// and closes the gap by a flat face.
void add_flat_face(Triangle_soup& soup, std::size_t face, double share, double height)
{
  const auto [u, v, apex] = soup.triangles[face];
  soups::Point p;
  for (int i : {0, 1, 2})
    p[i] = soup.points[u][i] * (1 - share) + soup.points[v][i] * share +
           height * (soup.points[apex][i] - soup.points[u][i]);
  const std::size_t middle = soup.points.size();
  soup.points.push_back(p);
  soup.triangles[face] = {u, middle, apex};
  soup.triangles.push_back({middle, v, apex});
  soup.triangles.push_back({u, v, middle});
}

// a face at one of the vertices
std::size_t face_at(const Triangle_soup& soup, const std::vector<std::size_t>& vertices, Random& r)
{
  const std::size_t v = vertices[r.index(vertices.size())];
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (std::count(soup.triangles[f].begin(), soup.triangles[f].end(), v) > 0)
      faces.push_back(f);
  return faces[r.index(faces.size())];
}

struct System
{
  Triangle_soup soup;
  std::vector<std::size_t> poles;
};

System system_with_flat_faces(std::uint64_t seed)
{
  Random random(seed);
  System result;
  const std::size_t limbs = 3 + random.index(4);
  result.soup = random.index(2) == 0 ? soups::noisy(soups::icosphere(3), 0.2, seed)
                                     : soups::limbed_sphere(limbs, 3);
  std::set<std::size_t> poles;
  while (poles.size() < limbs)
    poles.insert(random.index(result.soup.points.size()));
  result.poles.assign(poles.begin(), poles.end());
  const auto kind = static_cast<Kind>(random.index(4));
  for (std::size_t i = 5 + random.index(16); i > 0; --i)
  {
    const std::size_t face = kind == AT_POLES ? face_at(result.soup, result.poles, random)
                                              : random.index(result.soup.triangles.size());
    const double share = kind == MIDPOINTS ? 0.5 : random.between(0.01, 0.99);
    const double height = kind == NEEDLES ? std::pow(10., random.between(-16, -3)) : 0;
    add_flat_face(result.soup, face, share, height);
  }
  return result;
}

} // namespace

TEST(Flat_faces, systems_on_them_converge_certified)
{
  int number_of_systems = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed)
  {
    SCOPED_TRACE(seed);
    const System example = system_with_flat_faces(seed);
    if (!SMF::check_triangle_soup(example.soup).empty())
      continue; // a face is exactly degenerate
    ++number_of_systems;
    const Mesh mesh = to_mesh(example.soup);
    SMF::Poles_and_loops<Mesh> input;
    for (const std::size_t pole : example.poles)
      input.add_pole(Mesh::Vertex_index(static_cast<Mesh::size_type>(pole)));
    try
    {
      const SMF::Loop_system<Mesh> system(mesh, input);
      const SMF::Foliation_statistics newton = SMF::harmonic_foliation(system).statistics();
      EXPECT_TRUE(newton.has_converged) << newton.optimality;
      EXPECT_TRUE(newton.is_certified);
    }
    catch (const std::exception& exception)
    {
      ADD_FAILURE() << exception.what();
    }
  }
  EXPECT_GT(number_of_systems, 100);
}

TEST(Flat_faces, have_weights_that_are_capped)
{
  Triangle_soup soup = soups::icosphere(3);
  soup.points[5][0] += 0.013; // so that the midpoint is rounded
  for (std::size_t face = 0; face < soup.triangles.size(); face += 97)
    add_flat_face(soup, face, 0.5, 1e-15);
  const Mesh mesh = to_mesh(soup);
  SMF::Poles_and_loops<Mesh> input;
  input.add_pole(Mesh::Vertex_index(0));
  input.add_pole(Mesh::Vertex_index(1));
  const SMF::Loop_system<Mesh> system(mesh, input);
  std::vector<double> weights = SMF::internal::mean_value_weights(system.data().flat.mesh);
  std::sort(weights.begin(), weights.end());
  EXPECT_GT(weights.front(), 0);
  EXPECT_DOUBLE_EQ(weights.back(), 1e5 * weights[weights.size() / 2]);
}

} // namespace test_flat_faces
