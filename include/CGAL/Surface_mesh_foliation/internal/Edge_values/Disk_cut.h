// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_DISK_CUT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_DISK_CUT_H

#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The edges along which a closed mesh is cut open into a disk with given vertices on its boundary
// [5.2.2].
//
// The paths to a root in a tree of shortest paths join all these vertices, which is enough on a
// sphere. Otherwise the greedy homotopy basis of Erickson and Whittlesey at the root is added:
// given this tree, take a maximal spanning tree of the faces over the other edges, where the weight
// of an edge is the length of the loop that it closes; 2g edges remain, and their loops cut the
// mesh into a disk.
class Disk_cut
{
public:
  // Precondition: `vertices` is not empty; the first is the root.
  Disk_cut(const Flat_mesh& mesh, const std::vector<int>& vertices)
    : m_mesh(mesh), m_is_cut(mesh.number_of_edges(), false)
  {
    find_shortest_paths(vertices[0]);
    for (int v : vertices)
      cut_path(v);
    if (mesh.genus() > 0)
      cut_greedy_loops();
  }

  bool is_cut(int e) const { return m_is_cut[e]; }

private:
  struct Weighted_edge
  {
    int edge;
    double weight;
  };
  using Graph = boost::
    adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Weighted_edge>;

  double length(int e) const
  {
    return distance(m_mesh.point(m_mesh.source(halfedge_of(e))),
                    m_mesh.point(m_mesh.target(halfedge_of(e))));
  }

  void find_shortest_paths(int root)
  {
    Graph graph(m_mesh.number_of_vertices());
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      add_edge(m_mesh.source(halfedge_of(e)), m_mesh.target(halfedge_of(e)), {e, length(e)}, graph);
    const auto index = get(boost::vertex_index, graph);
    m_predecessor.resize(m_mesh.number_of_vertices());
    m_distance.resize(m_mesh.number_of_vertices());
    boost::dijkstra_shortest_paths(
      graph, root,
      boost::weight_map(get(&Weighted_edge::weight, graph))
        .predecessor_map(boost::make_iterator_property_map(m_predecessor.begin(), index))
        .distance_map(boost::make_iterator_property_map(m_distance.begin(), index)));
  }

  int predecessor(int v) const { return static_cast<int>(m_predecessor[v]); }
  int tree_edge(int v) const { return edge_of(m_mesh.find_halfedge(v, predecessor(v))); }

  // where a path meets one that is cut already, its rest is, too
  void cut_path(int v)
  {
    for (; predecessor(v) != v && !m_is_cut[tree_edge(v)]; v = predecessor(v))
      m_is_cut[tree_edge(v)] = true;
  }

  void cut_greedy_loops()
  {
    std::vector<bool> is_in_tree(m_mesh.number_of_edges(), false);
    for (int v = 0; v < m_mesh.number_of_vertices(); ++v)
      if (predecessor(v) != v)
        is_in_tree[tree_edge(v)] = true;
    Graph dual(m_mesh.number_of_faces());
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (!is_in_tree[e])
        add_edge(m_mesh.face(halfedge_of(e)), m_mesh.face(opposite_of(halfedge_of(e))),
                 {e, -(m_distance[m_mesh.source(halfedge_of(e))] + length(e) +
                       m_distance[m_mesh.target(halfedge_of(e))])},
                 dual);
    std::vector<Graph::edge_descriptor> cotree;
    boost::kruskal_minimum_spanning_tree(dual, std::back_inserter(cotree),
                                         boost::weight_map(get(&Weighted_edge::weight, dual)));
    std::vector<bool> is_in_cotree(m_mesh.number_of_edges(), false);
    for (const auto& edge : cotree)
      is_in_cotree[dual[edge].edge] = true;
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      if (!is_in_tree[e] && !is_in_cotree[e])
      {
        m_is_cut[e] = true;
        cut_path(m_mesh.source(halfedge_of(e)));
        cut_path(m_mesh.target(halfedge_of(e)));
      }
  }

  const Flat_mesh& m_mesh;
  std::vector<bool> m_is_cut;                          // by edge
  std::vector<Graph::vertex_descriptor> m_predecessor; // in the tree; of the root itself
  std::vector<double> m_distance;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_EDGE_VALUES_DISK_CUT_H
