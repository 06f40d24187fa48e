// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_DISJOINT_SETS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_DISJOINT_SETS_H

#include <CGAL/assertions.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
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
    : m_ranks(size), m_parents(size), m_sets(m_ranks.begin(), m_parents.begin())
  {
    CGAL_assertion(size <= (std::numeric_limits<std::uint32_t>::max)());
    for (std::uint32_t i = 0; i < size; ++i)
      m_sets.make_set(i);
  }

  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  std::size_t find_set(std::size_t i) { return m_sets.find_set(static_cast<std::uint32_t>(i)); }
  void union_set(std::size_t i, std::size_t j)
  {
    m_sets.union_set(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
  }

private:
  // a rank is at most the logarithm of the size
  using Ranks = std::vector<std::uint8_t>;
  using Parents = std::vector<std::uint32_t>;
  template <class Numbers>
  using Map = boost::iterator_property_map<typename Numbers::iterator,
                                           boost::typed_identity_property_map<std::uint32_t>>;

  Ranks m_ranks;
  Parents m_parents;
  boost::disjoint_sets<Map<Ranks>, Map<Parents>> m_sets;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_DISJOINT_SETS_H
