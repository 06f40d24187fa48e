// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "generators/meshes.h"
#include "include/uv_mesh.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_chart.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_seams.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_springs.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Corner_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/dirichlet_energies.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace test_component_coordinates {

// Coordinates on the components of foliations: at the corners of the cut mesh, and in charts.

namespace {

using smf_test::areas;
using smf_test::Each_foliation;
using smf_test::Mesh;
using smf_test::size_of;
using smf_test::Uv;
using smf_test::Uv_mesh;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Foliation = SMF::Measured_foliation<Mesh>;
using Coordinates = SMF::Component_coordinates<Mesh>;

class Coordinates_of_example : public Each_foliation
{};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Coordinates_of_example,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

} // namespace

// ===  Coordinates of corners

TEST_P(Coordinates_of_example, all_faces_keep_their_orientation)
{
  const Uv_mesh uv_mesh((Coordinates(foliation)));
  std::vector<double> total(system.number_of_arcs(), 0);
  for (const auto f : faces(uv_mesh.mesh))
    if (uv_mesh.has_coordinates(f))
    {
      EXPECT_GT(uv_mesh.area_of(f), 0) << f;
      total[uv_mesh.component[f]] += uv_mesh.area_of(f);
    }
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    bool has_pole_at_vertex = false;
    for (int end : {0, 1})
      if (const int pole = system.pole(system.node(a, end)); pole >= 0)
        has_pole_at_vertex |= system.pole_vertices(static_cast<std::size_t>(pole)).size() == 1;
    if (has_pole_at_vertex) // the circle that the pole is blown up to does not belong to the mesh
    {
      EXPECT_LT(total[a], size_of(foliation, a));
    }
    else
    {
      EXPECT_NEAR(total[a], size_of(foliation, a), 1e-12 * size_of(foliation, a));
    }
  }
}

TEST_P(Coordinates_of_example, only_faces_at_nodes_have_no_coordinates)
{
  const Uv_mesh uv_mesh((Coordinates(foliation)));
  for (const auto f : faces(uv_mesh.mesh))
  {
    bool is_at_node = true;
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, uv_mesh.mesh), uv_mesh.mesh))
    {
      is_at_node = is_at_node && uv_mesh.is_critical[edge(h, uv_mesh.mesh)];
      EXPECT_EQ(std::isnan(uv_mesh.uv[h][0]), std::isnan(uv_mesh.uv[h][1]));
    }
    EXPECT_EQ(uv_mesh.has_coordinates(f), !is_at_node);
  }
}

TEST_P(Coordinates_of_example, v_is_the_parameter)
{
  const Uv_mesh uv_mesh((Coordinates(foliation)));
  auto v = vertices(uv_mesh.mesh).begin();
  for (const auto u : vertices(mesh))
  {
    for (const auto h : CGAL::halfedges_around_target(halfedge(*v, uv_mesh.mesh), uv_mesh.mesh))
      if (uv_mesh.has_coordinates(face(h, uv_mesh.mesh)))
      {
        const std::size_t a = uv_mesh.component[face(h, uv_mesh.mesh)];
        const double t = uv_mesh.uv[h][1];
        if (foliation.cell(u).is_arc)
        {
          EXPECT_EQ(a, foliation.cell(u).index);
          EXPECT_EQ(t, foliation.parameter(u));
        }
        else
        {
          EXPECT_TRUE(t == 0 || t == system.height(a));
          EXPECT_EQ(system.node(a, t == 0 ? 0 : 1), foliation.cell(u).index);
        }
      }
    ++v;
  }
}

// The edges of the seams, seen from nothing but the coordinates.
class Seams
{
public:
  Seams(const Uv_mesh& uv_mesh, const Foliation& foliation)
    : m_uv_mesh(uv_mesh), m_mesh(uv_mesh.mesh), m_foliation(foliation)
  {
    for (const auto e : edges(m_mesh))
      if (!uv_mesh.is_critical[e])
        if (const int turns = jump(halfedge(e, m_mesh)); turns != 0)
          add(halfedge(e, m_mesh), turns);
  }

  std::size_t component(Mesh::Halfedge_index h) const
  {
    return m_uv_mesh.component[face(h, m_mesh)];
  }

  // by component, the number of its edges at each of its vertices, and the levels of these
  std::map<std::size_t, std::map<Mesh::Vertex_index, int>> degree;
  std::map<std::size_t, std::set<double>> levels;

private:
  // by how many turns the coordinate of target(h) on the left side is larger than on the right side
  double turns_at_target(Mesh::Halfedge_index h) const
  {
    const Uv &left = m_uv_mesh.uv[h], &right = m_uv_mesh.uv[prev(opposite(h, m_mesh), m_mesh)];
    EXPECT_EQ(left[1], right[1]);
    return (left[0] - right[0]) / m_foliation.flux(component(h));
  }

  // whether a vertex is a pole, which has another value in each corner
  bool is_pole(Mesh::Vertex_index v) const
  {
    for (const auto h : CGAL::halfedges_around_target(v, m_mesh))
      if (m_uv_mesh.is_critical[edge(h, m_mesh)])
        return false;
    const double t = m_uv_mesh.uv[halfedge(v, m_mesh)][1];
    return t == 0 || t == m_foliation.system().height(component(halfedge(v, m_mesh)));
  }

  // from the right side to the left side of h
  int jump(Mesh::Halfedge_index h) const
  {
    EXPECT_EQ(component(h), component(opposite(h, m_mesh)));
    std::vector<double> turns;
    if (!is_pole(target(h, m_mesh)))
      turns.push_back(turns_at_target(h));
    if (!is_pole(source(h, m_mesh)))
      turns.push_back(-turns_at_target(opposite(h, m_mesh)));
    if (turns.empty()) // an edge from pole to pole
      turns.push_back(std::round(turns_at_target(h)));
    for (const double x : turns)
      EXPECT_NEAR(x, std::round(turns[0]), 1e-12);
    return static_cast<int>(std::round(turns[0]));
  }

  void add(Mesh::Halfedge_index h, int turns)
  {
    const double from = m_uv_mesh.uv[prev(h, m_mesh)][1], to = m_uv_mesh.uv[h][1];
    EXPECT_EQ(std::abs(turns), 1);
    // a seam need not rise everywhere, but does where it is one edge
    if (from == 0 && to == m_foliation.system().height(component(h)))
    {
      EXPECT_EQ(turns, 1);
    }
    for (const auto v : {source(h, m_mesh), target(h, m_mesh)})
      ++degree[component(h)][v];
    levels[component(h)].insert({from, to});
  }

  const Uv_mesh& m_uv_mesh;
  const Mesh& m_mesh;
  const Foliation& m_foliation;
};

// The ends of an edge have the same coordinates on both sides, or both differ by the circumference;
// and edges of the latter sort are one path per component, from end to end.
TEST_P(Coordinates_of_example, coordinates_jump_at_one_seam_only)
{
  const Uv_mesh uv_mesh((Coordinates(foliation)));
  const Seams seams(uv_mesh, foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    ASSERT_EQ(seams.degree.count(a), 1u);
    int ends = 0;
    for (const auto& [v, number] : seams.degree.at(a))
    {
      EXPECT_LE(number, 2);
      ends += number == 1;
    }
    // both ends may be one vertex of the mesh
    EXPECT_TRUE(ends == 2 || (ends == 0 && system.node(a, 0) == system.node(a, 1))) << a;
    EXPECT_EQ(*seams.levels.at(a).begin(), 0);
    EXPECT_EQ(*seams.levels.at(a).rbegin(), system.height(a));
  }
}

TEST_P(Coordinates_of_example, shapes_are_heights_and_fluxes)
{
  double energy = 0;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    const SMF::Component_shape shape = SMF::component_shape(foliation, a);
    EXPECT_EQ(shape.height, system.height(a));
    EXPECT_EQ(shape.circumference, foliation.flux(a));
    EXPECT_EQ(shape.modulus(), shape.height / shape.circumference);
    EXPECT_NEAR(shape.modulus() * shape.extremal_length(), 1, 1e-15);
    energy += shape.height * shape.circumference;
  }
  EXPECT_NEAR(energy, foliation.statistics().energy, 1e-10 * energy);
  EXPECT_THROW(SMF::component_shape(foliation, system.number_of_arcs()),
               SMF::Invalid_parameter_exception);
}

// ===  Charts

// The border of a chart consists of two translates of the seam, and of the lines v = 0 and v = k.
void expect_sides(const Mesh& chart, double height, double circumference)
{
  double low = 0, high = 0;
  std::map<double, std::vector<double>> seam; // by v: the values of u
  for (const auto h : halfedges(chart))
    if (is_border(h, chart))
    {
      const Point &p = chart.point(source(h, chart)), &q = chart.point(target(h, chart));
      if (p.y() == q.y() && (p.y() == 0 || p.y() == height))
        (p.y() == 0 ? low : high) += std::abs(q.x() - p.x());
      else
        for (const Point& r : {p, q})
          seam[r.y()].push_back(r.x());
    }
  EXPECT_NEAR(low, circumference, 1e-12 * circumference);
  EXPECT_NEAR(high, circumference, 1e-12 * circumference);
  for (auto& [v, us] : seam) // every edge gives two values, on both sides
  {
    std::sort(us.begin(), us.end());
    ASSERT_EQ(us.size() % 2, 0u);
    const std::size_t half = us.size() / 2;
    if (v == 0 || v == height)
    {
      ASSERT_EQ(half, 1u);
      EXPECT_NEAR(us[1] - us[0], circumference, 1e-12 * circumference);
    }
    for (const double u : us) // the seam need not rise, so there may be several on either side
    {
      double error = circumference;
      for (const double translate : us)
        error = std::min(error, std::abs(std::abs(translate - u) - circumference));
      EXPECT_LE(error, 1e-12 * circumference);
    }
  }
}

TEST_P(Coordinates_of_example, charts_are_rectangles)
{
  const Coordinates coordinates(foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    Mesh chart;
    const auto surface_point = chart.add_property_map<Mesh::Vertex_index, Point>("v:point3").first;
    coordinates.chart(a, chart, SMF::parameters::surface_point_map(surface_point));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(chart));
    EXPECT_TRUE(CGAL::is_triangle_mesh(chart));
    EXPECT_EQ(static_cast<int>(num_vertices(chart) + num_faces(chart)) -
                static_cast<int>(num_edges(chart)),
              1);
    const auto [total, smallest] = areas(chart);
    EXPECT_NEAR(total, size_of(foliation, a), 1e-12 * size_of(foliation, a));
    EXPECT_GT(smallest, 0);
    expect_sides(chart, system.height(a), foliation.flux(a));
    // vertices of the chart that are the same point of the surface lie on one level
    std::map<Point, std::set<double>> levels;
    for (const auto v : vertices(chart))
      levels[surface_point[v]].insert(chart.point(v).y());
    for (const auto& entry : levels)
      EXPECT_TRUE(entry.second.size() == 1 ||
                  entry.second == std::set<double>({0, system.height(a)}));
  }
  Mesh chart;
  EXPECT_THROW(coordinates.chart(system.number_of_arcs(), chart), SMF::Invalid_parameter_exception);
}

// ===  Seams

void expect_seams_from_end_to_end(const Foliation& foliation)
{
  const SMF::internal::Refined_mesh& refined = foliation.extraction().refined_mesh;
  const SMF::internal::Leaf_graph graph(refined);
  const SMF::internal::Corner_nodes nodes(refined, graph);
  const std::size_t number_of_arcs = foliation.system().number_of_arcs();
  const SMF::internal::Component_seams seams(
    nodes, std::vector<double>(number_of_arcs, foliation.system().height(0)));
  const auto is_at_node = [&](int v) { return refined.node[static_cast<std::size_t>(v)] >= 0; };
  for (std::size_t a = 0; a < number_of_arcs; ++a)
  {
    const std::vector<int>& seam = seams.seam(static_cast<int>(a));
    EXPECT_TRUE(is_at_node(nodes.mesh().source(seam.front())));
    EXPECT_TRUE(is_at_node(nodes.mesh().target(seam.back())));
  }
}

// A fuzzer found it: where heights are tiny, differences of parameters may be no numbers.
TEST(Component_seams, lead_from_end_to_end_in_arcs_of_the_least_height)
{
  const Mesh mesh = smf_test::icosphere<Mesh>(0);
  for (std::size_t u = 0; u < 12; ++u)
    for (std::size_t v = 0; v < u; ++v)
      for (std::size_t w = 0; w < v; ++w)
      {
        SMF::Poles_and_loops<Mesh> input;
        for (const std::size_t pole : {u, v, w})
          input.add_pole(smf_test::vertex(pole), 1e-300);
        const SMF::Loop_system<Mesh> system(mesh, input);
        expect_seams_from_end_to_end(SMF::harmonic_foliation(system));
      }
}

} // namespace test_component_coordinates
