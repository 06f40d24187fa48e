// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/each_foliation.h"
#include "include/conformal_tori.h"
#include "include/example_systems.h"
#include "generators/meshes.h"
#include "include/test_models.h"
#include "generators/Random.h"
#include "include/uv_mesh.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_chart.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_seams.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_springs.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Corner_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Texture_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/dirichlet_energies.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/pack_boxes.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_component_coordinates {

// Coordinates on the components of foliations: at the corners of the cut mesh, and in charts.

namespace {

using smf_test::area;
using smf_test::Each_foliation;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;
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

double size_of(const Foliation& foliation, std::size_t arc)
{
  return foliation.system().height(arc) * foliation.flux(arc);
}

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

// The sides of a chart, its total area, and the smallest area of a face.
template <class Chart>
std::array<double, 2> areas(const Chart& chart)
{
  const auto points = get(CGAL::vertex_point, chart);
  std::array<double, 2> result = {0, 1e300};
  for (const auto f : faces(chart))
  {
    const auto h = halfedge(f, chart);
    const auto uv = [&](auto v) {
      EXPECT_EQ(get(points, v).z(), 0);
      return Uv{get(points, v).x(), get(points, v).y()};
    };
    const double x =
      area(uv(source(h, chart)), uv(target(h, chart)), uv(target(next(h, chart), chart)));
    result[0] += x;
    result[1] = std::min(result[1], x);
  }
  return result;
}

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

// ===  Texture coordinates

// whether boxes do not even touch
bool are_apart(const SMF::Texture_chart& a, const SMF::Texture_chart& b, double gap)
{
  bool result = false;
  for (std::size_t i : {0, 1})
    result |= a.upper[i] + gap < b.lower[i] || b.upper[i] + gap < a.lower[i];
  return result;
}

TEST_P(Coordinates_of_example, charts_lie_side_by_side_in_the_unit_square)
{
  const Coordinates coordinates(foliation);
  const double gap = 1. / 400;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    const SMF::Texture_chart chart = coordinates.texture_chart(a);
    for (std::size_t i : {0, 1})
    {
      EXPECT_GT(chart.scale[i], 0) << "nothing is turned over";
      EXPECT_GE(chart.lower[i], gap);
      EXPECT_LT(chart.lower[i], chart.upper[i]);
      EXPECT_LE(chart.upper[i], 1 - gap);
    }
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_TRUE(are_apart(chart, coordinates.texture_chart(b), gap)) << a << ' ' << b;

    // the chart fills its box
    Mesh mesh_of_chart;
    coordinates.chart(a, mesh_of_chart);
    Uv lower = {1, 1}, upper = {0, 0};
    for (const auto v : vertices(mesh_of_chart))
    {
      const Uv texture = chart({mesh_of_chart.point(v).x(), mesh_of_chart.point(v).y()});
      for (std::size_t i : {0, 1})
      {
        lower[i] = std::min(lower[i], texture[i]);
        upper[i] = std::max(upper[i], texture[i]);
      }
    }
    for (std::size_t i : {0, 1})
    {
      EXPECT_NEAR(lower[i], chart.lower[i], 1e-12);
      EXPECT_NEAR(upper[i], chart.upper[i], 1e-12);
    }
  }
  EXPECT_THROW(coordinates.texture_chart(system.number_of_arcs()),
               SMF::Invalid_parameter_exception);
}

// The chart has the area of the component, and corners get the image of u and v.
TEST_P(Coordinates_of_example, texture_coordinates_are_to_scale)
{
  const Coordinates coordinates(foliation);
  const Uv_mesh uv_mesh(coordinates);
  Mesh output;
  using Point_2 = smf_test::Kernel::Point_2;
  const auto texture = output.add_property_map<Mesh::Halfedge_index, Point_2>("h:texture").first;
  coordinates.texture_mesh(output, texture);
  ASSERT_EQ(num_faces(output), num_faces(uv_mesh.mesh));
  std::vector<double> area(system.number_of_arcs(), 0);
  for (const auto f : faces(output))
  {
    const auto h = halfedge(f, output), g = next(h, output), i = next(g, output);
    if (!uv_mesh.has_coordinates(f))
    {
      EXPECT_TRUE(std::isnan(texture[h].x()));
      continue;
    }
    const SMF::Texture_chart chart = coordinates.texture_chart(uv_mesh.component[f]);
    for (const auto corner : {h, g, i})
    {
      const Uv expected = chart(uv_mesh.uv[corner]);
      EXPECT_EQ(texture[corner], Point_2(expected[0], expected[1]));
    }
    EXPECT_EQ(CGAL::orientation(texture[h], texture[g], texture[i]), CGAL::LEFT_TURN);
    area[uv_mesh.component[f]] +=
      std::sqrt(CGAL::squared_area(output.point(target(h, output)), output.point(target(g, output)),
                                   output.point(target(i, output))));
  }
  for (std::size_t a = 0; a < area.size(); ++a)
  {
    const SMF::Texture_chart chart = coordinates.texture_chart(a);
    const double stretch =
      chart.scale[0] * chart.scale[1] * coordinates.texture_size() * coordinates.texture_size();
    EXPECT_NEAR(stretch * size_of(foliation, a), area[a], 1e-12 * area[a]);
  }
}

// Weights and heights change measures, but neither the shape of a chart nor its size.
TEST(Texture, of_a_thin_torus_has_its_lengths_whatever_the_weights)
{
  const double large_radius = 10, small_radius = 1, pi = std::acos(-1.);
  const std::size_t n = 32;
  const smf_test::soups::Torus_of_revolution torus(large_radius, small_radius, 0);
  const std::size_t m = torus.number_of_rows(n);
  const Mesh mesh = smf_test::to_mesh(torus.soup(m, n));
  // sides of the rectangle of the same area that the torus can be mapped to conformally
  const double area = 4 * pi * pi * large_radius * small_radius;
  const double tube = std::sqrt(area * torus.ratio()), axis = std::sqrt(area / torus.ratio());
  EXPECT_NEAR(tube, 2 * pi * small_radius, 0.01 * tube);
  EXPECT_NEAR(axis, 2 * pi * large_radius, 0.01 * axis);
  for (const bool is_meridian : {true, false})
    for (const double height : {1e-3, 1., 50.})
    {
      const SMF::Loop_system<Mesh> system(
        mesh, smf_test::poles_and_loops(
                {{smf_test::Item::CYCLE,
                  is_meridian ? smf_test::meridian(0, n) : smf_test::longitude(0, m, n), height}},
                mesh));
      const auto expect_lengths = [&](const Foliation& foliation) {
        const Coordinates coordinates(foliation);
        const SMF::Texture_chart chart = coordinates.texture_chart(0);
        const double side = coordinates.texture_size();
        const double around = foliation.flux(0) * chart.scale[0] * side;
        const double along = height * chart.scale[1] * side;
        EXPECT_NEAR(around, is_meridian ? tube : axis, 0.02 * around);
        EXPECT_NEAR(along, is_meridian ? axis : tube, 0.02 * along);
        EXPECT_NEAR(chart.upper[1] - chart.lower[1], along / side, 1e-12);
      };
      using SMF::parameters::weights;
      expect_lengths(SMF::harmonic_foliation(system));
      expect_lengths(SMF::harmonic_foliation(system, weights(SMF::Cotangent_weights())));
      expect_lengths(SMF::harmonic_foliation(
        system, weights(CGAL::Constant_property_map<Mesh::Edge_index, double>(1000))));
    }
}

// With cotangent weights the Dirichlet energy is height times circumference, so that the chart has
// the modulus that the foliation tells.
TEST(Texture, has_the_modulus_with_cotangent_weights)
{
  using smf_test::soups::icosphere;
  const auto sphere = icosphere(4);
  for (const Example& example :
       {Example{"sphere", sphere,
                smf_test::pole_items({smf_test::extreme_vertex(sphere, {0, 0, 1}),
                                      smf_test::extreme_vertex(sphere, {1, 0, -1})})},
        Example{"three poles", sphere,
                smf_test::pole_items({smf_test::extreme_vertex(sphere, {0, 0, 1}),
                                      smf_test::extreme_vertex(sphere, {1, 0, 0}),
                                      smf_test::extreme_vertex(sphere, {0, 1, -1})})}})
  {
    const Mesh mesh = smf_test::to_mesh(example.soup);
    const SMF::Loop_system<Mesh> system(mesh, smf_test::poles_and_loops(example.items, mesh));
    const Foliation foliation =
      SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
    const Coordinates coordinates(foliation);
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      const SMF::Texture_chart chart = coordinates.texture_chart(a);
      EXPECT_NEAR(chart.scale[0] / chart.scale[1], 1, 0.02) << example.name;
    }
  }
}

// ===  Boxes in a square

TEST(Boxes, are_packed_without_overlap)
{
  smf_test::Random random(7);
  for (std::size_t number : {1, 2, 3, 10, 100})
    for (const double slimness : {1., 30.})
    {
      std::vector<std::array<double, 2>> sizes;
      double area = 0, largest = 0;
      for (std::size_t i = 0; i < number; ++i)
      {
        sizes.push_back({random.between(0.1, 1) * slimness, random.between(0.01, 1) / slimness});
        if (i % 2 == 1)
          std::swap(sizes[i][0], sizes[i][1]);
        area += sizes[i][0] * sizes[i][1];
        largest = std::max({largest, sizes[i][0], sizes[i][1]});
      }
      const SMF::internal::Packed_boxes packed = SMF::internal::pack_boxes(sizes);
      ASSERT_EQ(packed.corners.size(), number);
      EXPECT_LE(packed.side, 3.2 * std::max(largest, std::sqrt(area)));
      const double gap = packed.side / 410;
      for (std::size_t i = 0; i < number; ++i)
        for (std::size_t k : {0, 1})
        {
          EXPECT_GE(packed.corners[i][k], gap);
          EXPECT_LE(packed.corners[i][k] + sizes[i][k], packed.side - gap);
        }
      for (std::size_t i = 0; i < number; ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
          bool is_apart = false;
          for (std::size_t k : {0, 1})
            is_apart |= packed.corners[i][k] + sizes[i][k] + gap < packed.corners[j][k] ||
                        packed.corners[j][k] + sizes[j][k] + gap < packed.corners[i][k];
          EXPECT_TRUE(is_apart) << number << ' ' << slimness << ' ' << i << ' ' << j;
        }
    }
}

// ===  Values of maps

TEST(Component_coordinates, go_into_maps_of_any_pairs)
{
  for (const Example& example :
       {smf_test::theta_example(), smf_test::dumbbell_example(), smf_test::example_systems()[0]})
  {
    const Solved_example<> solved(example);
    const Coordinates coordinates(solved.foliation);
    const Uv_mesh expected(coordinates);
    using Point_2 = smf_test::Kernel::Point_2;
    using Pair = std::pair<double, double>;
    Mesh output, other;
    const auto points = output.add_property_map<Mesh::Halfedge_index, Point_2>("h:uv").first;
    const auto pairs = other.add_property_map<Mesh::Halfedge_index, Pair>("h:uv").first;
    coordinates.uv_mesh(output, points);
    coordinates.uv_mesh(other, pairs);
    for (const auto h : halfedges(output))
      if (expected.has_coordinates(face(h, output)))
      {
        EXPECT_EQ(points[h], Point_2(expected.uv[h][0], expected.uv[h][1]));
        EXPECT_EQ(pairs[h], Pair(expected.uv[h][0], expected.uv[h][1]));
      }
    for (std::size_t a = 0; a < solved.system.number_of_arcs(); ++a)
    {
      Mesh chart;
      CGAL::Surface_mesh<Point_2> flat_chart;
      coordinates.chart(a, chart);
      coordinates.chart(a, flat_chart);
      ASSERT_EQ(num_vertices(flat_chart), num_vertices(chart));
      EXPECT_EQ(num_faces(flat_chart), num_faces(chart));
      for (const auto v : vertices(chart))
        EXPECT_EQ(flat_chart.point(v), Point_2(chart.point(v).x(), chart.point(v).y()));
    }
  }
}

// ===  Models of meshes

template <class TriangleMesh>
class Coordinates_on : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Surface_mesh_model<smf_test::Kernel>,
                                smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>>;

// the last argument is empty, so that a comma is needed
TYPED_TEST_SUITE(Coordinates_on, Models, );

TYPED_TEST(Coordinates_on, all_models_are_equal)
{
  for (const Example& example :
       {smf_test::example_systems()[0], smf_test::theta_example(), smf_test::example_systems()[8]})
  {
    const Solved_example<> expected_example(example);
    const Coordinates expected(expected_example.foliation);
    const Uv_mesh expected_mesh(expected);
    std::vector<Uv> expected_uv;
    for (const auto f : faces(expected_mesh.mesh))
      for (const auto h :
           CGAL::halfedges_around_face(halfedge(f, expected_mesh.mesh), expected_mesh.mesh))
        expected_uv.push_back(expected_mesh.uv[h]);

    // not a Solved_example: a cell complex that is moved has its vertices in another order
    const TypeParam mesh = smf_test::to_mesh<TypeParam>(example.soup);
    const SMF::Loop_system<TypeParam> system(mesh, smf_test::poles_and_loops(example.items, mesh));
    const auto foliation = SMF::harmonic_foliation(system);
    const SMF::Component_coordinates<TypeParam> coordinates(foliation);
    TypeParam output;
    const auto uv = get(CGAL::dynamic_halfedge_property_t<Uv>(), output);
    coordinates.uv_mesh(output, uv);
    std::size_t i = 0;
    for (const auto f : faces(output))
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, output), output))
      {
        EXPECT_EQ(get(uv, h), expected_uv.at(i)) << example.name;
        ++i;
      }
    EXPECT_EQ(i, expected_uv.size());
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      Mesh expected_chart;
      TypeParam chart;
      expected.chart(a, expected_chart);
      coordinates.chart(a, chart);
      EXPECT_EQ(num_faces(chart), num_faces(expected_chart));
      EXPECT_EQ(num_vertices(chart), num_vertices(expected_chart));
      EXPECT_NEAR(areas(chart)[0], size_of(expected_example.foliation, a),
                  1e-12 * size_of(expected_example.foliation, a));
      EXPECT_GT(areas(chart)[1], 0);
    }
  }
}

// ===  The linear solver

TEST(Component_coordinates, by_a_solver_of_the_user)
{
  const Solved_example<> solved(smf_test::theta_example());
  SMF::Simplicial_cholesky_solver solver;
  const Uv_mesh by_default((Coordinates(solved.foliation)));
  const Uv_mesh by_solver(
    Coordinates(solved.foliation, CGAL::parameters::sparse_linear_solver(std::ref(solver))));
  for (const auto h : halfedges(by_default.mesh))
    EXPECT_EQ(by_default.uv[h], by_solver.uv[h]);
}

struct Failing_solver
{
  void analyze_pattern(const Eigen::SparseMatrix<double>&) {}
  bool factorize(const Eigen::SparseMatrix<double>&) { return false; }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) { return b; }
};

TEST(Component_coordinates, report_a_solver_that_fails)
{
  const Solved_example<> solved(smf_test::theta_example());
  Failing_solver solver;
  EXPECT_THROW(
    Coordinates(solved.foliation, CGAL::parameters::sparse_linear_solver(std::ref(solver))),
    SMF::Solver_exception);
}

} // namespace test_component_coordinates
