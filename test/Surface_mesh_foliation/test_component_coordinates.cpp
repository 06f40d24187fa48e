#include "include/conformal_tori.h"
#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "include/temporary_folder.h"
#include "include/test_models.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_chart.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_seams.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_springs.h>
#include <CGAL/Surface_mesh_foliation/internal/Corner_nodes.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using smf_test::Each_foliation;
using smf_test::Example;
using smf_test::Item;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace smf = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Point = Mesh::Point;
using Uv = std::array<double, 2>;
using Foliation = smf::Measured_foliation<Mesh>;
using Coordinates = smf::Component_coordinates<Mesh>;

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_foliation,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

double area(const Uv& p, const Uv& q, const Uv& r)
{
  return ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
}

// the cut mesh with everything on it
struct Uv_mesh
{
  explicit Uv_mesh(const Coordinates& coordinates)
    : uv(mesh.add_property_map<Mesh::Halfedge_index, Uv>("h:uv").first),
      component(mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component").first),
      is_critical(mesh.add_property_map<Mesh::Edge_index, bool>("e:critical", false).first)
  {
    coordinates.uv_mesh(
      mesh, uv,
      smf::parameters::face_component_map(component).edge_is_constrained_map(is_critical));
  }

  bool has_coordinates(Mesh::Face_index f) const { return !std::isnan(uv[halfedge(f, mesh)][0]); }

  double area_of(Mesh::Face_index f) const
  {
    const auto h = halfedge(f, mesh);
    return area(uv[h], uv[next(h, mesh)], uv[next(next(h, mesh), mesh)]);
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Halfedge_index, Uv> uv;
  Mesh::Property_map<Mesh::Face_index, std::size_t> component;
  Mesh::Property_map<Mesh::Edge_index, bool> is_critical;
};

double size_of(const Foliation& foliation, std::size_t arc)
{
  return foliation.system().height(arc) * foliation.flux(arc);
}

} // namespace

// ===  Coordinates of corners

TEST_P(Each_foliation, all_faces_keep_their_orientation)
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

TEST_P(Each_foliation, only_faces_at_nodes_have_no_coordinates)
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

TEST_P(Each_foliation, v_is_the_parameter)
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
TEST_P(Each_foliation, coordinates_jump_at_one_seam_only)
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

TEST_P(Each_foliation, shapes_are_heights_and_fluxes)
{
  double energy = 0;
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    const smf::Component_shape shape = smf::component_shape(foliation, a);
    EXPECT_EQ(shape.height, system.height(a));
    EXPECT_EQ(shape.circumference, foliation.flux(a));
    EXPECT_EQ(shape.modulus(), shape.height / shape.circumference);
    EXPECT_NEAR(shape.modulus() * shape.extremal_length(), 1, 1e-15);
    energy += shape.height * shape.circumference;
  }
  EXPECT_NEAR(energy, foliation.statistics().energy, 1e-10 * energy);
  EXPECT_THROW(smf::component_shape(foliation, system.number_of_arcs()),
               smf::Invalid_parameter_exception);
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
  }
}

TEST_P(Each_foliation, charts_are_rectangles)
{
  const Coordinates coordinates(foliation);
  for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
  {
    Mesh chart;
    const auto surface_point = chart.add_property_map<Mesh::Vertex_index, Point>("v:point3").first;
    coordinates.chart(a, chart, smf::parameters::surface_point_map(surface_point));
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
  EXPECT_THROW(coordinates.chart(system.number_of_arcs(), chart), smf::Invalid_parameter_exception);
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
    const smf::Loop_system<TypeParam> system(mesh, smf_test::poles_and_loops(example.items, mesh));
    const auto foliation = smf::harmonic_foliation(system);
    const smf::Component_coordinates<TypeParam> coordinates(foliation);
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

// ===  The conformal modulus

namespace {

// the foliation of a torus with one loop and cotangent weights
struct Torus
{
  Torus(const soups::Torus_of_revolution& surface, std::size_t m, std::size_t n, bool is_meridian)
    : mesh(smf_test::to_mesh(surface.soup(m, n))),
      input(smf_test::poles_and_loops(
        {{Item::CYCLE, is_meridian ? smf_test::meridian(0, n) : smf_test::longitude(0, m, n)}},
        mesh)),
      system(mesh, input),
      foliation(smf::harmonic_foliation(system, smf::parameters::weights(smf::Cotangent_weights())))
  {}

  Mesh mesh;
  smf::Poles_and_loops<Mesh> input;
  smf::Loop_system<Mesh> system;
  Foliation foliation;
};

// The energy of u and v less twice the area of their image, divided by this: 0 if the map is
// conformal.
double conformal_energy(const Uv_mesh& uv_mesh)
{
  double energy = 0, total = 0;
  for (const auto f : faces(uv_mesh.mesh))
  {
    total += uv_mesh.area_of(f);
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, uv_mesh.mesh), uv_mesh.mesh))
    {
      const auto g = next(h, uv_mesh.mesh), i = next(g, uv_mesh.mesh);
      const auto a =
        uv_mesh.mesh.point(target(i, uv_mesh.mesh)) - uv_mesh.mesh.point(target(h, uv_mesh.mesh));
      const auto b =
        uv_mesh.mesh.point(target(g, uv_mesh.mesh)) - uv_mesh.mesh.point(target(h, uv_mesh.mesh));
      const double cotangent = a * b / std::sqrt(CGAL::cross_product(a, b).squared_length());
      for (int k : {0, 1})
        energy += cotangent / 2 * std::pow(uv_mesh.uv[g][k] - uv_mesh.uv[i][k], 2);
    }
  }
  return energy / (2 * total) - 1;
}

} // namespace

TEST(Modulus, of_a_torus_of_revolution_converges_at_second_order)
{
  for (const double small_radius : {1., 2.})
    for (const bool is_meridian : {true, false})
    {
      const soups::Torus_of_revolution surface(3, small_radius, 0.1);
      const double exact = is_meridian ? 1 / surface.ratio() : surface.ratio();
      double last_error = 0, last_energy = 0;
      for (std::size_t level = 0; level < 3; ++level)
      {
        const std::size_t n = std::size_t(16) << level;
        const Torus torus(surface, surface.number_of_rows(16) << level, n, is_meridian);
        const double error =
          std::abs(smf::component_shape(torus.foliation, 0).modulus() / exact - 1);
        const Uv_mesh uv_mesh((Coordinates(torus.foliation)));
        const double energy = conformal_energy(uv_mesh);
        for (const auto f : faces(uv_mesh.mesh))
          EXPECT_GT(uv_mesh.area_of(f), 0);
        std::cout << "R/r " << 3 / small_radius << (is_meridian ? ", meridian" : ", longitude")
                  << ", n " << n << ": modulus error " << error << ", conformal energy " << energy;
        if (level > 0)
        {
          std::cout << ", orders " << std::log2(last_error / error) << ' '
                    << std::log2(last_energy / energy);
          EXPECT_GT(std::log2(last_error / error), 1.8);
          EXPECT_GT(std::log2(last_energy / energy), 1.8);
        }
        std::cout << std::endl;
        last_error = error;
        last_energy = energy;
      }
      EXPECT_LT(last_error, 2e-3);
    }
}

// A flat torus is one by its weights, wherever its vertices are.
class Flat_torus
{
public:
  // the step from row to row is (0.9, shear), that along a row (0, 1)
  Flat_torus(std::size_t m, std::size_t n, double shear)
    : mesh(smf_test::to_mesh(soups::Torus_of_revolution(3, 1, 0).soup(m, n))),
      weight(mesh.add_property_map<Mesh::Edge_index, double>("e:weight", 0).first),
      m_m(m),
      m_n(n),
      m_step({0.9, shear, 0})
  {
    smf_test::Random random(3);
    for (std::size_t i = 0; i < m * n; ++i)
      m_noise.push_back({random.between(-0.05, 0.05), random.between(-0.05, 0.05), 0});
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        const std::size_t even = i % 2 == 0 ? 1 : 0; // as staggered_triangles()
        add({{{i, j}, {i + 1, j + 1 - even}, {i, j + 1}}});
        add({{{i, j + even}, {i + 1, j}, {i + 1, j + 1}}});
      }
  }

  // of leaves along a row, or across
  double modulus(bool is_along_row) const
  {
    const soups::Point across = soups::scaled(m_step, static_cast<double>(m_m));
    const soups::Point along = {0, static_cast<double>(m_n), 0};
    const soups::Point& loop = is_along_row ? along : across;
    return std::abs(soups::cross(across, along)[2]) / soups::dot(loop, loop);
  }

  Mesh mesh;
  Mesh::Property_map<Mesh::Edge_index, double> weight; // half the sum of both cotangents

private:
  using Place = std::array<std::size_t, 2>; // not reduced modulo m and n

  soups::Point point(const Place& p) const
  {
    const auto [i, j] = p;
    const soups::Point along = {0, static_cast<double>(j) + (i % 2 == 0 ? 0 : 0.5), 0};
    return soups::sum(soups::sum(along, m_step, static_cast<double>(i)),
                      m_noise[i % m_m * m_n + j % m_n]);
  }

  Mesh::Vertex_index vertex(const Place& p) const
  {
    return smf_test::vertex(p[0] % m_m * m_n + p[1] % m_n);
  }

  void add(const std::array<Place, 3>& triangle)
  {
    for (std::size_t k : {0, 1, 2})
    {
      const Place &p = triangle[(k + 1) % 3], &q = triangle[(k + 2) % 3];
      const soups::Point a = soups::sum(point(p), point(triangle[k]), -1);
      const soups::Point b = soups::sum(point(q), point(triangle[k]), -1);
      const auto [h, exists] = halfedge(vertex(p), vertex(q), mesh);
      ASSERT_TRUE(exists);
      weight[edge(h, mesh)] += soups::dot(a, b) / std::abs(soups::cross(a, b)[2]) / 2;
    }
  }

  std::size_t m_m, m_n;
  soups::Point m_step;
  std::vector<soups::Point> m_noise;
};

// There t is linear, and the modulus exact on any mesh that is Delaunay in the flat metric.
TEST(Modulus, of_a_flat_torus_is_exact)
{
  const std::size_t m = 12, n = 10;
  for (const double shear : {0., 0.15, -0.2})
    for (const bool is_along_row : {true, false})
    {
      const Flat_torus torus(m, n, shear);
      const Item loop = {
        Item::CYCLE, is_along_row ? smf_test::meridian(0, n) : smf_test::longitude(0, m, n), 2.5};
      const smf::Loop_system<Mesh> system(torus.mesh,
                                          smf_test::poles_and_loops({loop}, torus.mesh));
      const Foliation foliation =
        smf::harmonic_foliation(system, smf::parameters::weights(torus.weight));
      const double exact = torus.modulus(is_along_row);
      EXPECT_NEAR(smf::component_shape(foliation, 0).modulus(), exact, 1e-11 * exact);
      const Uv_mesh uv_mesh((Coordinates(foliation)));
      for (const auto f : faces(uv_mesh.mesh))
        EXPECT_GT(uv_mesh.area_of(f), 0);
    }
}

// Each bisection of edges adds log(2) / (2 pi) at each of the two poles.
TEST(Modulus, grows_with_the_logarithm_of_the_resolution_at_poles)
{
  double last = 0;
  for (int level = 2; level < 6; ++level)
  {
    const smf_test::Triangle_soup soup = soups::icosphere(level);
    const Mesh mesh = smf_test::to_mesh(soup);
    const smf::Loop_system<Mesh> system(
      mesh,
      smf_test::poles_and_loops(smf_test::pole_items({smf_test::extreme_vertex(soup, {0, 0, 1}),
                                                      smf_test::extreme_vertex(soup, {0, 0, -1})}),
                                mesh));
    const Foliation foliation =
      smf::harmonic_foliation(system, smf::parameters::weights(smf::Cotangent_weights()));
    const double modulus = smf::component_shape(foliation, 0).modulus();
    if (level > 2)
    {
      EXPECT_NEAR(modulus - last, std::log(2) / soups::pi, 0.03 * std::log(2) / soups::pi);
    }
    last = modulus;
  }
}

// With cotangents the modulus belongs to the shape, with mean values to its size as well.
TEST(Modulus, of_mean_value_weights_is_not_conformal)
{
  const Torus torus(soups::Torus_of_revolution(3, 1, 0.1), 52, 16, true);
  Mesh large = torus.mesh;
  for (const auto v : vertices(large))
    large.point(v) = CGAL::ORIGIN + 4 * (large.point(v) - CGAL::ORIGIN);
  const smf::Loop_system<Mesh> system(
    large, smf_test::poles_and_loops({{Item::CYCLE, smf_test::meridian(0, 16)}}, large));
  const auto modulus = [](const Foliation& foliation) {
    return smf::component_shape(foliation, 0).modulus();
  };
  const double cotangent =
    modulus(smf::harmonic_foliation(system, smf::parameters::weights(smf::Cotangent_weights())));
  EXPECT_NEAR(cotangent, modulus(torus.foliation), 1e-11 * cotangent);
  const double small_mean_value = modulus(smf::harmonic_foliation(torus.system));
  EXPECT_NEAR(modulus(smf::harmonic_foliation(system)), 4 * small_mean_value,
              1e-9 * small_mean_value);
}

// ===  The linear solver, and files

TEST(Component_coordinates, by_a_solver_of_the_user)
{
  const Solved_example<> solved(smf_test::theta_example());
  smf::Simplicial_cholesky_solver solver;
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
    smf::Solver_exception);
}

// what was read of an OBJ file, and whether its faces are those of a mesh
struct Obj
{
  // the corners of a face as words
  void expect_face(std::istringstream& words, const Uv_mesh& uv_mesh, Mesh::Face_index f) const
  {
    const bool has_uv = uv_mesh.has_coordinates(f);
    EXPECT_EQ(group, has_uv ? "component_" + std::to_string(uv_mesh.component[f]) : "none");
    auto h = prev(halfedge(f, uv_mesh.mesh), uv_mesh.mesh);
    std::string word;
    for (; words >> word; h = next(h, uv_mesh.mesh))
    {
      const std::size_t slash = word.find('/');
      EXPECT_EQ(points.at(std::stoul(word) - 1), uv_mesh.mesh.point(target(h, uv_mesh.mesh)));
      ASSERT_EQ(slash != std::string::npos, has_uv);
      if (has_uv)
      {
        EXPECT_EQ(uvs.at(std::stoul(word.substr(slash + 1)) - 1), uv_mesh.uv[h]);
      }
    }
  }

  std::vector<Point> points;
  std::vector<Uv> uvs;
  std::string group;
};

TEST_P(Each_foliation, coordinates_in_obj)
{
  const smf_test::Temporary_folder folder;
  const Coordinates coordinates(foliation);
  const Uv_mesh uv_mesh(coordinates);
  smf::write_component_coordinates_obj(folder.file_name("uv.obj"), coordinates);
  std::istringstream file(smf_test::file_text(folder.file_name("uv.obj")));
  Obj obj;
  std::string line;
  auto f = faces(uv_mesh.mesh).begin();
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    double x = 0, y = 0, z = 0;
    if (keyword == "v" && words >> x >> y >> z)
      obj.points.emplace_back(x, y, z);
    else if (keyword == "vt" && words >> x >> y)
      obj.uvs.push_back({x, y});
    else if (keyword == "g")
      words >> obj.group;
    else
    {
      ASSERT_EQ(keyword, "f");
      obj.expect_face(words, uv_mesh, *f++);
    }
  }
  EXPECT_EQ(f, faces(uv_mesh.mesh).end());
  EXPECT_LT(obj.uvs.size(), 3 * num_faces(uv_mesh.mesh)); // shared where there is no seam
}

TEST_P(Each_foliation, coordinates_in_ply)
{
  const smf_test::Temporary_folder folder;
  const Coordinates coordinates(foliation);
  const Uv_mesh uv_mesh(coordinates);
  smf::write_component_coordinates_ply(folder.file_name("uv.ply"), coordinates);
  std::istringstream file(smf_test::file_text(folder.file_name("uv.ply")));
  std::string line;
  while (std::getline(file, line) && line != "end_header")
    ;
  std::vector<Point> points;
  for (std::size_t i = 0; i < num_vertices(uv_mesh.mesh); ++i)
  {
    double x = 0, y = 0, z = 0;
    file >> x >> y >> z;
    points.emplace_back(x, y, z);
  }
  for (const auto f : faces(uv_mesh.mesh))
  {
    int number = 0, component = 0;
    std::array<std::size_t, 3> corners = {};
    std::array<Uv, 3> uvs = {};
    file >> number >> corners[0] >> corners[1] >> corners[2];
    EXPECT_EQ(number, 3);
    file >> number;
    EXPECT_EQ(number, 6);
    for (Uv& uv : uvs)
      file >> uv[0] >> uv[1];
    file >> component;
    ASSERT_TRUE(file);
    EXPECT_EQ(component, uv_mesh.has_coordinates(f) ? static_cast<int>(uv_mesh.component[f]) : -1);
    auto h = prev(halfedge(f, uv_mesh.mesh), uv_mesh.mesh);
    for (std::size_t i : {0, 1, 2})
    {
      EXPECT_EQ(points.at(corners[i]), uv_mesh.mesh.point(target(h, uv_mesh.mesh)));
      EXPECT_EQ(uvs[i], uv_mesh.has_coordinates(f) ? uv_mesh.uv[h] : (Uv{0, 0}));
      h = next(h, uv_mesh.mesh);
    }
  }
  int rest = 0;
  EXPECT_FALSE(file >> rest);
}

TEST(Component_coordinates, cannot_be_written_where_there_is_no_folder)
{
  const smf_test::Temporary_folder folder;
  const Solved_example<> solved(smf_test::theta_example());
  const Coordinates coordinates(solved.foliation);
  EXPECT_THROW(smf::write_component_coordinates_ply(folder.file_name("no/such.ply"), coordinates),
               smf::Invalid_file_exception);
  EXPECT_THROW(smf::write_component_coordinates_obj(folder.file_name("no/such.obj"), coordinates),
               smf::Invalid_file_exception);
}
