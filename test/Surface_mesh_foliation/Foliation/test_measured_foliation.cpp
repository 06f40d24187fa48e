// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/edge_stretches.h"
#include "include/example_systems.h"

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/balance.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/relax_vertex.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace test_measured_foliation {

// What a foliation says about vertices and edges fits together.

namespace {

using smf_test::edge_stretches;
using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;
using smf_test::Stretch;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Foliation = SMF::Measured_foliation<Mesh>;
using Halfedge = Mesh::Halfedge_index;
using Vertex = Mesh::Vertex_index;
using Path = std::vector<Foliation::Passage>;

// Checks that a path leads from cell to cell, from source to target.
void check_path(const Foliation& foliation, Halfedge h)
{
  const Vertex u = source(h, foliation.mesh()), v = target(h, foliation.mesh());
  const Foliation::Cell last = foliation.cell(v);
  Foliation::Cell cell = foliation.cell(u);
  for (const Foliation::Passage& passage : foliation.path(h))
  {
    const std::size_t node = foliation.system().node(passage.arc, passage.end);
    EXPECT_EQ(cell.is_arc ? passage.arc : node, cell.index)
      << "it leaves a cell in which it is not";
    cell = cell.is_arc ? Foliation::Cell{false, node} : Foliation::Cell{true, passage.arc};
  }
  EXPECT_EQ(cell.is_arc, last.is_arc) << u << ' ' << v;
  EXPECT_EQ(cell.index, last.index) << u << ' ' << v;
}

class Measured_foliation_of_example : public ::testing::TestWithParam<Example>
{
protected:
  Measured_foliation_of_example()
    : example(GetParam()), mesh(*example.mesh), foliation(example.foliation)
  {}

  double weighted_sum(const std::vector<std::pair<Mesh::Edge_index, double>>& factors) const
  {
    double result = 0;
    for (const auto& [e, factor] : factors)
      result += factor * weight[e] * foliation.edge_value(e);
    return result;
  }

  void SetUp() override
  {
    weight = example.mesh->add_property_map<Mesh::Edge_index, double>("e:weight", 0).first;
    SMF::edge_weights(foliation.system(), SMF::Mean_value_weights(), weight);
  }

  Solved_example<> example;
  const Mesh& mesh;
  const Foliation& foliation;
  Mesh::Property_map<Mesh::Edge_index, double> weight;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Measured_foliation_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

TEST_P(Measured_foliation_of_example, refers_to_mesh_and_system)
{
  EXPECT_EQ(&foliation.mesh(), &mesh);
  EXPECT_EQ(foliation.system().number_of_arcs(), example.system.number_of_arcs());
  const auto copy = std::make_unique<Foliation>(foliation);
  EXPECT_EQ(&copy->statistics(), &foliation.statistics()) << "copies share their contents";
}

TEST_P(Measured_foliation_of_example, cells_and_parameters)
{
  const SMF::Loop_system<Mesh>& system = foliation.system();
  for (const Vertex v : vertices(mesh))
  {
    const Foliation::Cell cell = foliation.cell(v);
    const double t = foliation.parameter(v);
    if (cell.is_arc)
    {
      ASSERT_LT(cell.index, system.number_of_arcs());
      EXPECT_GT(t, 0) << v;
      EXPECT_LT(t, system.height(cell.index)) << v;
    }
    else
    {
      ASSERT_LT(cell.index, system.number_of_nodes());
      EXPECT_EQ(t, 0) << v;
    }
  }
}

TEST_P(Measured_foliation_of_example, poles_and_nothing_else_lie_at_their_nodes)
{
  const SMF::Loop_system<Mesh>& system = foliation.system();
  std::vector<int> pole_of_vertex(num_vertices(mesh), -1);
  for (std::size_t p = 0; p < system.number_of_poles(); ++p)
    for (const Vertex v : system.pole_vertices(p))
      pole_of_vertex[v] = static_cast<int>(p);
  for (const Vertex v : vertices(mesh))
  {
    const Foliation::Cell cell = foliation.cell(v);
    EXPECT_EQ(cell.is_arc ? -1 : system.pole(cell.index), pole_of_vertex[v]) << v;
  }
}

TEST_P(Measured_foliation_of_example, paths_lead_from_cell_to_cell)
{
  for (const Halfedge h : halfedges(mesh))
  {
    check_path(foliation, h);
    for (const Stretch& stretch : edge_stretches(foliation, h))
      EXPECT_TRUE(stretch.from != stretch.to || foliation.path(h).empty())
        << "it leaves an arc where it came in";
  }
}

TEST_P(Measured_foliation_of_example, paths_are_empty_inside_one_cell_only)
{
  for (const Halfedge h : halfedges(mesh))
  {
    const auto from = foliation.cell(source(h, mesh)), to = foliation.cell(target(h, mesh));
    const bool is_one_cell = from.is_arc == to.is_arc && from.index == to.index;
    // away from genus 0 a path may run around a handle, back to another lift of its arc
    if (foliation.path(h).empty() || foliation.system().genus() == 0)
    {
      EXPECT_EQ(foliation.path(h).empty(), is_one_cell) << h;
    }
  }
}

TEST_P(Measured_foliation_of_example, paths_of_opposite_halfedges_are_reversed)
{
  for (const Halfedge h : halfedges(mesh))
  {
    const Path path = foliation.path(h);
    Path back = foliation.path(opposite(h, mesh));
    std::reverse(back.begin(), back.end());
    ASSERT_EQ(path.size(), back.size());
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      EXPECT_EQ(path[i].arc, back[i].arc);
      EXPECT_EQ(path[i].end, back[i].end);
    }
  }
  for (const auto e : edges(mesh))
  {
    const Path path = foliation.path(e), same = foliation.path(halfedge(e, mesh));
    ASSERT_EQ(path.size(), same.size());
    for (std::size_t i = 0; i < path.size(); ++i)
      EXPECT_TRUE(path[i].arc == same[i].arc && path[i].end == same[i].end);
  }
}

TEST_P(Measured_foliation_of_example, edge_values_are_lengths_of_paths)
{
  for (const auto e : edges(mesh))
  {
    double length = 0;
    for (const Stretch& stretch : edge_stretches(foliation, halfedge(e, mesh)))
      length += std::abs(stretch.to - stretch.from);
    EXPECT_NEAR(foliation.edge_value(e), length, 1e-14 * length);
  }
}

TEST_P(Measured_foliation_of_example, edge_values_go_into_any_map)
{
  const auto doubles = example.mesh->add_property_map<Mesh::Edge_index, double>("e:w", -1).first;
  const auto floats = example.mesh->add_property_map<Mesh::Edge_index, float>("e:f", -1).first;
  std::map<Mesh::Edge_index, double> tree;
  SMF::edge_values(foliation, doubles);
  SMF::edge_values(foliation, floats);
  SMF::edge_values(foliation, boost::make_assoc_property_map(tree));
  EXPECT_EQ(tree.size(), num_edges(mesh));
  for (const auto e : edges(mesh))
  {
    EXPECT_EQ(doubles[e], foliation.edge_value(e));
    EXPECT_EQ(floats[e], static_cast<float>(foliation.edge_value(e)));
    EXPECT_EQ(tree[e], foliation.edge_value(e));
  }
}

TEST_P(Measured_foliation_of_example, cells_of_vertices_go_into_any_map)
{
  const auto arcs = example.mesh->add_property_map<Vertex, int>("v:arc", 99).first;
  const auto nodes = example.mesh->add_property_map<Vertex, long>("v:node", 99).first;
  const auto parameters = example.mesh->add_property_map<Vertex, float>("v:t", 99).first;
  std::map<Vertex, int> tree_of_arcs;
  std::map<Vertex, double> tree_of_parameters;
  SMF::vertex_cells(foliation, arcs, nodes, parameters);
  SMF::vertex_cells(foliation, boost::make_assoc_property_map(tree_of_arcs),
                    boost::make_assoc_property_map(tree_of_parameters));
  EXPECT_EQ(tree_of_arcs.size(), num_vertices(mesh));
  EXPECT_EQ(tree_of_parameters.size(), num_vertices(mesh));
  for (const Vertex v : vertices(mesh))
  {
    const Foliation::Cell cell = foliation.cell(v);
    const int index = static_cast<int>(cell.index);
    EXPECT_EQ(arcs[v], cell.is_arc ? index : -1);
    EXPECT_EQ(nodes[v], cell.is_arc ? -1 : index);
    EXPECT_EQ(parameters[v], static_cast<float>(foliation.parameter(v)));
    EXPECT_EQ(tree_of_arcs[v], arcs[v]);
    EXPECT_EQ(tree_of_parameters[v], foliation.parameter(v));
  }
}

TEST_P(Measured_foliation_of_example, triangle_inequalities)
{
  for (const auto f : faces(mesh))
  {
    std::vector<double> w;
    for (const Halfedge h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      w.push_back(foliation.edge_value(edge(h, mesh)));
    std::sort(w.begin(), w.end());
    EXPECT_GE(w[0], 0);
    EXPECT_LE(w[2], (w[0] + w[1]) * (1 + 1e-12)) << f;
  }
}

TEST_P(Measured_foliation_of_example, energy_is_that_of_the_edges)
{
  double energy = 0;
  for (const auto e : edges(mesh))
    energy += weight[e] * foliation.edge_value(e) * foliation.edge_value(e);
  EXPECT_NEAR(foliation.statistics().energy, energy, 1e-12 * energy);
  EXPECT_GT(energy, 0);
}

TEST_P(Measured_foliation_of_example, flux_is_the_same_at_all_levels)
{
  const SMF::Loop_system<Mesh>& system = foliation.system();
  for (const double share : {0.03, 0.3, 0.5, 0.77})
  {
    // by arc, the edges that cross this level, and how often
    std::vector<std::vector<std::pair<Mesh::Edge_index, double>>> crossed(system.number_of_arcs());
    for (const auto e : edges(mesh))
      for (const Stretch& stretch : edge_stretches(foliation, halfedge(e, mesh)))
      {
        const auto [low, high] = std::minmax({stretch.from, stretch.to});
        const double level = share * system.height(stretch.arc);
        if (low < level && level <= high)
          crossed[stretch.arc].emplace_back(e, 1);
      }
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      EXPECT_NEAR(weighted_sum(crossed[a]), foliation.flux(a), 1e-9 * foliation.flux(a))
        << "arc " << a << ", level " << share;
  }
}

TEST_P(Measured_foliation_of_example, energy_is_the_sum_of_height_times_flux)
{
  double sum = 0;
  for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
    sum += foliation.system().height(a) * foliation.flux(a);
  EXPECT_NEAR(foliation.statistics().energy, sum, 1e-10 * sum);
}

// ===  Optimality, recomputed with nothing but public functions

// the forces at a vertex: sum of weight times value over the edges that leave it into a direction
class Forces
{
public:
  template <class Weight>
  Forces(const Foliation& foliation, const Weight& weight, Vertex v)
    : m_foliation(foliation), m_mesh(foliation.mesh())
  {
    for (const Halfedge in : CGAL::halfedges_around_target(v, m_mesh))
    {
      m_spokes.push_back(opposite(in, m_mesh));
      const auto e = edge(in, m_mesh);
      m_force.push_back(weight[e] * foliation.edge_value(e));
      m_total += m_force.back();
    }
  }

  // the excess of one direction over all others
  double excess() const
  {
    const auto v = source(m_spokes[0], m_mesh);
    return m_foliation.cell(v).is_arc ? excess_in_arc(v) : excess_at_node();
  }

private:
  double excess_in_arc(Vertex v) const
  {
    double difference = 0;
    for (std::size_t i = 0; i < m_spokes.size(); ++i)
    {
      const Path path = m_foliation.path(m_spokes[i]);
      const bool is_up =
        path.empty() ? m_foliation.parameter(target(m_spokes[i], m_mesh)) > m_foliation.parameter(v)
                     : path[0].end == 1;
      difference += is_up ? m_force[i] : -m_force[i];
    }
    return std::abs(difference);
  }

  // whether spokes i and i + 1 begin with the same half-arc: their paths in the tree part, and the
  // path between their ends is what remains of both
  bool is_same_direction(std::size_t i) const
  {
    const std::size_t j = (i + 1) % m_spokes.size();
    const Halfedge between = next(m_spokes[j], m_mesh); // from the end of spoke j to that of i
    const std::size_t n = m_foliation.path(m_spokes[i]).size();
    const std::size_t m = m_foliation.path(m_spokes[j]).size();
    return n > 0 && m > 0 && n + m >= m_foliation.path(between).size() + 2;
  }

  double excess_at_node() const
  {
    std::size_t first = 0; // a spoke at which a direction begins
    while (first < m_spokes.size() &&
           is_same_direction((first + m_spokes.size() - 1) % m_spokes.size()))
      ++first;
    double strongest = 0, force = 0;
    for (std::size_t k = 0; k < m_spokes.size(); ++k)
    {
      const std::size_t i = (first + k) % m_spokes.size();
      force += m_force[i];
      strongest = (std::max)(strongest, force);
      if (!is_same_direction(i))
        force = 0;
    }
    return 2 * strongest - m_total;
  }

  const Foliation& m_foliation;
  const Mesh& m_mesh;
  std::vector<Halfedge> m_spokes;
  std::vector<double> m_force; // by spoke
  double m_total = 0;
};

// the largest excess, as a share of the largest force, to which edges between poles do not add,
// unless there are no others
template <class Weight>
double largest_excess(const Foliation& foliation, const Weight& weight)
{
  const Mesh& mesh = foliation.mesh();
  std::vector<Vertex> poles;
  for (std::size_t p = 0; p < foliation.system().number_of_poles(); ++p)
    for (const Vertex v : foliation.system().pole_vertices(p))
      poles.push_back(v);
  const auto is_pole = [&](Vertex v) {
    return std::find(poles.begin(), poles.end(), v) != poles.end();
  };
  double largest_force = 0, largest_of_all = 0, result = 0;
  for (const Vertex v : vertices(mesh))
  {
    double force = 0, force_of_all = 0;
    for (const auto h : halfedges_around_source(v, mesh))
    {
      const double of_edge = weight[edge(h, mesh)] * foliation.edge_value(edge(h, mesh));
      force_of_all += of_edge;
      if (!is_pole(v) || !is_pole(target(h, mesh)))
        force += of_edge;
    }
    largest_force = (std::max)(largest_force, force);
    largest_of_all = (std::max)(largest_of_all, force_of_all);
    if (!is_pole(v))
      result = (std::max)(result, Forces(foliation, weight, v).excess());
  }
  return result / (largest_force > 0 ? largest_force : largest_of_all);
}

TEST_P(Measured_foliation_of_example, optimality_is_the_largest_excess_of_a_direction)
{
  for (const int iterations : {0, 1, 2, 4, 100}) // the first ones are far from optimal
  {
    const Foliation some =
      SMF::harmonic_foliation(example.system, CGAL::parameters::number_of_iterations(iterations));
    const double excess = largest_excess(some, weight);
    EXPECT_NEAR(some.statistics().optimality, excess, 1e-9 * excess + 1e-13) << iterations;
  }
}

// When all leaves lie in the loops all vertices are at nodes; a little later still most of them.
TEST_P(Measured_foliation_of_example, optimality_at_nodes_is_the_largest_excess_of_a_direction)
{
  const SMF::internal::Flat_mesh& flat = example.system.data().flat.mesh;
  std::vector<double> weights;
  for (int e = 0; e < flat.number_of_edges(); ++e)
    weights.push_back(weight[example.system.data().mesh_index.edge_descriptor_of(e)]);
  const auto data = std::make_shared<SMF::internal::Foliation_data<Mesh>>(example.system, weights);
  const Foliation start(data);
  SMF::internal::Vertex_relaxation relax(data->state);
  for (int v = 0; v < flat.number_of_vertices(); v += 7)
  {
    const double excess = largest_excess(start, weight);
    EXPECT_NEAR(SMF::internal::balance(data->state).optimality, excess, 1e-12);
    relax(v);
  }
}

TEST_P(Measured_foliation_of_example, every_arc_is_crossed)
{
  const SMF::Loop_system<Mesh>& system = foliation.system();
  std::vector<bool> has_crossing(system.number_of_arcs(), false);
  for (const Halfedge h : halfedges(mesh))
    for (const Stretch& stretch : edge_stretches(foliation, h))
      has_crossing[stretch.arc] = true;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    EXPECT_TRUE(has_crossing[a]) << a;
    EXPECT_GT(foliation.flux(a), 0) << a;
  }
}

} // namespace

} // namespace test_measured_foliation
