// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_STL_FILES_H
#define SMF_TEST_STL_FILES_H

#include "big_and_little_endian.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

// STL files of triangles.

namespace smf_test {

// the coordinates of the corners of triangles
using Stl_corners = std::vector<std::array<std::array<float, 3>, 3>>;

// in the order of tetrahedron_faces
inline Stl_corners tetrahedron_stl_corners()
{
  const std::array<float, 3> o = {0, 0, 0}, x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  return {{{o, y, x}}, {{o, x, z}}, {{x, y, z}}, {{o, z, y}}};
}

inline std::string ascii_stl(const Stl_corners& faces)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(std::numeric_limits<float>::max_digits10);
  out << "solid t\n";
  for (const auto& corners : faces)
  {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const auto& [x, y, z] : corners)
      out << "vertex " << x << ' ' << y << ' ' << z << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid t\n";
  return out.str();
}

// with normals that are not numbers, and an attribute
inline std::string binary_stl(const Stl_corners& faces, std::string comment = {})
{
  constexpr std::size_t comment_size = 80;
  comment.resize(comment_size);
  std::string text = comment + little_endian_bytes(static_cast<std::uint32_t>(faces.size()));
  for (const auto& corners : faces)
  {
    for (int i = 0; i < 3; ++i)
      text += little_endian_bytes(std::numeric_limits<float>::quiet_NaN());
    for (const auto& corner : corners)
      for (const float coordinate : corner)
        text += little_endian_bytes(coordinate);
    text += little_endian_bytes(std::uint16_t(0xabcd));
  }
  return text;
}

} // namespace smf_test

#endif // SMF_TEST_STL_FILES_H
