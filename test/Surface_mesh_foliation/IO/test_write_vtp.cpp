// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/decimal_comma.h"
#include "include/temporary_folder.h"
#include "include/test_models.h"
#include "include/vtp_file.h"
#include "include/vtp_writers.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Vtp_document.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/singular_points.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <locale>
#include <set>
#include <string>
#include <vector>

namespace test_write_vtp {

// Files for VTK that are parsed as XML say what the foliation says. That VTK itself can read them
// is tested in test_write_vtp_with_vtk.cpp.

namespace {

using smf_test::Example;
using smf_test::Mesh;
using smf_test::Vtp_file;
using smf_test::Vtp_writers;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Numbers = std::vector<double>;

std::array<double, 3> coordinates(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

class Vtp_files_of_example : public ::testing::TestWithParam<Example>, public Vtp_writers<>
{
protected:
  Vtp_files_of_example()
    : Vtp_writers<>(GetParam()), foliation(solved.foliation), system(solved.system)
  {}

  Vtp_file file(const std::string& name) const
  {
    for (const auto& [what, write] : all())
      if (what == name)
        write(folder.file_name(name));
    return Vtp_file(folder.file_name(name));
  }

  smf_test::Temporary_folder folder;
  const SMF::Measured_foliation<Mesh>& foliation;
  const SMF::Loop_system<Mesh>& system;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Vtp_files_of_example,
                         ::testing::ValuesIn(smf_test::example_systems()),
                         smf_test::name_of_example);

TEST_P(Vtp_files_of_example, foliation)
{
  const Vtp_file vtp = file("foliation");
  const Mesh& mesh = *solved.mesh;
  ASSERT_EQ(vtp.points.size(), num_vertices(mesh));
  ASSERT_EQ(vtp.polygons.size(), num_faces(mesh));
  EXPECT_TRUE(vtp.vertices.empty() && vtp.lines.empty());
  for (const auto v : vertices(mesh))
  {
    const auto cell = foliation.cell(v);
    const int index = static_cast<int>(cell.index);
    EXPECT_EQ(vtp.points[v], coordinates(mesh.point(v))) << "17 digits";
    EXPECT_EQ(vtp.point_arrays.at("t")[v], foliation.parameter(v));
    EXPECT_EQ(vtp.point_arrays.at("arc")[v], cell.is_arc ? index : -1);
    EXPECT_EQ(vtp.point_arrays.at("node")[v], cell.is_arc ? -1 : index);
  }
  const auto segment =
    solved.mesh->add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  SMF::face_segmentation(foliation, segment);
  for (const auto f : faces(mesh))
  {
    EXPECT_EQ(vtp.cell_arrays.at("component")[f], static_cast<double>(segment[f]));
    std::set<std::size_t> corners;
    for (const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      corners.insert(v);
    EXPECT_EQ(std::set<std::size_t>(vtp.polygons[f].begin(), vtp.polygons[f].end()), corners);
  }
  EXPECT_EQ(vtp.types.at("t"), "Float64");
  EXPECT_EQ(vtp.types.at("arc"), "Int32");
}

TEST_P(Vtp_files_of_example, components)
{
  const Vtp_file vtp = file("components");
  Mesh cut;
  const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:c").first;
  const auto is_critical = cut.add_property_map<Mesh::Edge_index, bool>("e:c").first;
  SMF::surface_components(
    foliation, cut,
    SMF::parameters::face_component_map(component).edge_is_constrained_map(is_critical));
  ASSERT_EQ(vtp.points.size(), num_vertices(cut));
  ASSERT_EQ(vtp.polygons.size(), num_faces(cut));
  for (const auto v : vertices(cut))
    EXPECT_EQ(vtp.points[v], coordinates(cut.point(v)));
  for (const auto f : faces(cut))
    EXPECT_EQ(vtp.cell_arrays.at("component")[f], static_cast<double>(component[f]));
  for (const auto e : edges(cut)) // critical edges join vertices of one node
  {
    const double node = vtp.point_arrays.at("node")[cut.vertex(e, 0)];
    if (is_critical[e])
    {
      EXPECT_GE(node, 0);
      EXPECT_EQ(node, vtp.point_arrays.at("node")[cut.vertex(e, 1)]);
    }
  }
  for (const double face : vtp.cell_arrays.at("face"))
    EXPECT_LT(face, static_cast<double>(num_faces(*solved.mesh)));
}

TEST_P(Vtp_files_of_example, coordinates)
{
  const Vtp_file vtp = file("coordinates");
  const Vtp_file components = file("components");
  ASSERT_EQ(vtp.polygons.size(), components.polygons.size());
  EXPECT_EQ(vtp.cell_arrays.at("component").size(), vtp.polygons.size());
  const Numbers &u = vtp.point_arrays.at("u"), &v = vtp.point_arrays.at("v");
  std::vector<double> area(system.number_of_arcs(), 0);
  for (std::size_t f = 0; f < vtp.polygons.size(); ++f)
  {
    const std::vector<std::size_t>& p = vtp.polygons[f];
    ASSERT_EQ(p.size(), 3u);
    for (int i : {0, 1, 2})
      EXPECT_EQ(vtp.points[p[i]], components.points[components.polygons[f][i]]);
    const double arc = vtp.cell_arrays.at("component")[f];
    const double twice =
      (u[p[1]] - u[p[0]]) * (v[p[2]] - v[p[0]]) - (u[p[2]] - u[p[0]]) * (v[p[1]] - v[p[0]]);
    if (arc >= 0)
      area[static_cast<std::size_t>(arc)] += twice / 2;
    else
      EXPECT_EQ(twice, 0);
  }
  const SMF::Component_coordinates<Mesh> coordinates_of(foliation);
  for (std::size_t f = 0; f < vtp.polygons.size(); ++f)
    if (const double arc = vtp.cell_arrays.at("component")[f]; arc >= 0)
      for (const std::size_t p : vtp.polygons[f])
      {
        const auto texture =
          coordinates_of.texture_chart(static_cast<std::size_t>(arc))({u[p], v[p]});
        EXPECT_EQ(vtp.point_arrays.at("texture_u")[p], texture[0]);
        EXPECT_EQ(vtp.point_arrays.at("texture_v")[p], texture[1]);
      }
  for (std::size_t a = 0; a < area.size(); ++a)
  {
    const double whole = system.height(a) * foliation.flux(a);
    const bool has_pole =
      system.pole(system.node(a, 0)) >= 0 || system.pole(system.node(a, 1)) >= 0;
    EXPECT_LT(area[a], whole * (1 + 1e-9)) << "height times circumference";
    // a face at a pole, which is a circle, is only one of two triangles there
    EXPECT_GT(area[a], has_pole ? 0.4 * whole : whole * (1 - 1e-9));
  }
}

TEST_P(Vtp_files_of_example, leaves)
{
  const Vtp_file vtp = file("leaves");
  std::vector<SMF::Critical_polyline<Point>> critical;
  SMF::critical_leaves(foliation, std::back_inserter(critical));
  std::size_t poles = 0, lines = 0, i = 0;
  for (const auto& polyline : critical)
    ++(polyline.points.size() == 1 ? poles : lines);
  for (const auto& levels : embedding.levels)
    lines += levels.size();
  ASSERT_EQ(vtp.vertices.size(), poles);
  ASSERT_EQ(vtp.lines.size(), lines);
  const Numbers &arc = vtp.cell_arrays.at("arc"), &node = vtp.cell_arrays.at("node"),
                &level = vtp.cell_arrays.at("level");
  const auto expect_cell = [&](const std::vector<std::size_t>& points, const auto& polyline) {
    ASSERT_EQ(points.size(), polyline.size());
    for (std::size_t j = 0; j < points.size(); ++j)
      EXPECT_EQ(vtp.points[points[j]], coordinates(polyline[j]));
  };
  for (const bool is_line : {false, true})
    for (const auto& polyline : critical)
      if ((polyline.points.size() > 1) == is_line)
      {
        expect_cell(is_line ? vtp.lines[i - poles] : vtp.vertices[i], polyline.points);
        EXPECT_EQ(arc[i], -1);
        EXPECT_EQ(level[i], 0);
        EXPECT_EQ(node[i++], static_cast<double>(polyline.node));
      }
  for (std::size_t a = 0; a < embedding.levels.size(); ++a)
    for (const double t : embedding.levels[a])
    {
      expect_cell(vtp.lines[i - poles], SMF::leaf(foliation, a, t));
      EXPECT_EQ(arc[i], static_cast<double>(a));
      EXPECT_EQ(level[i], t);
      EXPECT_EQ(node[i++], -1);
    }
}

TEST_P(Vtp_files_of_example, skeleton)
{
  const Vtp_file vtp = file("skeleton");
  const std::size_t n = num_vertices(graph);
  ASSERT_EQ(vtp.vertices.size(), n);
  ASSERT_EQ(vtp.lines.size(), num_edges(graph));
  const auto at = [&](const char* name, std::size_t i) { return vtp.point_arrays.at(name).at(i); };
  for (std::size_t v = 0; v < n; ++v)
  {
    EXPECT_EQ(vtp.vertices[v], std::vector<std::size_t>{v});
    EXPECT_EQ(vtp.points[v], coordinates(graph[v].point));
    EXPECT_EQ(at("node", v), static_cast<double>(graph[v].id));
    EXPECT_EQ(at("kind", v), static_cast<double>(graph[v].kind));
    EXPECT_EQ(at("pole", v), graph[v].pole);
    EXPECT_EQ(at("genus", v), static_cast<double>(graph[v].genus));
    EXPECT_EQ(at("arc", v), -1);
    EXPECT_EQ(at("radius", v), graph[v].radius);
    EXPECT_EQ(vtp.cell_arrays.at("node")[v], static_cast<double>(graph[v].id));
    EXPECT_EQ(vtp.cell_arrays.at("arc")[v], -1);
  }
  std::size_t i = 0, points = n;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    const std::vector<std::size_t>& line = vtp.lines[i];
    ASSERT_EQ(line.size(), graph[e].polyline.size());
    EXPECT_EQ(line.front(), source(e, graph));
    EXPECT_EQ(line.back(), target(e, graph));
    for (std::size_t j = 0; j < line.size(); ++j)
    {
      EXPECT_EQ(vtp.points[line[j]], coordinates(graph[e].polyline[j]));
      EXPECT_EQ(at("radius", line[j]), graph[e].radii.at(j));
      if (j == 0 || j + 1 == line.size())
        continue;
      ++points;
      EXPECT_EQ(at("arc", line[j]), static_cast<double>(graph[e].loop));
      for (const char* name : {"node", "kind", "pole"})
        EXPECT_EQ(at(name, line[j]), -1);
    }
    const auto of_cell = [&](const char* name) { return vtp.cell_arrays.at(name).at(n + i); };
    EXPECT_EQ(of_cell("arc"), static_cast<double>(graph[e].loop));
    EXPECT_EQ(of_cell("node"), -1);
    EXPECT_EQ(of_cell("height"), graph[e].height);
    EXPECT_EQ(of_cell("flux"), graph[e].flux);
    EXPECT_EQ(of_cell("area"), graph[e].area);
    EXPECT_EQ(of_cell("length"), SMF::length(graph[e].polyline));
    ++i;
  }
  EXPECT_EQ(vtp.points.size(), points);
}

TEST_P(Vtp_files_of_example, singularities)
{
  const Vtp_file vtp = file("singularities");
  std::vector<SMF::Singularity<Mesh>> expected;
  SMF::singularities(foliation, std::back_inserter(expected));
  ASSERT_EQ(vtp.points.size(), expected.size());
  ASSERT_EQ(vtp.vertices.size(), expected.size());
  // singular faces are marked where the cut mesh has a vertex inside
  std::set<std::array<double, 3>> cut_points;
  Mesh cut;
  SMF::surface_components(foliation, cut);
  for (const auto v : vertices(cut))
    cut_points.insert(coordinates(cut.point(v)));
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const auto& singularity = expected[i];
    EXPECT_EQ(vtp.vertices[i], std::vector<std::size_t>{i});
    EXPECT_EQ(vtp.point_arrays.at("index")[i], singularity.index);
    EXPECT_EQ(vtp.point_arrays.at("node")[i], static_cast<double>(singularity.node));
    EXPECT_EQ(vtp.point_arrays.at("is_face")[i], singularity.is_face);
    EXPECT_EQ(cut_points.count(vtp.points[i]), 1u);
    if (!singularity.is_face)
    {
      EXPECT_EQ(vtp.points[i], coordinates(solved.mesh->point(singularity.vertex)));
      continue;
    }
    const auto h = halfedge(singularity.face, *solved.mesh);
    const Point p = solved.mesh->point(source(h, *solved.mesh)),
                q = solved.mesh->point(target(h, *solved.mesh)),
                r = solved.mesh->point(target(next(h, *solved.mesh), *solved.mesh)),
                c(vtp.points[i][0], vtp.points[i][1], vtp.points[i][2]);
    const auto area = [](const Point& a, const Point& b, const Point& d) {
      return CGAL::approximate_sqrt(CGAL::squared_area(a, b, d));
    };
    const double whole = area(p, q, r);
    for (const double part : {area(p, q, c), area(q, r, c), area(r, p, c)})
      EXPECT_GT(part, 0);
    EXPECT_NEAR(area(p, q, c) + area(q, r, c) + area(r, p, c), whole, 1e-12 * whole) << "inside";
  }
}

// ===  The document itself

TEST(Vtp_document, gives_back_every_number)
{
  const smf_test::Temporary_folder folder;
  const Numbers numbers = {0,
                           -0.1,
                           1. / 3,
                           std::numeric_limits<double>::max(),
                           std::numeric_limits<double>::min(),
                           -123456789012345678.};
  SMF::internal::Vtp_document document;
  for (const double x : numbers)
    document.add_point(Point(x, 1, -x));
  document.add_line({0, 1, 2});
  document.add_polygon({3, 4, 5});
  document.add_vertex(2);
  document.add_vertex(5);
  document.add_point_array("numbers", numbers);
  document.add_cell_array("cells", std::vector<int>{1, 2, 3, std::numeric_limits<int>::min()});
  const std::size_t large = (std::numeric_limits<std::size_t>::max)() / 2 / 1024 / 1024 + 1;
  document.add_cell_array("large", std::vector<std::size_t>{1, 2, 3, large});
  SMF::internal::write_vtp(folder.file_name("file.vtp"), document);
  const Vtp_file vtp(folder.file_name("file.vtp"));
  EXPECT_EQ(vtp.point_arrays.at("numbers"), numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(vtp.points[i], (std::array<double, 3>{numbers[i], 1, -numbers[i]}));
  EXPECT_EQ(vtp.vertices, (Vtp_file::Cells{{2}, {5}}));
  EXPECT_EQ(vtp.lines, (Vtp_file::Cells{{0, 1, 2}}));
  EXPECT_EQ(vtp.polygons, (Vtp_file::Cells{{3, 4, 5}}));
  EXPECT_EQ(vtp.cell_arrays.at("cells")[3], std::numeric_limits<int>::min());
  EXPECT_EQ(vtp.cell_arrays.at("large")[3], static_cast<double>(large));
  EXPECT_EQ(vtp.types.at("large"), "Int64");
}

// ===  Failures, locales, models

TEST(Vtp_failures, are_reported)
{
  const smf_test::Temporary_folder folder;
  const Vtp_writers<> writers(smf_test::dumbbell_example());
  for (const auto& [what, write] : writers.all())
    for (const std::string& name :
         {folder.file_name("missing/file"), folder.file_name("."), std::string("/dev/full")})
    {
      if (name == "/dev/full" && !std::filesystem::exists(name))
        continue;
      try
      {
        write(name);
        ADD_FAILURE() << name << " was written: " << what;
      }
      catch (const SMF::Invalid_file_exception& exception)
      {
        EXPECT_EQ(std::string(exception.what()).rfind(name, 0), 0u) << exception.what();
      }
    }
}

TEST(Vtp_locale, does_not_matter)
{
  const smf_test::Temporary_folder folder;
  const Vtp_writers<> writers(smf_test::dumbbell_example());
  for (const auto& [what, write] : writers.all())
  {
    write(folder.file_name(what));
    const std::string expected = smf_test::file_text(folder.file_name(what));
    const std::locale before =
      std::locale::global(std::locale(std::locale(), new smf_test::Decimal_comma));
    write(folder.file_name(what));
    std::locale::global(before);
    EXPECT_TRUE(smf_test::file_text(folder.file_name(what)) == expected) << what;
  }
}

template <class TriangleMesh>
void expect_same_files(const Example& example)
{
  SCOPED_TRACE(example.name);
  const smf_test::Temporary_folder folder;
  const Vtp_writers<> expected(example);
  const Vtp_writers<TriangleMesh> found(example);
  for (const auto& [what, write] : expected.all())
    write(folder.file_name(what));
  for (const auto& [what, write] : found.all())
  {
    write(folder.file_name("found"));
    EXPECT_TRUE(smf_test::file_text(folder.file_name("found")) ==
                smf_test::file_text(folder.file_name(what)))
      << what;
  }
}

TEST(Models, give_the_same_files)
{
  const std::vector<Example> all = smf_test::example_systems();
  for (const Example& example : {all[0], all[3], smf_test::theta_example()}) // genus 0 to 2
  {
    expect_same_files<smf_test::Polyhedron_model<smf_test::Kernel>>(example);
    expect_same_files<smf_test::Linear_cell_complex_model<smf_test::Kernel>>(example);
    expect_same_files<smf_test::Surface_mesh_model<CGAL::Simple_cartesian<double>>>(example);
  }
}

} // namespace

} // namespace test_write_vtp
