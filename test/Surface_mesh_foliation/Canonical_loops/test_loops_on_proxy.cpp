// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moduli that are measured on a coarser mesh, and again where it is too coarse.

#include "generators/Random.h"
#include "generators/genus_soups.h"
#include "generators/known_moduli.h"
#include "generators/meshes.h"
#include "generators/openings.h"
#include "generators/revolution.h"
#include "include/flat_meshes.h"

#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Loop_fineness.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Loops_on_proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/openings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace test_loops_on_proxy {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace SI = SMF::internal;
using namespace smf_test;

std::vector<SI::Pole> poles_at(const std::vector<std::size_t>& vertices)
{
  std::vector<SI::Pole> result;
  result.reserve(vertices.size());
  for (const std::size_t v : vertices)
    result.push_back({static_cast<int>(v)});
  return result;
}

std::shared_ptr<const SI::Proxy> proxy_of(const SI::Flat_mesh& fine,
                                          const std::vector<SI::Pole>& poles,
                                          int number_of_vertices)
{
  return std::make_shared<const SI::Proxy>(fine, poles, SI::Proxy::no_loops(), number_of_vertices);
}

SI::Flat_loop_hierarchy hierarchy_on(const SI::Proxy& proxy)
{
  return {proxy.mesh(), proxy.lengths(), proxy.poles()};
}

// angles with the axis
void append_arc(std::vector<soups::Profile_point>& profile,
                double center,
                double radius,
                double from,
                double to,
                double step)
{
  const double number = std::round(std::abs(to - from) * radius / step);
  for (double i = 1; i <= number; ++i)
  {
    const double angle = from + (to - from) * i / number;
    profile.push_back({center - radius * std::cos(angle), radius * std::sin(angle)});
  }
}

void append_tube(
  std::vector<soups::Profile_point>& profile, double from, double to, double radius, double step)
{
  const double number = std::round((to - from) / step);
  for (double i = 1; i <= number; ++i)
    profile.push_back({from + (to - from) * i / number, radius});
}

// with pairs of opposite poles on some circles
std::pair<SI::Flat_mesh, std::vector<SI::Pole>> surface_with_pairs_of_poles(
  const std::vector<soups::Profile_point>& profile,
  std::size_t n,
  double first_tip,
  double last_tip,
  const std::vector<std::size_t>& circles)
{
  std::vector<std::size_t> poles;
  for (const std::size_t circle : circles)
    for (const std::size_t turn : {std::size_t(0), n / 2})
      poles.push_back(circle * n + turn);
  return {flat_mesh(soups::surface_of_revolution(profile, n, first_tip, last_tip)),
          poles_at(poles)};
}

// A surface with two waists between three pairs of poles. The first one is as wide as the ends and
// long, with a modulus above 1; the second one is narrow and short, with a modulus below 1.
std::pair<SI::Flat_mesh, std::vector<SI::Pole>> surface_with_two_waists()
{
  constexpr std::size_t n = 64;
  constexpr double step = 2 * soups::pi / n, radius = 0.3, length = 6.5, tube = 0.15;
  const double neck = std::asin(radius), end = length + std::cos(neck);
  const double last_center = end + tube + std::cos(neck);
  std::vector<soups::Profile_point> profile;
  append_arc(profile, 0, 1, 0, soups::pi / 2, step);
  const std::size_t first = profile.size() - 1;
  append_tube(profile, 0, length, 1, step);
  const std::size_t second = profile.size() - 1;
  append_arc(profile, length, 1, soups::pi / 2, soups::pi - neck, step);
  append_tube(profile, end, end + tube, radius, step);
  append_arc(profile, last_center, 1, neck, soups::pi / 2, step);
  const std::size_t third = profile.size() - 1;
  append_arc(profile, last_center, 1, soups::pi / 2, soups::pi, step);
  profile.pop_back(); // on the axis
  return surface_with_pairs_of_poles(profile, n, -1, last_center + 1, {first, second, third});
}

// A sphere of radius 1 with a knob, another sphere a little wider than the neck between the two. A
// sweep from the poles meets a loop that is drawn somewhere on the large sphere.
std::pair<SI::Flat_mesh, std::vector<SI::Pole>> sphere_with_knob(double neck, double ratio)
{
  const double angle = std::asin(neck), angle_of_knob = std::asin(1 / ratio);
  const double radius = ratio * neck, step = 0.13 * neck, end = std::cos(angle) + 1.5 * neck;
  const double center = end + radius * std::cos(angle_of_knob);
  std::vector<soups::Profile_point> profile;
  append_arc(profile, 0, 1, 0, soups::pi / 2, 0.045);
  const std::size_t first = profile.size() - 1;
  append_arc(profile, 0, 1, soups::pi / 2, soups::pi - angle, 0.045);
  append_tube(profile, std::cos(angle), end, neck, step);
  append_arc(profile, center, radius, angle_of_knob, soups::pi / 2, step);
  const std::size_t second = profile.size() - 1;
  append_arc(profile, center, radius, soups::pi / 2, soups::pi, step);
  profile.pop_back(); // on the axis
  return surface_with_pairs_of_poles(profile, 48, -1, center + radius, {first, second});
}

} // namespace

// A thin torus has few edges around on a proxy of even edges. Its modulus is known: the torus is
// conformal to a flat one.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_handles_are_thin)
{
  double error = 0, error_before = 0; // relative, their sums
  for (const double r : {0.06, 0.08, 0.1, 0.12, 0.15})
  {
    SCOPED_TRACE(r);
    const double expected = std::sqrt(9 - r * r) / r;
    const SI::Flat_mesh fine = flat_mesh(soups::torus(static_cast<std::size_t>(72 / r), 24, 3, r));
    const auto proxy = proxy_of(fine, {}, 1000);
    const SI::Loops_on_proxy found(fine, {}, proxy);
    ASSERT_EQ(found.hierarchy().loops().size(), 1u);
    EXPECT_TRUE(found.hierarchy().loops()[0].is_measured_again);
    const double modulus = found.hierarchy().loops()[0].modulus;
    EXPECT_NEAR(modulus, expected, 0.1 * expected);
    const double before = hierarchy_on(*proxy).loops()[0].modulus;
    EXPECT_GT(std::abs(before - expected), std::abs(modulus - expected));
    error += std::abs(modulus / expected - 1);
    error_before += std::abs(before / expected - 1);
  }
  EXPECT_GT(error_before, 2 * error);
}

// With twenty vertices around, too, moduli depend on which edges were collapsed, by some percent.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_handles_are_a_little_thin)
{
  for (const double r : {0.15, 0.2, 0.3})
  {
    SCOPED_TRACE(r);
    const double expected = std::sqrt(9 - r * r) / r;
    const Triangle_soup soup = soups::torus(static_cast<std::size_t>(108 / r), 36, 3, r);
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
    {
      const SI::Flat_mesh fine =
        flat_mesh(soups::relabeled(soup, new_labels(soup.points.size(), seed), seed));
      const SI::Loops_on_proxy found(fine, {}, proxy_of(fine, {}, 5000));
      ASSERT_EQ(found.hierarchy().loops().size(), 1u);
      EXPECT_NEAR(found.hierarchy().loops()[0].modulus, expected, 0.015 * expected);
    }
  }
}

// With a few edges around each bar of a plate with holes, moduli depend on which edges were
// collapsed, by several percent, and with them the order of the loops.
TEST(Loops_on_proxy, do_not_depend_on_the_order_of_vertices_where_handles_are_thin)
{
  // Its bars are alike, and no two have the same modulus if it is bent.
  Triangle_soup soup = soups::genus_surface(4, 6);
  double width = 0;
  for (const soups::Point& p : soup.points)
    width = std::max(width, p[0]);
  for (soups::Point& p : soup.points)
  {
    const double x = p[0] / width, y = p[1] / width;
    p = {p[0] * (1 + 0.6 * x), p[1] * (1 + 0.6 * y * (1 + 0.3 * x)), p[2] * (1 + 0.6 * x * y)};
  }
  std::vector<double> expected;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
  {
    SCOPED_TRACE(seed);
    const SI::Flat_mesh fine =
      flat_mesh(soups::relabeled(soup, new_labels(soup.points.size(), seed), seed));
    const SI::Loops_on_proxy found(fine, {}, proxy_of(fine, {}, 300));
    EXPECT_EQ(found.hierarchy().size_of_pants_decomposition(), 9);
    ASSERT_EQ(found.hierarchy().loops().size(), 9u);
    if (expected.empty())
      for (const SI::Loop_class& loop : found.hierarchy().loops())
        expected.push_back(loop.modulus);
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found.hierarchy().loops()[i].modulus, expected[i], 0.02 * expected[i]);
  }
}

// The tubes have five to ten vertices around on the proxy, and functions are singular at poles,
// which makes moduli a percent or two too small.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_tubes_are_thin)
{
  constexpr double length = 3;
  for (const double radius : {0.15, 0.2, 0.3})
    for (std::uint64_t seed = 1; seed <= 2; ++seed)
    {
      SCOPED_TRACE(radius);
      SCOPED_TRACE(seed);
      const auto [soup, ends] = soups::dumbbell(radius, length, 64);
      const std::vector<std::size_t> label = new_labels(soup.points.size(), seed);
      const SI::Flat_mesh fine = flat_mesh(soups::relabeled(soup, label, seed));
      const std::vector<SI::Pole> poles =
        poles_at({label[ends[0]], label[ends[1]], label[ends[2]], label[ends[3]]});
      const auto proxy = proxy_of(fine, poles, 1000);
      const SI::Loops_on_proxy found(fine, poles, proxy);
      ASSERT_EQ(found.hierarchy().loops().size(), 1u);
      const SI::Loop_class& loop = found.hierarchy().loops()[0];
      const double expected = modulus_of_dumbbell(radius, length);
      EXPECT_TRUE(loop.is_measured_again);
      EXPECT_NEAR(loop.modulus, expected, 0.008 * expected);
      EXPECT_LT(hierarchy_on(*proxy).loops()[0].modulus, loop.modulus);
    }
}

// A neck may be thin although its loop is drawn where the surface is wide.
TEST(Loops_on_proxy, are_measured_on_a_finer_one_where_necks_are_thin)
{
  double error = 0, error_before = 0; // relative, their sums
  for (const double neck : {0.03, 0.05, 0.08})
    for (const double ratio : {1.3, 2.})
    {
      SCOPED_TRACE(neck);
      SCOPED_TRACE(ratio);
      const auto [fine, poles] = sphere_with_knob(neck, ratio);
      const auto proxy = proxy_of(fine, poles, 3000);
      const SI::Loops_on_proxy found(fine, poles, proxy);
      const SI::Flat_loop_hierarchy all(fine, SI::edge_lengths(fine), poles);
      ASSERT_EQ(found.hierarchy().loops().size(), 1u);
      const double expected = all.loops()[0].modulus;
      EXPECT_TRUE(found.hierarchy().loops()[0].is_measured_again);
      EXPECT_NEAR(found.hierarchy().loops()[0].modulus, expected, 0.006 * expected);
      error += std::abs(found.hierarchy().loops()[0].modulus / expected - 1);
      error_before += std::abs(hierarchy_on(*proxy).loops()[0].modulus / expected - 1);
    }
  EXPECT_GT(error_before, 4 * error);
}

// What is not thin does not lose by it: the rest of the mesh is no coarser than before.
TEST(Loops_on_proxy, are_not_worse_beside_thin_tubes)
{
  const auto [fine, poles] = surface_with_two_waists();
  const auto proxy = proxy_of(fine, poles, 3000);
  const SI::Loops_on_proxy found(fine, poles, proxy);
  const SI::Flat_loop_hierarchy before = hierarchy_on(*proxy);
  const SI::Flat_loop_hierarchy all(fine, SI::edge_lengths(fine), poles);
  ASSERT_EQ(found.hierarchy().loops().size(), 3u);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const SI::Loop_class& loop = found.hierarchy().loops()[i];
    EXPECT_TRUE(loop.is_measured_again);
    const double expected = all.loops()[i].modulus;
    EXPECT_LT(std::abs(loop.modulus / expected - 1), 0.005);
    EXPECT_LT(std::abs(loop.modulus - expected),
              std::abs(before.loops()[i].modulus - expected) + 0.001 * expected);
  }
}

// Asked for loops above some modulus only, one gets the same ones, although the finer mesh is made
// for one below it.
TEST(Loops_on_proxy, do_not_depend_on_the_least_modulus)
{
  const auto [fine, poles] = surface_with_two_waists();
  const auto proxy = proxy_of(fine, poles, 3000);
  const SI::Loops_on_proxy all(fine, poles, proxy);
  ASSERT_EQ(all.hierarchy().loops().size(), 3u);
  EXPECT_GT(all.hierarchy().loops()[0].modulus, 1);
  EXPECT_LT(all.hierarchy().loops()[1].modulus, 1);
  for (const double least : {0.3, 0.6, 1.})
  {
    SCOPED_TRACE(least);
    const SI::Loops_on_proxy found(fine, poles, proxy, SI::poll_nobody, least);
    ASSERT_EQ(found.hierarchy().loops().size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
      if (const double modulus = all.hierarchy().loops()[i].modulus; modulus >= least)
        EXPECT_NEAR(found.hierarchy().loops()[i].modulus, modulus, 1e-6 * modulus);
      else
        EXPECT_LT(found.hierarchy().loops()[i].modulus, least);
  }
}

// With handles, so are those that separate the surface, whatever their modulus.
TEST(Loops_on_proxy, are_measured_again_where_they_separate_handles)
{
  for (const double radius : {0.5, 0.7})
  {
    SCOPED_TRACE(radius);
    const auto [soup, ends] = soups::dumbbell(radius, 0.1, 48);
    // a thin handle on either sphere
    Triangle_soup with_handles = soup;
    std::vector<std::size_t> removed;
    for (const std::size_t half : {std::size_t(0), std::size_t(2)})
    {
      std::array<std::size_t, 2> faces{};
      for (std::size_t i = 0; i < 2; ++i)
        faces[i] = static_cast<std::size_t>(
          std::find_if(soup.triangles.begin(), soup.triangles.end(),
                       [&, v = ends[half + i]](const soups::Triangle& t) { return t[0] == v; }) -
          soup.triangles.begin());
      soups::add_tube(with_handles, soup.triangles[faces[0]], soup.triangles[faces[1]]);
      removed.insert(removed.end(), faces.begin(), faces.end());
    }
    std::sort(removed.rbegin(), removed.rend());
    for (const std::size_t face : removed)
      with_handles.triangles.erase(with_handles.triangles.begin() +
                                   static_cast<std::ptrdiff_t>(face));
    const SI::Flat_mesh fine = flat_mesh(with_handles);
    ASSERT_EQ(fine.genus(), 2);
    const std::vector<SI::Pole> none;
    const SI::Loops_on_proxy found(fine, none, proxy_of(fine, none, 500));
    const SI::Flat_loop_hierarchy all(fine, SI::edge_lengths(fine), none);
    ASSERT_EQ(found.hierarchy().loops().size(), 3u);
    const auto waist = [](const SI::Flat_loop_hierarchy& hierarchy) {
      return *std::find_if(hierarchy.loops().begin(), hierarchy.loops().end(),
                           [](const SI::Loop_class& loop) { return loop.is_separating; });
    };
    const double expected = waist(all).modulus;
    EXPECT_GT(expected, 0.25);
    EXPECT_LT(expected, radius < 0.6 ? 0.8 : 0.57);
    EXPECT_TRUE(waist(found.hierarchy()).is_measured_again);
    EXPECT_NEAR(waist(found.hierarchy()).modulus, expected, 0.01 * expected);
  }
}

// Openings are ends like poles.
TEST(Loops_on_proxy, are_measured_again_between_openings)
{
  for (const double radius : {0.2, 0.3})
  {
    SCOPED_TRACE(radius);
    const auto [soup, ends] = soups::dumbbell(radius, 2, 48);
    const Triangle_soup open = soups::without_isolated_vertices(
      soups::with_faces(soup, [ends = ends](const soups::Triangle& t) {
        return std::none_of(t.begin(), t.end(), [&](std::size_t v) {
          return std::find(ends.begin(), ends.end(), v) != ends.end();
        });
      }));
    const Mesh mesh = to_open_mesh(open);
    SMF::Poles_and_loops<Mesh> openings;
    SMF::add_border_poles(mesh, openings);
    const auto modulus = [&](int number) {
      const auto hierarchy =
        SMF::loop_hierarchy(mesh, openings, SMF::parameters::number_of_proxy_vertices(number));
      EXPECT_EQ(hierarchy.loops().size(), 1u);
      return hierarchy.loops().at(0).modulus;
    };
    const double expected = modulus(static_cast<int>(num_vertices(mesh)) + 4);
    EXPECT_NEAR(modulus(700), expected, 0.01 * expected);
  }
}

TEST(Loops_on_proxy, are_not_measured_again_if_it_is_fine_enough)
{
  const SI::Flat_mesh fine = flat_mesh(soups::torus(80, 60, 3, 1.5));
  const SI::Loops_on_proxy found(fine, {}, proxy_of(fine, {}, 3000));
  ASSERT_EQ(found.hierarchy().loops().size(), 1u);
  EXPECT_FALSE(found.hierarchy().loops()[0].is_measured_again);
}

// Other moduli may change the order, and what is chosen; it cuts the surface as before, although
// candidates may be missing that would complete another choice.
TEST(Flat_loop_hierarchy, chooses_again)
{
  const auto [waists, six] = surface_with_two_waists();
  const Triangle_soup limbs = soups::limbed_sphere(7, 4);
  const Triangle_soup plate = soups::genus_surface(2, 4);
  const auto random_poles = [](const Triangle_soup& soup, std::uint64_t seed) {
    std::vector<std::size_t> result = Random(seed).permutation(soup.points.size());
    result.resize(10);
    return poles_at(result);
  };
  std::size_t number_of_choices = 0, number_kept = 0;
  for (const auto& [fine, poles] :
       {std::make_pair(waists, six), std::make_pair(flat_mesh(limbs), random_poles(limbs, 2)),
        std::make_pair(flat_mesh(plate), random_poles(plate, 1))})
  {
    SCOPED_TRACE(fine.number_of_vertices());
    const auto proxy = proxy_of(fine, poles, 300);
    const std::size_t number = hierarchy_on(*proxy).candidates().size();
    for (std::size_t i = 0; i < number; i += 1 + number / 10)
    {
      SCOPED_TRACE(i);
      SI::Flat_loop_hierarchy hierarchy = hierarchy_on(*proxy);
      ASSERT_TRUE(hierarchy.is_complete());
      const bool was_chosen = hierarchy.candidates()[i].is_chosen;
      hierarchy.choose_again({i}, {2});
      EXPECT_TRUE(hierarchy.is_complete());
      const std::vector<SI::Loop_class>& loops = hierarchy.loops();
      EXPECT_TRUE(std::is_sorted(
        loops.begin(), loops.end(),
        [](const SI::Loop_class& x, const SI::Loop_class& y) { return x.modulus > y.modulus; }));
      const bool is_chosen =
        std::any_of(loops.begin(), loops.end(),
                    [](const SI::Loop_class& loop) { return loop.is_measured_again; });
      EXPECT_TRUE(is_chosen || !was_chosen);
      number_of_choices += is_chosen && !was_chosen ? 1 : 0;
      number_kept += is_chosen ? 0 : 1;
    }
  }
  EXPECT_GT(number_of_choices, 5u);
  EXPECT_GT(number_kept, 1u);
}

// Minsky's inequality bounds the dominance from below, whichever mesh the two moduli are from.
TEST(Flat_loop_hierarchy, has_dominances_as_large_as_the_inequality_demands)
{
  const auto [soup, ends] = soups::dumbbell(0.5, 0.5, 32);
  const SI::Flat_mesh fine = flat_mesh(soup);
  const std::vector<SI::Pole> poles = poles_at({ends[0], ends[1], ends[2], ends[3]});
  const auto proxy = proxy_of(fine, poles, 500);
  SI::Flat_loop_hierarchy hierarchy = hierarchy_on(*proxy);
  const auto dominance = [&] {
    return hierarchy.loops()[0].modulus / hierarchy.loops()[0].largest_crossing;
  };
  const double modulus = hierarchy.loops()[0].modulus;
  const double before = dominance();
  EXPECT_GE(before, 4 * modulus * modulus);
  EXPECT_LT(before, 1.1 * 4 * modulus * modulus);
  hierarchy.choose_again({0}, {1.2 * modulus}); // of the first one only
  EXPECT_EQ(hierarchy.loops()[0].modulus, 1.2 * modulus);
  EXPECT_GE(dominance(), 4 * 1.44 * modulus * modulus * (1 - 1e-12));
  // on one mesh, this contradicts the inequality
  std::vector<std::size_t> all(hierarchy.candidates().size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<double> moduli;
  for (const SI::Loop_class& candidate : hierarchy.candidates())
    moduli.push_back(candidate.modulus);
  EXPECT_THROW(hierarchy.choose_again(all, moduli), SMF::Certificate_exception);
}

TEST(Loop_fineness, is_less_where_the_surface_is_wider)
{
  const auto [soup, ends] = soups::dumbbell(0.2, 2, 48);
  const SI::Flat_mesh fine = flat_mesh(soup);
  const std::vector<SI::Pole> poles = poles_at({ends[0], ends[1], ends[2], ends[3]});
  const auto proxy = proxy_of(fine, poles, 500);
  const SI::Flat_loop_hierarchy hierarchy = hierarchy_on(*proxy);
  SI::Loop_fineness fineness(proxy->mesh());
  const SI::Loop_class& loop = hierarchy.loops()[0];
  fineness.add(loop.loop, loop.modulus);
  const std::vector<double> values = fineness.fineness();
  const double at_loop = values[proxy->mesh().source(loop.loop.crossings[0].halfedge)];
  EXPECT_GT(at_loop, 2);
  for (const SI::Pole& pole : proxy->poles()) // where the surface is five times as wide
    EXPECT_LT(values[pole[0]] - 1, 0.25 * (at_loop - 1));
}

// It is full where an annulus of that modulus may reach, and fades away from there.
TEST(Loop_fineness, reaches_as_far_as_an_annulus)
{
  const std::size_t m = 400, n = 20;
  const SI::Flat_mesh fine = flat_mesh(soups::torus(m, n, 3, 0.15));
  SI::Flat_loop around; // between the first two rings
  for (int v = 0; v < static_cast<int>(n); ++v)
    for (const int h : fine.ring(v))
      if (const auto target = static_cast<std::size_t>(fine.target(h)); target / n == 1)
        around.crossings.push_back({h, 0.5});
  ASSERT_EQ(around.crossings.size(), 2 * n);
  for (const double modulus : {0.5, 1., 2.})
  {
    SCOPED_TRACE(modulus);
    SI::Loop_fineness fineness(fine);
    fineness.add(around, modulus);
    const std::vector<double> values = fineness.fineness();
    const auto at = [&](double annuli) { // so many times as far as an annulus
      const double steps = annuli * 2 * n * (0.5 + modulus) / 2;
      return values[(1 + static_cast<std::size_t>(steps)) * n];
    };
    EXPECT_NEAR(at(0), 64 / (2. * n), 1e-12);
    EXPECT_NEAR(at(0.9), at(0), 1e-12);
    EXPECT_LT(at(1.5) - 1, 0.7 * (at(0) - 1));
    EXPECT_GT(at(1.5) - 1, 0.3 * (at(0) - 1));
    EXPECT_DOUBLE_EQ(at(2.1), 1);
  }
}

TEST(Loop_fineness, makes_nothing_coarser)
{
  const auto [dumbbell, ends] = soups::dumbbell(0.2, 2, 48);
  const std::vector<SI::Pole> four = poles_at({ends[0], ends[1], ends[2], ends[3]});
  const std::vector<SI::Pole> none;
  for (const auto& [soup, poles] :
       {std::make_pair(dumbbell, four), std::make_pair(soups::torus(400, 20, 3, 0.15), none),
        std::make_pair(soups::genus_surface(3, 5), none)})
  {
    const SI::Flat_mesh fine = flat_mesh(soup);
    SCOPED_TRACE(fine.genus());
    const auto proxy = proxy_of(fine, poles, 500);
    const SI::Flat_loop_hierarchy hierarchy = hierarchy_on(*proxy);
    SI::Loop_fineness fineness(proxy->mesh());
    EXPECT_DOUBLE_EQ(fineness.number_of_vertices(), proxy->mesh().number_of_vertices());
    for (const SI::Loop_class& loop : hierarchy.loops())
      fineness.add(loop.loop, loop.modulus);
    const std::vector<double> values = fineness.fineness();
    EXPECT_GE(*std::min_element(values.begin(), values.end()), 1);
    const SI::Loop_class& first = hierarchy.loops()[0];
    EXPECT_TRUE(fineness.is_needed());
    EXPECT_GT(values[proxy->mesh().source(first.loop.crossings[0].halfedge)], 1.2);
    const double size = std::inner_product(values.begin(), values.end(), values.begin(), 0.);
    EXPECT_LE(size, SI::Loop_fineness::most_growth * static_cast<double>(values.size()) + 1e-6);
    EXPECT_NEAR(fineness.number_of_vertices(), size, 1e-6);

    // on the finer mesh, edges are as many times shorter
    std::vector<double> of_fine_mesh(fine.number_of_vertices());
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      of_fine_mesh[v] = values[proxy->clusters()[v]];
    const SI::Proxy finer(fine, poles, SI::Proxy::no_loops(),
                          static_cast<int>(fineness.number_of_vertices()), of_fine_mesh);
    std::array<double, 2> before{}, after{}; // numbers of vertices where it is finer, and elsewhere
    for (const double value : values)
      ++before[value > 1.2 ? 0 : 1];
    for (int v = 0; v < finer.mesh().number_of_vertices(); ++v)
      ++after[of_fine_mesh[finer.clusters().representative(v)] > 1.2 ? 0 : 1];
    EXPECT_GT(after[0], 1.4 * before[0]);
    EXPECT_GE(after[1], 0.85 * before[1]);
  }
}

} // namespace test_loops_on_proxy
