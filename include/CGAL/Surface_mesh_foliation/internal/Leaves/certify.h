// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_CERTIFY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_CERTIFY_H

#include <CGAL/Surface_mesh_foliation/internal/Common/compiled.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Extraction.h>

#include <vector>

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES
#include <CGAL/Surface_mesh_foliation/internal/Leaves/essential_leaf.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Singular_places.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <algorithm>
#include <string>
#include <utility>
#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Proves, in time O(n log n), that a foliation has the class of its loops and that the graph
// extracted from it is the dual graph of the loop system. Independent evidence for each point:
//  - no singularity lies inside an arc, and only poles have a positive index; the indices of each
//    node add up to twice the Euler characteristic of its region;
//  - the middle leaf of each arc is freely homotopic to the loop, in the surface minus its poles;
//  - the graph of critical leaves and components, made from the connectivity of the refined mesh
//    alone, agrees with the dual graph arc by arc, and every component is an annulus.
// Returns what is wrong: nothing if the foliation is certified.
CGAL_SURFACE_MESH_FOLIATION_INLINE std::vector<Problem> certify(const Foliation_state& state,
                                                                const Extraction& extraction);

#if CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

// Finds what is wrong with a foliation and with what was extracted from it; see `certify()`.
// Letters, words and frames: see the glossary in ARCHITECTURE.md.
class Certification
{
public:
  Certification(const Foliation_state& state, const Extraction& extraction)
    : m_state(state),
      m_singular_places(extraction.singular_places),
      m_refined(extraction.refined_mesh),
      m_graph(extraction.leaf_graph),
      m_middle_leaves(extraction.middle_leaves)
  {
    check_singularities();
    check_index_sums();
    check_arcs();
    check_middle_leaves();
    check_graph();
  }

  std::vector<Problem>&& problems() && { return std::move(m_problems); }

private:
  void fail(const std::string& message, Indices vertices = {}, Indices loops = {})
  {
    m_problems.push_back(problem(Problem_kind::CERTIFICATE_FAILURE, "not certified: ", message)
                           .vertices(std::move(vertices))
                           .loops(std::move(loops)));
  }

  const Flat_loop_system& system() const { return m_state.system(); }

  void check_singularities()
  {
    for (const Singular_place& place : m_singular_places)
      if (place.index > 0 && (place.is_face || !m_state.is_fixed(place.place)))
        fail(text("vertex ", place.place, " is a pole of index ", place.index,
                  " that is not among the poles given"),
             {index(place.place)});
  }

  // of the critical leaf of a region [3.1]
  void check_index_sums()
  {
    std::vector<int> sum(system().nodes.size(), 0);
    for (const Singular_place& place : m_singular_places)
      sum[place.node] += place.index;
    for (std::size_t r = 0; r < sum.size(); ++r)
      if (sum[r] != 2 * system().nodes[r].euler_characteristic)
        fail(text("the indices at node ", r, " add up to ", sum[r], " instead of ",
                  2 * system().nodes[r].euler_characteristic));
  }

  void check_arcs()
  {
    for (int v : vertices_singular_in_arcs(m_state))
      fail(text("vertex ", v, " is singular inside arc ", m_state.arc(v)), {index(v)},
           {index(m_state.arc(v))});
  }

  void check_middle_leaves()
  {
    const std::vector<double> levels = middle_levels(system());
    for (int a = 0; a < system().number_of_arcs(); ++a)
      if (number_of_leaves_like_loop(a, m_middle_leaves[a], levels[a]) != 1)
        fail(text("the middle leaf of arc ", a, " is not homotopic to its loop"), {}, {index(a)});
  }

  // -1 if there is a leaf that is homotopic neither to the loop nor to a point
  int number_of_leaves_like_loop(int arc,
                                 const std::vector<Leaf_crossing>& crossings,
                                 double level) const
  {
    int like_loop = 0, others = 0;
    for_each_leaf(m_state, crossings, level, [&](const std::vector<Leaf_crossing>& leaf) {
      const Group_word translation = translation_of(m_state, leaf);
      const bool is_like_loop = is_translation_of(arc, leaf[0], translation);
      like_loop += is_like_loop;
      others += !is_like_loop && !group().are_equal(translation, {});
    });
    return others == 0 ? like_loop : -1;
  }

  const Surface_group& group() const { return m_state.deck().group(); }

  // Whether a leaf's deck translation is that of the lift of the loop along which it runs, in
  // either direction; the names of lifts are the conjugates of the loop's translation.
  bool is_translation_of(int arc,
                         const Leaf_crossing& crossing,
                         const Group_word& translation) const
  {
    Group_word name;
    if (group().is_abelian())
      for (const Flat_crossing& c : system().loops[arc].crossings)
        name = group().product(name, m_state.deck().element(c.halfedge));
    else
      name = m_state.name_of_cell(crossing.halfedge, crossing.cell);
    return group().are_equal(translation, name) || group().are_equal(translation, inverse(name));
  }

  void check_graph()
  {
    const int number_of_nodes = static_cast<int>(system().nodes.size());
    std::vector<int> node_of_leaf(m_graph.number_of_leaves(), -1);
    std::vector<bool> is_met(number_of_nodes, false);
    for (std::size_t v = 0; v < m_refined.node.size(); ++v)
    {
      const int leaf = m_graph.leaf_of_vertex(static_cast<int>(v)), node = m_refined.node[v];
      if (leaf < 0)
        continue;
      if (node == Refined_mesh::NONE)
        return fail(text("vertex ", v, " of a critical leaf lies at no node"));
      if (node_of_leaf[leaf] < 0 && !is_met[node])
        is_met[node_of_leaf[leaf] = node] = true;
      else if (node_of_leaf[leaf] != node)
        return fail(
          text("the critical leaf of node ", node, " is not connected, or meets another"));
    }
    if (m_graph.number_of_leaves() != number_of_nodes)
      return fail(text("there are ", m_graph.number_of_leaves(), " critical leaves for ",
                       number_of_nodes, " nodes"));
    if (static_cast<int>(m_graph.components().size()) != system().number_of_arcs())
      return fail(text("there are ", m_graph.components().size(), " components for ",
                       system().number_of_arcs(), " loops"));
    std::vector<bool> is_arc_met(system().number_of_arcs(), false);
    for (const Leaf_graph::Component& component : m_graph.components())
      check_component(component, node_of_leaf, is_arc_met);
    for (std::size_t f = 0; f < m_refined.faces.size(); ++f)
      check_label(static_cast<int>(f));
  }

  void check_component(const Leaf_graph::Component& component,
                       const std::vector<int>& node_of_leaf,
                       std::vector<bool>& is_arc_met)
  {
    const int arc = m_refined.faces[component.first_face].arc;
    if (arc == Refined_mesh::NONE)
      return fail("a component lies in no arc");
    if (is_arc_met[arc])
      return fail(text("arc ", arc, " has several components"), {}, {index(arc)});
    is_arc_met[arc] = true;
    if (component.euler_characteristic != 0 || component.ends.size() != 2)
      return fail(text("the component of arc ", arc, " is not an annulus: Euler characteristic ",
                       component.euler_characteristic, ", ", component.ends.size(), " ends"),
                  {}, {index(arc)});
    std::vector<int> found, expected;
    for (int end : {0, 1})
    {
      found.push_back(node_of_leaf[component.ends[end]]);
      expected.push_back(system().node_of_end(arc, end));
    }
    if (!std::is_permutation(found.begin(), found.end(), expected.begin()))
      fail(text("arc ", arc, " joins nodes ", found[0], " and ", found[1], " instead of ",
                expected[0], " and ", expected[1]),
           {}, {index(arc)});
  }

  // all faces of a component carry its arc
  void check_label(int f)
  {
    const int component = m_graph.component_of_face(f);
    const int expected = component < 0
                           ? Refined_mesh::NONE
                           : m_refined.faces[m_graph.components()[component].first_face].arc;
    if (m_refined.faces[f].arc != expected)
      fail(text("a part of face ", m_refined.faces[f].origin, " lies in a wrong component"));
  }

  const Foliation_state& m_state;
  const std::vector<Singular_place>& m_singular_places;
  const Refined_mesh& m_refined;
  const Leaf_graph& m_graph;
  const std::vector<std::vector<Leaf_crossing>>& m_middle_leaves;
  std::vector<Problem> m_problems;
};

CGAL_SURFACE_MESH_FOLIATION_INLINE std::vector<Problem> certify(const Foliation_state& state,
                                                                const Extraction& extraction)
{
  return Certification(state, extraction).problems();
}

#endif // CGAL_SURFACE_MESH_FOLIATION_HAS_BODIES

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_CERTIFY_H
