// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ARC_EMBEDDING_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ARC_EMBEDDING_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Leaf_centroids.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/openings.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Points for the nodes and polylines for the arcs: centroids of leaves.
class Arc_embedding
{
public:
  struct Sample
  {
    double level;
    Point point;
    double length, radius; // of the leaf
  };

  Arc_embedding(const Foliation_state& state, const Refined_mesh& refined)
    : m_state(state),
      m_centroids(refined, state.executor()),
      m_nodes(m_centroids.of_nodes(state.system().nodes.size()))
  {
    for (const Pole& pole : state.system().poles)
      if (pole.is_cap())
        m_nodes[state.node(pole[0])] =
          centroid_of_border(Border(pole.begin() + 1, pole.end()), state.mesh().points());
  }

  const std::vector<Centroid>& nodes() const { return m_nodes; }

  // by arc: leaves at equal distances of t, strictly inside the arc [5.4]
  std::vector<std::vector<Sample>> uniform_samples(int number) const
  {
    std::vector<std::vector<double>> levels(number_of_arcs());
    for (int a = 0; a < number_of_arcs(); ++a)
      for (int i = 1; i <= number; ++i)
        levels[a].push_back(m_state.system().height(a) * (i / (number + 1.)));
    return samples(levels);
  }

  // By arc: leaves whose centroids are at equal distances along the embedded arc. Near poles t
  // grows like a logarithm, so leaves at equal distances of t would crowd there. The levels are
  // found by inverting the length of a polyline through many leaves, at quantiles of t over the
  // vertices, and then of the resulting polyline. At a saddle leaf, the centroids of the leaves of
  // one arc tend to a point other than that of the node; the jump between them is not counted.
  std::vector<std::vector<Sample>> even_samples(int number) const
  {
    const int many = (std::max)(4 * number, 32);
    std::vector<std::vector<double>> levels = quantiles(many);
    for (int round = 0; round < 2; ++round)
    {
      levels = evened(levels, many);
      for (int a = 0; a < number_of_arcs(); ++a)
        add_limits(a, levels[a]);
    }
    return samples(evened(levels, number));
  }

  // Adds leaves in the middle between others, in t, as long as one between them is farther from
  // their chord than `deviation` times its radius. Three are looked at: the middle of an S lies on
  // the chord.
  std::vector<std::vector<Sample>> refined(std::vector<std::vector<Sample>> samples,
                                           double deviation) const
  {
    constexpr int largest_number_of_rounds = 10; // each halves the chords
    std::vector<std::vector<bool>> is_settled;   // by arc and chord
    is_settled.reserve(samples.size());
    for (const std::vector<Sample>& arc : samples)
      is_settled.emplace_back(arc.empty() ? 0 : arc.size() - 1, false);
    for (int round = 0; round < largest_number_of_rounds; ++round)
    {
      std::vector<std::vector<double>> levels(number_of_arcs());
      for (int a = 0; a < number_of_arcs(); ++a)
        for (std::size_t i = 0; i < is_settled[a].size(); ++i)
          if (!is_settled[a][i])
            for (const double share : {0.25, 0.5, 0.75})
              levels[a].push_back(samples[a][i].level +
                                  share * (samples[a][i + 1].level - samples[a][i].level));
      const std::vector<std::vector<Centroid>> centroids = m_centroids.of_levels(levels);
      for (int a = 0; a < number_of_arcs(); ++a)
        insert_centroids(levels[a], centroids[a], deviation, samples[a], is_settled[a]);
    }
    return samples;
  }

private:
  // whether a leaf is too far from the chord between two others
  static bool is_far(const Centroid& leaf,
                     const Sample& first,
                     const Sample& last,
                     double deviation)
  {
    return !leaf.is_empty() &&
           distance_to_segment(leaf.point(), first.point, last.point) > deviation * leaf.radius();
  }

  // One round of `refined()` for one arc, with three leaves for each chord that is not settled.
  static void insert_centroids(const std::vector<double>& levels,
                               const std::vector<Centroid>& centroids,
                               double deviation,
                               std::vector<Sample>& samples,
                               std::vector<bool>& is_settled)
  {
    std::vector<Sample> new_samples;
    std::vector<bool> is_newly_settled;
    std::size_t next = 0; // of the first leaf of the chord
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      new_samples.push_back(samples[i]);
      if (i + 1 == samples.size())
        break;
      bool is_split = false;
      if (!is_settled[i])
      {
        const double level = levels[next + 1];
        const Centroid& middle = centroids[next + 1];
        for (std::size_t k = next; k < next + 3; ++k)
          is_split = is_split || is_far(centroids[k], samples[i], samples[i + 1], deviation);
        is_split = is_split && level > samples[i].level && level < samples[i + 1].level &&
                   !middle.is_empty();
        if (is_split)
          new_samples.push_back({level, middle.point(), middle.length(), middle.radius()});
        next += 3;
      }
      is_newly_settled.insert(is_newly_settled.end(), is_split ? 2 : 1, !is_split);
    }
    samples = std::move(new_samples);
    is_settled = std::move(is_newly_settled);
  }

  int number_of_arcs() const { return m_state.system().number_of_arcs(); }

  // Levels between the parameters of consecutive vertices, so that none falls on a plateau, and as
  // many equally spaced ones for arcs with few vertices.
  std::vector<std::vector<double>> quantiles(int number) const
  {
    std::vector<std::vector<double>> parameters(number_of_arcs()), result(number_of_arcs());
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (!m_state.is_at_node(v))
        parameters[m_state.arc(v)].push_back(m_state.parameter(v));
    for (int a = 0; a < number_of_arcs(); ++a)
    {
      std::vector<double>& t = parameters[a];
      const double height = m_state.system().height(a);
      t.push_back(0);
      t.push_back(height);
      std::sort(t.begin(), t.end());
      for (int i = 1; i <= number; ++i)
      {
        const std::size_t j = i * (t.size() - 1) / (number + 1);
        result[a].push_back(t[j] + (t[j + 1] - t[j]) / 2);
        result[a].push_back(height * i / (number + 1));
      }
      add_limits(a, result[a]);
    }
    return result;
  }

  // adds the levels that stand for the leaves next to the ends
  void add_limits(int arc, std::vector<double>& levels) const
  {
    const double height = m_state.system().height(arc);
    levels.push_back(1e-6 * height);
    levels.push_back((1 - 1e-6) * height);
    keep_distance(levels, height);
  }

  // sorts the levels and drops those that equal another level or an end up to rounding
  static void keep_distance(std::vector<double>& levels, double height)
  {
    const double margin = 1e-9 * height;
    std::sort(levels.begin(), levels.end());
    std::vector<double> kept;
    for (double level : levels)
      if (level > margin && level < height - margin &&
          (kept.empty() || level > kept.back() + margin))
        kept.push_back(level);
    levels = kept;
  }

  // by arc: levels at equal distances along the polyline through the leaves of other levels
  std::vector<std::vector<double>> evened(const std::vector<std::vector<double>>& levels,
                                          int number) const
  {
    const auto leaves = m_centroids.of_levels<Centroid_without_radius>(levels);
    std::vector<std::vector<double>> result;
    for (int a = 0; a < number_of_arcs(); ++a)
      result.push_back(evened(a, levels[a], leaves[a], number));
    return result;
  }

  // the same in one arc; the poles at its ends belong to the polyline
  std::vector<double> evened(int arc,
                             const std::vector<double>& levels,
                             const std::vector<Centroid_without_radius>& leaves,
                             int number) const
  {
    const double height = m_state.system().height(arc);
    std::vector<double> level, way;
    Point last{};
    const auto add = [&](double t, const Point& p) {
      way.push_back(way.empty() ? 0 : way.back() + distance(last, p));
      level.push_back(t);
      last = p;
    };
    const auto add_pole = [&](int end) {
      const int node = m_state.system().node_of_end(arc, end);
      if (m_state.system().nodes[node].pole >= 0)
        add(end * height, m_nodes[node].point());
    };
    add_pole(0);
    for (std::size_t i = 0; i < levels.size(); ++i)
      if (!leaves[i].is_empty())
        add(levels[i], leaves[i].point());
    add_pole(1);
    std::vector<double> result;
    if (way.size() < 2) // the height is so small that no floating-point number lies inside the arc
      return result;
    for (int i = 1; i <= number; ++i)
    {
      const double target = way.back() * i / (number + 1);
      const std::size_t j = std::clamp<std::size_t>(
        std::lower_bound(way.begin(), way.end(), target) - way.begin(), 1, way.size() - 1);
      const double step = way[j] - way[j - 1];
      const double share = step > 0 ? (target - way[j - 1]) / step : 0.5;
      result.push_back(level[j - 1] + share * (level[j] - level[j - 1]));
    }
    keep_distance(result, height);
    return result;
  }

  std::vector<std::vector<Sample>> samples(const std::vector<std::vector<double>>& levels) const
  {
    const std::vector<std::vector<Centroid>> centroids = m_centroids.of_levels(levels);
    std::vector<std::vector<Sample>> result(levels.size());
    for (std::size_t a = 0; a < levels.size(); ++a)
      for (std::size_t i = 0; i < levels[a].size(); ++i)
        if (!centroids[a][i].is_empty())
          result[a].push_back({levels[a][i], centroids[a][i].point(), centroids[a][i].length(),
                               centroids[a][i].radius()});
    return result;
  }

  const Foliation_state& m_state;
  Leaf_centroids m_centroids;
  std::vector<Centroid> m_nodes;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LEAVES_ARC_EMBEDDING_H
