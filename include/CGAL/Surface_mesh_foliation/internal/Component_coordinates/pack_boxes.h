// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_PACK_BOXES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_PACK_BOXES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Boxes without overlap in a square.
struct Packed_boxes
{
  std::vector<std::array<double, 2>> corners; // the lower left ones
  double side = 0; // of the square, whose lower left corner is the origin
};

// Places boxes, in the given order, in rows of a given width, with gaps between them and around
// them.
inline Packed_boxes place_in_rows(const std::vector<std::array<double, 2>>& sizes,
                                  const std::vector<std::size_t>& order,
                                  double width,
                                  double gap)
{
  Packed_boxes result = {std::vector<std::array<double, 2>>(sizes.size()), 0};
  double x = gap, y = gap, height_of_row = 0;
  for (const std::size_t i : order)
  {
    if (x > gap && x + sizes[i][0] + gap > width)
    {
      x = gap;
      y += height_of_row + gap;
      height_of_row = 0;
    }
    result.corners[i] = {x, y};
    x += sizes[i][0] + gap;
    height_of_row = (std::max)(height_of_row, sizes[i][1]);
    result.side = (std::max)({result.side, x, y + height_of_row + gap});
  }
  return result;
}

// Places boxes in rows, the highest first, in the smallest of several squares that are tried. If
// there are at most a few hundred boxes, so that gaps do not outweigh them, its side is at most
// about three times that of a square of the same area or of the largest box. Equal boxes are
// ordered by their numbers.
inline Packed_boxes pack_boxes(const std::vector<std::array<double, 2>>& sizes)
{
  constexpr int number_of_trials = 16;
  constexpr double relative_gap = 1. / 128;
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return sizes[i][1] > sizes[j][1]; });
  double area = 0, largest = 0;
  for (const std::array<double, 2>& size : sizes)
  {
    area += size[0] * size[1];
    largest = (std::max)({largest, size[0], size[1]});
  }
  const double least_side = (std::max)(largest, std::sqrt(area));
  const double gap = relative_gap * least_side;
  Packed_boxes best;
  for (int i = 0; i <= number_of_trials; ++i)
  {
    const double width = least_side * (1 + static_cast<double>(i) / number_of_trials) + 2 * gap;
    const Packed_boxes packed = place_in_rows(sizes, order, width, gap);
    if (i == 0 || packed.side < best.side)
      best = packed;
  }
  return best;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMPONENT_COORDINATES_PACK_BOXES_H
