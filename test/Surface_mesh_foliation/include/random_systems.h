// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_RANDOM_SYSTEMS_H
#define SMF_TEST_RANDOM_SYSTEMS_H

#include "generators/meshes.h"
#include "generators/openings.h"
#include "generators/Random.h"
#include "system_items.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// Random valid loop systems on a mesh: up to twelve poles, often close together, with loops that
// hug them or run around them at a distance of up to five rings, line poles, handle loops and loops
// around sets of vertices, with heights over six decades.

namespace smf_test {

namespace SMF = CGAL::Surface_mesh_foliation;
using Vertex = Mesh::Vertex_index;
using Input = SMF::Poles_and_loops<Mesh>;

class Random_items
{
public:
  Random_items(const Mesh& mesh, Random& random) : m_mesh(mesh), m_random(random) {}

  // a set of items that together make a valid system; empty if none was found
  std::vector<Item> operator()()
  {
    std::vector<Item> result = borders();
    const std::size_t number_of_borders = result.size();
    for (std::size_t i = m_random.index(13); i > 0; --i)
    {
      result.push_back(m_random.index(6) == 0 ? line_pole() : pole(result));
      if (result.size() > 2 + number_of_borders && !is_valid(result))
        result.pop_back(); // one pole alone may be too few
    }
    while (result.size() > number_of_borders && !is_valid(result))
      result.pop_back();
    for (std::size_t i = m_random.index(8); i > 0; --i)
    {
      std::vector<Item> more = result;
      more.push_back(m_random.index(2) == 0 ? handle() : ball());
      if (!more.back().vertices.empty() && is_valid(more))
        result = more;
    }
    return is_valid(result) ? result : std::vector<Item>();
  }

  // a closed walk through the edge of an arbitrary pair of neighbors along a breadth-first tree
  // that is a valid loop on the closed surface; without vertices if none was found
  Item handle()
  {
    const Vertex root = vertex();
    std::vector<int> parent(num_vertices(m_mesh), -1);
    std::vector<Vertex> reached = {root};
    parent[root] = static_cast<int>(root);
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (Vertex v : neighbors(reached[i]))
        if (parent[v] < 0)
        {
          parent[v] = static_cast<int>(reached[i]);
          reached.push_back(v);
        }
    for (int attempt = 0; attempt < 30; ++attempt)
    {
      const Vertex u = vertex(), v = neighbor(u);
      Item result = {Item::CYCLE, cycle(parent, u, v), height()};
      if (result.vertices.size() > 3 && is_possible_alone(result))
        return result;
    }
    return {Item::CYCLE, {}, 1};
  }

  double height() { return std::pow(10., m_random.between(-3, 3)); }

  Vertex neighbor(Vertex v)
  {
    const std::vector<Vertex> all = neighbors(v);
    return all[m_random.index(all.size())];
  }

  // every third pole is next to another; every third has a loop of its own
  Item pole(const std::vector<Item>& others)
  {
    Vertex v = vertex();
    if (!others.empty() && m_random.index(3) == 0)
      v = neighbor(
        Vertex(static_cast<Mesh::size_type>(others[m_random.index(others.size())].vertices[0])));
    const std::size_t rings = m_random.index(3) == 0 ? 1 + m_random.index(5) : 0;
    Item result = {Item::POLE, {v}, height()};
    result.rings = static_cast<unsigned int>(rings);
    return result;
  }

  // the vertices reached first by a breadth-first search
  Item ball()
  {
    std::vector<Vertex> reached = {vertex()};
    std::set<Vertex> seen(reached.begin(), reached.end());
    const std::size_t size = 1 + m_random.index(num_vertices(m_mesh) / 2);
    for (std::size_t i = 0; i < reached.size() && reached.size() < size; ++i)
      for (Vertex v : neighbors(reached[i]))
        if (seen.insert(v).second)
          reached.push_back(v);
    return {Item::SET, std::vector<std::size_t>(reached.begin(), reached.end()), height()};
  }

  bool is_valid(const std::vector<Item>& items) const
  {
    try
    {
      return SMF::validate(m_mesh, poles_and_loops(items, m_mesh)).empty();
    }
    catch (const SMF::Invalid_loops_exception&)
    {
      return false;
    }
  }

private:
  Vertex vertex()
  {
    return Vertex(static_cast<Mesh::size_type>(m_random.index(num_vertices(m_mesh))));
  }

  std::vector<Vertex> neighbors(Vertex v) const
  {
    const auto range = CGAL::vertices_around_target(v, m_mesh);
    return std::vector<Vertex>(range.begin(), range.end());
  }

  Item line_pole()
  {
    Item result = {Item::LINE_POLE, {vertex()}, height()};
    for (std::size_t i = m_random.index(5); i > 0; --i)
      result.vertices.push_back(
        neighbor(Vertex(static_cast<Mesh::size_type>(result.vertices.back()))));
    return result;
  }

  // all openings, which have to be poles
  std::vector<Item> borders()
  {
    std::vector<Item> result;
    for (const auto h : border_halfedges(m_mesh))
      result.push_back({Item::BORDER, {static_cast<std::size_t>(target(h, m_mesh))}, height()});
    return result;
  }

  // essential without other poles than openings, which is much more than what may be valid with
  // poles
  bool is_possible_alone(const Item& item)
  {
    std::vector<Item> items = borders();
    items.push_back(item);
    return is_valid(items);
  }

  static std::vector<std::size_t> cycle(const std::vector<int>& parent, Vertex u, Vertex v)
  {
    std::vector<std::size_t> from_u = path(parent, u), from_v = path(parent, v);
    while (from_u.size() > 1 && from_v.size() > 1 &&
           from_u[from_u.size() - 2] == from_v[from_v.size() - 2])
    {
      from_u.pop_back();
      from_v.pop_back();
    }
    from_v.pop_back();
    from_u.insert(from_u.end(), from_v.rbegin(), from_v.rend());
    return from_u;
  }

  static std::vector<std::size_t> path(const std::vector<int>& parent, Vertex v)
  {
    std::vector<std::size_t> result = {static_cast<std::size_t>(v)};
    while (parent[result.back()] != static_cast<int>(result.back()))
      result.push_back(static_cast<std::size_t>(parent[result.back()]));
    return result;
  }

  const Mesh& m_mesh;
  Random& m_random;
};

inline std::string to_string(const std::vector<Item>& items)
{
  std::ostringstream out;
  for (const Item& item : items)
  {
    out << (item.kind == Item::POLE        ? "pole"
            : item.kind == Item::LINE_POLE ? "line"
            : item.kind == Item::BORDER    ? "border"
            : item.kind == Item::CYCLE     ? "cycle"
                                           : "set");
    out << "(" << item.vertices.size() << ":" << item.vertices[0] << ") rings " << item.rings
        << " height " << item.height << "; ";
  }
  return out.str();
}

// splits some faces into three, which gives vertices of degree three
inline void split_random_faces(Mesh& mesh, Random& random)
{
  for (std::size_t i = 1 + random.index(10); i > 0; --i)
  {
    const auto f = Mesh::Face_index(static_cast<Mesh::size_type>(random.index(num_faces(mesh))));
    const auto h = halfedge(f, mesh);
    const auto middle = CGAL::centroid(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                       mesh.point(target(next(h, mesh), mesh)));
    mesh.point(target(CGAL::Euler::add_center_vertex(h, mesh), mesh)) = middle;
  }
}

// A small mesh of random genus and quality.
inline Mesh random_mesh(Random& random)
{
  const std::uint64_t seed = random.index(1000000);
  Mesh result;
  switch (random.index(8))
  {
  case 0:
    result = icosphere(static_cast<int>(2 + random.index(3)));
    break;
  case 1:
    result = torus(8 + random.index(20), 6 + random.index(12), 3, 1);
    break;
  case 2:
    result = limbed_sphere(3 + random.index(4), 3);
    break;
  case 3:
    result = handle_surface(1 + random.index(12), seed);
    break;
  case 4:
    result = tetrahedron();
    break;
  case 5:
    result = octahedron();
    break;
  default:
    result = genus_surface(random.index(13), 1 + random.index(3), seed);
    break;
  }
  if (random.index(2) == 0)
    result = noisy(result, random.between(0, 0.3), seed);
  if (random.index(3) == 0)
    result = flip_random_edges(result, random.between(0, 0.3), seed);
  if (random.index(4) == 0)
    split_random_faces(result, random);
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_RANDOM_SYSTEMS_H
