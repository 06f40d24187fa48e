// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes with openings that are poles: what every public function makes of them.

#include "include/open_meshes.h"
#include "include/polylines.h"
#include "include/solved_open_meshes.h"
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
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>
#include <CGAL/Surface_mesh_foliation/subdivide_saddle_faces.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace test_openings {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace PMP = CGAL::Polygon_mesh_processing;
using smf_test::Mesh;
using smf_test::Open_case;
using Point = Mesh::Point;
using Input = SMF::Poles_and_loops<Mesh>;
using Graph = SMF::Reeb_graph<Point>;
using Foliation = SMF::Measured_foliation<Mesh>;
using Halfedge = Mesh::Halfedge_index;
using smf_test::all_cases;
using Solved = smf_test::Solved_open_mesh;

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

} // namespace test_openings
