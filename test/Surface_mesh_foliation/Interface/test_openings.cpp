// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with openings that are poles: what every public function makes of them.

#include "include/open_meshes.h"
#include "include/polylines.h"
#include "include/temporary_folder.h"
#include "include/vtp_file.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/curve_skeleton.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_matching.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polyhedron_3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace test_openings {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace soups = smf_test::soups;
using smf_test::Mesh;
using smf_test::Open_case;
using Point = Mesh::Point;
using Input = SMF::Poles_and_loops<Mesh>;
using Graph = SMF::Reeb_graph<Point>;
using Foliation = SMF::Measured_foliation<Mesh>;
using Halfedge = Mesh::Halfedge_index;

// solved; `mesh` stays where it is
struct Solved
{
  explicit Solved(const Open_case& open)
    : Solved(open.soup, [&](const Mesh& m) { return smf_test::openings_and_poles(m, open.poles); })
  {}

  template <class Make_input>
  Solved(const smf_test::Triangle_soup& soup, const Make_input& make_input)
    : mesh(new Mesh(smf_test::to_open_mesh(soup))),
      input(make_input(*mesh)),
      system(*mesh, input),
      foliation(SMF::harmonic_foliation(system))
  {}

  Graph graph() const
  {
    Graph result;
    SMF::reeb_graph(foliation, result);
    return result;
  }

  std::unique_ptr<Mesh> mesh;
  Input input;
  SMF::Loop_system<Mesh> system;
  Foliation foliation;
};

std::vector<Point> border_points(const Mesh& mesh, Halfedge border)
{
  std::vector<Point> result;
  Halfedge h = border;
  do
  {
    result.push_back(mesh.point(target(h, mesh)));
    h = next(h, mesh);
  } while (h != border);
  result.push_back(result.front());
  return result;
}

// the centroid of a closed polyline by length, and the root mean square distance from it
struct Moments
{
  explicit Moments(const std::vector<Point>& polyline)
  {
    double length = 0, x = 0, y = 0, z = 0;
    for (std::size_t i = 1; i < polyline.size(); ++i)
    {
      const double step = smf_test::distance(polyline[i - 1], polyline[i]);
      const Point middle = CGAL::midpoint(polyline[i - 1], polyline[i]);
      length += step;
      x += step * middle.x();
      y += step * middle.y();
      z += step * middle.z();
    }
    centroid = Point(x / length, y / length, z / length);
    double sum = 0;
    for (std::size_t i = 1; i < polyline.size(); ++i)
    {
      const double step = smf_test::distance(polyline[i - 1], polyline[i]);
      const Point middle = CGAL::midpoint(polyline[i - 1], polyline[i]);
      sum += step * (CGAL::squared_distance(middle, centroid) + step * step / 12);
    }
    radius = std::sqrt(sum / length);
  }

  Point centroid;
  double radius;
};

std::string name_of_case(const ::testing::TestParamInfo<Open_case>& info)
{
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

// the cases are made and solved once
const std::vector<Open_case>& all_cases()
{
  static const std::vector<Open_case> result = smf_test::open_cases();
  return result;
}

class Openings : public ::testing::TestWithParam<Open_case>
{
protected:
  Openings() : solved(GetParam()), mesh(*solved.mesh), foliation(solved.foliation) {}

  std::size_t number_of_arcs() const { return solved.system.number_of_arcs(); }

  int euler_characteristic() const
  {
    return static_cast<int>(num_vertices(mesh)) - static_cast<int>(num_edges(mesh)) +
           static_cast<int>(num_faces(mesh));
  }

  Solved solved;
  const Mesh& mesh;
  const Foliation& foliation;
};

INSTANTIATE_TEST_SUITE_P(Cases, Openings, ::testing::ValuesIn(all_cases()), name_of_case);

} // namespace

TEST_P(Openings, the_graph_and_its_certificate)
{
  EXPECT_TRUE(foliation.statistics().has_converged);
  EXPECT_TRUE(foliation.statistics().is_certified);
  const std::vector<Halfedge> borders = smf_test::border_halfedges(mesh);
  ASSERT_EQ(borders.size(), GetParam().openings);
  const Graph graph = solved.graph();
  EXPECT_EQ(num_vertices(graph), GetParam().nodes);
  EXPECT_EQ(num_edges(graph), GetParam().arcs);
  std::set<int> poles;
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
  {
    const SMF::Reeb_node<Point>& node = graph[v];
    EXPECT_EQ(node.pole, solved.system.pole(v));
    if (node.kind != SMF::Node_kind::BOUNDARY)
    {
      EXPECT_EQ(node.kind, node.pole < 0 ? SMF::Node_kind::SADDLE : SMF::Node_kind::POLE);
      continue;
    }
    ASSERT_GE(node.pole, 0);
    const std::size_t pole = static_cast<std::size_t>(node.pole);
    poles.insert(node.pole);
    ASSERT_LT(pole, borders.size()); // they were given first
    EXPECT_TRUE(solved.system.is_border_pole(pole));
    EXPECT_EQ(degree(v, graph), 1u);
    const std::vector<Point> border = border_points(mesh, borders[pole]);
    EXPECT_EQ(solved.system.pole_vertices(pole).size(), border.size() - 1);
    const Moments moments(border);
    EXPECT_LT(smf_test::distance(moments.centroid, node.point), 1e-12 * moments.radius);
    EXPECT_NEAR(node.radius / moments.radius, 1, 1e-12);
  }
  EXPECT_EQ(poles.size(), borders.size());
  for (const auto e : boost::make_iterator_range(edges(graph)))
  {
    const auto is_pole = [&](std::size_t v) { return graph[v].kind == SMF::Node_kind::POLE; };
    const int ends = is_pole(source(e, graph)) + is_pole(target(e, graph));
    EXPECT_EQ(graph[e].component, ends == 0   ? SMF::Component_kind::CYLINDER
                                  : ends == 1 ? SMF::Component_kind::DISK
                                              : SMF::Component_kind::SPHERE);
  }
}

TEST_P(Openings, are_no_singularities)
{
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  int sum = 0;
  for (const SMF::Singularity<Mesh>& singularity : singularities)
  {
    sum += singularity.index;
    const int pole = solved.system.pole(singularity.node);
    EXPECT_EQ(singularity.index > 0, pole >= 0);
    EXPECT_FALSE(pole >= 0 && solved.system.is_border_pole(static_cast<std::size_t>(pole)));
    if (singularity.is_face)
    {
      EXPECT_LT(singularity.face.idx(), num_faces(mesh));
    }
    else
      EXPECT_LT(singularity.vertex.idx(), num_vertices(mesh));
  }
  EXPECT_EQ(sum, 2 * euler_characteristic());
}

TEST_P(Openings, components_have_no_caps)
{
  Mesh cut;
  const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:arc").first;
  EXPECT_EQ(SMF::surface_components(foliation, cut, SMF::parameters::face_component_map(component)),
            number_of_arcs());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(cut));
  EXPECT_NEAR(PMP::area(cut) / PMP::area(mesh), 1, 1e-12);
  for (const auto v : vertices(mesh))
    EXPECT_EQ(cut.point(v), mesh.point(v));
  EXPECT_EQ(static_cast<int>(num_vertices(cut)) - static_cast<int>(num_edges(cut)) +
              static_cast<int>(num_faces(cut)),
            euler_characteristic());
  EXPECT_EQ(smf_test::border_halfedges(cut).size(), GetParam().openings);
  std::vector<double> area(number_of_arcs(), 0);
  for (const auto f : faces(cut))
    area.at(component[f]) += PMP::face_area(f, cut);
  const Graph graph = solved.graph();
  for (const auto e : boost::make_iterator_range(edges(graph)))
    EXPECT_NEAR(graph[e].area / area[graph[e].loop], 1, 1e-12);

  const auto segment = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  for (const auto f : faces(mesh))
    put(segment, f, number_of_arcs());
  EXPECT_EQ(SMF::face_segmentation(foliation, segment), number_of_arcs());
  for (const auto f : faces(mesh))
    EXPECT_LT(get(segment, f), number_of_arcs());
}

TEST_P(Openings, edge_values_and_weights)
{
  const auto value = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  const auto weight = get(CGAL::dynamic_edge_property_t<double>(), mesh);
  for (const auto e : edges(mesh))
    put(value, e, -1);
  SMF::edge_values(foliation, value);
  SMF::edge_weights(solved.system, SMF::Mean_value_weights(), weight);
  double energy = 0;
  for (const auto e : edges(mesh))
  {
    EXPECT_EQ(get(value, e), foliation.edge_value(e));
    EXPECT_GT(get(weight, e), 0);
    energy += get(weight, e) * get(value, e) * get(value, e);
    if (is_border(e, mesh))
    {
      EXPECT_EQ(get(value, e), 0);
      EXPECT_TRUE(foliation.path(e).empty());
    }
  }
  double flux = 0;
  for (std::size_t a = 0; a < number_of_arcs(); ++a)
    flux += solved.system.height(a) * foliation.flux(a);
  EXPECT_NEAR(energy / flux, 1, 1e-9);
  const Foliation same =
    SMF::harmonic_foliation(solved.system, SMF::parameters::weights(weight)); // as a map
  for (const auto e : edges(mesh))
    EXPECT_EQ(same.edge_value(e), foliation.edge_value(e));
}

TEST_P(Openings, leaves_end_on_no_border)
{
  std::vector<SMF::Critical_polyline<Point>> critical;
  SMF::critical_leaves(foliation, std::back_inserter(critical));
  for (std::size_t p = 0; p < GetParam().openings; ++p)
  {
    std::vector<const SMF::Critical_polyline<Point>*> at_border;
    double length = 0;
    for (const SMF::Critical_polyline<Point>& polyline : critical)
      if (solved.system.pole(polyline.node) == static_cast<int>(p))
      {
        at_border.push_back(&polyline);
        length += smf_test::length(polyline.points);
      }
    const std::vector<Point> border = border_points(mesh, smf_test::border_halfedges(mesh)[p]);
    if (GetParam().has_ears)
    {
      EXPECT_GE(length, smf_test::length(border) * (1 - 1e-12)); // with edges within the ears
      continue;
    }
    ASSERT_EQ(at_border.size(), 1u); // the border as a closed polyline
    const std::vector<Point>& points = at_border[0]->points;
    EXPECT_EQ(points.front(), points.back());
    EXPECT_EQ(points.size(), border.size());
    EXPECT_EQ(std::set<Point>(points.begin(), points.end()),
              std::set<Point>(border.begin(), border.end()));
  }

  const SMF::Leaf_tracer<Mesh> tracer(foliation);
  for (std::size_t a = 0; a < number_of_arcs(); ++a)
    for (const double share : {1e-9, 0.3, 1 - 1e-9})
    {
      const auto points = SMF::leaf(foliation, a, share * solved.system.height(a));
      EXPECT_GT(points.size(), 3u);
      EXPECT_EQ(points.front(), points.back());
    }
  for (const auto v : vertices(mesh))
    if (CGAL::is_border(v, mesh))
    {
      EXPECT_FALSE(foliation.cell(v).is_arc);
      EXPECT_FALSE(tracer.leaf_through(v).has_value());
    }
  for (const auto f : faces(mesh))
  {
    const auto place = tracer.locate(f, {1, 1, 1});
    EXPECT_LT(place.index, place.is_arc ? number_of_arcs() : solved.system.number_of_nodes());
  }
}

TEST_P(Openings, files_have_no_caps)
{
  const smf_test::Temporary_folder folder;
  Mesh cut;
  SMF::surface_components(foliation, cut);
  const std::string components = folder.file_name("components"), input = folder.file_name("input");
  SMF::write_components_vtp(components, foliation);
  SMF::write_foliation_vtp(input, foliation);
  const auto expect_sizes = [](const smf_test::Vtp_file& file, const Mesh& expected) {
    EXPECT_EQ(file.points.size(), num_vertices(expected));
    EXPECT_EQ(file.polygons.size(), num_faces(expected));
  };
  expect_sizes(smf_test::Vtp_file(components), cut);
  expect_sizes(smf_test::Vtp_file(input), mesh);
  SMF::write_components_ply(components, foliation);
  SMF::write_foliation_ply(input, foliation);
  const auto expect_header = [](const std::string& file_name, const Mesh& expected) {
    const std::string text = smf_test::file_text(file_name);
    EXPECT_NE(text.find("element vertex " + std::to_string(num_vertices(expected)) + '\n'),
              std::string::npos);
    EXPECT_NE(text.find("element face " + std::to_string(num_faces(expected)) + '\n'),
              std::string::npos);
  };
  expect_header(components, cut);
  expect_header(input, mesh);
}

TEST_P(Openings, saddle_faces_are_split_behind_the_vertices_of_the_input)
{
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(foliation, std::back_inserter(singularities));
  const auto number = static_cast<std::size_t>(std::count_if(
    singularities.begin(), singularities.end(), [](const auto& s) { return s.is_face; }));
  Mesh split;
  const auto value = split.add_property_map<Mesh::Edge_index, double>("e:value").first;
  EXPECT_EQ(SMF::subdivide_saddle_faces(foliation, split, SMF::parameters::edge_value_map(value)),
            number);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(split));
  EXPECT_EQ(num_vertices(split), num_vertices(mesh) + number);
  EXPECT_EQ(num_faces(split), num_faces(mesh) + 2 * number);
  EXPECT_NEAR(PMP::area(split) / PMP::area(mesh), 1, 1e-12);
}

TEST_P(Openings, skeletons_have_all_vertices)
{
  const auto embedding = SMF::reeb_graph_embedding(foliation);
  SMF::Curve_skeleton<Mesh> skeleton;
  SMF::curve_skeleton(foliation, embedding, skeleton);
  std::set<Mesh::Vertex_index> reached;
  for (const auto p : boost::make_iterator_range(vertices(skeleton)))
    reached.insert(skeleton[p].vertices.begin(), skeleton[p].vertices.end());
  EXPECT_EQ(reached.size(), num_vertices(mesh));
}

TEST_P(Openings, a_solver_starts_again_from_the_last_foliation)
{
  SMF::Foliation_solver<Mesh> solver;
  solver.solve(solved.system);
  Input input = solved.input;
  input.set_height(0, 2.5);
  const SMF::Loop_system<Mesh> other(mesh, input);
  const Foliation again = solver.solve(other), fresh = SMF::harmonic_foliation(other);
  EXPECT_TRUE(again.statistics().is_certified);
  for (const auto e : edges(mesh))
    EXPECT_NEAR(again.edge_value(e), fresh.edge_value(e), 1e-9);
}

TEST_P(Openings, whitehead_moves_find_the_same)
{
  const Foliation other = SMF::whitehead_foliation(
    solved.system, SMF::parameters::number_of_iterations(20000).tolerance(1e-9));
  EXPECT_TRUE(other.statistics().is_certified);
  for (const auto e : edges(mesh))
    EXPECT_NEAR(other.edge_value(e), foliation.edge_value(e), 1e-5);
}

TEST(Openings_and_poles, faces_in_ears_lie_at_the_border)
{
  for (const Open_case& open : all_cases())
  {
    const Solved solved(open);
    bool has_face_at_border = false;
    for (const auto f : faces(*solved.mesh))
    {
      double sum = 0;
      for (const auto h : halfedges_around_face(halfedge(f, *solved.mesh), *solved.mesh))
        sum += solved.foliation.edge_value(edge(h, *solved.mesh));
      has_face_at_border = has_face_at_border || sum == 0;
    }
    EXPECT_EQ(has_face_at_border, open.has_ears) << open.name;
  }
}

// Ears change nothing: the foliation on the rest is that of the mesh without them, but for the
// weights of the chord.
TEST(Openings_and_poles, ears_have_no_influence)
{
  const auto& cases = all_cases();
  const auto find = [&](const std::string& name) {
    return Solved(*std::find_if(cases.begin(), cases.end(),
                                [&](const Open_case& open) { return open.name == name; }));
  };
  const Solved one = find("ear"), other = find("thin strip");
  for (std::size_t v = 0; v < 28; ++v)
    EXPECT_NEAR(one.foliation.parameter(smf_test::vertex(v)),
                other.foliation.parameter(smf_test::vertex(v)), 1e-12);
  EXPECT_NEAR(one.foliation.flux(0) / other.foliation.flux(0), 1, 1e-12);
}

TEST(Openings_and_poles, a_flat_annulus_has_the_logarithm)
{
  const std::size_t n = 24, rings = 9;
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(n, rings));
  const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
  ASSERT_EQ(system.number_of_arcs(), 1u);
  EXPECT_EQ(system.height(0), 2); // the loops of both are homotopic
  const Foliation foliation =
    SMF::harmonic_foliation(system, SMF::parameters::weights(SMF::Cotangent_weights()));
  const double largest =
    std::log(smf_test::distance(mesh.point(smf_test::vertex(n * rings - 1)), CGAL::ORIGIN));
  const bool begins_inside =
    system.pole_vertices(static_cast<std::size_t>(system.pole(system.node(0, 0))))[0] ==
    smf_test::vertex(0);
  for (const auto v : vertices(mesh))
  {
    if (CGAL::is_border(v, mesh))
      continue;
    ASSERT_TRUE(foliation.cell(v).is_arc);
    const double share =
      std::log(std::sqrt(CGAL::squared_distance(mesh.point(v), Point(0, 0, 0)))) / largest;
    // the triangulation is similar to itself, so this is exact
    EXPECT_NEAR(foliation.parameter(v) / 2, begins_inside ? share : 1 - share, 1e-12);
  }
  const double modulus = foliation.flux(0) / system.height(0);
  EXPECT_NEAR(modulus / (2 * soups::pi / largest), 1, 0.02);
}

// With rings at equal distances the error is that of linear finite elements, of second order.
TEST(Openings_and_poles, the_logarithm_is_approached_at_second_order)
{
  std::vector<double> errors;
  for (const std::size_t rings : {5, 9, 17})
  {
    std::vector<std::array<double, 2>> radii;
    for (std::size_t i = 0; i < rings; ++i)
      radii.push_back({1 + 2 * static_cast<double>(i) / static_cast<double>(rings - 1), 0});
    const Mesh mesh = smf_test::to_open_mesh(soups::tube(6 * (rings - 1), radii));
    const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
    const Foliation foliation = SMF::harmonic_foliation(
      system, SMF::parameters::weights(SMF::Cotangent_weights()).allow_any_weights(true));
    const bool begins_inside =
      system.pole_vertices(static_cast<std::size_t>(system.pole(system.node(0, 0))))[0] ==
      smf_test::vertex(0);
    errors.push_back(0);
    for (const auto v : vertices(mesh))
      if (foliation.cell(v).is_arc)
      {
        const double share =
          std::log(std::sqrt(CGAL::squared_distance(mesh.point(v), Point(0, 0, 0)))) / std::log(3.);
        errors.back() = std::max(errors.back(), std::abs(foliation.parameter(v) / 2 -
                                                         (begins_inside ? share : 1 - share)));
      }
  }
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], errors[0] / 3);
  EXPECT_LT(errors[2], errors[1] / 3);
}

TEST(Openings_and_poles, a_cylinder_has_its_height)
{
  const std::size_t n = 10, rings = 7;
  std::vector<std::array<double, 2>> levels;
  for (std::size_t i = 0; i < rings; ++i)
    levels.push_back({1, 0.5 * static_cast<double>(i)});
  const Mesh mesh = smf_test::to_open_mesh(soups::tube(n, levels));
  const SMF::Loop_system<Mesh> system(mesh, smf_test::openings_and_poles(mesh));
  const Foliation foliation = SMF::harmonic_foliation(system);
  const bool begins_below =
    system.pole_vertices(static_cast<std::size_t>(system.pole(system.node(0, 0))))[0] ==
    smf_test::vertex(0);
  for (const auto v : vertices(mesh))
    if (!CGAL::is_border(v, mesh))
    {
      const double share = mesh.point(v).z() / 3;
      EXPECT_NEAR(foliation.parameter(v) / 2, begins_below ? share : 1 - share, 1e-12);
    }
}

// Edges from one opening to another one pass the whole arc.
TEST(Openings_and_poles, edges_may_join_openings)
{
  for (const Open_case& open : all_cases())
  {
    if (open.name != "openings joined by edges" && open.name != "strip")
      continue;
    const Solved solved(open);
    const Mesh& mesh = *solved.mesh;
    std::size_t number = 0;
    for (const auto e : edges(mesh))
    {
      const auto u = source(halfedge(e, mesh), mesh), v = target(halfedge(e, mesh), mesh);
      if (is_border(e, mesh) || !CGAL::is_border(u, mesh) || !CGAL::is_border(v, mesh))
        continue;
      ++number;
      EXPECT_EQ(solved.foliation.edge_value(e), solved.system.height(0));
    }
    EXPECT_GT(number, 0u) << open.name;
  }
}

// The chord of the glasses crosses the saddle between the two holes.
TEST(Openings_and_poles, a_chord_between_openings_is_a_path_in_the_tree)
{
  const std::size_t n = 8;
  const Solved solved(soups::glasses(n, 3),
                      [](const Mesh& mesh) { return smf_test::openings_and_poles(mesh); });
  const auto [h, exists] =
    halfedge(smf_test::vertex(2 * n), smf_test::vertex(2 * n + 1), *solved.mesh);
  ASSERT_TRUE(exists);
  EXPECT_FALSE(is_border(edge(h, *solved.mesh), *solved.mesh));
  const auto path = solved.foliation.path(h);
  ASSERT_EQ(path.size(), 4u); // into the arc, out of it at the saddle, and back
  for (const auto& passage : path)
    EXPECT_EQ(passage.arc, path[0].arc);
  EXPECT_EQ(solved.foliation.edge_value(edge(h, *solved.mesh)),
            2 * solved.system.height(path[0].arc));
}

TEST(Openings_and_poles, a_loop_of_the_users_around_an_opening)
{
  const soups::Point pole = {0, 0, -1};
  const smf_test::Triangle_soup bowl = soups::part_below(soups::icosphere(3), 2, 0.3);
  const std::size_t bottom = soups::nearest_vertex(bowl, pole);
  const Solved solved(bowl, [&](const Mesh& mesh) {
    std::vector<Mesh::Vertex_index> inside; // the border, and a ring around it
    for (const auto v : vertices(mesh))
      if (mesh.point(v).z() > -0.2)
        inside.push_back(v);
    std::vector<SMF::Loop<Mesh>> loops;
    SMF::loops_around_vertices(inside, mesh, std::back_inserter(loops));
    EXPECT_EQ(loops.size(), 1u);
    Input input;
    input.add_border_pole(smf_test::border_halfedges(mesh)[0], loops.at(0), 1.5);
    input.add_pole(smf_test::vertex(bottom), 0.5);
    return input;
  });
  EXPECT_EQ(solved.system.number_of_arcs(), 1u);
  EXPECT_EQ(solved.system.height(0), 2);
  const Solved tight(
    bowl, [&](const Mesh& mesh) { return smf_test::openings_and_poles(mesh, {bottom}); });
  for (const auto e : edges(*solved.mesh))
    EXPECT_NEAR(solved.foliation.edge_value(e), tight.foliation.edge_value(e), 1e-9);
}

TEST(Openings_and_poles, graphs_of_open_meshes_are_matched)
{
  const auto make = [](double cosine, const soups::Point& third) {
    return Solved(
      soups::without_caps(soups::icosphere(3), {{1, 0, 0}, {-0.5, 0.9, 0}, third}, cosine),
      [](const Mesh& mesh) { return smf_test::openings_and_poles(mesh); });
  };
  const Graph one = make(0.9, {-0.5, -0.9, 0}).graph(), other = make(0.95, {0, -0.8, 0.5}).graph();
  EXPECT_TRUE(SMF::reeb_graphs_are_isomorphic(one, other, SMF::parameters::use_pole_labels(false)));
  EXPECT_TRUE(
    SMF::match_reeb_graphs(one, other, SMF::parameters::use_pole_labels(false)).has_value());

  // an opening is not a vertex
  const smf_test::Triangle_soup sphere = soups::icosphere(3);
  const Mesh closed = smf_test::to_mesh(sphere);
  Input input;
  for (const soups::Point& p :
       {soups::Point{1, 0, 0}, soups::Point{-0.5, 0.9, 0}, soups::Point{-0.5, -0.9, 0}})
    input.add_pole(smf_test::vertex(soups::nearest_vertex(sphere, p)));
  const SMF::Loop_system<Mesh> system(closed, input);
  Graph with_poles;
  SMF::reeb_graph(SMF::harmonic_foliation(system), with_poles);
  EXPECT_FALSE(
    SMF::reeb_graphs_are_isomorphic(one, with_poles, SMF::parameters::use_pole_labels(false)));
}

TEST(Openings_and_poles, other_mesh_types)
{
  using Polyhedron = CGAL::Polyhedron_3<smf_test::Kernel>;
  for (const Open_case& open : all_cases())
  {
    SCOPED_TRACE(open.name);
    const Polyhedron mesh = smf_test::to_open_mesh<Polyhedron>(open.soup);
    SMF::Poles_and_loops<Polyhedron> input;
    for (const auto h : smf_test::border_halfedges(mesh))
      input.add_border_pole(h);
    for (const std::size_t v : open.poles)
      input.add_pole(*std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(v)));
    const SMF::Loop_system<Polyhedron> system(mesh, input);
    const auto foliation = SMF::harmonic_foliation(system);
    EXPECT_TRUE(foliation.statistics().is_certified);
    Graph graph;
    SMF::reeb_graph(foliation, graph);
    EXPECT_EQ(num_vertices(graph), open.nodes);
    EXPECT_EQ(num_edges(graph), open.arcs);
    Polyhedron cut;
    SMF::surface_components(foliation, cut);
    EXPECT_NEAR(PMP::area(cut) / PMP::area(mesh), 1, 1e-12);
  }
}

// ===  Mistakes

namespace {

std::vector<SMF::Problem> problems_of(const Mesh& mesh, const Input& input)
{
  const std::vector<SMF::Problem> result = SMF::validate(mesh, input);
  EXPECT_FALSE(result.empty());
  return result.empty() ? std::vector<SMF::Problem>(1) : result;
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(Mistakes_with_openings, an_opening_that_is_no_pole)
{
  const Mesh mesh = smf_test::to_open_mesh(
    soups::without_caps(soups::icosphere(2), {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}}, 0.9));
  Input input;
  input.add_border_pole(smf_test::border_halfedges(mesh).at(1));
  const SMF::Problem problem = problems_of(mesh, input)[0];
  EXPECT_EQ(problem.kind, SMF::Problem_kind::NOT_CLOSED);
  EXPECT_TRUE(contains(problem.message, "3 openings")) << problem.message;
  EXPECT_TRUE(contains(problem.message, "2 of them are no poles")) << problem.message;
  EXPECT_TRUE(contains(problem.message, "add_border_pole")) << problem.message;
  EXPECT_THROW(SMF::Loop_system<Mesh>(mesh, input), SMF::Invalid_mesh_exception);
}

TEST(Mistakes_with_openings, a_halfedge_that_is_no_border)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  const Halfedge border = smf_test::border_halfedges(mesh)[0];
  const auto inner = std::find_if(halfedges(mesh).begin(), halfedges(mesh).end(),
                                  [&](Halfedge h) { return !CGAL::is_border_edge(h, mesh); });
  for (const Halfedge h : {opposite(border, mesh), *inner})
  {
    Input input;
    input.add_border_pole(h);
    const SMF::Problem problem = problems_of(mesh, input)[0];
    EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_POLE);
    EXPECT_TRUE(contains(problem.message, "pole 0")) << problem.message;
  }
  const Mesh closed = smf_test::icosphere(1);
  Input input;
  input.add_border_pole(*halfedges(closed).begin());
  EXPECT_EQ(problems_of(closed, input)[0].kind, SMF::Problem_kind::INVALID_POLE);
}

TEST(Mistakes_with_openings, the_same_opening_twice)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  Input input = smf_test::openings_and_poles(mesh);
  input.add_border_pole(next(smf_test::border_halfedges(mesh)[1], mesh));
  const SMF::Problem problem = problems_of(mesh, input)[0];
  EXPECT_EQ(problem.kind, SMF::Problem_kind::INVALID_POLE);
  EXPECT_TRUE(contains(problem.message, "poles 1 and 2")) << problem.message;
}

TEST(Mistakes_with_openings, borders_that_share_a_vertex)
{
  // two faces at one vertex are missing that are not neighbors
  const smf_test::Triangle_soup sphere = soups::icosphere(1);
  std::vector<soups::Triangle> at_vertex;
  for (const soups::Triangle& t : sphere.triangles)
    if (std::find(t.begin(), t.end(), sphere.triangles[0][0]) != t.end())
      at_vertex.push_back(t);
  const auto shared = [&](const soups::Triangle& t) {
    return std::count_if(t.begin(), t.end(), [&](std::size_t v) {
      return std::find(at_vertex[0].begin(), at_vertex[0].end(), v) != at_vertex[0].end();
    });
  };
  const soups::Triangle other = *std::find_if(
    at_vertex.begin(), at_vertex.end(), [&](const soups::Triangle& t) { return shared(t) == 1; });
  const smf_test::Triangle_soup soup = soups::with_faces(
    sphere, [&](const soups::Triangle& t) { return t != at_vertex[0] && t != other; });
  const std::vector<SMF::Problem> problems =
    SMF::check_triangle_soup(soup, SMF::parameters::allow_openings(true));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, SMF::Problem_kind::NOT_MANIFOLD);
}

TEST(Mistakes_with_openings, a_pole_on_a_border)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  EXPECT_EQ(problems_of(mesh, smf_test::openings_and_poles(mesh, {0}))[0].kind,
            SMF::Problem_kind::INVALID_POLE);
}

TEST(Mistakes_with_openings, a_disk_without_another_pole)
{
  for (const smf_test::Triangle_soup& soup :
       {soups::part_below(soups::icosphere(2), 2, 0.3),
        smf_test::Triangle_soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}},
                                {{0, 1, 2}, {1, 3, 2}}},
        smf_test::Triangle_soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}})
  {
    const Mesh mesh = smf_test::to_open_mesh(soup);
    const SMF::Problem problem = problems_of(mesh, smf_test::openings_and_poles(mesh))[0];
    EXPECT_EQ(problem.kind, SMF::Problem_kind::INESSENTIAL_LOOP) << problem.message;
    EXPECT_EQ(problem.loops, std::vector<std::size_t>{0});
  }
}

TEST(Mistakes_with_openings, a_loop_in_an_ear)
{
  const auto& cases = all_cases();
  const Open_case& open = *std::find_if(
    cases.begin(), cases.end(), [](const Open_case& c) { return c.name == "ear with a vertex"; });
  const Mesh mesh = smf_test::to_open_mesh(open.soup);
  Input input = smf_test::openings_and_poles(mesh, open.poles);
  EXPECT_TRUE(SMF::validate(mesh, input).empty());
  input.add_loop(SMF::pole_loop(smf_test::vertex(open.soup.points.size() - 1), mesh));
  EXPECT_EQ(problems_of(mesh, input)[0].kind, SMF::Problem_kind::INESSENTIAL_LOOP);
}

TEST(Mistakes_with_openings, a_loop_that_crosses_a_border)
{
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(8, 3));
  Input input = smf_test::openings_and_poles(mesh);
  const Halfedge border = smf_test::border_halfedges(mesh)[0];
  SMF::Loop<Mesh> loop;
  for (const Halfedge h : halfedges_around_face(opposite(border, mesh), mesh))
    loop.push_back({h, 0.5});
  input.add_loop(loop);
  const std::vector<SMF::Problem> problems = problems_of(mesh, input);
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const SMF::Problem& problem) {
    return problem.kind == SMF::Problem_kind::INVALID_LOOP && contains(problem.message, "border");
  }));
}

TEST(Mistakes_with_openings, an_edge_cycle_with_an_opening_to_its_left)
{
  const std::size_t n = 8;
  const Mesh mesh = smf_test::to_open_mesh(soups::plane_annulus(n, 3));
  std::vector<Mesh::Vertex_index> inner, outer;
  for (std::size_t j = 0; j < n; ++j)
  {
    inner.push_back(smf_test::vertex(j));
    outer.push_back(smf_test::vertex(2 * n + j));
  }
  // counterclockwise, so that the hole is to the left of the inner one
  EXPECT_THROW(SMF::loop_from_edge_cycle(inner, mesh), SMF::Invalid_loops_exception);
  EXPECT_EQ(SMF::loop_from_edge_cycle(outer, mesh).size(), 2 * n);
  std::reverse(inner.begin(), inner.end());
  std::reverse(outer.begin(), outer.end());
  EXPECT_EQ(SMF::loop_from_edge_cycle(inner, mesh).size(), 2 * n);
  EXPECT_THROW(SMF::loop_from_edge_cycle(outer, mesh), SMF::Invalid_loops_exception);
  try
  {
    SMF::loop_from_edge_cycle(outer, mesh);
  }
  catch (const SMF::Invalid_loops_exception& exception)
  {
    EXPECT_TRUE(contains(exception.what(), "opening of the mesh to its left")) << exception.what();
  }
}

} // namespace test_openings
