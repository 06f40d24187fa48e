// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_FLAT_LOOP_HIERARCHY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_FLAT_LOOP_HIERARCHY_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Proposed_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Automatic_loops/Sweep.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Minimal_position.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Ring_bounds.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Regions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_farthest_from_centroid.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The cyclically reduced word of a loop, or of its inverse, starting where it is least: the same
// for all loops in a free homotopy class on a surface with poles.
inline Group_word class_of_loop(const Deck_cocycle& deck, const Flat_loop& loop)
{
  Group_word word;
  for (const Flat_crossing& crossing : loop.crossings)
    if (!deck.is_identity(crossing.halfedge))
      word = deck.group().product(word, deck.element(crossing.halfedge));
  word = cyclically_reduced(word);
  Group_word result = word;
  for (Group_word turned : {word, inverse(word)})
    for (std::size_t i = 0; i < turned.size(); ++i)
    {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      result = (std::min)(result, turned);
    }
  return result;
}

// A homotopy class of simple loops, with one of them.
struct Loop_class
{
  Flat_loop loop;
  double modulus = 0;
  bool is_separating = false;
  double largest_crossing =
    0;                      // the largest modulus of a class that crosses it, if it has one of 1/4
  int parent = -1;          // the last loop before it in whose pieces it lies
  bool cuts_handle = false; // whether the pieces have less genus with it than without
  bool is_chosen = false;
  bool is_measured_again = false; // on another mesh, which is finer where loops need it
};

// The loops of a surface with poles in the order of their moduli, each disjoint from those before
// it, until they cut the surface into pairs of pants. By Minsky's inequality, i(a, b)^2 Mod(a)
// Mod(b) <= 1, the first of them, separating loops with moduli above 1/2 and others with moduli
// above 1, cross no class above these bounds; so they do not depend on which others were looked at.
//
// Candidates are the loops that sweeps propose: from all poles together and from each of them. If
// those do not suffice, more sweeps start at the loops found so far, whose contours run beside
// them. Where there are so many handles that each sweep has dozens of loops, only those are taken
// that are nearest to its start.
class Flat_loop_hierarchy
{
public:
  // Loops with smaller moduli are no part of what people look at.
  static constexpr double least_looked_at = 0.25;

  // lengths: see Class_moduli
  // least_modulus: where moduli are certain to be less, they need not be computed, and count as 0
  // more_sweeps: vertices that further sweeps start at, which should not change what is chosen
  Flat_loop_hierarchy(const Flat_mesh& mesh,
                      std::vector<double> lengths,
                      const std::vector<Pole>& poles,
                      const Poll& poll = poll_nobody,
                      double least_modulus = 0,
                      const std::vector<std::vector<int>>& more_sweeps = {})
    : m_mesh(mesh),
      m_poles(poles),
      m_lengths(std::move(lengths)),
      m_deck(mesh, poles),
      m_moduli(mesh, m_lengths, poles, poll),
      m_least_modulus(least_modulus)
  {
    if (least_modulus > 0 && mesh.genus() == 0)
      m_bounds.emplace(m_moduli.mesh(), m_moduli.weights());
    add_first_candidates();
    for (const std::vector<int>& sources : more_sweeps)
      add_candidates(sources);
    choose_from(m_candidates);
    improve();
    compare_with_crossing_classes();
  }

  const std::vector<Loop_class>& loops() const { return m_loops; }

  // all classes that were looked at, by falling modulus
  const std::vector<Loop_class>& candidates() const { return m_candidates; }

  // Chooses anew, after the moduli of some of the candidates were measured on another mesh of the
  // same surface, where they are more accurate. For another choice, candidates may be missing that
  // would complete it; then what was chosen only gets its new order.
  void choose_again(const std::vector<std::size_t>& candidates, const std::vector<double>& moduli)
  {
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      m_candidates[candidates[i]].modulus = moduli[i];
      m_candidates[candidates[i]].is_measured_again = true;
    }
    std::vector<Loop_class> before;
    std::copy_if(m_candidates.begin(), m_candidates.end(), std::back_inserter(before),
                 [](const Loop_class& candidate) { return candidate.is_chosen; });
    choose_from(m_candidates);
    if (m_loops.size() < before.size())
      choose_from(before);
    compare_with_crossing_classes();
  }

  // the number of loops that cut the surface into pairs of pants
  int size_of_pants_decomposition() const
  {
    return (std::max)(0, 3 * m_mesh.genus() - 3 + static_cast<int>(m_poles.size()) +
                           (m_mesh.genus() == 1 && m_poles.empty() ? 1 : 0));
  }

  bool is_complete() const
  {
    return static_cast<int>(m_loops.size()) >= size_of_pants_decomposition();
  }

private:
  void add_first_candidates()
  {
    if (size_of_pants_decomposition() == 0)
      return;
    std::vector<int> all;
    for (const Pole& pole : m_poles)
      all.insert(all.end(), pole.begin(), pole.end());
    if (all.empty())
      all = {vertex_farthest_from_centroid(m_mesh)};
    const std::vector<double> distance = add_candidates(all);
    add_candidates_of_each_pole();
    if (m_poles.size() < 2) // sweeps from the other side, too
      add_candidates(
        {static_cast<int>(std::max_element(distance.begin(), distance.end()) - distance.begin())});
  }

  // Each sweep starts at the pole that is farthest from those before it.
  void add_candidates_of_each_pole()
  {
    std::vector<bool> is_left(m_poles.size(), true);
    std::vector<double> nearest(m_poles.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < m_poles.size() && m_number_of_sweeps < most_sweeps(); ++i)
    {
      std::size_t farthest = m_poles.size();
      for (std::size_t p = 0; p < m_poles.size(); ++p)
        if (is_left[p] && (farthest == m_poles.size() || nearest[p] > nearest[farthest]))
          farthest = p;
      is_left[farthest] = false;
      const std::vector<double> distance = add_candidates(m_poles[farthest].vertices());
      for (std::size_t p = 0; p < m_poles.size(); ++p)
        nearest[p] = (std::min)(nearest[p], distance[m_poles[p][0]]);
    }
  }

  // besides the first one
  int most_sweeps() const
  {
    constexpr int most_classes = 150;
    return 1 + most_classes / size_of_pants_decomposition();
  }

  static constexpr std::size_t all_loops = (std::numeric_limits<std::size_t>::max)();

  // by a sweep from some vertices, the loops nearest to them first; returns the distances from them
  std::vector<double> add_candidates(const std::vector<int>& sources, std::size_t most = all_loops)
  {
    ++m_number_of_sweeps;
    std::vector<double> distances = Geodesic_distances(m_mesh, m_lengths, sources).distances();
    const Sweep sweep(distances, m_poles);
    Proposed_loops proposed(m_mesh, m_poles, sweep);
    proposed.reduce(true);
    for (Flat_loop& loop : most == all_loops ? proposed.loops() : proposed.first_loops(most))
      if (m_classes.insert(class_of_loop(m_deck, loop)).second)
        add_candidate(std::move(loop));
    return distances;
  }

  void add_candidate(Flat_loop loop)
  {
    const Class_moduli::Result result = modulus_of(loop);
    m_candidates.push_back({std::move(loop), result.modulus, result.is_separating});
  }

  Class_moduli::Result modulus_of(const Flat_loop& loop)
  {
    constexpr double accuracy_of_bounds = 0.03; // if poles are a few edges apart
    if (m_bounds &&
        (*m_bounds)(poles_beside(m_mesh, m_poles, loop)) + accuracy_of_bounds < m_least_modulus)
      return {0, true};
    return m_moduli.of_loop(loop);
  }

  // Looks for more candidates as long as that changes what is chosen. Without handles, the first
  // ones suffice, if they cut the surface into pairs of pants.
  void improve()
  {
    constexpr int most_rounds = 6;
    for (int rounds = 0; rounds < most_rounds; ++rounds)
    {
      if (is_complete() && m_mesh.genus() == 0)
        return;
      const std::size_t number = m_classes.size();
      const std::vector<Loop_class> before = m_loops;
      for (const Loop_class& chosen : before)
        add_candidates_beside(chosen);
      if (!is_complete())
        add_candidates_beside_loops();
      if (m_classes.size() == number)
        return;
      choose_from(m_candidates);
      if (is_complete() && before.size() == m_loops.size() &&
          std::equal(
            before.begin(), before.end(), m_loops.begin(),
            [](const Loop_class& x, const Loop_class& y) { return x.modulus == y.modulus; }))
        return;
    }
  }

  void add_candidates_beside(const Loop_class& chosen)
  {
    constexpr std::size_t nearest = 4; // two on either side
    if (m_number_of_sweeps < most_sweeps())
      add_candidates(vertices_beside(chosen.loop));
    // Without handles, the sweeps from the poles suffice.
    else if (m_mesh.genus() > 0 && chosen.modulus >= least_looked_at &&
             m_swept.insert(class_of_loop(m_deck, chosen.loop)).second)
      add_candidates(vertices_beside(chosen.loop), nearest);
  }

  std::vector<int> vertices_beside(const Flat_loop& loop) const
  {
    std::vector<int> result;
    for (const Flat_crossing& crossing : loop.crossings)
    {
      result.push_back(m_mesh.source(crossing.halfedge));
      result.push_back(m_mesh.target(crossing.halfedge));
    }
    return result;
  }

  void add_candidates_beside_loops()
  {
    std::vector<int> sources;
    for (const Pole& pole : m_poles)
      sources.insert(sources.end(), pole.begin(), pole.end());
    for (const Loop_class& chosen : m_loops)
    {
      const std::vector<int> beside = vertices_beside(chosen.loop);
      sources.insert(sources.end(), beside.begin(), beside.end());
    }
    if (!sources.empty())
      add_candidates(sources);
  }

  // Greedily: of the candidates that cross no loop chosen before, the one with the largest modulus.
  void choose_from(std::vector<Loop_class>& candidates)
  {
    // Moduli that differ by rounding only, as those of one class under two names, count as equal:
    // then the first one found goes first.
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Loop_class& x, const Loop_class& y) {
                       return static_cast<float>(x.modulus) > static_cast<float>(y.modulus);
                     });
    m_loops.clear();
    for (Loop_class& candidate : candidates)
      candidate.is_chosen = false;
    std::vector<Flat_loop> chosen;
    int genus = m_mesh.genus();
    for (Loop_class& candidate : candidates)
    {
      if (is_complete())
        return;
      Minimal_position position(m_deck, m_mesh, chosen, candidate.loop);
      if (!position.is_disjoint())
        continue;
      std::vector<Flat_loop> loops = position.loops();
      const std::vector<Flat_loop> with_poles = with_tight_loops(loops);
      const Edge_crossings crossings(m_mesh, with_poles);
      const Regions regions(m_mesh, m_poles, with_poles, crossings);
      Problems problems;
      check_regions(m_mesh, m_poles, with_poles, regions, false, problems);
      if (!problems.empty()) // a loop of the same class was chosen before
        continue;
      candidate.is_chosen = true;
      m_loops.push_back(candidate);
      int rest = 0;
      for (int r = 0; r < regions.number_of_regions(); ++r)
        rest += regions.region(r).genus();
      m_loops.back().cuts_handle = rest < genus;
      genus = rest;
      m_loops.back().parent = parent_of_last(with_poles, regions);
      chosen = std::move(loops);
      for (std::size_t i = 0; i < chosen.size(); ++i)
        m_loops[i].loop = chosen[i];
    }
  }

  std::vector<Flat_loop> with_tight_loops(const std::vector<Flat_loop>& loops) const
  {
    std::vector<Flat_loop> result;
    for (std::size_t p = 0; p < m_poles.size(); ++p)
      result.push_back(tight_loop(m_mesh, m_poles[p], static_cast<int>(p), 1));
    result.insert(result.end(), loops.begin(), loops.end());
    return result;
  }

  // the last of the loops before the last one that bound the piece that it divides
  int parent_of_last(const std::vector<Flat_loop>& with_poles, const Regions& regions) const
  {
    const int last = static_cast<int>(with_poles.size()) - 1;
    int result = -1;
    for (int side : {0, 1})
      for (const Regions::Side& other :
           regions.region(regions.region_beside(with_poles[last], last, side)).sides)
        if (other.loop != last)
          result = (std::max)(result, other.loop - static_cast<int>(m_poles.size()));
    return result;
  }

  void compare_with_crossing_classes()
  {
    for (Loop_class& chosen : m_loops)
      for (const Loop_class& candidate : m_candidates)
      {
        if (chosen.modulus < least_looked_at)
          continue;
        const int crossings =
          Minimal_position(m_deck, m_mesh, {chosen.loop}, candidate.loop).number_of_crossings(0);
        if (crossings > 0)
          chosen.largest_crossing =
            (std::max)(chosen.largest_crossing, modulus_beside(chosen, candidate, crossings));
      }
  }

  // The modulus of a class that crosses another one. On one mesh, Minsky's inequality holds for
  // what is computed, too; if one of the two was measured on a finer mesh, it sets a limit.
  static double modulus_beside(const Loop_class& chosen, const Loop_class& other, int crossings)
  {
    constexpr double rounding = 1e-6;
    const double largest = 1 / (static_cast<double>(crossings) * crossings * chosen.modulus);
    const bool are_on_one_mesh = chosen.is_measured_again == other.is_measured_again;
    if (are_on_one_mesh && other.modulus > (1 + rounding) * largest)
      throw Certificate_exception(problem(Problem_kind::CERTIFICATE_FAILURE,
                                          "two classes of loops that cross ", crossings,
                                          " times have moduli ", chosen.modulus, " and ",
                                          other.modulus, ", too large for Minsky's inequality"));
    return (std::min)(other.modulus, largest);
  }

  const Flat_mesh& m_mesh;
  const std::vector<Pole>& m_poles;
  const std::vector<double> m_lengths; // by edge
  const Deck_cocycle m_deck;
  Class_moduli m_moduli;
  const double m_least_modulus = 0;
  std::optional<Ring_bounds> m_bounds;
  int m_number_of_sweeps = 0;
  std::set<Group_word> m_classes; // of the candidates
  std::set<Group_word> m_swept;   // of the loops whose nearest ones are candidates
  std::vector<Loop_class> m_candidates;
  std::vector<Loop_class> m_loops;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_FLAT_LOOP_HIERARCHY_H
