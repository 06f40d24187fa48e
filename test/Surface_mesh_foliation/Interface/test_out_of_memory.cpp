// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Memory that runs out at the n-th allocation, in every public function: std::bad_alloc arrives,
// nothing leaks, and what was passed in is as it was. This program counts its allocations, so it is
// one by itself. (Eigen's are not counted.)

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/soups.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/loop_modulus.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <new>
#include <optional>
#include <string>
#include <vector>

namespace test_out_of_memory {

// ===  Counted allocations

namespace {

std::atomic<std::ptrdiff_t> number_alive{0};
std::atomic<std::ptrdiff_t> number_left{-1}; // allocations that succeed; -1: all do
std::atomic<bool> was_refused{false};        // one of them

bool is_granted()
{
  if (number_left < 0)
    return true;
  if (number_left == 0)
  {
    was_refused = true;
    return false;
  }
  --number_left;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment)
{
  void* result = nullptr;
  if (is_granted())
    result = alignment <= alignof(std::max_align_t)
               ? std::malloc(size == 0 ? 1 : size)
               : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (result == nullptr)
    throw std::bad_alloc();
  ++number_alive;
  return result;
}

void release(void* memory)
{
  if (memory == nullptr)
    return;
  --number_alive;
  std::free(memory);
}

} // namespace

} // namespace test_out_of_memory

// (The forms for arrays call these.)
void* operator new(std::size_t size)
{
  return test_out_of_memory::allocate(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment)
{
  return test_out_of_memory::allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try
  {
    return test_out_of_memory::allocate(size, 1);
  }
  catch (const std::bad_alloc&)
  {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept
{
  test_out_of_memory::release(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
  test_out_of_memory::release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
  test_out_of_memory::release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
  test_out_of_memory::release(memory);
}

namespace test_out_of_memory {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = SMF::parameters;
using namespace smf_test;
using Input = SMF::Poles_and_loops<Mesh>;
using Graph = SMF::Reeb_graph<Mesh::Point>;
using Foliation = SMF::Measured_foliation<Mesh>;

// Runs a function with only so many allocations; returns whether these were enough.
template <class Function>
bool run_with(std::ptrdiff_t allocations, const Function& function)
{
  was_refused = false;
  number_left = allocations;
  try
  {
    function();
    number_left = -1;
    return !was_refused; // std::stable_sort() does without
  }
  catch (const std::bad_alloc&)
  {
    number_left = -1;
    EXPECT_TRUE(was_refused);
    return false;
  }
}

// Runs a function again and again, each time with a few more allocations. What it makes it
// destroys. `check` looks whether what was passed in is as it was.
template <class Function, class Check>
void starve(const Function& function, const Check& check)
{
  // CGAL's Surface_mesh loses a property for which there is no room
  constexpr std::ptrdiff_t lost_by_others = 1;
  function(); // libraries keep what they allocate in the first run
  std::ptrdiff_t n = 0;
  for (std::ptrdiff_t before = number_alive; !run_with(n, function); n += 1 + n / 7)
  {
    ASSERT_LE(number_alive - before, lost_by_others) << "allocation " << n;
    before = number_alive;
    ASSERT_NO_FATAL_FAILURE(check()) << "allocation " << n;
  }
  EXPECT_GT(n, 0) << "nothing is allocated";
}

template <class Function>
void starve(const Function& function)
{
  starve(function, [] {});
}

// Appends to a graph that has got some already, each time with one allocation more.
template <class G, class Append>
void starve_appending(const Append& append)
{
  G result;
  append(result);
  const std::size_t nodes = num_vertices(result), arcs = num_edges(result);
  ASSERT_GT(arcs, 0u);
  bool is_done = false;
  const auto append_again = [&] {
    is_done = false;
    append(result);
    is_done = true;
  };
  std::ptrdiff_t n = 0;
  for (; !run_with(n, append_again); ++n)
  {
    if (is_done) // without what was refused
    {
      result = G();
      append(result);
    }
    ASSERT_EQ(num_vertices(result), nodes) << "allocation " << n;
    ASSERT_EQ(num_edges(result), arcs) << "allocation " << n;
    std::size_t sum_of_degrees = 0;
    for (const auto v : boost::make_iterator_range(vertices(result)))
      sum_of_degrees += out_degree(v, result);
    ASSERT_EQ(sum_of_degrees, 2 * arcs) << "allocation " << n;
  }
  EXPECT_GT(n, 0) << "nothing is allocated";
  EXPECT_EQ(num_vertices(result), 2 * nodes);
  EXPECT_EQ(num_edges(result), 2 * arcs);
}

class Out_of_memory : public ::testing::Test
{
protected:
  Out_of_memory()
  {
    input.add_pole(vertex(0));
    input.add_pole(vertex(40));
    SMF::propose_loops(torus, input);
    foliation.emplace(SMF::harmonic_foliation(SMF::Loop_system<Mesh>(torus, input)));
    SMF::reeb_graph(*foliation, graph);
  }

  const Mesh torus = to_mesh(soups::torus(12, 8, 3, 1));
  const Mesh body = to_mesh(soups::limbed_sphere(5, 3));
  Input input; // of the torus: two poles and what shows the handle
  std::optional<Foliation> foliation;
  Graph graph;
};

} // namespace

TEST_F(Out_of_memory, reading_and_repair)
{
  const Temporary_folder folder;
  const std::string file = folder.file_name("torus.off");
  CGAL::IO::write_OFF(file, torus);
  starve([&] { SMF::read_polygon_soup(file); });
  SMF::Polygon_soup soup = SMF::read_polygon_soup(file);
  soup.polygons.push_back(soup.polygons.back()); // something to repair
  starve([&] { SMF::repair_polygon_soup(soup); });
  starve([&] {
    Mesh mesh;
    SMF::read_triangle_mesh(file, mesh);
  });
}

TEST_F(Out_of_memory, poles)
{
  std::vector<Mesh::Vertex_index> poles;
  starve(
    [&] {
      SMF::detect_feature_poles(body, std::back_inserter(poles));
      std::vector<Mesh::Vertex_index>().swap(poles);
    },
    [&] {
      std::vector<Mesh::Vertex_index>().swap(poles); // it may have got some
    });
  starve([&] {
    std::vector<std::vector<Mesh::Vertex_index>> lines;
    SMF::detect_feature_lines(body, std::back_inserter(lines));
  });
  const Input none;
  starve([&] {
    Input some = none;
    SMF::add_missing_poles(body, some);
  });
}

TEST_F(Out_of_memory, loops)
{
  Input poles;
  poles.add_pole(vertex(0));
  poles.add_pole(vertex(40));
  starve([&] {
    Input copy = poles;
    SMF::propose_loops(torus, copy);
  });
  starve([&] {
    Input copy = poles;
    SMF::canonical_loops(torus, copy);
  });
  starve([&] { SMF::loop_modulus(torus, input, 2); });
  starve([&] {
    Input copy = poles;
    const std::vector<Mesh::Vertex_index> picks = {vertex(3), vertex(35), vertex(67)};
    SMF::add_loop_through_vertices(picks, torus, copy);
  });
  starve([&] { SMF::Loop_system<Mesh>(torus, input); });
}

TEST_F(Out_of_memory, foliations)
{
  const SMF::Loop_system<Mesh>& system = foliation->system();
  starve([&] { SMF::harmonic_foliation(system); });
  starve([&] { SMF::whitehead_foliation(system, np::number_of_iterations(3)); });
  const double energy = foliation->statistics().energy;
  starve([&] {
    SMF::Foliation_solver<Mesh> fresh;
    fresh.solve(system);
  });
  // one solver, whose runs fail one after another
  SMF::Foliation_solver<Mesh> solver;
  solver.solve(system);
  for (std::ptrdiff_t n = 0; !run_with(n, [&] { solver.solve(system); }); n += 1 + n / 7)
    EXPECT_NEAR(solver.solve(system).statistics().energy, energy, 1e-9 * energy) << n;
}

TEST_F(Out_of_memory, graphs)
{
  starve([&] {
    Graph result;
    SMF::reeb_graph(*foliation, result);
  });
  starve([&] {
    Graph result;
    SMF::foliation_reeb_graph(torus, input, result);
  });
  starve([&] {
    Graph result;
    SMF::canonical_reeb_graph(body, result);
  });
  starve([&] { SMF::match_reeb_graphs(graph, graph); });
  starve([&] { SMF::reeb_graph_symmetries(graph); });
}

// A graph that is appended to is as it was.
TEST_F(Out_of_memory, a_graph_that_is_appended_to)
{
  const auto embedding = SMF::reeb_graph_embedding(*foliation);
  starve_appending<Graph>([&](Graph& result) { SMF::reeb_graph(*foliation, result, embedding); });
  starve_appending<SMF::Curve_skeleton<Mesh>>(
    [&](SMF::Curve_skeleton<Mesh>& result) { SMF::curve_skeleton(*foliation, embedding, result); });
  const auto height = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return torus.point(v).x(); });
  starve_appending<SMF::Scalar_reeb_graph<Mesh>>([&](SMF::Scalar_reeb_graph<Mesh>& result) {
    SMF::reeb_graph_of_function(torus, height, result);
  });
}

TEST_F(Out_of_memory, what_is_read_from_a_foliation)
{
  starve([&] {
    std::vector<SMF::Singularity<Mesh>> singularities;
    SMF::singularities(*foliation, std::back_inserter(singularities));
  });
  starve([&] {
    const SMF::Leaf_tracer<Mesh> tracer(*foliation);
    std::vector<SMF::Leaf<Mesh::Point>> leaves;
    tracer.evenly_spaced_leaves(0, 3, std::back_inserter(leaves));
  });
  starve([&] { const SMF::Component_coordinates<Mesh> coordinates(*foliation); });
  starve([&] { SMF::reeb_graph_embedding(*foliation); });
}

TEST_F(Out_of_memory, files)
{
  const Temporary_folder folder;
  const std::string file = folder.file_name("reeb_graph.graphml");
  SMF::write_reeb_graph_graphml(file, graph);
  const std::string before = file_text(file);
  starve(
    [&] {
      try
      {
        SMF::write_reeb_graph_graphml(file, graph);
      }
      catch (const SMF::Invalid_file_exception&) // streams turn it into a state of theirs
      {
        throw std::bad_alloc();
      }
    },
    [&] { ASSERT_EQ(file_text(file), before); });
}

} // namespace test_out_of_memory
