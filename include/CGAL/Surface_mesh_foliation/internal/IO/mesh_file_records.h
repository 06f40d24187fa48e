// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_MESH_FILE_RECORDS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_MESH_FILE_RECORDS_H

#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

// What the readers of all text formats have in common: numbers and points, read strictly.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// the record a message is about; it is turned into text only when something is wrong
struct Record
{
  const char* kind;
  std::size_t index;

  std::string name() const { return kind + (" " + std::to_string(index)); }
};

[[noreturn]] inline void fail_at_line_end(const Text_cursor& cursor, const Record& record)
{
  cursor.fail(cursor.remaining_text().empty() ? "unexpected end of file in " + record.name()
                                              : record.name() + ": the line ends too early");
}

// reads the next word of the line
template <class Integer>
Integer read_integer(Text_cursor& cursor, const Record& record)
{
  const std::string_view word = cursor.next_word();
  Integer number = 0;
  if (word.empty())
    fail_at_line_end(cursor, record);
  const Parse_status status = parse_number(word, number);
  if (status == Parse_status::NOT_A_NUMBER)
    cursor.fail(record.name() + ": " + quoted(word) + " is not an integer");
  if (status == Parse_status::OUT_OF_RANGE)
    cursor.fail(record.name() + ": " + quoted(word) + " is out of range");
  return number;
}

inline double read_coordinate(Text_cursor& cursor, std::size_t vertex)
{
  const std::string_view word = cursor.next_word();
  double coordinate = 0;
  if (word.empty())
    fail_at_line_end(cursor, {"vertex", vertex});
  const Parse_status status = parse_number(word, coordinate);
  if (status == Parse_status::NOT_A_NUMBER)
    cursor.fail(vertex_name(vertex) + ": " + quoted(word) + " is not a number");
  const auto fail = [&](const char* what) {
    throw Invalid_mesh_exception(problem(Problem_kind::NOT_FINITE, cursor.place(),
                                         vertex_name(vertex), ": the coordinate ", quoted(word),
                                         " ", what)
                                   .vertices({vertex}));
  };
  if (status == Parse_status::OUT_OF_RANGE)
    fail("does not fit a double");
  if (!std::isfinite(coordinate))
    fail("is not finite");
  return coordinate;
}

inline std::array<double, 3> read_point(Text_cursor& cursor, std::size_t vertex)
{
  const double x = read_coordinate(cursor, vertex);
  const double y = read_coordinate(cursor, vertex);
  const double z = read_coordinate(cursor, vertex);
  return {x, y, z};
}

// takes the rest of the line, which must consist of numbers, and returns how many there are
inline std::size_t skip_numbers(Text_cursor& cursor, const Record& record)
{
  std::size_t count = 0;
  double ignored = 0;
  for (; !cursor.is_line_finished(); ++count)
  {
    const std::string_view word = cursor.next_word();
    if (parse_number(word, ignored) == Parse_status::NOT_A_NUMBER)
      cursor.fail(record.name() + ": " + quoted(word) + " is not a number");
  }
  return count;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_MESH_FILE_RECORDS_H
