// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/flat_meshes.h"
#include "generators/meshes.h"
#include "include/test_models.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_lines.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Blade_lines.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Normal_spreads.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Surface_mesh_copy.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace test_feature_lines {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = CGAL::Surface_mesh_foliation::parameters;

using smf_test::Mesh;
using smf_test::Triangle_soup;
using smf_test::soups::Point;
using Line = std::vector<std::size_t>;
using Lines = std::vector<Line>;

// a ball with three fins of different lengths around its equator, their tips at `fin_tips()`
const std::vector<Point> fin_directions = {{1, 0, 0}, {-0.5, 0.866, 0}, {-0.5, -0.866, 0}};

Triangle_soup finned_ball()
{
  Triangle_soup soup = smf_test::soups::icosphere(5);
  for (Point& p : soup.points)
  {
    double radius = 1;
    for (std::size_t i = 0; i < fin_directions.size(); ++i)
    {
      const Point& d = fin_directions[i];
      const double ahead = p[0] * d[0] + p[1] * d[1], aside = p[1] * d[0] - p[0] * d[1];
      if (ahead > 0) // thin across the equator's plane, wide along the axis
        radius += (1.5 + 0.2 * static_cast<double>(i)) *
                  std::exp(-std::pow(aside / 0.09, 2) - std::pow(p[2] / 0.6, 4));
    }
    p = {radius * p[0], radius * p[1], radius * p[2]};
  }
  return soup;
}

Line fin_tips()
{
  const Triangle_soup soup = finned_ball();
  Line result;
  for (const Point& d : fin_directions)
    result.push_back(static_cast<std::size_t>(
      std::max_element(soup.points.begin(), soup.points.end(),
                       [&](const Point& p, const Point& q) {
                         return p[0] * d[0] + p[1] * d[1] < q[0] * d[0] + q[1] * d[1];
                       }) -
      soup.points.begin()));
  return result;
}

// by positions in `vertices(mesh)`
template <class TriangleMesh, class NamedParameters>
Lines lines_of(const TriangleMesh& mesh, const NamedParameters& parameters)
{
  std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>> lines;
  SMF::detect_feature_lines(mesh, std::back_inserter(lines), parameters);
  Lines result;
  for (const auto& line : lines)
    result.push_back(SMF::internal::positions_of_vertices(line, mesh));
  return result;
}

Lines lines_of(const Triangle_soup& soup)
{
  return lines_of(smf_test::to_mesh(soup), CGAL::parameters::default_values());
}

double distance(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Each of the vertices is near to a line of its own, and there are no other lines.
void expect_near(const Triangle_soup& soup, const Lines& lines, const Line& vertices)
{
  double diameter = 0;
  for (const Point& p : soup.points)
    diameter = std::max(diameter, distance(p, soup.points[vertices[0]]));
  EXPECT_EQ(lines.size(), vertices.size());
  std::set<std::size_t> used;
  for (const std::size_t v : vertices)
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      const bool is_near = std::any_of(lines[i].begin(), lines[i].end(), [&](std::size_t u) {
        return distance(soup.points[u], soup.points[v]) < 0.05 * diameter;
      });
      if (is_near)
      {
        EXPECT_TRUE(used.insert(i).second) << "line " << i << " at vertex " << v;
      }
    }
  EXPECT_EQ(used.size(), vertices.size());
}

SMF::Poles_and_loops<Mesh> line_poles(const Lines& lines)
{
  SMF::Poles_and_loops<Mesh> result;
  for (const Line& line : lines)
    result.add_line_pole(smf_test::vertex_range(line));
  return result;
}

// with them, the mesh has a foliation whose only thorn poles are the ends of lines
void expect_thorns_at_ends(const Mesh& mesh, const Lines& lines)
{
  const SMF::Loop_system<Mesh> system(mesh, line_poles(lines));
  std::vector<SMF::Singularity<Mesh>> singularities;
  SMF::singularities(SMF::harmonic_foliation(system), std::back_inserter(singularities));
  std::multiset<std::size_t> positive, ends;
  for (const auto& singularity : singularities)
    if (singularity.index > 0)
    {
      EXPECT_EQ(singularity.index, 1);
      positive.insert(static_cast<std::size_t>(singularity.vertex));
    }
  for (const Line& line : lines)
  {
    ends.insert(line.front());
    ends.insert(line.back());
  }
  EXPECT_EQ(positive, ends);
}

// Radius 0.001: the faces around a vertex alone.
// Large meshes are looked at on a decimated copy; lines are of the mesh itself.
TEST(Feature_lines, of_large_meshes)
{
  const Triangle_soup fine = smf_test::soups::midpoint_subdivided(finned_ball());
  ASSERT_GT(fine.points.size(), 40000u);
  const Mesh mesh = smf_test::to_mesh(fine);
  const Lines lines = lines_of(mesh, CGAL::parameters::default_values());
  expect_near(fine, lines, fin_tips()); // its first vertices are those of the coarse one
  const SMF::Loop_system<Mesh> system(mesh, line_poles(lines)); // so they are induced paths
  EXPECT_EQ(lines_of(mesh, CGAL::parameters::default_values()), lines);
}

TEST(Normal_spreads, tell_flat_from_sharp)
{
  const auto flat = smf_test::flat_mesh(smf_test::soups::octahedron());
  const SMF::internal::Normal_spreads spreads(flat, flat.points());
  EXPECT_NEAR(spreads.area(), 4 * std::sqrt(3.), 1e-12);
  const SMF::internal::Normal_spread near = spreads.within(0.001), all = spreads.within(10);
  for (int v = 0; v < flat.number_of_vertices(); ++v)
  {
    EXPECT_NEAR(near.mean[v], 1 / std::sqrt(3.), 1e-12); // four normals (+-1, +-1, 1)
    EXPECT_NEAR(near.alignment[v], 1. / 3, 1e-12);
    EXPECT_NEAR(all.mean[v], 0, 1e-12);
  }
}

TEST(Feature_lines, are_the_rims_of_fins)
{
  const Triangle_soup soup = finned_ball();
  const Lines lines = lines_of(soup);
  expect_near(soup, lines, fin_tips());
  for (const Line& line : lines) // from the ball and back, around the tip
    EXPECT_GT(distance(soup.points[line.front()], soup.points[line.back()]), 0.8);
}

TEST(Feature_lines, become_line_poles_with_thorns_at_their_ends)
{
  expect_thorns_at_ends(smf_test::to_mesh(finned_ball()), lines_of(finned_ball()));
}

TEST(Feature_lines, are_induced_paths_without_common_vertices)
{
  const Mesh mesh = smf_test::noisy(smf_test::to_mesh(finned_ball()), 0.2, 1);
  const Lines lines = lines_of(mesh, np::blade_width(0.1));
  ASSERT_GE(lines.size(), 2u);
  EXPECT_TRUE(SMF::validate(mesh, line_poles(lines)).empty());
}

TEST(Feature_lines, do_not_care_for_position_orientation_and_scale)
{
  const Triangle_soup soup = finned_ball();
  for (double scale : {1e-150, 1e150})
  {
    Triangle_soup moved = soup;
    for (Point& p : moved.points)
      p = {scale * (0.36 * p[0] + 0.48 * p[1] - 0.8 * p[2] + 7),
           scale * (-0.8 * p[0] + 0.6 * p[1] - 3),
           scale * (0.48 * p[0] + 0.64 * p[1] + 0.6 * p[2])};
    expect_near(moved, lines_of(moved), fin_tips());
  }
}

TEST(Feature_lines, do_not_care_for_the_order_of_vertices)
{
  const Triangle_soup soup = finned_ball();
  const Line labels = smf_test::new_labels(soup.points.size(), 1);
  Line tips;
  for (const std::size_t tip : fin_tips())
    tips.push_back(labels[tip]);
  const Triangle_soup other = smf_test::soups::relabeled(soup, labels, 2);
  expect_near(other, lines_of(other), tips);
}

TEST(Feature_lines, are_the_same_on_other_types_of_meshes)
{
  const auto parameters = CGAL::parameters::default_values();
  const Lines expected = lines_of(finned_ball());
  using Polyhedron = smf_test::Polyhedron_model<smf_test::Kernel>;
  using Complex = smf_test::Linear_cell_complex_model<smf_test::Kernel>;
  EXPECT_EQ(lines_of(smf_test::to_mesh<Polyhedron>(finned_ball()), parameters), expected);
  EXPECT_EQ(lines_of(smf_test::to_mesh<Complex>(finned_ball()), parameters), expected);
}

TEST(Feature_lines, are_not_found_on_round_shapes)
{
  EXPECT_EQ(lines_of(smf_test::soups::icosphere(4)), Lines());
  EXPECT_EQ(lines_of(smf_test::soups::limbed_sphere(6, 4)), Lines());
  EXPECT_EQ(lines_of(smf_test::soups::torus(40, 20, 3, 0.3)), Lines());
}

TEST(Feature_lines, obey_their_parameters)
{
  const Mesh mesh = smf_test::to_mesh(finned_ball());
  EXPECT_EQ(lines_of(mesh, np::least_line_length(5.)), Lines());
  EXPECT_EQ(lines_of(mesh, np::blade_flatness(1.)), Lines());
}

template <class NamedParameters>
void expect_parameter_refused(const NamedParameters& parameters)
{
  EXPECT_THROW(lines_of(smf_test::octahedron(), parameters), SMF::Invalid_parameter_exception);
}

TEST(Feature_lines, refuse_parameters_out_of_range)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (double value : {0., -1., infinity, nan})
  {
    expect_parameter_refused(np::blade_width(value));
    expect_parameter_refused(np::least_line_length(value));
  }
  for (double value : {-0.1, 1.1, nan})
    expect_parameter_refused(np::blade_flatness(value));
  expect_parameter_refused(np::decimation_threshold(999));
}

TEST(Feature_lines, refuse_an_open_mesh)
{
  Mesh mesh = smf_test::icosphere(1);
  CGAL::Euler::remove_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  EXPECT_THROW(lines_of(mesh, CGAL::parameters::default_values()), SMF::Invalid_mesh_exception);
}

// The places are those of include/feature_places.h.
TEST(Feature_lines, of_real_meshes)
{
  const std::string folder = SMF_SHARED_DIR;
  if (folder.empty())
    GTEST_SKIP() << "no shared meshes";
  struct Shape
  {
    std::string name;
    Line places;
  };
  for (const Shape& shape :
       {Shape{"airplane_8730", {8506, 8257, 2053, 2686, 2088}}, // wings, fin, tailplanes
        Shape{"fish_945", {897, 287, 650, 856}},                // fins, back, tail
        Shape{"human_man_6890", {}}, Shape{"human_woman_6890", {}}, Shape{"hand_7993", {}}})
  {
    SCOPED_TRACE(shape.name);
    Mesh mesh;
    SMF::read_triangle_mesh(folder + "/meshes/" + shape.name + ".off", mesh);
    const Lines lines = lines_of(mesh, CGAL::parameters::default_values());
    if (shape.places.empty())
    {
      EXPECT_EQ(lines, Lines());
      continue;
    }
    expect_near(smf_test::to_soup(mesh), lines, shape.places);
    expect_thorns_at_ends(mesh, lines);
  }
}

} // namespace

} // namespace test_feature_lines
