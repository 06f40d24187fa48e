// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_DISJOINT_SETS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Boost's disjoint sets over the numbers below `size`, with their storage. (Boost's own
// disjoint_sets_with_storage does not compile after <boost/graph/graphviz.hpp> in Boost 1.74; these
// maps are found by argument-dependent lookup.)
class Disjoint_sets
{
public:
  explicit Disjoint_sets(std::size_t size)
    : m_ranks(size), m_parents(size), m_sets(map(m_ranks), map(m_parents))
  {
    for (std::size_t i = 0; i < size; ++i)
      m_sets.make_set(i);
  }

  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  std::size_t find_set(std::size_t i) { return m_sets.find_set(i); }
  void union_set(std::size_t i, std::size_t j) { m_sets.union_set(i, j); }

private:
  using Numbers = std::vector<std::size_t>;
  using Map = boost::iterator_property_map<Numbers::iterator,
                                           boost::typed_identity_property_map<std::size_t>>;

  static Map map(Numbers& numbers) { return Map(numbers.begin()); }

  Numbers m_ranks, m_parents;
  boost::disjoint_sets<Map, Map> m_sets;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_DISJOINT_SETS_H
