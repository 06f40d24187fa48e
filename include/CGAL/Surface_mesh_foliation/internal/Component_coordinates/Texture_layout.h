// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_TEXTURE_LAYOUT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_TEXTURE_LAYOUT_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Sum.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/dirichlet_energies.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/pack_boxes.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/component_labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The charts of all components side by side in the unit square, at the same scale.
//
// A chart of height k and circumference c is stretched along both axes to lengths on the surface.
// Their product is the area A of the component. Their quotient is that of k and the circumference
// D / k that a conformal map with the same t would have, D being the Dirichlet energy of t: then
// the integrals of the squared gradient of t and of the Jacobian agree, whatever the weights are.
class Texture_layout
{
public:
  // from u and t to texture coordinates: origin + scale * (u, t)
  struct Chart
  {
    std::array<double, 2> origin, scale;
    std::array<double, 2> lower, upper; // corners of its box
  };

  Texture_layout(const Component_layout& layout,
                 const std::vector<double>& height,
                 const std::vector<double>& flux)
    : m_charts(height.size())
  {
    stretch(layout.nodes(), height, flux);
    find_ranges(layout, height);
    pack();
  }

  const Chart& chart(std::size_t arc) const { return m_charts[arc]; }

  // the length on the surface that the side of the square stands for
  double side() const { return m_side; }

private:
  // lengths for units of u and t; if they cannot be determined, because all faces are degenerate,
  // those of the foliation are kept
  void stretch(const Corner_nodes& nodes,
               const std::vector<double>& height,
               const std::vector<double>& flux)
  {
    const std::vector<double> energy = dirichlet_energies(nodes, height.size());
    std::vector<Sum> area(height.size());
    for (const Refined_mesh::Face& face : nodes.refined().faces)
      if (face.arc != Refined_mesh::NONE)
        area[face.arc].add(area_of_face(nodes.refined(), face, 1));
    for (std::size_t a = 0; a < height.size(); ++a)
    {
      const double length = std::sqrt(area[a].value());
      const double slimness = std::sqrt(energy[a]) / height[a]; // the root of (D / k) / k
      const std::array<double, 2> scale = {length * slimness / flux[a],
                                           length / slimness / height[a]};
      const bool is_known = is_positive(scale[0]) && is_positive(scale[1]);
      m_charts[a].scale = is_known ? scale : std::array<double, 2>{1, 1};
    }
  }

  static bool is_positive(double x) { return x > 0 && std::isfinite(x); }

  // the boxes in u and t
  void find_ranges(const Component_layout& layout, const std::vector<double>& height)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t a = 0; a < height.size(); ++a)
    {
      m_charts[a].lower = {infinity, 0};
      m_charts[a].upper = {-infinity, height[a]};
    }
    const Corner_nodes& nodes = layout.nodes();
    for (int h = 0; h < nodes.mesh().number_of_halfedges(); ++h)
      if (const int arc = nodes.arc(h); arc != Corner_nodes::NONE)
        for (const double u : {layout.around_of_source(h), layout.around_of_target(h)})
        {
          Chart& chart = m_charts[arc];
          chart.lower[0] = (std::min)(chart.lower[0], u);
          chart.upper[0] = (std::max)(chart.upper[0], u);
        }
  }

  void pack()
  {
    std::vector<std::array<double, 2>> sizes;
    for (const Chart& chart : m_charts)
      sizes.push_back({(chart.upper[0] - chart.lower[0]) * chart.scale[0],
                       (chart.upper[1] - chart.lower[1]) * chart.scale[1]});
    const Packed_boxes packed = pack_boxes(sizes);
    m_side = packed.side;
    for (std::size_t a = 0; a < m_charts.size(); ++a)
      for (std::size_t i : {0, 1})
      {
        Chart& chart = m_charts[a];
        chart.scale[i] /= m_side;
        chart.origin[i] = packed.corners[a][i] / m_side - chart.scale[i] * chart.lower[i];
        chart.lower[i] = chart.origin[i] + chart.scale[i] * chart.lower[i];
        chart.upper[i] = chart.origin[i] + chart.scale[i] * chart.upper[i];
      }
  }

  std::vector<Chart> m_charts; // by arc
  double m_side = 0;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_TEXTURE_LAYOUT_H
