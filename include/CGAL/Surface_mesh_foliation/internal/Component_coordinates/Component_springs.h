// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_SPRINGS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_SPRINGS_H

#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_seams.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Corner_nodes.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/dirichlet_energies.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The springs between the nodes of the components; their equilibrium is the coordinate u.
//
// An edge of the mesh with weight alpha and foliation value w is a chain of parts, one for each arc
// that it passes. A part of length l in T gets the strength alpha w / l, so that the flux alpha w
// through all parts of an edge is the same: t, with its ends held, is in equilibrium with these
// springs at every vertex inside an arc, exactly as the foliation is. The diagonals that cut pieces
// of faces into triangles have no spring.
//
// Along the boundary, sides have springs, too, without which the nodes there would collapse. They
// keep distances: the length of a side is, in smooth terms, that of the side times the gradient of
// t, which is the differential of the conjugate coordinate. Around a pole it is the angle. The
// springs of one end have the same tension at these lengths, so that they do not pull when the
// nodes are in their right places; they are as strong as a strip of the height of the component
// would be.
class Component_springs
{
public:
  // between source and target of a side of a face, as seen in this face
  struct Spring
  {
    int source_node, target_node;
    int turns; // how often the seam is passed from source to target, to its left side
    double strength;
    int arc;
  };

  Component_springs(const Foliation_state& state,
                    const std::vector<double>& flux,
                    const Corner_nodes& nodes,
                    const Component_seams& seams)
    : m_state(state), m_arc_flux(flux), m_nodes(nodes), m_seams(seams)
  {
    add_parts_of_edges();
    add_boundaries();
  }

  const std::vector<Spring>& springs() const { return m_springs; }

private:
  // A side of the boundary, and its length around its end, in an arbitrary unit.
  struct Boundary_side
  {
    Spring spring;
    double length;
    int end; // of its arc
  };

  // the edge of the mesh that a side of a refined face is a part of
  int edge_that_holds(int h) const
  {
    const std::vector<int>& edge_of_vertex = m_nodes.refined().edge_of_vertex;
    const int u = m_nodes.mesh().source(h), v = m_nodes.mesh().target(h);
    for (int w : {u, v})
      if (edge_of_vertex[w] != Refined_mesh::NONE)
        return edge_of_vertex[w];
    const int origin = m_nodes.refined().faces[m_nodes.mesh().face(h)].origin;
    for (int g : m_state.mesh().halfedges(origin))
      if (m_state.mesh().source(g) == u && m_state.mesh().target(g) == v)
        return edge_of(g);
    CGAL_assertion_msg(false, "a side of a refined face that is not part of an edge");
    return Refined_mesh::NONE;
  }

  // whether side i of a refined face was added to cut a piece into triangles
  bool is_diagonal(int f, int i) const
  {
    const std::vector<Refined_mesh::Face>& faces = m_nodes.refined().faces;
    const bool is_last =
      f + 1 == static_cast<int>(faces.size()) || faces[f + 1].piece != faces[f].piece;
    return (i == 0 && faces[f].piece != f) || (i == 2 && !is_last);
  }

  Spring spring(int h, double strength) const
  {
    return {m_nodes.node_of_source(h), m_nodes.node_of_target(h),
            m_seams.is_target_left(h) - m_seams.is_source_left(h), strength, m_nodes.arc(h)};
  }

  void add_parts_of_edges()
  {
    const Flat_mesh& mesh = m_nodes.mesh();
    for (int f = 0; f < mesh.number_of_faces(); ++f)
      for (int i : {0, 1, 2})
      {
        const int h = mesh.halfedges(f)[i];
        if (!is_forward(h) || m_nodes.is_critical(h) || is_diagonal(f, i))
          continue;
        const int e = edge_that_holds(h);
        const double part = std::abs(m_nodes.parameter_of_target(h) - m_nodes.parameter(h));
        const double ratio = part > 0 ? length_of_edge(m_state, e) / part : 1;
        m_springs.push_back(
          spring(h, m_state.weight(e) *
                      (m_state.word_size(e) == 0 ? 1 : (std::min)(ratio, largest_ratio))));
      }
  }

  // Sides whose length cannot be determined, in degenerate triangles, get the least or the largest
  // length.
  void add_boundaries()
  {
    const std::vector<Boundary_side> sides = boundary_sides();
    std::vector<std::array<double, 2>> length(m_arc_flux.size(), {0, 0}); // by arc and end
    for (const Boundary_side& side : sides)
      length[side.spring.arc][side.end] += side.length;
    const std::vector<double> conductance = conductances();
    for (const Boundary_side& side : sides)
    {
      const int arc = side.spring.arc;
      const double c = m_arc_flux[arc];
      const double total = length[arc][side.end];
      const double share = total > 0 ? side.length / total : 1;
      m_springs.push_back(side.spring);
      m_springs.back().strength = conductance[arc] * conductance[arc] *
                                  m_state.system().height(arc) /
                                  (std::clamp(share, least_length, 1.) * c);
    }
  }

  std::vector<Boundary_side> boundary_sides() const
  {
    const Flat_mesh& mesh = m_nodes.mesh();
    Corner_geometry corner(mesh);
    std::vector<Boundary_side> result;
    for (int h = 0; h < mesh.number_of_halfedges(); ++h)
    {
      const int arc = m_nodes.arc(h), g = mesh.prev(h);
      if (arc == Refined_mesh::NONE)
        continue;
      const int end = m_nodes.parameter(h) > 0 ? 1 : 0;
      corner.visit(h);
      if (m_nodes.is_critical(h))
      {
        // the side times the gradient of t, which is perpendicular
        const double side = corner.length_of(h),
                     extent = std::abs(m_nodes.parameter(g) - m_nodes.parameter(h));
        result.push_back(
          {spring(h, 0), finite_or_zero(extent * side / (2 * corner.area()) * side), end});
      }
      else if (m_nodes.is_pole(mesh.source(h))) // a part of the circle of the pole
        result.push_back({{m_nodes.node_of_target(g), m_nodes.node_of_source(h),
                           m_seams.is_source_left(h) - m_seams.is_target_left(g), 0, arc},
                          finite_or_zero(2 * std::atan(corner.tangent_of_half())),
                          end});
    }
    return result;
  }

  // By arc, the weights relative to cotangents: the quotient of energies.
  std::vector<double> conductances() const
  {
    const std::vector<double> energy = dirichlet_energies(m_nodes, m_arc_flux.size());
    std::vector<double> result;
    for (std::size_t a = 0; a < energy.size(); ++a)
      result.push_back(energy[a] > 0
                         ? m_state.system().height(static_cast<int>(a)) * m_arc_flux[a] / energy[a]
                         : 1);
    return result;
  }

  // The linear solver cannot tell apart nodes that are tied together more strongly. Sides shorter
  // than this share of the circumference occur on plateaus, where the gradient is rounding noise.
  static constexpr double largest_ratio = 1e8, least_length = 1e-9;

  const Foliation_state& m_state;
  const std::vector<double>& m_arc_flux;
  const Corner_nodes& m_nodes;
  const Component_seams& m_seams;
  std::vector<Spring> m_springs;
};

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_COMPONENT_SPRINGS_H
