// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor that stops functions that find poles and loops.

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

namespace test_stopping_detectors {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = SMF::parameters;
using namespace smf_test;

// Says at the n-th call of `go_on()` that no result is wanted.
struct Stop_at : SMF::Default_foliation_visitor
{
  explicit Stop_at(std::size_t n) : limit(n) {}
  bool go_on()
  {
    EXPECT_LT(calls, limit) << "a call after the stop";
    return ++calls < limit;
  }

  std::size_t limit, calls = 0;
};

// Stops a function at one call after another, with growing steps; returns the number of its calls.
template <class Run, class Check>
std::size_t stop_everywhere(const Run& run, const Check& is_untouched)
{
  for (std::size_t n = 1;; n += 1 + n / 2)
  {
    SCOPED_TRACE("call " + std::to_string(n));
    Stop_at visitor(n);
    try
    {
      run(visitor);
      return visitor.calls;
    }
    catch (const SMF::Stopped_exception&)
    {
      is_untouched();
    }
  }
}

class Stopped_detectors : public ::testing::Test
{
protected:
  // of genus 0, 1 and 3
  const std::vector<Mesh> meshes{to_mesh(soups::limbed_sphere(5, 3)),
                                 to_mesh(soups::torus(24, 12, 3, 1)),
                                 to_mesh(soups::handle_surface(3))};
};

} // namespace

TEST_F(Stopped_detectors, find_poles)
{
  for (const Mesh& mesh : meshes)
  {
    std::vector<Mesh::Vertex_index> poles, all;
    SMF::detect_feature_poles(mesh, std::back_inserter(all));
    const std::size_t calls = stop_everywhere(
      [&](Stop_at& visitor) {
        SMF::detect_feature_poles(mesh, std::back_inserter(poles), np::visitor(std::ref(visitor)));
      },
      [&] { EXPECT_TRUE(poles.empty()); });
    EXPECT_EQ(poles, all);
    EXPECT_GE(calls, 16 + all.size()) << "for samples and for maxima";
  }
}

TEST_F(Stopped_detectors, find_loops)
{
  for (const Mesh& mesh : meshes)
  {
    SMF::Poles_and_loops<Mesh> input;
    for (const std::size_t v : {0u, 40u, 80u, 100u})
      input.add_pole(vertex(v));
    std::size_t number_of_loops = 0;
    const std::size_t calls = stop_everywhere(
      [&](Stop_at& visitor) {
        number_of_loops =
          SMF::canonical_loops(mesh, input, np::visitor(std::ref(visitor)).min_modulus(0.)).size();
      },
      [&] { EXPECT_EQ(input.size(), 4u); });
    EXPECT_EQ(input.size(), 4 + number_of_loops);
    EXPECT_GT(calls, number_of_loops);
  }
}

TEST_F(Stopped_detectors, find_canonical_graphs)
{
  for (const Mesh& mesh : meshes)
  {
    SMF::Reeb_graph<Mesh::Point> graph;
    Stop_at never(static_cast<std::size_t>(-1));
    const auto foliation = SMF::canonical_reeb_graph(mesh, graph, np::visitor(std::ref(never)));
    Stop_at only_solving(static_cast<std::size_t>(-1));
    SMF::harmonic_foliation(foliation.system(), np::visitor(std::ref(only_solving)));
    EXPECT_GT(never.calls, only_solving.calls) << "what finds poles and loops asks, too";

    SMF::Reeb_graph<Mesh::Point> untouched;
    Stop_at visitor(never.calls - only_solving.calls); // the last call before the solver's
    EXPECT_THROW(SMF::canonical_reeb_graph(mesh, untouched, np::visitor(std::ref(visitor))),
                 SMF::Stopped_exception);
    EXPECT_EQ(num_vertices(untouched), 0u);
  }
}

} // namespace test_stopping_detectors
