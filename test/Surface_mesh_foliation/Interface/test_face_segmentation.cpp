// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The components of a foliation as segments of the input mesh and of the cut one, looked at with
// CGAL's tools for segments.

#include "include/example_systems.h"
#include "include/test_models.h"

#include <CGAL/Surface_mesh_foliation/components.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace test_face_segmentation {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace soups = smf_test::soups;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;

template <class TriangleMesh>
using Face_map =
  typename boost::property_map<TriangleMesh,
                               CGAL::dynamic_face_property_t<std::size_t>>::const_type;

template <class TriangleMesh>
class Segments : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>,
                                smf_test::Surface_mesh_model<CGAL::Simple_cartesian<double>>>;
TYPED_TEST_SUITE(Segments, Models);

// of genus 0 to 3
std::vector<Example> examples()
{
  std::vector<Example> result;
  for (const Example& example : smf_test::all_example_systems())
    if (example.name == "limbs" || example.name == "more limbs" || example.name == "theta" ||
        example.name == "torus with poles" || example.name == "dumbbell" ||
        example.name == "genus in a region")
      result.push_back(example);
  return result;
}

// vertices - edges + faces of what the filter selects
template <class Filtered>
int euler_characteristic(const Filtered& part)
{
  int result = 0;
  for (const auto v : vertices(part))
    result += v == v; // they are not always counted by num_vertices()
  for (const auto e : edges(part))
    result -= e == e;
  for (const auto f : faces(part))
    result += f == f;
  return result;
}

TYPED_TEST(Segments, of_the_input_mesh_cover_it)
{
  for (const Example& example : examples())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<TypeParam> solved(example);
    const TypeParam& mesh = *solved.mesh;
    const auto segment = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    for (const auto f : faces(mesh))
      put(segment, f, std::size_t(12345));
    const std::size_t n = SMF::face_segmentation(solved.foliation, segment);
    ASSERT_EQ(n, solved.system.number_of_arcs());
    std::size_t number_of_faces = 0;
    for (std::size_t a = 0; a < n; ++a)
    {
      const CGAL::Face_filtered_graph<TypeParam> part(mesh, a, segment);
      EXPECT_TRUE(part.is_selection_valid());
      EXPECT_GT(num_faces(part), 0u) << "arc " << a;
      number_of_faces += num_faces(part);
    }
    EXPECT_EQ(number_of_faces, num_faces(mesh));
    for (const auto f : faces(mesh)) // faces in one component as a whole are in its segment
    {
      const auto h = halfedge(f, mesh);
      const auto u = solved.foliation.cell(source(h, mesh));
      bool is_inside = u.is_arc;
      for (const auto g : {h, next(h, mesh), prev(h, mesh)})
        is_inside = is_inside && solved.foliation.path(g).empty();
      if (is_inside)
      {
        EXPECT_EQ(get(segment, f), u.index);
      }
    }
  }
}

// Where faces are small, the segments have the topology and nearly the areas of the components.
TYPED_TEST(Segments, of_a_fine_mesh_are_like_the_components)
{
  const Example limbs = {"", soups::limbed_sphere(4, 5),
                         smf_test::pole_items(soups::limb_tips(4, 5))};
  const Solved_example<TypeParam> solved(limbs);
  const TypeParam& mesh = *solved.mesh;
  const auto segment = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  SMF::face_segmentation(solved.foliation, segment);
  Mesh cut;
  const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:c").first;
  SMF::surface_components(solved.foliation, cut, SMF::parameters::face_component_map(component));
  std::vector<double> area(4, 0), exact(4, 0);
  for (const auto f : faces(mesh))
    area[get(segment, f)] += CGAL::to_double(PMP::face_area(f, mesh));
  for (const auto f : faces(cut))
    exact[component[f]] += PMP::face_area(f, cut);
  for (std::size_t a = 0; a < 4; ++a)
  {
    EXPECT_NEAR(area[a] / exact[a], 1, 0.01);
    EXPECT_EQ(euler_characteristic(CGAL::Face_filtered_graph<TypeParam>(mesh, a, segment)), 1)
      << "a disk";
  }
}

// The component map of the cut mesh is a segmentation into connected parts. (That they are disks
// and annuli is tested elsewhere: boundaries may touch at a saddle, so counting would mislead.)
TYPED_TEST(Segments, of_the_cut_mesh_are_the_components)
{
  for (const Example& example : examples())
  {
    SCOPED_TRACE(example.name);
    const Solved_example<TypeParam> solved(example);
    TypeParam cut;
    const auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), cut);
    const std::size_t n = SMF::surface_components(solved.foliation, cut,
                                                  SMF::parameters::face_component_map(component));
    std::size_t number_of_faces = 0;
    for (std::size_t a = 0; a < n; ++a)
    {
      CGAL::Face_filtered_graph<TypeParam> part(cut, a, component);
      EXPECT_TRUE(part.is_selection_valid());
      number_of_faces += num_faces(part);
      std::map<typename boost::graph_traits<TypeParam>::face_descriptor, std::size_t> piece;
      EXPECT_EQ(
        PMP::connected_components(part, boost::make_assoc_property_map(piece),
                                  CGAL::parameters::face_index_map(get(CGAL::face_index, part))),
        1u)
        << "arc " << a;
    }
    EXPECT_EQ(number_of_faces, num_faces(cut));
  }
}

// ===  Faces that are passed by critical leaves

TEST(Face_segmentation, takes_the_larger_part_at_all_scales)
{
  const Example limbs = {"", soups::limbed_sphere(5, 2),
                         smf_test::pole_items(soups::limb_tips(5, 2))};
  std::vector<std::size_t> expected;
  for (const double scale : {1., 1e-200, 1e200})
  {
    Example scaled = limbs;
    for (auto& p : scaled.soup.points)
      for (double& x : p)
        x *= scale;
    const Solved_example<> solved(scaled);
    Mesh& mesh = *solved.mesh;
    const auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:s").first;
    SMF::face_segmentation(solved.foliation, segment);
    std::vector<std::size_t> found;
    for (const auto f : faces(mesh))
      found.push_back(segment[f]);
    if (expected.empty())
      expected = found;
    EXPECT_EQ(found, expected) << scale;
    if (scale != 1)
      continue;
    // by hand: the parts of each face are where its centroid falls in the cut mesh
    Mesh cut;
    const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:c").first;
    SMF::surface_components(solved.foliation, cut, SMF::parameters::face_component_map(component));
    const auto& refined = solved.foliation.extraction().refined_mesh;
    std::vector<std::map<std::size_t, double>> area(num_faces(mesh));
    std::size_t i = 0, mixed = 0;
    for (const auto f : faces(cut)) // in the order of the refined mesh
      area[static_cast<std::size_t>(refined.faces[i++].origin)][component[f]] +=
        PMP::face_area(f, cut);
    for (const auto f : faces(mesh))
    {
      mixed += area[f].size() > 1;
      for (const auto& entry : area[f])
        EXPECT_LE(entry.second, area[f].at(segment[f]));
    }
    EXPECT_GT(mixed, 10u);
  }
}

TEST(Face_segmentation, components_without_vertices_may_get_no_face)
{
  const Solved_example<> solved({"", soups::tetrahedron(), smf_test::pole_items({0, 1, 2, 3})});
  Mesh& mesh = *solved.mesh;
  const auto segment = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:s", 99).first;
  EXPECT_EQ(SMF::face_segmentation(solved.foliation, segment), 4u);
  for (const auto f : faces(mesh))
    EXPECT_LT(segment[f], 4u);
}

} // namespace

} // namespace test_face_segmentation
