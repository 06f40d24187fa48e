// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_ARRAYS_H
#define SMF_PYTHON_ARRAYS_H

#include "types.h"

#include <pybind11/numpy.h>

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Arrays of numpy from and to vectors.

namespace smf_python {

// Nothing is rounded to fit: numbers of another kind are refused, with a better message in Python.
// What is not laid out as here is copied.
constexpr int layout = py::array::c_style | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
using Doubles = py::array_t<double, layout>;
using Indices = py::array_t<Index, layout>;

inline void require_shape(const py::array& array, const char* name, py::ssize_t columns)
{
  const bool is_list = columns == 0;
  if (is_list ? array.ndim() != 1 : array.ndim() != 2 || array.shape(1) != columns)
    throw std::invalid_argument(
      std::string(name) + (is_list ? " must have one dimension"
                                   : " must have the shape (n, " + std::to_string(columns) + ")"));
}

// Hands over the memory of a vector: nothing is copied.
template <class T>
py::array_t<T> to_array(std::vector<T>&& values, std::vector<py::ssize_t> shape)
{
  auto owned = std::make_unique<std::vector<T>>(std::move(values));
  T* const data = owned->data();
  const py::capsule owner(owned.get(),
                          [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  owned.release();
  return py::array_t<T>(std::move(shape), data, owner);
}

template <class T>
py::array_t<T> to_array(std::vector<T>&& values)
{
  const auto size = static_cast<py::ssize_t>(values.size());
  return to_array(std::move(values), {size});
}

// as rows of a table
template <class T, std::size_t N>
py::array_t<T> to_array(const std::vector<std::array<T, N>>& rows)
{
  std::vector<T> values;
  values.reserve(N * rows.size());
  for (const std::array<T, N>& row : rows)
    values.insert(values.end(), row.begin(), row.end());
  return to_array(std::move(values),
                  {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(N)});
}

inline py::array_t<double> to_array(const std::vector<Point>& points)
{
  std::vector<double> values;
  values.reserve(3 * points.size());
  for (const Point& p : points)
    for (const int i : {0, 1, 2})
      values.push_back(p[i]);
  return to_array(std::move(values), {static_cast<py::ssize_t>(points.size()), 3});
}

template <class Range>
py::array_t<Index> to_indices(const Range& range)
{
  std::vector<Index> values;
  for (const auto& element : range)
    values.push_back(static_cast<Index>(element));
  return to_array(std::move(values));
}

// An array whose memory belongs to an object; it cannot be written to.
inline py::array_t<double> read_only_view(const double* data,
                                          std::vector<py::ssize_t> shape,
                                          const py::object& owner)
{
  py::array_t<double> result(std::move(shape), data, owner);
  result.attr("setflags")(py::arg("write") = false);
  return result;
}

inline std::vector<double> to_vector(const Doubles& array)
{
  return std::vector<double>(array.data(), array.data() + array.size());
}

inline std::vector<Index> to_vector(const Indices& array)
{
  return std::vector<Index>(array.data(), array.data() + array.size());
}

} // namespace smf_python

#endif // SMF_PYTHON_ARRAYS_H
