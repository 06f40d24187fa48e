// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_PARTS_H
#define SMF_EXPERIMENTS_PARTS_H

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

// Comparison of two segmentations of one mesh, each a number by face.

namespace smf_experiments {

class Overlaps
{
public:
  Overlaps(const std::vector<int>& first,
           const std::vector<int>& second,
           const std::vector<double>& areas)
  {
    for (std::size_t f = 0; f < areas.size(); ++f)
    {
      m_first[first[f]] += areas[f];
      m_second[second[f]] += areas[f];
      m_joint[{first[f], second[f]}] += areas[f];
      m_area += areas[f];
    }
  }

  // the number of pairs of segments, one of each segmentation, whose intersection is at least a
  // share of their union; above a half no segment is in two pairs
  std::size_t number_of_pairs(double least) const
  {
    std::size_t result = 0;
    for (const auto& [pair, area] : m_joint)
      if (area >= least * (m_first.at(pair.first) + m_second.at(pair.second) - area))
        ++result;
    return result;
  }

  // The number of those pairs as a share of the mean number of segments.
  double agreement(double least) const
  {
    return 2 * static_cast<double>(number_of_pairs(least)) /
           static_cast<double>(m_first.size() + m_second.size());
  }

  // whether some segment of the first segmentation contains a share of segment `i` of the second,
  // and of no other but the last one, `rest`, more than the opposite share
  bool is_found_alone(int i, int rest, double share) const
  {
    for (const auto& segment : m_first)
      if (contains(segment.first, i, share) &&
          std::none_of(m_second.begin(), m_second.end(), [&](const auto& other) {
            return other.first != i && other.first != rest &&
                   contains(segment.first, other.first, 1 - share);
          }))
        return true;
    return false;
  }

  // the share of pairs of points that are in one segment in exactly one segmentation
  double rand_difference() const
  {
    return (square(m_first) + square(m_second) - 2 * square(m_joint)) / (m_area * m_area);
  }

  // the share of the area of the first segmentation that is outside the segments of the second
  // that overlap most, and the other way round: the mean of both
  double hamming_difference() const
  {
    std::map<int, double> first, second; // the largest overlap of each segment
    for (const auto& [pair, area] : m_joint)
    {
      first[pair.first] = (std::max)(first[pair.first], area);
      second[pair.second] = (std::max)(second[pair.second], area);
    }
    return 1 - (sum(first) + sum(second)) / (2 * m_area);
  }

private:
  bool contains(int first, int second, double share) const
  {
    const auto found = m_joint.find({first, second});
    return found != m_joint.end() && found->second >= share * m_second.at(second);
  }

  template <class Map>
  static double square(const Map& areas)
  {
    double result = 0;
    for (const auto& entry : areas)
      result += entry.second * entry.second;
    return result;
  }

  static double sum(const std::map<int, double>& areas)
  {
    double result = 0;
    for (const auto& entry : areas)
      result += entry.second;
    return result;
  }

  std::map<int, double> m_first, m_second;
  std::map<std::pair<int, int>, double> m_joint;
  double m_area = 0;
};

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_PARTS_H
