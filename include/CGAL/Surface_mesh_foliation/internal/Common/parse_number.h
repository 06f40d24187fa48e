// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARSE_NUMBER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARSE_NUMBER_H

#include <charconv>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

enum class Parse_status {
  OK,
  NOT_A_NUMBER, // the token is not, or not only, a number of the wanted type
  OUT_OF_RANGE  // a number that does not fit the type
};

// reads the whole token as a number, independently of the locale. `Number` is `double` or an
// integer type; `inf` and `nan` are numbers of type `double`.
template <class Number>
Parse_status parse_number(std::string_view token, Number& number)
{
  // std::from_chars() knows no plus sign
  if (token.size() > 1 && token[0] == '+' && token[1] != '-')
    token.remove_prefix(1);
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, number);
  if (result.ec == std::errc::invalid_argument || result.ptr != end)
    return Parse_status::NOT_A_NUMBER;
  return result.ec == std::errc() ? Parse_status::OK : Parse_status::OUT_OF_RANGE;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARSE_NUMBER_H
