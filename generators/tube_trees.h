// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_TUBE_TREES_H
#define SMF_GENERATORS_TUBE_TREES_H

#include "generators/Random.h"
#include "generators/soups.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh_default_criteria_3.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

// Random surfaces whose graph is known: unions of tubes along a tree, some of whose inner tubes may
// be rings.

namespace smf_test {

// A tube of constant radius between two nodes, along a polyline.
struct Tube
{
  std::array<std::size_t, 2> nodes;
  std::vector<soups::Point> line;
  double radius;

  double length() const
  {
    double result = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      result += soups::distance(line[i - 1], line[i]);
    return result;
  }
};

struct Tube_tree
{
  std::vector<soups::Point> nodes;
  std::vector<std::size_t> degrees; // ends have one tube
  std::vector<Tube> tubes;
  std::size_t number_of_rings = 0;

  bool is_end(std::size_t node) const { return degrees[node] == 1; }
};

inline double distance_to_segment(const soups::Point& p,
                                  const soups::Point& a,
                                  const soups::Point& b)
{
  const soups::Point u = soups::sum(b, a, -1), v = soups::sum(p, a, -1);
  const double t = std::clamp(soups::dot(u, v) / soups::dot(u, u), 0., 1.);
  return soups::distance(p, soups::sum(a, u, t));
}

inline double distance_to_tube(const soups::Point& p, const Tube& tube)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < tube.line.size(); ++i)
    result = std::min(result, distance_to_segment(p, tube.line[i - 1], tube.line[i]));
  return result - tube.radius;
}

// Whether a tube keeps away from others, but for its twin in a ring, and for those at its first
// node as long as it is near this node.
inline bool has_room(const Tube& tube, const std::vector<Tube>& others)
{
  for (const Tube& other : others)
  {
    if (other.nodes == tube.nodes)
      continue;
    const bool are_neighbors = other.nodes[0] == tube.nodes[0] || other.nodes[1] == tube.nodes[0];
    for (std::size_t i = 1; i < tube.line.size(); ++i)
      for (int k = 0; k <= 10; ++k)
      {
        const soups::Point p =
          soups::sum(soups::scaled(tube.line[i - 1], 1 - 0.1 * k), tube.line[i], 0.1 * k);
        const double free = tube.radius + 0.6 * std::max(tube.radius, other.radius);
        const double from_node = soups::distance(p, tube.line[0]);
        if (distance_to_tube(p, other) < free &&
            (!are_neighbors || from_node > 2.5 * (tube.radius + other.radius)))
          return false;
      }
  }
  return true;
}

inline soups::Point random_direction(Random& random)
{
  while (true)
  {
    const soups::Point p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const double square = soups::dot(p, p);
    if (square > 0.01 && square < 1)
      return soups::normalized(p);
  }
}

// Grows a tree tube by tube. Radii lie between 1 and 4. An inner tube is 5 to 12 radii long, or,
// one in five, so short that its two branchings look like one; the last tube before an end is 5 to
// 9 radii long, measured from the branching.
class Tube_tree_growth
{
public:
  // There are at least three ends, and at most as many rings as ends beyond these.
  Tube_tree_growth(std::size_t number_of_ends, std::size_t number_of_rings, std::uint64_t seed)
    : m_number_of_ends((std::max)(number_of_ends, std::size_t(3))),
      m_number_of_rings((std::min)(number_of_rings, m_number_of_ends - 3)),
      m_random(seed)
  {}

  Tube_tree operator()()
  {
    while (true)
      if (const std::optional<Tube_tree> tree = grow())
        return *tree;
  }

private:
  // a node from which a tube is to grow
  struct Bud
  {
    std::size_t node;
    soups::Point direction;
    double radius; // of the tube that leads there
  };

  // at an angle between 35 and 65 degrees to another one, on a given side of it
  soups::Point branch(const soups::Point& direction, const soups::Point& side)
  {
    const double angle = m_random.between(35, 65) * soups::pi / 180;
    return soups::normalized(
      soups::sum(soups::scaled(direction, std::cos(angle)), side, std::sin(angle)));
  }

  std::size_t add_node(const soups::Point& p)
  {
    m_tree.nodes.push_back(p);
    m_tree.degrees.push_back(0);
    return m_tree.nodes.size() - 1;
  }

  // a tube with a bend of up to 30 degrees in its middle
  bool add_tube(const Bud& bud, double radius, double length, Bud& next)
  {
    const soups::Point start = m_tree.nodes[bud.node];
    const soups::Point middle = soups::sum(start, bud.direction, length / 2);
    const soups::Point end_direction =
      soups::normalized(soups::sum(bud.direction, random_direction(m_random), 0.5));
    const soups::Point end = soups::sum(middle, end_direction, length / 2);
    Tube tube = {{bud.node, m_tree.nodes.size()}, {start, middle, end}, radius};
    if (!has_room(tube, m_tree.tubes))
      return false;
    next = {add_node(end), end_direction, radius};
    add(tube);
    return true;
  }

  void add(const Tube& tube)
  {
    ++m_tree.degrees[tube.nodes[0]];
    ++m_tree.degrees[tube.nodes[1]];
    m_tree.tubes.push_back(tube);
  }

  double next_radius(double radius)
  {
    return std::clamp(radius * m_random.between(0.8, 1.25), 1., 4.);
  }

  double inner_length(double radius)
  {
    return radius * (m_random.index(5) == 0 ? m_random.between(0.2, 0.6) : m_random.between(5, 12));
  }

  // two tubes side by side between the end of a tube and a new node
  bool add_ring(Bud& bud)
  {
    const double radius = std::max(1., 0.7 * bud.radius), width = 2.6 * radius, height = 7 * radius;
    const soups::Point side =
      soups::normalized(soups::cross(bud.direction, random_direction(m_random)));
    const soups::Point start = m_tree.nodes[bud.node];
    const soups::Point end = soups::sum(start, bud.direction, height);
    std::vector<Tube> both;
    for (const double sign : {1., -1.})
    {
      const soups::Point lower =
        soups::sum(soups::sum(start, bud.direction, 0.25 * height), side, sign * width);
      const soups::Point upper =
        soups::sum(soups::sum(start, bud.direction, 0.75 * height), side, sign * width);
      both.push_back({{bud.node, m_tree.nodes.size()}, {start, lower, upper, end}, radius});
      if (!has_room(both.back(), m_tree.tubes))
        return false;
    }
    bud.node = add_node(end);
    for (const Tube& tube : both)
      add(tube);
    ++m_tree.number_of_rings;
    return true;
  }

  std::optional<Tube_tree> grow()
  {
    m_tree = Tube_tree();
    const double radius = m_random.between(1, 4);
    const soups::Point direction = random_direction(m_random);
    add_node({0, 0, 0});
    const soups::Point first =
      soups::normalized(soups::cross(direction, random_direction(m_random)));
    std::vector<Bud> buds = {
      {0, direction, radius},
      {0, branch(soups::scaled(direction, -1), first), radius},
      {0, branch(soups::scaled(direction, -1), soups::scaled(first, -1)), radius}};
    while (!buds.empty())
    {
      const std::size_t chosen = m_random.index(buds.size());
      const Bud bud = buds[chosen];
      buds.erase(buds.begin() + static_cast<std::ptrdiff_t>(chosen));
      const bool branches = buds.size() + 1 + m_number_of_ended < m_number_of_ends;
      const double next = next_radius(bud.radius);
      Bud end;
      if (!branches)
      {
        if (!add_tube(bud, next, next * m_random.between(5, 9), end))
          return fail();
        ++m_number_of_ended;
        continue;
      }
      if (!add_tube(bud, next, inner_length(next), end))
        return fail();
      if (m_tree.number_of_rings < m_number_of_rings)
      {
        if (!add_ring(end))
          return fail();
        Bud behind;
        if (!add_tube(end, next, next * m_random.between(5, 8), behind))
          return fail();
        end = behind;
      }
      const soups::Point side =
        soups::normalized(soups::cross(end.direction, random_direction(m_random)));
      buds.push_back({end.node, branch(end.direction, side), end.radius});
      buds.push_back({end.node, branch(end.direction, soups::scaled(side, -1)), end.radius});
    }
    m_number_of_ended = 0;
    if (m_tree.number_of_rings < m_number_of_rings)
      return std::nullopt;
    return m_tree;
  }

  std::optional<Tube_tree> fail()
  {
    m_number_of_ended = 0;
    return std::nullopt;
  }

  std::size_t m_number_of_ends, m_number_of_rings, m_number_of_ended = 0;
  Random m_random;
  Tube_tree m_tree;
};

// Other poses of a tree: every tube long enough to bend is bent in its middle once more, by up to
// 30 degrees, and carries what lies behind it along. Lengths and radii stay.
class Tube_tree_poses
{
public:
  Tube_tree_poses(const Tube_tree& tree, std::uint64_t seed) : m_tree(tree), m_random(seed) {}

  Tube_tree operator()()
  {
    while (true)
      if (const std::optional<Tube_tree> pose = bent())
        return *pose;
  }

private:
  using Frame = std::array<soups::Point, 3>; // images of the axes under a rotation

  static soups::Point image(const Frame& frame, const soups::Point& p)
  {
    return soups::sum(soups::sum(soups::scaled(frame[0], p[0]), frame[1], p[1]), frame[2], p[2]);
  }

  Frame turned(Frame frame)
  {
    const soups::Point axis = random_direction(m_random);
    const double angle = m_random.between(0, 30) * soups::pi / 180;
    for (soups::Point& p : frame) // Rodrigues' formula
    {
      const soups::Point along = soups::scaled(axis, (1 - std::cos(angle)) * soups::dot(axis, p));
      p = soups::sum(
        soups::sum(soups::scaled(p, std::cos(angle)), soups::cross(axis, p), std::sin(angle)),
        along);
    }
    return frame;
  }

  std::optional<Tube_tree> bent()
  {
    Tube_tree result = m_tree;
    result.tubes.clear();
    std::vector<Frame> frames(m_tree.nodes.size(), {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    for (const Tube& tube : m_tree.tubes) // each starts where one before it ends
    {
      const bool can_bend = tube.line.size() == 3 && tube.length() > 2 * tube.radius;
      Frame frame = frames[tube.nodes[0]];
      Tube copy = tube;
      copy.line[0] = result.nodes[tube.nodes[0]];
      for (std::size_t i = 1; i < tube.line.size(); ++i)
      {
        if (i == 2 && can_bend)
          frame = turned(frame);
        copy.line[i] = soups::sum(copy.line[i - 1],
                                  image(frame, soups::sum(tube.line[i], tube.line[i - 1], -1)));
      }
      if (!has_room(copy, result.tubes))
        return std::nullopt;
      frames[tube.nodes[1]] = frame;
      result.nodes[tube.nodes[1]] = copy.line.back();
      result.tubes.push_back(copy);
    }
    return result;
  }

  const Tube_tree m_tree;
  Random m_random;
};

// the surface around all tubes, rounded where they meet
template <class TriangleMesh>
TriangleMesh surface_of_tubes(const Tube_tree& tree)
{
  using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
  using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
  using Traits = Triangulation::Geom_traits;
  using Function = std::function<Traits::FT(Traits::Point_3)>;
  using Surface = CGAL::Implicit_surface_3<Traits, Function>;
  const Function function = [&tree](const Traits::Point_3& p) {
    constexpr double rounding = 0.15;
    const soups::Point q = {p.x(), p.y(), p.z()};
    thread_local std::vector<double> distances;
    distances.clear();
    for (const Tube& tube : tree.tubes)
      distances.push_back(distance_to_tube(q, tube));
    const double least = *std::min_element(distances.begin(), distances.end());
    double sum = 0;
    for (const double d : distances)
      if (d - least < 30 * rounding) // others do not count
        sum += std::exp((least - d) / rounding);
    return least - rounding * std::log(sum);
  };
  double radius = 1;
  for (const auto& p : tree.nodes)
    radius = std::max(radius, 1.5 * (soups::distance(p, tree.nodes[0]) + 6));
  const auto& first = tree.nodes[0];
  const Traits::Point_3 center(first[0], first[1], first[2]);
  const Surface surface(function, Traits::Sphere_3(center, radius * radius), 1e-5);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, 0.7, 0.15);
  Triangulation triangulation;
  Complex complex(triangulation);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());
  TriangleMesh mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  return mesh;
}

} // namespace smf_test

#endif // SMF_GENERATORS_TUBE_TREES_H
