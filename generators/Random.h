// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_RANDOM_H
#define SMF_GENERATORS_RANDOM_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace smf_test {

// The distributions of the standard library differ from one implementation to the next; these give
// the same numbers everywhere.
class Random
{
public:
  explicit Random(std::uint64_t seed) : m_engine(seed) {}

  double between(double low, double high)
  {
    constexpr double unit = 1.0 / 9007199254740992.0; // 2^-53
    return low + (high - low) * (static_cast<double>(m_engine() >> 11) * unit);
  }

  // one of 0, ..., size-1
  std::size_t index(std::size_t size) { return static_cast<std::size_t>(m_engine() % size); }

  std::vector<std::size_t> permutation(std::size_t size)
  {
    std::vector<std::size_t> result(size);
    std::iota(result.begin(), result.end(), std::size_t(0));
    for (std::size_t i = size; i > 1; --i)
      std::swap(result[i - 1], result[index(i)]);
    return result;
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace smf_test

#endif // SMF_GENERATORS_RANDOM_H
