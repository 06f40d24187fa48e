// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_MINIMAL_POSITION_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_MINIMAL_POSITION_H

#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/loop_checks.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Flat_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// gives the crossings of loops with each edge equal distances, in their order
inline void space_crossings_evenly(const Flat_mesh& mesh, std::vector<Flat_loop>& loops)
{
  const Edge_crossings crossings(mesh, loops);
  for (int e = 0; e < mesh.number_of_edges(); ++e)
    for (int i = 0; i < crossings.size(e); ++i)
    {
      const Edge_crossings::Entry& entry = crossings.entry(e, i);
      const double position = double(i + 1) / double(crossings.size(e) + 1);
      loops[entry.loop].crossings[entry.index].position =
        is_forward(entry.halfedge) ? position : 1 - position;
    }
}

// Moves a simple loop, in its homotopy class on the surface minus its poles, until it crosses some
// fixed loops, simple and pairwise disjoint, as rarely as possible. As long as it crosses one more
// often than it has to, there is a bigon: a disk without pole between an arc of the loop and one of
// a fixed loop, which meet at their ends only (Farb and Margalit, A primer on mapping class groups,
// Proposition 1.7). Two arcs bound a bigon iff they are homotopic, which their group elements
// decide; the loop is then led along the other side of the fixed one.
//
// Where two loops cross is decided by the order of their ends on the edges, never by coordinates.
class Minimal_position
{
public:
  Minimal_position(const Deck_cocycle& deck,
                   const Flat_mesh& mesh,
                   std::vector<Flat_loop> fixed,
                   Flat_loop loop)
    : m_deck(deck), m_mesh(mesh), m_loops(std::move(fixed))
  {
    m_loops.push_back(std::move(loop));
    do
    {
      space_crossings_evenly(m_mesh, m_loops);
      find_meetings();
    } while (remove_bigon());
  }

  // the loop, after the fixed ones, whose positions have changed, too
  const std::vector<Flat_loop>& loops() const { return m_loops; }

  // the geometric intersection number with a fixed loop
  int number_of_crossings(int fixed) const { return static_cast<int>(m_order[fixed].size()); }

  bool is_disjoint() const { return m_meetings.empty(); }

private:
  using Crossings = std::vector<Flat_crossing>;

  // where the loop meets a fixed one: a place on a segment of each. Segment i ends at crossing i,
  // in the face that it crosses from.
  struct Place
  {
    int segment;
    double way; // grows along the segment
    bool operator<(const Place& other) const
    {
      return segment != other.segment ? segment < other.segment : way < other.way;
    }
  };
  struct Meeting
  {
    int fixed;
    Place on_loop, on_fixed;
    bool comes_from_left; // of the fixed loop
  };

  struct Segment
  {
    int face, loop, number;
    bool operator<(const Segment& other) const { return face < other.face; }
  };

  const Crossings& crossings(int loop) const { return m_loops[loop].crossings; }
  int loop() const { return static_cast<int>(m_loops.size()) - 1; }

  // a point on the border of a face, as a number from 0 to 3
  double place_on_border(int h, double position) const
  {
    const std::array<int, 3> sides = m_mesh.halfedges(m_mesh.face(h));
    return static_cast<double>(std::find(sides.begin(), sides.end(), h) - sides.begin()) + position;
  }

  // the start and the end of a segment
  std::array<double, 2> ends(int loop, int segment) const
  {
    const Crossings& all = crossings(loop);
    const Flat_crossing& first = all[(segment + all.size() - 1) % all.size()];
    const Flat_crossing& last = all[segment];
    return {place_on_border(opposite_of(first.halfedge), 1 - first.position),
            place_on_border(last.halfedge, last.position)};
  }

  // how far it is counterclockwise around a face
  static double way(double from, double to) { return to >= from ? to - from : to - from + 3; }
  static bool is_between(double x, const std::array<double, 2>& ends)
  {
    return way(ends[0], x) < way(ends[0], ends[1]);
  }

  void find_meetings()
  {
    std::vector<Segment> segments; // of the fixed loops
    for (int a = 0; a < loop(); ++a)
      for (int i = 0; i < static_cast<int>(crossings(a).size()); ++i)
        segments.push_back({m_mesh.face(crossings(a)[i].halfedge), a, i});
    std::stable_sort(segments.begin(), segments.end());
    m_meetings.clear();
    for (int i = 0; i < static_cast<int>(crossings(loop()).size()); ++i)
    {
      const int face = m_mesh.face(crossings(loop())[i].halfedge);
      const auto [first, last] =
        std::equal_range(segments.begin(), segments.end(), Segment{face, 0, 0});
      for (auto it = first; it != last; ++it)
        add_meeting(i, *it);
    }
    std::sort(m_meetings.begin(), m_meetings.end(),
              [](const Meeting& x, const Meeting& y) { return x.on_loop < y.on_loop; });
    m_order.assign(m_loops.size() - 1, {});
    for (int k = 0; k < static_cast<int>(m_meetings.size()); ++k)
      m_order[m_meetings[k].fixed].push_back(k);
    for (std::vector<int>& order : m_order)
      std::sort(order.begin(), order.end(),
                [&](int k, int l) { return m_meetings[k].on_fixed < m_meetings[l].on_fixed; });
  }

  // Disjoint segments that cross another one do so in the order of their ends on one side of it:
  // the right one, along which the border of the face runs from its start to its end.
  void add_meeting(int segment, const Segment& other)
  {
    const std::array<double, 2> mine = ends(loop(), segment), its = ends(other.loop, other.number);
    const bool first_is_right = is_between(its[0], mine);
    if (first_is_right == is_between(its[1], mine))
      return;
    const bool comes_from_right = is_between(mine[0], its);
    m_meetings.push_back({other.loop,
                          {segment, way(mine[0], first_is_right ? its[0] : its[1])},
                          {other.number, way(its[0], comes_from_right ? mine[0] : mine[1])},
                          !comes_from_right});
  }

  // an arc of a loop between two of its segments, by the crossings on it
  struct Arc
  {
    int first, size;
  };

  Arc arc(int loop, int from_segment, int to_segment, bool goes_around) const
  {
    const int size = to_segment - from_segment;
    return {from_segment, goes_around ? size + static_cast<int>(crossings(loop).size()) : size};
  }

  Flat_crossing crossing(int loop, const Arc& arc, int i) const
  {
    return crossings(loop)[(arc.first + i) % crossings(loop).size()];
  }

  Group_word element(int loop, const Arc& arc) const
  {
    Group_word result;
    for (int i = 0; i < arc.size; ++i)
      if (const int h = crossing(loop, arc, i).halfedge; !m_deck.is_identity(h))
        result = m_deck.group().product(result, m_deck.element(h));
    return result;
  }

  // Looks for two meetings that follow each other on both loops, with homotopic arcs.
  bool remove_bigon()
  {
    const int n = static_cast<int>(m_meetings.size());
    for (int k = 0; n >= 2 && k < n; ++k)
    {
      const Meeting &x = m_meetings[k], &y = m_meetings[(k + 1) % n];
      if (x.fixed != y.fixed)
        continue;
      const Arc mine = arc(loop(), x.on_loop.segment, y.on_loop.segment, k + 1 == n);
      for (const bool is_forward : {true, false})
      {
        const std::optional<Arc> its =
          is_forward ? arc_of_fixed(k, (k + 1) % n) : arc_of_fixed((k + 1) % n, k);
        if (!its)
          continue;
        const Group_word word = element(x.fixed, *its);
        if (!m_deck.group().are_equal(element(loop(), mine), is_forward ? word : inverse(word)))
          continue;
        lead_along(mine, x, *its, is_forward);
        return true;
      }
    }
    return false;
  }

  // from a meeting to another one, if that is the next on their fixed loop
  std::optional<Arc> arc_of_fixed(int k, int l) const
  {
    const int fixed = m_meetings[k].fixed;
    const std::vector<int>& order = m_order[fixed];
    const auto place = std::find(order.begin(), order.end(), k) - order.begin();
    const bool goes_around = place + 1 == static_cast<std::ptrdiff_t>(order.size());
    if (order[goes_around ? 0 : place + 1] != l)
      return std::nullopt;
    return arc(fixed, m_meetings[k].on_fixed.segment, m_meetings[l].on_fixed.segment, goes_around);
  }

  // Replaces an arc of the loop by one beside a fixed loop, on the side from which the loop comes.
  void lead_along(const Arc& mine, const Meeting& start, const Arc& its, bool is_along)
  {
    const Edge_crossings on_edges(m_mesh, m_loops);
    Crossings result;
    for (int i = 0; i < its.size; ++i)
    {
      auto [h, position] = crossing(start.fixed, its, is_along ? i : its.size - 1 - i);
      const double gap = 0.3 / (on_edges.size(edge_of(h)) + 1); // less than half of the distance
      position += start.comes_from_left ? gap : -gap;
      if (is_along)
        result.push_back({h, position});
      else
        result.push_back({opposite_of(h), 1 - position});
    }
    const int rest = static_cast<int>(crossings(loop()).size()) - mine.size;
    const Arc kept = {mine.first + mine.size, rest};
    for (int i = 0; i < rest; ++i)
      result.push_back(crossing(loop(), kept, i));
    cancel_returns(result);
    m_loops.back().crossings = std::move(result);
  }

  const Deck_cocycle& m_deck;
  const Flat_mesh& m_mesh;
  std::vector<Flat_loop> m_loops;
  std::vector<Meeting> m_meetings;       // in the order of the loop
  std::vector<std::vector<int>> m_order; // by fixed loop: its meetings, in its order
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_MINIMAL_POSITION_H
