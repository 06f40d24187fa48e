// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_SHARED_ARRAY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_SHARED_ARRAY_H

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// An array that does not change once it is made, so that copies share it.
template <class T>
class Shared_array
{
public:
  Shared_array() : Shared_array(std::vector<T>()) {}
  explicit Shared_array(std::vector<T> values)
    : m_values(std::make_shared<const std::vector<T>>(std::move(values))), m_data(m_values->data())
  {}

  std::size_t size() const { return m_values->size(); }
  const T* data() const { return m_data; }
  const T& operator[](std::size_t i) const { return m_data[i]; }
  const std::vector<T>& values() const { return *m_values; }

  // whether this is a copy of the other array or the other way around
  bool is_shared_with(const Shared_array& other) const { return m_values == other.m_values; }

private:
  std::shared_ptr<const std::vector<T>> m_values;
  const T* m_data; // in m_values; spares a way through memory
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_SHARED_ARRAY_H
