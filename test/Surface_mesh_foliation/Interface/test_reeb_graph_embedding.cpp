// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"
#include "include/polylines.h"

#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace test_reeb_graph_embedding {

namespace {

using smf_test::distance;
using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Point = Mesh::Point;
using Polyline = std::vector<Point>;
using Embedding = SMF::Reeb_graph_embedding<Point>;
using SMF::parameters::number_of_samples;
using SMF::parameters::number_of_smoothing_steps;
using SMF::parameters::use_uniform_levels;

// A tube of the given radius around a curve from 0 to 1, closed by its two ends, which are the
// last vertices.
template <class Curve>
smf_test::Triangle_soup tube(const Curve& curve, double radius, std::size_t m, std::size_t n)
{
  using soups::Point;
  smf_test::Triangle_soup result;
  Point side = {0, 0, 1};
  for (std::size_t i = 0; i < m; ++i)
  {
    const double t = (i + 0.5) / m, step = 1e-4;
    const Point along = soups::normalized(soups::sum(curve(t + step), curve(t - step), -1));
    side = soups::normalized(soups::sum(side, along, -soups::dot(side, along)));
    const Point other = soups::cross(along, side);
    for (std::size_t j = 0; j < n; ++j)
    {
      const double angle = 2 * std::acos(-1) * j / n;
      result.points.push_back(soups::sum(soups::sum(curve(t), side, radius * std::cos(angle)),
                                         other, radius * std::sin(angle)));
    }
  }
  result.points.push_back(curve(0));
  result.points.push_back(curve(1));
  for (std::size_t i = 0; i + 1 < m; ++i)
    for (std::size_t j = 0; j < n; ++j)
    {
      const std::size_t k = (j + 1) % n;
      result.triangles.push_back({i * n + j, i * n + k, (i + 1) * n + j});
      result.triangles.push_back({i * n + k, (i + 1) * n + k, (i + 1) * n + j});
    }
  for (std::size_t j = 0; j < n; ++j)
  {
    result.triangles.push_back({j, m * n, (j + 1) % n});
    result.triangles.push_back({(m - 1) * n + j, (m - 1) * n + (j + 1) % n, m * n + 1});
  }
  return result;
}

// the centroid of polylines, weighted by length
struct Centroid
{
  void add(const Polyline& polyline)
  {
    for (std::size_t i = 1; i < polyline.size(); ++i)
    {
      const double step = distance(polyline[i - 1], polyline[i]);
      length += step;
      sum += step * (CGAL::midpoint(polyline[i - 1], polyline[i]) - CGAL::ORIGIN);
    }
  }
  Point point() const { return CGAL::ORIGIN + sum / length; }

  double length = 0;
  smf_test::Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
};

// of a polyline from its centroid: over each segment by Simpson's rule, exact for squares
double root_mean_square_distance(const Polyline& polyline)
{
  Centroid centroid;
  centroid.add(polyline);
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
  {
    const Point &p = polyline[i - 1], &q = polyline[i], m = CGAL::midpoint(p, q);
    const auto square = [&](const Point& r) { return CGAL::squared_distance(r, centroid.point()); };
    sum += distance(p, q) * (square(p) + 4 * square(m) + square(q)) / 6;
  }
  return centroid.length > 0 ? std::sqrt(sum / centroid.length) : 0;
}

class Each_embedding : public ::testing::TestWithParam<Example>
{
protected:
  Each_embedding() : example(GetParam()), system(example.system), foliation(example.foliation)
  {
    for (const auto& p : GetParam().soup.points)
      size = (std::max)(size, soups::distance(p, GetParam().soup.points[0]));
  }

  // what holds for each embedding with so many samples
  void check(const Embedding& embedding, std::size_t samples) const
  {
    ASSERT_EQ(embedding.node_points.size(), system.number_of_nodes());
    ASSERT_EQ(embedding.arc_polylines.size(), system.number_of_arcs());
    ASSERT_EQ(embedding.levels.size(), system.number_of_arcs());
    ASSERT_EQ(embedding.leaf_lengths.size(), system.number_of_arcs());
    ASSERT_EQ(embedding.leaf_radii.size(), system.number_of_arcs());
    ASSERT_EQ(embedding.node_radii.size(), system.number_of_nodes());
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      const std::vector<double>& levels = embedding.levels[a];
      const Polyline& polyline = embedding.arc_polylines[a];
      EXPECT_LE(levels.size(), samples);
      EXPECT_EQ(embedding.leaf_lengths[a].size(), levels.size());
      EXPECT_EQ(embedding.leaf_radii[a].size(), levels.size());
      ASSERT_EQ(polyline.size(), levels.size() + 2);
      EXPECT_EQ(polyline.front(), embedding.node_points[system.node(a, 0)]);
      EXPECT_EQ(polyline.back(), embedding.node_points[system.node(a, 1)]);
      for (std::size_t i = 0; i < levels.size(); ++i)
      {
        EXPECT_GT(levels[i], i == 0 ? 0 : levels[i - 1]);
        EXPECT_LT(levels[i], system.height(a));
      }
    }
  }

  Solved_example<> example;
  const SMF::Loop_system<Mesh>& system;
  const SMF::Measured_foliation<Mesh>& foliation;
  double size = 0;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_embedding,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

TEST_P(Each_embedding, polylines_lead_from_node_to_node)
{
  check(SMF::reeb_graph_embedding(foliation), 20);
  for (const int samples : {0, 1, 2, 7, 60})
  {
    const auto n = static_cast<std::size_t>(samples);
    check(SMF::reeb_graph_embedding(foliation, number_of_samples(samples)), n);
    check(SMF::reeb_graph_embedding(foliation, SMF::parameters::combine(number_of_samples(samples),
                                                                        use_uniform_levels(true))),
          n);
  }
}

TEST_P(Each_embedding, nodes_are_centroids_of_critical_leaves)
{
  const Embedding embedding = SMF::reeb_graph_embedding(foliation);
  std::vector<SMF::Critical_polyline<Point>> polylines;
  SMF::critical_leaves(foliation, std::back_inserter(polylines));
  std::vector<Centroid> centroids(system.number_of_nodes());
  for (const auto& polyline : polylines)
    centroids[polyline.node].add(polyline.points);
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
  {
    const auto pole = system.pole(r) < 0
                        ? std::vector<Mesh::Vertex_index>()
                        : system.pole_vertices(static_cast<std::size_t>(system.pole(r)));
    const Point expected = pole.size() == 1 ? example.mesh->point(pole[0]) : centroids[r].point();
    EXPECT_LE(distance(embedding.node_points[r], expected), pole.size() == 1 ? 0 : 1e-12 * size);
    if (pole.size() == 1)
    {
      EXPECT_EQ(embedding.node_radii[r], 0);
      continue;
    }
    EXPECT_GT(embedding.node_radii[r], 0);
    // no leaf is farther from its centroid than half its length
    EXPECT_LT(embedding.node_radii[r], centroids[r].length);
  }
}

TEST_P(Each_embedding, samples_are_centroids_of_leaves)
{
  for (const bool uniform : {false, true})
  {
    const Embedding embedding = SMF::reeb_graph_embedding(
      foliation, SMF::parameters::combine(number_of_samples(5), use_uniform_levels(uniform)));
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
      for (std::size_t i = 0; i < embedding.levels[a].size(); ++i)
      {
        Centroid centroid;
        centroid.add(SMF::leaf(foliation, a, embedding.levels[a][i]));
        EXPECT_NEAR(embedding.leaf_lengths[a][i], centroid.length, 1e-12 * centroid.length);
        EXPECT_LT(distance(embedding.arc_polylines[a][i + 1], centroid.point()), 1e-12 * size);
        const double radius =
          root_mean_square_distance(SMF::leaf(foliation, a, embedding.levels[a][i]));
        EXPECT_NEAR(embedding.leaf_radii[a][i], radius, 1e-9 * radius + 1e-12 * size);
      }
  }
}

TEST_P(Each_embedding, uniform_levels)
{
  for (const int samples : {1, 4, 20})
  {
    const Embedding embedding = SMF::reeb_graph_embedding(
      foliation, SMF::parameters::combine(number_of_samples(samples), use_uniform_levels(true)));
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      ASSERT_EQ(embedding.levels[a].size(), static_cast<std::size_t>(samples));
      for (int i = 0; i < samples; ++i)
        EXPECT_NEAR(embedding.levels[a][static_cast<std::size_t>(i)],
                    system.height(a) * (i + 1) / (samples + 1), 1e-12 * system.height(a));
    }
  }
}

TEST_P(Each_embedding, negative_numbers_are_refused)
{
  EXPECT_THROW(SMF::reeb_graph_embedding(foliation, number_of_smoothing_steps(-1)),
               SMF::Invalid_parameter_exception);
  EXPECT_THROW(SMF::reeb_graph_embedding(foliation, number_of_samples(-1)),
               SMF::Invalid_parameter_exception);
}

// ===  Smoothing

// the sum of the squares of second differences
double roughness(const Polyline& polyline)
{
  double result = 0;
  for (std::size_t i = 1; i + 1 < polyline.size(); ++i)
    result += ((polyline[i + 1] - polyline[i]) - (polyline[i] - polyline[i - 1])).squared_length();
  return result;
}

TEST_P(Each_embedding, smoothing_keeps_ends_and_straightens)
{
  const Embedding plain = SMF::reeb_graph_embedding(foliation);
  const Embedding zero = SMF::reeb_graph_embedding(foliation, number_of_smoothing_steps(0));
  const Embedding once = SMF::reeb_graph_embedding(foliation, number_of_smoothing_steps(1));
  const Embedding often = SMF::reeb_graph_embedding(foliation, number_of_smoothing_steps(5000));
  EXPECT_EQ(zero.arc_polylines, plain.arc_polylines);
  for (const Embedding* smooth : {&once, &often})
  {
    check(*smooth, 20);
    EXPECT_EQ(smooth->node_points, plain.node_points);
    EXPECT_EQ(smooth->levels, plain.levels);
    EXPECT_EQ(smooth->leaf_lengths, plain.leaf_lengths);
    EXPECT_EQ(smooth->leaf_radii, plain.leaf_radii);
  }
  for (std::size_t a = 0; a < plain.arc_polylines.size(); ++a)
  {
    const Polyline &before = plain.arc_polylines[a], &after = once.arc_polylines[a];
    EXPECT_LE(roughness(after), roughness(before));
    for (std::size_t i = 1; i + 1 < before.size(); ++i)
    {
      const Point expected =
        CGAL::barycenter(before[i - 1], 0.25, before[i], 0.5, before[i + 1], 0.25);
      EXPECT_LT(distance(after[i], expected), 1e-14 * size);
    }
    const Polyline& line = often.arc_polylines[a]; // evenly from end to end
    for (std::size_t i = 0; i < line.size(); ++i)
    {
      const double share = static_cast<double>(i) / static_cast<double>(line.size() - 1);
      const Point expected = line.front() + share * (line.back() - line.front());
      EXPECT_LT(distance(line[i], expected), 1e-9 * size);
    }
  }
}

// ===  Spacing

// The longest step divided by the shortest, without the steps to saddle leaves: these branch, so
// that the centroid jumps from them to the leaves beside them.
double ratio_of_steps(const SMF::Loop_system<Mesh>& system,
                      std::size_t arc,
                      const Polyline& polyline)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    if ((i > 1 || system.pole(system.node(arc, 0)) >= 0) &&
        (i + 1 < polyline.size() || system.pole(system.node(arc, 1)) >= 0))
      steps.push_back(distance(polyline[i - 1], polyline[i]));
  const auto [shortest, longest] = std::minmax_element(steps.begin(), steps.end());
  return *longest / *shortest;
}

TEST_P(Each_embedding, samples_are_spaced_evenly)
{
  for (const int samples : {5, 20, 50})
  {
    const Embedding embedding = SMF::reeb_graph_embedding(foliation, number_of_samples(samples));
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      EXPECT_EQ(embedding.levels[a].size(), static_cast<std::size_t>(samples));
      EXPECT_LT(ratio_of_steps(system, a, embedding.arc_polylines[a]), 3) << "arc " << a;
    }
  }
}

TEST(Embedding, uniform_levels_crowd_at_poles)
{
  const Solved_example<> example(
    {"", soups::limbed_sphere(4, 4), smf_test::pole_items(soups::limb_tips(4, 4))});
  const Embedding even = SMF::reeb_graph_embedding(example.foliation);
  const Embedding uniform = SMF::reeb_graph_embedding(example.foliation, use_uniform_levels(true));
  for (const std::size_t a : {0, 1, 2, 3})
    EXPECT_GT(ratio_of_steps(example.system, a, uniform.arc_polylines[a]),
              5 * ratio_of_steps(example.system, a, even.arc_polylines[a]));
}

// the embedding moves with the mesh
TEST_P(Each_embedding, follows_rotations_and_scale)
{
  Example moved = GetParam();
  for (auto& p : moved.soup.points)
    p = {3 * p[1] + 1, 3 * p[2] - 5, 3 * p[0]};
  for (auto& item : moved.items) // a x + b y + c z + d of the old place, as a function of the new
    item.plane = {item.plane[1], item.plane[2], item.plane[0],
                  3 * item.plane[3] - item.plane[1] + 5 * item.plane[2]};
  const Solved_example<> other(moved);
  const Embedding before = SMF::reeb_graph_embedding(foliation, number_of_samples(3));
  const Embedding after = SMF::reeb_graph_embedding(other.foliation, number_of_samples(3));
  ASSERT_EQ(after.node_points.size(), before.node_points.size());
  const auto transformed = [](const Point& p) {
    return Point(3 * p.y() + 1, 3 * p.z() - 5, 3 * p.x());
  };
  for (std::size_t r = 0; r < before.node_points.size(); ++r)
    EXPECT_LT(distance(after.node_points[r], transformed(before.node_points[r])), 1e-6 * size);
  for (std::size_t a = 0; a < before.arc_polylines.size(); ++a)
    for (std::size_t i = 0; i < before.arc_polylines[a].size(); ++i)
      EXPECT_LT(distance(after.arc_polylines[a][i], transformed(before.arc_polylines[a][i])),
                1e-6 * size)
        << "arc " << a << ", point " << i;
}

TEST_P(Each_embedding, works_at_all_scales)
{
  const Embedding before = SMF::reeb_graph_embedding(foliation, number_of_samples(3));
  for (const double scale : {1e-200, 1e-100, 1e100, 1e200})
  {
    SCOPED_TRACE(scale);
    Mesh mesh = *example.mesh;
    for (const auto v : vertices(mesh))
      mesh.point(v) = CGAL::ORIGIN + scale * (mesh.point(v) - CGAL::ORIGIN);
    const SMF::Loop_system<Mesh> scaled_system(mesh, example.input);
    const auto scaled = SMF::harmonic_foliation(scaled_system);
    const Embedding after = SMF::reeb_graph_embedding(scaled, number_of_samples(3));
    const auto expect_scaled = [&](const Point& p, const Point& q) { // also false for NaN
      EXPECT_LT(distance(p, CGAL::ORIGIN + (q - CGAL::ORIGIN) / scale), 1e-6 * size) << q;
    };
    for (std::size_t r = 0; r < before.node_points.size(); ++r)
      expect_scaled(before.node_points[r], after.node_points[r]);
    for (std::size_t a = 0; a < before.arc_polylines.size(); ++a)
    {
      ASSERT_EQ(after.arc_polylines[a].size(), before.arc_polylines[a].size());
      for (std::size_t i = 0; i < before.arc_polylines[a].size(); ++i)
        expect_scaled(before.arc_polylines[a][i], after.arc_polylines[a][i]);
    }
  }
}

// ===  As many samples as the shape needs

// A line, a helix and a wave, in tubes: chords stay near the axis, which few samples do not.
TEST(Reeb_graph_embedding, has_chords_inside_the_tube)
{
  using soups::Point;
  const double pi = std::acos(-1), radius = 0.3;
  const auto line = [](double t) { return Point{9 * t, 0, 0}; };
  const auto helix = [&](double t) {
    return Point{2 * std::cos(6 * pi * t), 2 * std::sin(6 * pi * t), 6 * t};
  };
  const auto wave = [&](double t) { return Point{12 * t, std::sin(8 * pi * t), 0}; };
  std::vector<std::size_t> numbers; // of samples
  const auto largest_distance = [&](const auto& curve, double deviation) {
    const std::size_t m = 120, n = 10;
    const Mesh mesh = smf_test::to_mesh(tube(curve, radius, m, n));
    SMF::Poles_and_loops<Mesh> input;
    input.add_pole(smf_test::vertex(m * n));
    input.add_pole(smf_test::vertex(m * n + 1));
    const auto foliation = SMF::harmonic_foliation(SMF::Loop_system<Mesh>(mesh, input));
    const Embedding embedding =
      SMF::reeb_graph_embedding(foliation, number_of_samples(4).max_chord_deviation(deviation));
    const Polyline& polyline = embedding.arc_polylines.at(0);
    numbers.push_back(embedding.levels[0].size());
    EXPECT_EQ(polyline.size(), embedding.levels[0].size() + 2);
    EXPECT_TRUE(std::is_sorted(embedding.levels[0].begin(), embedding.levels[0].end()));
    double result = 0; // from the axis, over points of chords between samples
    for (std::size_t i = 2; i + 1 < polyline.size(); ++i)
      for (const double share : {0., 0.25, 0.5, 0.75})
      {
        const auto p = polyline[i - 1] + share * (polyline[i] - polyline[i - 1]);
        double nearest = 1e9;
        for (double t = 0; t <= 1; t += 1 / 4096.)
        {
          const Point q = curve(t);
          nearest = (std::min)(nearest, distance(p, Mesh::Point(q[0], q[1], q[2])));
        }
        result = (std::max)(result, nearest);
      }
    return result;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_LT(largest_distance(line, 0.1), 0.01);
  EXPECT_EQ(numbers.back(), 4u) << "a straight tube needs no more";
  EXPECT_GT(largest_distance(helix, infinity), radius);
  EXPECT_EQ(numbers.back(), 4u);
  EXPECT_GT(largest_distance(wave, infinity), radius);
  for (const double deviation : {0.1, 0.3})
  {
    EXPECT_LT(largest_distance(helix, deviation), (deviation + 0.1) * radius);
    EXPECT_LT(largest_distance(wave, deviation), (deviation + 0.1) * radius);
    EXPECT_LT(numbers.back(), 200u);
  }
}

TEST(Reeb_graph_embedding, wants_a_positive_deviation)
{
  const Solved_example example(smf_test::theta_example());
  for (const double deviation : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(
      SMF::reeb_graph_embedding(example.foliation, SMF::parameters::max_chord_deviation(deviation)),
      SMF::Invalid_parameter_exception);
}

} // namespace

} // namespace test_reeb_graph_embedding
