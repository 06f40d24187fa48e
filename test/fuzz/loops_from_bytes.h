// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_LOOPS_FROM_BYTES_H
#define SMF_FUZZ_LOOPS_FROM_BYTES_H

#include "mesh_from_bytes.h"

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/loops.h>
#include <CGAL/Surface_mesh_foliation/picked_loops.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace smf_fuzz {

using Input = SMF::Poles_and_loops<Mesh>;
using Entry = Input::Entry;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;

// Poles and loops of all kinds on a mesh, as bytes say. Whether they fit together is not looked at.
class Loops_from_bytes
{
public:
  Loops_from_bytes(const Mesh& mesh, FuzzedDataProvider& bytes) : m_mesh(mesh), m_bytes(bytes) {}

  // all openings as poles, mostly
  std::vector<Entry> openings()
  {
    std::vector<Entry> result;
    for (const Halfedge h : smf_test::border_halfedges(m_mesh))
      if (m_bytes.ConsumeIntegral<std::uint8_t>() != 255)
        result.push_back({{}, {}, usual_height(), h});
    return result;
  }

  // May throw what the package throws, and may return several, or none.
  std::vector<Entry> next()
  {
    switch (m_bytes.ConsumeIntegral<std::uint8_t>() % 12)
    {
    case 0: {
      const Vertex v = vertex();
      return {{{v}, SMF::pole_loop(v, m_mesh, 1 + unsigned(index(4))), usual_height()}};
    }
    case 1:
    case 2:
      return {{walk(), {}, usual_height()}};
    case 3:
    case 4:
      return {{{}, SMF::loop_from_edge_cycle(tree_cycle(), m_mesh), usual_height()}};
    case 5:
      return loops(SMF::loop_through_vertices(some_vertices(3 + index(3)), m_mesh));
    case 6:
      return around(ball());
    case 7:
      return around(some_vertices(1 + index(6)));
    case 8:
      return loops(crossings());
    case 9:
      return loops(SMF::plane_section_loop(m_mesh, plane(), vertex()));
    default:
      return {{{vertex()}, {}, usual_height()}};
    }
  }

  double usual_height()
  {
    constexpr std::array<double, 8> heights = {1, 1, 1, 2, 0.3, 1e-3, 1e3, 17};
    return m_bytes.PickValueInArray(heights);
  }
  // far from the usual ones, or wrong
  double odd_height()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array<double, 12> heights = {1e-9,   1e9, 1e-150, 1e150, 1e-308,   5e-324,
                                                1e+308, 0,   -0.0,   -1,    infinity, -infinity};
    return m_bytes.PickValueInArray(heights);
  }

  std::size_t index(std::size_t size) { return m_bytes.ConsumeIntegral<std::uint16_t>() % size; }
  Vertex vertex() { return Vertex(static_cast<Mesh::size_type>(index(num_vertices(m_mesh)))); }
  Vertex neighbor(Vertex v)
  {
    const std::vector<Vertex> all = neighbors(v);
    return all[index(all.size())];
  }

private:
  using Loop = SMF::Loop<Mesh>;

  std::vector<Entry> loops(Loop loop) { return {{{}, std::move(loop), usual_height()}}; }

  std::vector<Entry> around(const std::vector<Vertex>& inside)
  {
    std::vector<Loop> found;
    SMF::loops_around_vertices(inside, m_mesh, std::back_inserter(found));
    std::vector<Entry> result;
    for (Loop& loop : found)
      result.push_back({{}, std::move(loop), usual_height()});
    return result;
  }

  std::vector<Vertex> neighbors(Vertex v) const
  {
    const auto range = CGAL::vertices_around_target(v, m_mesh);
    return std::vector<Vertex>(range.begin(), range.end());
  }

  std::vector<Vertex> some_vertices(std::size_t number)
  {
    std::vector<Vertex> result;
    for (std::size_t i = 0; i < number; ++i)
      result.push_back(vertex());
    return result;
  }

  std::vector<Vertex> walk()
  {
    std::vector<Vertex> result = {vertex()};
    for (std::size_t i = index(5); i > 0; --i)
      result.push_back(neighbor(result.back()));
    return result;
  }

  // the vertices that a breadth-first search reaches first
  std::vector<Vertex> ball()
  {
    tree(vertex(), m_order);
    m_order.resize(1 + index(m_order.size()));
    return m_order;
  }

  // by vertex, the one before it on the way from the root; `order`: vertices as they are reached
  std::vector<Vertex> tree(Vertex root, std::vector<Vertex>& order) const
  {
    std::vector<Vertex> parent(num_vertices(m_mesh), Mesh::null_vertex());
    parent[root] = root;
    order = {root};
    for (std::size_t i = 0; i < order.size(); ++i)
      for (const Vertex v : neighbors(order[i]))
        if (parent[v] == Mesh::null_vertex())
        {
          parent[v] = order[i];
          order.push_back(v);
        }
    return parent;
  }

  // through an edge and along a tree to where its ends come together
  std::vector<Vertex> tree_cycle()
  {
    const std::vector<Vertex> parent = tree(vertex(), m_order);
    const Vertex u = vertex(), v = neighbor(u);
    std::vector<Vertex> from_u = path(parent, u), from_v = path(parent, v);
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

  static std::vector<Vertex> path(const std::vector<Vertex>& parent, Vertex v)
  {
    std::vector<Vertex> result = {v};
    while (parent[result.back()] != result.back())
      result.push_back(parent[result.back()]);
    return result;
  }

  // from face to face, as long as it does not come back; a loop only if it does
  Loop crossings()
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr std::array<double, 12> positions = {0.5,    0.5,       0.5, 0.25, 0.75, 0.1,
                                                  1e-300, 1 - 1e-16, 0,   1,    -0.5, nan};
    Loop result;
    const Halfedge first(static_cast<Mesh::size_type>(index(num_halfedges(m_mesh))));
    Halfedge h = first;
    for (std::size_t i = 3 + index(24); i > 0; --i)
    {
      if (is_border(h, m_mesh))
        break;
      result.push_back({h, m_bytes.PickValueInArray(positions)});
      const Halfedge o = opposite(h, m_mesh);
      if (is_border(o, m_mesh))
        break;
      h = m_bytes.ConsumeBool() ? CGAL::next(o, m_mesh) : CGAL::prev(o, m_mesh);
      if (h == first)
        break;
    }
    return result;
  }

  std::array<double, 4> plane()
  {
    std::array<double, 4> result;
    for (double& coefficient : result)
      coefficient = m_bytes.ConsumeIntegral<std::int8_t>() / 16.;
    return result;
  }

  const Mesh& m_mesh;
  FuzzedDataProvider& m_bytes;
  std::vector<Vertex> m_order;
};

// the mesh as the text of an OFF file, then poles and loops, one a line
inline void print(const Mesh& mesh, const std::vector<Entry>& entries)
{
  std::cerr.precision(17);
  std::cerr << mesh;
  for (const Entry& entry : entries)
  {
    std::cerr << "height " << entry.height;
    if (entry.border != Mesh::null_halfedge())
      std::cerr << " border at " << target(entry.border, mesh).idx();
    for (const Vertex v : entry.pole)
      std::cerr << " pole " << v.idx();
    for (const auto& crossing : entry.loop)
      std::cerr << ' ' << source(crossing.halfedge, mesh).idx() << '-'
                << target(crossing.halfedge, mesh).idx() << " at " << crossing.position;
    std::cerr << std::endl;
  }
}

inline Input to_input(const std::vector<Entry>& entries)
{
  Input result;
  for (const Entry& entry : entries)
    if (entry.border != Mesh::null_halfedge())
      result.add_border_pole(entry.border, entry.loop, entry.height);
    else if (entry.pole.empty())
      result.add_loop(entry.loop, entry.height);
    else
      result.add_line_pole(entry.pole, entry.loop, entry.height);
  return result;
}

} // namespace smf_fuzz

#endif // SMF_FUZZ_LOOPS_FROM_BYTES_H
