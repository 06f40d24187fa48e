// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_CHECKS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_CHECKS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Regions.h>

#include <array>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

class Pole_checks
{
public:
  Pole_checks(const Flat_mesh& mesh, Problems& problems)
    : m_mesh(mesh), m_problems(problems), m_pole_of_vertex(mesh.number_of_vertices(), -1)
  {}

  void operator()(const std::vector<Pole>& poles)
  {
    for (std::size_t p = 0; p < poles.size(); ++p)
      mark(poles, static_cast<int>(p));
    if (m_problems.empty())
      for (const Pole& pole : poles)
        if (!pole.is_cap())
          check_path(pole);
  }

private:
  void report(const std::string& message, Indices vertices)
  {
    m_problems.push_back(
      problem(Problem_kind::INVALID_POLE, message).vertices(std::move(vertices)));
  }

  void mark(const std::vector<Pole>& poles, int p)
  {
    for (int v : poles[p])
    {
      const int other = v < 0 || v >= m_mesh.number_of_vertices() ? -1 : m_pole_of_vertex[v];
      if (v < 0 || v >= m_mesh.number_of_vertices())
        report(text("pole ", p, " is not a vertex of the mesh"), {});
      else if (other == p)
        report(text("line pole ", p, " visits vertex ", v, " twice"), {index(v)});
      else if (other >= 0)
        report(text("vertex ", v, " belongs to poles ", other, " and ", p,
                    poles[p].is_cap() || poles[other].is_cap()
                      ? "; an opening is a pole with all vertices of its border"
                      : ""),
               {index(v)});
      else
        m_pole_of_vertex[v] = p;
    }
  }

  void check_path(const Pole& pole)
  {
    for (std::size_t i = 0; i < pole.size(); ++i)
    {
      if (i > 0 && m_mesh.find_halfedge(pole[i - 1], pole[i]) < 0)
        report(text("line pole: vertices ", pole[i - 1], " and ", pole[i], " have no edge"),
               {index(pole[i - 1]), index(pole[i])});
      for (int h : m_mesh.ring(pole[i]))
      {
        const int u = m_mesh.target(h);
        if (m_pole_of_vertex[u] == m_pole_of_vertex[pole[i]] && pole[i] < u &&
            !(i > 0 && pole[i - 1] == u) && !(i + 1 < pole.size() && pole[i + 1] == u))
          report(text("line pole is not an induced path: edge ", pole[i], " ", u,
                      " joins two of its", " vertices that are not consecutive"),
                 {index(pole[i]), index(u)});
      }
    }
  }

  const Flat_mesh& m_mesh;
  Problems& m_problems;
  std::vector<int> m_pole_of_vertex;
};

// Poles are vertices, no two the same; a line is an induced path, so that a thin tube around it
// is a disk whose boundary is a simple curve.
inline void check_poles(const Flat_mesh& mesh, const std::vector<Pole>& poles, Problems& problems)
{
  Pole_checks check(mesh, problems);
  check(poles);
}

// Removes pairs of crossings where a closed loop crosses an edge and comes straight back, as around
// an ear of a border, a face with two border edges.
inline void cancel_returns(std::vector<Flat_crossing>& crossings)
{
  const auto are_inverse = [](const Flat_crossing& x, const Flat_crossing& y) {
    return x.halfedge == opposite_of(y.halfedge);
  };
  std::vector<Flat_crossing> kept;
  for (const Flat_crossing& crossing : crossings)
    if (!kept.empty() && are_inverse(kept.back(), crossing))
      kept.pop_back();
    else
      kept.push_back(crossing);
  std::size_t first = 0, end = kept.size();
  for (; first + 1 < end && are_inverse(kept[first], kept[end - 1]); ++first)
    --end;
  crossings.assign(kept.begin() + first, kept.begin() + end);
}

// The loop that runs counterclockwise just around a pole. Precondition: the pole is valid.
inline Flat_loop tight_loop(const Flat_mesh& mesh, const Pole& pole, int p, double height)
{
  std::vector<int> tree;
  if (!pole.is_cap())
    for (std::size_t i = 1; i < pole.size(); ++i)
      tree.push_back(edge_of(mesh.find_halfedge(pole[i], pole.parent(i))));
  const auto is_in_tree = [&](int h) {
    return pole.is_cap() ? mesh.is_cap_edge(edge_of(h))
                         : std::find(tree.begin(), tree.end(), edge_of(h)) != tree.end();
  };
  Flat_loop result;
  result.height = height;
  result.pole = p;
  result.is_tight = true;
  const int first = mesh.ring(pole[0])[0];
  int h = first;
  do
  {
    if (is_in_tree(h))
      h = opposite_of(h); // on to the other end
    else if (!pole.is_cap() || !mesh.is_border_edge(edge_of(h)))
      result.crossings.push_back({opposite_of(h), 0.75});
    h = mesh.rotate(h);
  } while (h != first);
  if (pole.is_cap())
    cancel_returns(result.crossings);
  return result;
}

// whether a mesh has a vertex that does not lie on the border of its only opening
inline bool has_inner_vertex(const Flat_mesh& mesh, const Pole& cap)
{
  return static_cast<std::size_t>(mesh.number_of_vertices()) > cap.size();
}

// Each loop is a closed curve in general position that does not run through a line pole.
inline void check_curve(const Flat_mesh& mesh,
                        const std::vector<Pole>& poles,
                        const Flat_loop& loop,
                        int a,
                        Problems& problems)
{
  const auto report = [&](const std::string& message, int h) {
    problems.push_back(problem(Problem_kind::INVALID_LOOP, "loop ", a, " ", message)
                         .vertices({index(mesh.source(h)), index(mesh.target(h))})
                         .loops({index(a)}));
  };
  if (loop.crossings.empty() && loop.pole >= 0)
    problems.push_back(problem(Problem_kind::INESSENTIAL_LOOP, "loop ", a,
                               " is inessential: the surface is a disk, and its opening is the "
                               "only pole; ",
                               has_inner_vertex(mesh, poles[loop.pole])
                                 ? "give another one"
                                 : "there is no vertex inside for another one: subdivide the mesh")
                         .loops({index(a)}));
  else if (loop.crossings.empty())
    problems.push_back(
      problem(Problem_kind::INVALID_LOOP, "loop ", a, " has neither a crossing nor a pole")
        .loops({index(a)}));
  for (std::size_t i = 0; i < loop.crossings.size(); ++i)
  {
    const auto [h, position] = loop.crossings[i];
    const int next = loop.crossings[(i + 1) % loop.crossings.size()].halfedge;
    const auto edge = [&, h = h] { return text("edge ", mesh.source(h), " ", mesh.target(h)); };
    if (!(position > 0 && position < 1))
      report(text("crosses ", edge(), " at position ", position, ", not between 0 and 1"), h);
    if (next == opposite_of(h))
      report(text("turns back at ", edge()), h);
    else if (mesh.face(opposite_of(h)) != mesh.face(next))
      report(text("jumps after ", edge(), ": its next edge is not in the same face"), h);
    if (mesh.is_border_edge(edge_of(h)))
      report(text("crosses the border of an opening at ", edge()), h);
    for (const Pole& pole : poles)
      if (pole.is_line())
        for (std::size_t j = 1; j < pole.size(); ++j)
          if ((pole[j - 1] == mesh.source(h) && pole[j] == mesh.target(h)) ||
              (pole[j] == mesh.source(h) && pole[j - 1] == mesh.target(h)))
            report(text("crosses a line pole at ", edge()), h);
  }
}

inline void check_heights(const std::vector<Flat_loop>& loops, Problems& problems)
{
  constexpr double least = 1e-300; // so that parameters in the arc have digits
  for (std::size_t a = 0; a < loops.size(); ++a)
    if (!(loops[a].height >= least && std::isfinite(loops[a].height)))
      problems.push_back(problem(Problem_kind::INVALID_HEIGHT, "the height of loop ", a, " is ",
                                 loops[a].height, ", not a finite number of at least ", least)
                           .loops({a}));
}

class Disjointness_check
{
public:
  Disjointness_check(const Flat_mesh& mesh,
                     const std::vector<Flat_loop>& loops,
                     const Edge_crossings& crossings,
                     Problems& problems)
    : m_mesh(mesh), m_loops(loops), m_crossings(crossings), m_problems(problems)
  {}

  void operator()()
  {
    for (int e = 0; e < m_mesh.number_of_edges(); ++e)
      for (int i = 1; i < m_crossings.size(e); ++i)
        if (Edge_crossings::coincide(m_crossings.entry(e, i - 1), m_crossings.entry(e, i)))
          report(halfedge_of(e), m_crossings.entry(e, i - 1).loop, m_crossings.entry(e, i).loop);
    if (m_problems.empty())
      for (int e = 0; e < m_mesh.number_of_edges(); ++e)
        if (m_crossings.size(e) > 0) // otherwise no loop cuts off a corner at an end of the edge
          for (int h : halfedges_of_edge(e))
            check_corner(h);
  }

private:
  void check_corner(int h)
  {
    const int g = opposite_of(m_mesh.prev(h));
    for (int i = 0; i < m_crossings.number_at_corner(m_mesh, h); ++i)
    {
      const Edge_crossings::Entry& x = m_crossings.from_source(h, i);
      const Edge_crossings::Entry& y = m_crossings.from_source(g, i);
      if (x.loop != y.loop || segment(x, m_mesh.face(h)) != segment(y, m_mesh.face(h)))
        return report(h, x.loop, y.loop);
    }
  }

  // the segment of the loop in face f that ends at a crossing, by the crossing where it starts
  int segment(const Edge_crossings::Entry& x, int f) const
  {
    const int size = static_cast<int>(m_loops[x.loop].crossings.size());
    return m_mesh.face(x.halfedge) == f ? (x.index + size - 1) % size : x.index;
  }

  void report(int h, int a, int b)
  {
    const std::string place = text(" at edge ", m_mesh.source(h), " ", m_mesh.target(h));
    const Indices vertices = {index(m_mesh.source(h)), index(m_mesh.target(h))};
    const Indices faces = {index(m_mesh.face(h))};
    if (a == b)
      m_problems.push_back(problem(Problem_kind::INVALID_LOOP, "loop ", a, " meets itself", place)
                             .vertices(vertices)
                             .faces(faces)
                             .loops({index(a)}));
    else
      m_problems.push_back(problem(Problem_kind::INTERSECTING_LOOPS, "loops ", (std::min)(a, b),
                                   " and ", (std::max)(a, b), " meet", place)
                             .vertices(vertices)
                             .faces(faces)
                             .loops({index((std::min)(a, b)), index((std::max)(a, b))}));
  }

  const Flat_mesh& m_mesh;
  const std::vector<Flat_loop>& m_loops;
  const Edge_crossings& m_crossings;
  Problems& m_problems;
};

// The loops are simple and disjoint iff on every edge their crossings have an order, and around
// every corner of a triangle the i-th crossings of both edges are ends of one segment.
inline void check_disjointness(const Flat_mesh& mesh,
                               const std::vector<Flat_loop>& loops,
                               const Edge_crossings& crossings,
                               Problems& problems)
{
  Disjointness_check check(mesh, loops, crossings, problems);
  check();
}

// Loops are essential and pairwise not homotopic in the surface minus its poles iff no region is a
// disk without a pole or an annulus without a pole between two different loops [Section 4.2.2], and
// every pole lies alone in a disk bounded by its own loop.
inline void check_regions(const Flat_mesh& mesh,
                          const std::vector<Pole>& poles,
                          const std::vector<Flat_loop>& loops,
                          const Regions& regions,
                          bool may_be_homotopic,
                          Problems& problems)
{
  for (int r = 0; r < regions.number_of_regions(); ++r)
  {
    const Regions::Region& region = regions.region(r);
    if (region.genus() != 0 || region.poles.size() > 1)
      continue;
    const std::size_t a = region.sides.empty() ? 0 : index(region.sides[0].loop);
    if (region.sides.size() == 1 && region.poles.empty())
      problems.push_back(
        problem(Problem_kind::INESSENTIAL_LOOP, "loop ", a,
                " is inessential: it bounds a disk without pole",
                mesh.genus() == 0 && poles.size() < 2 ? " (a sphere needs at least two poles)" : "")
          .loops({a}));
    else if (region.sides.size() == 2 && region.poles.empty() && !may_be_homotopic &&
             region.sides[0].loop != region.sides[1].loop)
      problems.push_back(problem(Problem_kind::HOMOTOPIC_LOOPS, "loops ", a, " and ",
                                 region.sides[1].loop,
                                 " are homotopic: they bound an annulus without pole")
                           .loops({a, index(region.sides[1].loop)}));
  }
  for (const Flat_loop& loop : loops)
  {
    if (loop.pole < 0)
      continue;
    const int v = poles[loop.pole][0];
    const Regions::Region& region = regions.region(regions.region_of_vertex(v));
    const bool is_disk = region.genus() == 0 && region.sides.size() == 1;
    if (!is_disk || region.poles.size() != 1 || &loops[region.sides[0].loop] != &loop)
      problems.push_back(problem(Problem_kind::INVALID_LOOP, "the loop given for pole ", loop.pole,
                                 " (vertex ", v,
                                 ") does not bound a disk that holds just this pole")
                           .vertices({index(v)})
                           .loops({index(static_cast<int>(&loop - loops.data()))}));
  }
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_LOOPS_LOOP_CHECKS_H
