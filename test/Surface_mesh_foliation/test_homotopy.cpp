// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/test_meshes.h"
#include "include/test_random.h"

#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Regions.h>
#include <CGAL/Surface_mesh_foliation/internal/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/loop_checks.h>

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Our tests of homotopy, by Euler characteristics, against CGAL's of arbitrary curves [45] on the
// surface without the faces around the poles: on all contours that a sweep proposes.

namespace {

namespace smf = CGAL::Surface_mesh_foliation;
namespace internal = smf::internal;
using internal::Flat_loop;
using internal::Flat_mesh;
using internal::Pole;
using smf_test::Mesh;
using Path = CGAL::Surface_mesh_topology::Path_on_surface<Mesh>;
using Oracle = CGAL::Surface_mesh_topology::Curves_on_surface_topology<Mesh>;
using Walk = std::vector<Mesh::Halfedge_index>; // closed, along edges; empty: it stays at a vertex

class Surface
{
public:
  Surface(Mesh mesh, const std::vector<int>& pole_vertices) : m_mesh(std::move(mesh))
  {
    internal::Mesh_index<Mesh> index(m_mesh);
    EXPECT_TRUE(
      internal::build_flat_mesh(CGAL::parameters::default_values(), index, m_flat).empty());
    for (int v : pole_vertices)
      m_poles.push_back({v});
    const internal::Sweep sweep(internal::geodesic_sweep(m_flat, m_poles), m_poles);
    internal::Proposed_loops proposed(m_flat, m_poles, sweep);
    m_loops = proposed.loops();
    proposed.reduce(true);
    for (const Flat_loop& loop : proposed.loops())
      m_kept.push_back(position(loop));
    for (const Flat_loop& loop : m_loops)
      m_walks.push_back(walk_beside(loop, index));
    make_holes();
    m_oracle = std::make_unique<Oracle>(m_mesh);
  }

  int number_of_loops() const { return static_cast<int>(m_loops.size()); }
  int number_of_poles() const { return static_cast<int>(m_poles.size()); }
  const std::vector<int>& kept() const { return m_kept; }

  // no walk beside the loop avoids the poles
  bool is_hidden(int a) const { return !m_walks[a]; }

  // ===  By Euler characteristics

  bool is_inessential(int a) const
  {
    return has_problem({m_loops[a]}, smf::Problem_kind::INESSENTIAL_LOOP);
  }
  bool are_homotopic(int a, int b) const
  {
    return has_problem({m_loops[a], m_loops[b]}, smf::Problem_kind::HOMOTOPIC_LOOPS);
  }
  bool is_around_pole(int a, int p) const
  {
    return has_problem({m_loops[a], internal::tight_loop(m_flat, m_poles[p], p, 1)},
                       smf::Problem_kind::HOMOTOPIC_LOOPS);
  }

  // ===  By CGAL

  bool is_contractible(int a) const
  {
    return m_walks[a]->empty() || m_oracle->is_contractible(path(*m_walks[a]));
  }
  bool are_freely_homotopic(int a, int b) const { return are_homotopic(*m_walks[a], *m_walks[b]); }
  bool is_homotopic_to_rim(int a, int p) const { return are_homotopic(*m_walks[a], m_rims[p]); }

private:
  int position(const Flat_loop& loop) const
  {
    const auto is_same = [&](const Flat_loop& other) {
      return std::equal(loop.crossings.begin(), loop.crossings.end(), other.crossings.begin(),
                        other.crossings.end(),
                        [](const auto& x, const auto& y) { return x.halfedge == y.halfedge; });
    };
    const auto found = std::find_if(m_loops.begin(), m_loops.end(), is_same);
    EXPECT_NE(found, m_loops.end());
    return static_cast<int>(found - m_loops.begin());
  }

  bool is_pole(int v) const
  {
    return std::find(m_poles.begin(), m_poles.end(), Pole{v}) != m_poles.end();
  }

  // The walk along the vertices to the left of a loop, or else to its right, that meets no pole.
  std::optional<Walk> walk_beside(const Flat_loop& loop,
                                  const internal::Mesh_index<Mesh>& index) const
  {
    for (bool is_left : {true, false})
    {
      std::vector<int> corners;
      for (const auto& crossing : loop.crossings)
        corners.push_back(is_left ? m_flat.target(crossing.halfedge)
                                  : m_flat.source(crossing.halfedge));
      if (std::any_of(corners.begin(), corners.end(), [&](int v) { return is_pole(v); }))
        continue;
      Walk walk;
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        const int u = corners[i], v = corners[(i + 1) % corners.size()];
        if (u != v)
          walk.push_back(index.halfedge_descriptor_of(m_flat.find_halfedge(u, v)));
      }
      return walk;
    }
    return std::nullopt;
  }

  void make_holes()
  {
    for (const Pole& pole : m_poles)
    {
      const auto v = smf_test::vertex(static_cast<std::size_t>(pole[0]));
      Walk rim;
      for (const auto h : CGAL::halfedges_around_target(v, m_mesh))
        rim.push_back(prev(h, m_mesh));
      // they go around the vertex clockwise, as their faces do; a path goes the other way
      std::reverse(rim.begin(), rim.end());
      m_rims.push_back(rim);
      const auto faces = CGAL::faces_around_target(halfedge(v, m_mesh), m_mesh);
      for (const auto f : std::vector<Mesh::Face_index>(faces.begin(), faces.end()))
        CGAL::Euler::remove_face(halfedge(f, m_mesh), m_mesh);
    }
  }

  Path path(const Walk& walk) const
  {
    Path result(m_mesh);
    for (const auto h : walk)
      result.push_back(h);
    EXPECT_TRUE(result.is_closed());
    return result;
  }

  bool are_homotopic(const Walk& a, const Walk& b) const
  {
    if (a.empty() || b.empty())
      return a.empty() && b.empty();
    Path p = path(a);
    const Path q = path(b);
    if (m_oracle->are_freely_homotopic(p, q))
      return true;
    p.reverse();
    return m_oracle->are_freely_homotopic(p, q);
  }

  bool has_problem(const std::vector<Flat_loop>& loops, smf::Problem_kind kind) const
  {
    const internal::Edge_crossings crossings(m_flat, loops);
    internal::Problems problems;
    internal::Disjointness_check(m_flat, loops, crossings, problems);
    EXPECT_TRUE(problems.empty());
    const internal::Regions regions(m_flat, m_poles, loops, crossings);
    internal::check_regions(m_flat, m_poles, loops, regions, false, problems);
    return std::any_of(problems.begin(), problems.end(),
                       [&](const smf::Problem& problem) { return problem.kind == kind; });
  }

  Mesh m_mesh; // with a hole around each pole, in the end
  Flat_mesh m_flat;
  std::vector<Pole> m_poles;
  std::vector<Flat_loop> m_loops; // all that are proposed
  std::vector<int> m_kept;        // those that are not superfluous
  std::vector<std::optional<Walk>> m_walks;
  std::vector<Walk> m_rims; // by pole
  std::unique_ptr<Oracle> m_oracle;
};

struct Count
{
  int hidden = 0, inessential = 0, around_pole = 0, homotopic = 0, different = 0;
};

void compare(const Surface& surface, Count& count)
{
  for (int a = 0; a < surface.number_of_loops(); ++a)
  {
    if (surface.is_hidden(a))
    {
      ++count.hidden;
      continue;
    }
    const bool is_inessential = surface.is_inessential(a);
    EXPECT_EQ(surface.is_contractible(a), is_inessential) << "loop " << a;
    count.inessential += is_inessential;
    for (int p = 0; p < surface.number_of_poles(); ++p)
    {
      const bool is_around_pole = !is_inessential && surface.is_around_pole(a, p);
      EXPECT_EQ(surface.is_homotopic_to_rim(a, p), is_around_pole)
        << "loop " << a << ", pole " << p;
      count.around_pole += is_around_pole;
    }
    for (int b : surface.kept())
      if (a != b && !surface.is_hidden(b))
      {
        const bool are_homotopic = surface.are_homotopic(a, b);
        EXPECT_EQ(surface.are_freely_homotopic(a, b), are_homotopic) << "loops " << a << " " << b;
        ++(are_homotopic ? count.homotopic : count.different);
      }
  }
}

// vertices that share no neighbour
std::vector<int> random_poles(const Mesh& mesh, std::size_t number, std::uint64_t seed)
{
  std::vector<int> result;
  std::vector<bool> is_near(num_vertices(mesh), false);
  for (const std::size_t i : smf_test::Random(seed).permutation(num_vertices(mesh)))
  {
    const auto v = smf_test::vertex(i);
    bool is_free = result.size() < number && !is_near[i];
    for (const auto u : CGAL::vertices_around_target(v, mesh))
      is_free = is_free && !is_near[u];
    if (!is_free)
      continue;
    result.push_back(static_cast<int>(i));
    is_near[i] = true;
    for (const auto u : CGAL::vertices_around_target(v, mesh))
      is_near[u] = true;
  }
  return result;
}

TEST(Homotopy, on_generated_meshes)
{
  Count count;
  for (std::size_t genus = 0; genus <= 5; ++genus)
    for (std::uint64_t seed : {1, 2})
      for (std::size_t poles : {0, 4})
      {
        if (genus == 0 && poles == 0)
          continue; // everything is contractible
        SCOPED_TRACE("genus " + std::to_string(genus) + ", seed " + std::to_string(seed) + ", " +
                     std::to_string(poles) + " poles");
        Mesh mesh = seed == 1 && genus > 0 ? smf_test::genus_surface(genus, 2, seed)
                                           : smf_test::handle_surface(genus, seed);
        mesh = smf_test::noisy(mesh, 0.1, seed);
        const std::vector<int> pole_vertices = random_poles(mesh, poles, seed);
        ASSERT_EQ(pole_vertices.size(), poles);
        compare(Surface(std::move(mesh), pole_vertices), count);
      }
  std::cout << count.inessential << " inessential, " << count.around_pole << " around a pole, "
            << count.homotopic << " homotopic pairs of " << count.homotopic + count.different
            << ", " << count.hidden << " left out\n";
  EXPECT_GT(count.inessential, 20);
  EXPECT_GT(count.around_pole, 20);
  EXPECT_GT(count.homotopic, 50);
  EXPECT_GT(count.different, 500);
  EXPECT_LT(count.hidden, (count.inessential + count.around_pole + count.homotopic) / 10);
}

class Homotopy_on_files : public ::testing::TestWithParam<std::string>
{};

TEST_P(Homotopy_on_files, agrees)
{
  Mesh mesh;
  smf::read_triangle_mesh(GetParam(), mesh);
  if (num_vertices(mesh) > 10000)
    GTEST_SKIP() << "takes minutes (they agree there, too)";
  Count count;
  const std::vector<int> poles = random_poles(mesh, 4, 3);
  compare(Surface(std::move(mesh), poles), count);
  EXPECT_GT(count.around_pole, 0);
}

std::vector<std::string> files()
{
  const std::string cgal = SMF_DATA_DIR, shared = SMF_SHARED_DIR;
  std::vector<std::string> result =
    smf_test::all_shared_meshes(shared.empty() ? shared : shared + "/meshes");
  if (!cgal.empty())
    for (const char* name : {"/elephant.off", "/hand.off"})
      result.push_back(cgal + name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Meshes, Homotopy_on_files, ::testing::ValuesIn(files()));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Homotopy_on_files);

} // namespace
