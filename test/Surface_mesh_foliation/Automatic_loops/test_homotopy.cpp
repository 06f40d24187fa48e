// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/homotopy_oracle.h"
#include "generators/meshes.h"
#include "generators/Random.h"

#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Regions.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>

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

namespace test_homotopy {

// Our tests of homotopy, by Euler characteristics, against CGAL's of arbitrary curves (Erickson and
// Whittlesey, "Transforming curves on surfaces redux") on the surface without the faces around the
// poles: on all contours that a sweep proposes.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace internal = SMF::internal;
using internal::Flat_loop;
using internal::Flat_mesh;
using internal::Pole;
using smf_test::Homotopy_oracle;
using smf_test::Mesh;

class Surface
{
public:
  Surface(Mesh mesh, const std::vector<int>& pole_vertices) : m_mesh(std::move(mesh))
  {
    internal::Mesh_index<Mesh> index(m_mesh);
    internal::Capped_mesh capped;
    EXPECT_TRUE(
      internal::build_flat_mesh(CGAL::parameters::default_values(), index, capped).empty());
    m_flat = std::move(capped.mesh);
    index.number_halfedges(m_flat);
    for (int v : pole_vertices)
      m_poles.push_back({v});
    const internal::Sweep sweep(internal::geodesic_sweep(m_flat, m_poles), m_poles);
    internal::Proposed_loops proposed(m_flat, m_poles, sweep);
    m_loops = proposed.loops();
    proposed.reduce(true);
    for (const Flat_loop& loop : proposed.loops())
      m_kept.push_back(position(loop));
    std::vector<Mesh::Vertex_index> poles;
    for (int v : pole_vertices)
      poles.push_back(index.vertex(v));
    m_oracle = std::make_unique<Homotopy_oracle>(m_mesh, poles);
    for (const Flat_loop& loop : m_loops)
      m_walks.push_back(m_oracle->walk_beside(loop_on_mesh(loop, index)));
  }

  int number_of_loops() const { return static_cast<int>(m_loops.size()); }
  int number_of_poles() const { return static_cast<int>(m_poles.size()); }
  const std::vector<int>& kept() const { return m_kept; }

  // no walk beside the loop avoids the poles
  bool is_hidden(int a) const { return !m_walks[a]; }

  // ===  By Euler characteristics

  bool is_inessential(int a) const
  {
    return has_problem({m_loops[a]}, SMF::Problem_kind::INESSENTIAL_LOOP);
  }
  bool are_homotopic(int a, int b) const
  {
    return has_problem({m_loops[a], m_loops[b]}, SMF::Problem_kind::HOMOTOPIC_LOOPS);
  }
  bool is_around_pole(int a, int p) const
  {
    return has_problem({m_loops[a], internal::tight_loop(m_flat, m_poles[p], p, 1)},
                       SMF::Problem_kind::HOMOTOPIC_LOOPS);
  }

  // ===  By CGAL

  bool is_contractible(int a) const { return m_oracle->is_contractible(*m_walks[a]); }
  bool are_freely_homotopic(int a, int b) const
  {
    return m_oracle->are_freely_homotopic(*m_walks[a], *m_walks[b]);
  }
  bool is_homotopic_to_rim(int a, int p) const
  {
    return m_oracle->are_freely_homotopic(*m_walks[a], m_oracle->rims()[p]);
  }

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

  static Homotopy_oracle::Loop loop_on_mesh(const Flat_loop& loop,
                                            const internal::Mesh_index<Mesh>& index)
  {
    Homotopy_oracle::Loop result;
    for (const auto& crossing : loop.crossings)
      result.push_back({index.halfedge_descriptor_of(crossing.halfedge), crossing.position});
    return result;
  }

  bool has_problem(const std::vector<Flat_loop>& loops, SMF::Problem_kind kind) const
  {
    const internal::Edge_crossings crossings(m_flat, loops);
    internal::Problems problems;
    internal::check_disjointness(m_flat, loops, crossings, problems);
    EXPECT_TRUE(problems.empty());
    const internal::Regions regions(m_flat, m_poles, loops, crossings);
    internal::check_regions(m_flat, m_poles, loops, regions, false, problems);
    return std::any_of(problems.begin(), problems.end(),
                       [&](const SMF::Problem& problem) { return problem.kind == kind; });
  }

  Mesh m_mesh;
  Flat_mesh m_flat;
  std::vector<Pole> m_poles;
  std::vector<Flat_loop> m_loops; // all that are proposed
  std::vector<int> m_kept;        // those that are not superfluous
  std::vector<std::optional<Homotopy_oracle::Walk>> m_walks;
  std::unique_ptr<Homotopy_oracle> m_oracle;
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

// vertices that share no neighbor
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
  SMF::read_triangle_mesh(GetParam(), mesh);
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

} // namespace test_homotopy
