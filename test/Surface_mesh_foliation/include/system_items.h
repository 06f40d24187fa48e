// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_SYSTEM_ITEMS_H
#define SMF_TEST_SYSTEM_ITEMS_H

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/loops.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

// The poles and loops of a scenario by the positions of their vertices, so that they can be put on
// a mesh of any type, and be carried to a relabeled mesh.

namespace smf_test {

namespace SMF = CGAL::Surface_mesh_foliation;

struct Item
{
  enum Kind { POLE, LINE_POLE, BORDER, CYCLE, SET, PLANE };
  Kind kind;
  std::vector<std::size_t> vertices; // PLANE: the vertex that the curve is near to; BORDER: one
  double height = 1;
  std::array<double, 4> plane = {};
  unsigned int rings = 0; // of a pole with a loop of its own
};

template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertex_list(
  const TriangleMesh& mesh)
{
  const auto range = vertices(mesh);
  return {range.begin(), range.end()};
}

template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void add_item(const Item& item,
              const TriangleMesh& mesh,
              SMF::Poles_and_loops<TriangleMesh>& result,
              const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto all = vertex_list(mesh);
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> chosen;
  for (const std::size_t vertex : item.vertices)
    chosen.push_back(all.at(vertex));
  std::vector<SMF::Loop<TriangleMesh>> loops;
  switch (item.kind)
  {
  case Item::POLE:
    if (item.rings == 0)
      result.add_pole(chosen.at(0), item.height);
    else
      result.add_pole(chosen[0], SMF::pole_loop(chosen.at(0), mesh, item.rings), item.height);
    break;
  case Item::LINE_POLE:
    result.add_line_pole(chosen, item.height);
    break;
  case Item::BORDER:
    for (const auto h : CGAL::halfedges_around_target(chosen.at(0), mesh))
      if (is_border(h, mesh))
        result.add_border_pole(h, item.height);
    break;
  case Item::CYCLE:
    result.add_loop(SMF::loop_from_edge_cycle(chosen, mesh), item.height);
    break;
  case Item::SET:
    SMF::loops_around_vertices(chosen, mesh, std::back_inserter(loops));
    break;
  case Item::PLANE:
    loops.push_back(SMF::plane_section_loop(mesh, item.plane, chosen.at(0), np));
    break;
  }
  for (const auto& loop : loops)
    result.add_loop(loop, item.height);
}

template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
SMF::Poles_and_loops<TriangleMesh> poles_and_loops(
  const std::vector<Item>& items,
  const TriangleMesh& mesh,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  SMF::Poles_and_loops<TriangleMesh> result;
  for (const Item& item : items)
    add_item(item, mesh, result, np);
  return result;
}

// the same on the mesh in which vertex i has become vertex label[i]
inline std::vector<Item> relabeled_items(std::vector<Item> items,
                                         const std::vector<std::size_t>& label)
{
  for (Item& item : items)
    for (std::size_t& vertex : item.vertices)
      vertex = label[vertex];
  return items;
}

} // namespace smf_test

#endif // SMF_TEST_SYSTEM_ITEMS_H
