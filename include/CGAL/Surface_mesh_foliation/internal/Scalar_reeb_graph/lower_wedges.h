// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_LOWER_WEDGES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_LOWER_WEDGES_H

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Finds where the runs of lower neighbors begin in the counterclockwise cycle of the ranks of the
// neighbors of a vertex; each follows a higher neighbor. The runs are listed counterclockwise,
// first the one with the lowest neighbor, so that the result does not depend on where the cycle is
// cut open.
inline void find_lower_wedges(const std::vector<int>& neighbor_ranks,
                              int rank,
                              std::vector<int>& wedges)
{
  wedges.clear();
  bool is_last_higher = neighbor_ranks.back() > rank;
  for (int i = 0; i < static_cast<int>(neighbor_ranks.size()); ++i)
  {
    const bool is_higher = neighbor_ranks[i] > rank;
    if (is_last_higher && !is_higher)
      wedges.push_back(i);
    is_last_higher = is_higher;
  }
  if (wedges.size() < 2)
    return;
  const auto lowest = std::min_element(neighbor_ranks.begin(), neighbor_ranks.end());
  const auto next = std::upper_bound(wedges.begin(), wedges.end(),
                                     static_cast<int>(lowest - neighbor_ranks.begin()));
  std::rotate(wedges.begin(), next == wedges.begin() ? wedges.end() - 1 : next - 1, wedges.end());
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_LOWER_WEDGES_H
