// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_TEXT_OUTPUT_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_TEXT_OUTPUT_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <array>
#include <charconv>
#include <ios>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// enough digits to get every double back from its text
constexpr int number_of_digits = 17;

// For standard libraries whose std::to_chars() knows integers only; slow.
inline void append_by_stream(std::string& text, double number)
{
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(number_of_digits);
  stream << number;
  text += stream.str();
}

// appends a number independently of the locale
inline void append_number(std::string& text, double number)
{
#ifdef __cpp_lib_to_chars
  std::array<char, 32> buffer;
  const std::to_chars_result result =
    std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, std::chars_format::general,
                  number_of_digits);
  text.append(buffer.data(), result.ptr);
#else
  append_by_stream(text, number);
#endif
}

// `output_name` is the name of the file, or of whatever else is written to
inline void check_output(const std::ostream& output, const std::string& output_name)
{
  if (!output)
    throw_file_problem(output_name, ": cannot be written");
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_TEXT_OUTPUT_H
