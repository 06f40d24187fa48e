// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_BINARY_CURSOR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_BINARY_CURSOR_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/mesh_file_records.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// which byte of a number comes first
enum class Byte_order { LITTLE, BIG };

inline Byte_order byte_order_of_host()
{
  const std::uint16_t one = 1;
  unsigned char first_byte;
  std::memcpy(&first_byte, &one, 1);
  return first_byte == 1 ? Byte_order::LITTLE : Byte_order::BIG;
}

// walks over the numbers of a binary file. The data must outlive the cursor.
class Binary_cursor
{
public:
  // `data` is the end of the file, which has `file_size` bytes
  Binary_cursor(std::string file_name,
                std::string_view data,
                std::size_t file_size,
                Byte_order byte_order)
    : m_file_name(std::move(file_name)),
      m_data(data),
      m_file_size(file_size),
      m_byte_order(byte_order)
  {}

  template <class Number>
  Number next(const Record& record)
  {
    m_offset_of_number = m_file_size - m_data.size();
    std::array<char, sizeof(Number)> bytes;
    if (m_data.size() < bytes.size())
      throw_file_problem(place(), "unexpected end of file in " + record.name());
    std::copy_n(m_data.begin(), bytes.size(), bytes.begin());
    m_data.remove_prefix(bytes.size());
    if (m_byte_order != byte_order_of_host())
      std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
  }

  void skip(std::size_t number_of_bytes, const Record& record)
  {
    m_offset_of_number = m_file_size - m_data.size();
    if (m_data.size() < number_of_bytes)
      throw_file_problem(place(), "unexpected end of file in " + record.name());
    m_data.remove_prefix(number_of_bytes);
  }

  std::string_view remaining_data() const { return m_data; }

  // the place of the last number in the file, for messages
  std::string place() const
  {
    return m_file_name + ": byte " + std::to_string(m_offset_of_number) + ": ";
  }

  [[noreturn]] void fail(const std::string& what) const { throw_file_problem(place(), what); }

private:
  std::string m_file_name;
  std::string_view m_data; // the part that has not been read yet
  std::size_t m_file_size;
  std::size_t m_offset_of_number = 0;
  Byte_order m_byte_order;
};

// `source` serves only to tell the place in the file.
template <class Source>
void check_coordinate_is_finite(const Source& source, double coordinate, std::size_t vertex)
{
  if (!std::isfinite(coordinate))
    throw Invalid_mesh_exception(problem(Problem_kind::NOT_FINITE, source.place(),
                                         vertex_name(vertex),
                                         " has a coordinate that is not finite")
                                   .vertices({vertex}));
}

// three numbers of type float
inline std::array<double, 3> read_float_point(Binary_cursor& cursor, std::size_t vertex)
{
  std::array<double, 3> point;
  for (double& coordinate : point)
  {
    coordinate = static_cast<double>(cursor.next<float>({"vertex", vertex}));
    check_coordinate_is_finite(cursor, coordinate, vertex);
  }
  return point;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_BINARY_CURSOR_H
