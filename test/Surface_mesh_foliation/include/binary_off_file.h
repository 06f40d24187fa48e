// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_BINARY_OFF_FILE_H
#define SMF_TEST_BINARY_OFF_FILE_H

#include "big_and_little_endian.h"

#include <CGAL/Surface_mesh_foliation/IO/Triangle_soup.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace smf_test {

// a tetrahedron; each vertex has so many numbers after its coordinates, and each face a color of as
// many numbers as its index says
inline std::string binary_off(const std::string& header, int number_of_attributes)
{
  const CGAL::Surface_mesh_foliation::Triangle_soup tetrahedron = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  std::string text = header;
  for (const int count : {4, 4, 0})
    text += big_endian_bytes(std::int32_t(count));
  for (const std::array<double, 3>& point : tetrahedron.points)
  {
    for (const double coordinate : point)
      text += big_endian_bytes(static_cast<float>(coordinate));
    for (int i = 0; i < number_of_attributes; ++i)
      text += big_endian_bytes(0.25f);
  }
  std::int32_t color_size = 0;
  for (const std::array<std::size_t, 3>& triangle : tetrahedron.triangles)
  {
    text += big_endian_bytes(std::int32_t(3));
    for (const std::size_t corner : triangle)
      text += big_endian_bytes(static_cast<std::int32_t>(corner));
    text += big_endian_bytes(color_size);
    for (std::int32_t i = 0; i < color_size; ++i)
      text += big_endian_bytes(0.5f);
    ++color_size;
  }
  return text;
}

} // namespace smf_test

#endif // SMF_TEST_BINARY_OFF_FILE_H
