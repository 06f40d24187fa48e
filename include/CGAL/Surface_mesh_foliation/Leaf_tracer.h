// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_LEAF_TRACER_H
#define CGAL_SURFACE_MESH_FOLIATION_LEAF_TRACER_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Arc_paths.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Face_location.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Centroid.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/essential_leaf.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is a regular leaf of a foliation: a closed curve on the surface.
*/
template <class Point>
struct Leaf
{
  std::size_t arc;           ///< the arc in whose component it lies
  double level;              ///< its distance from end 0 of the arc
  std::vector<Point> points; ///< where it crosses edges; the first is repeated at the end
  double length;             ///< its length
  Point centroid;            ///< its centroid, weighted by length
};

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

traces regular leaves [Section 5.2.4], each in time linear in the number of faces that it crosses.

Leaves run straight through the faces of the mesh, and so do those of `leaf()` and of the embedding.
The points of a leaf are ordered such that larger levels lie to its left, seen from outside.

All decisions are combinatorial: a vertex whose parameter is at least the level of a leaf counts as
above it. So a leaf is always a single closed curve that runs around its component, even where many
vertices have the same parameter.

\tparam TriangleMesh see `Loop_system`
*/
template <class TriangleMesh>
class Leaf_tracer
{
  using Traits = boost::graph_traits<TriangleMesh>;

public:
  using Point = typename Loop_system<TriangleMesh>::Point; ///< a point with `double` coordinates
  using vertex_descriptor = typename Traits::vertex_descriptor;
  using face_descriptor = typename Traits::face_descriptor;

  /// A position in a face: the weights of its corners, in the order of `source(h)`, `target(h)` and
  /// `target(next(h))` with `h = halfedge(f, mesh)`, as for \cgal's
  /// `Polygon_mesh_processing::Face_location`.
  using Barycentric_coordinates = std::array<double, 3>;

  /// is where the foliation sends a point of the surface.
  struct Location
  {
    bool is_arc;       ///< whether the point lies on a regular leaf
    std::size_t index; ///< the arc of its component, or the node whose critical leaf it lies on
    double level;      ///< its distance from end 0 of the arc; 0 at a node
  };

  /// prepares to trace leaves of a foliation, in linear time. The foliation is shared.
  explicit Leaf_tracer(const Measured_foliation<TriangleMesh>& foliation)
    : m_foliation(foliation), m_paths(m_foliation.state())
  {}

  /// returns the leaf of an arc at a distance `t` from its end 0; see `leaf()`.
  /// \throws Invalid_parameter_exception if there is no such arc, or `t` is not strictly between 0
  ///   and its height
  Leaf<Point> leaf(std::size_t arc, double t) const
  {
    internal::require_parameter(arc < m_foliation.system().number_of_arcs() && t > 0 &&
                                  t < m_foliation.system().height(arc),
                                "there is no leaf at level ", t, " of arc ", arc);
    const int a = static_cast<int>(arc);
    Crossings crossings = trace(m_paths.step_at(a, t), t);
    if (is_essential(crossings))
      return made_of(crossings, arc, t);
    // only where the foliation is flat up to rounding
    for (const internal::Leaf_crossing& step : m_paths.all_steps_at(a, t))
      if (crossings = trace(step, t); is_essential(crossings))
        break;
    return made_of(crossings, arc, t);
  }

  /// outputs `number` leaves of an arc of height \f$k\f$, at the levels \f$ik/(n+1)\f$: the measure
  /// between neighbors is constant.
  /// \param arc the arc
  /// \param number the number \f$n\f$ of leaves
  /// \param out an output iterator for `Leaf<Point>`
  /// \returns the output iterator
  /// \throws Invalid_parameter_exception if there is no such arc
  template <class LeafOutputIterator>
  LeafOutputIterator evenly_spaced_leaves(std::size_t arc,
                                          std::size_t number,
                                          LeafOutputIterator out) const
  {
    if (number == 0)
      return out;
    internal::require_parameter(arc < m_foliation.system().number_of_arcs(), "there is no arc ",
                                arc);
    const double height = m_foliation.system().height(arc);
    for (std::size_t i = 1; i <= number; ++i)
      *out++ = leaf(arc, height * (static_cast<double>(i) / static_cast<double>(number + 1)));
    return out;
  }

  /*!
  returns where a point lies, in constant time (except for edges that pass many arcs).

  The middle of a tripod saddle, a triangle that no straight leaf enters, lies on the critical leaf.

  \param f the face that the point lies in
  \param coordinates the position of the point: not negative, not all zero; they are divided by
    their sum

  \throws Invalid_parameter_exception if the coordinates are not of this form
  */
  Location locate(face_descriptor f, const Barycentric_coordinates& coordinates) const
  {
    const internal::Face_location place = face_location(f, coordinates);
    return {place.is_arc(), static_cast<std::size_t>(place.index()), place.level()};
  }

  /*!
  returns the leaf through a point, or nothing if there is none: if the point lies on a critical
  leaf (`locate()` tells on which), or on a plateau. A plateau is a part of the surface through
  which no leaf has to pass, such as a limb without a pole, so that parameters are equal there up to
  rounding. There, the level set of a point may be a whole face, or a closed curve around a vertex
  that bounds a disk.

  \param f the face that the point lies in
  \param coordinates the position of the point, see `locate()`

  \throws Invalid_parameter_exception if the coordinates are negative, infinite or all zero

  The time is linear in the number of faces that the leaf crosses.
  */
  std::optional<Leaf<Point>> leaf_through(face_descriptor f,
                                          const Barycentric_coordinates& coordinates) const
  {
    const internal::Face_location place = face_location(f, coordinates);
    if (!place.is_arc())
      return std::nullopt;
    return leaf_from(place.crossing(), place.index(), place.level());
  }

  /// returns the leaf through a vertex, or nothing if there is none; see above.
  std::optional<Leaf<Point>> leaf_through(vertex_descriptor v) const
  {
    const int i = m_foliation.system().data().mesh_index.index(v);
    if (state().is_at_node(i))
      return std::nullopt;
    return leaf_from(internal::Face_location::crossing_below(state(), i), state().arc(i),
                     state().parameter(i));
  }

private:
  using Crossings = std::vector<internal::Leaf_crossing>;

  const internal::Foliation_state& state() const { return m_foliation.state(); }

  Crossings trace(const internal::Leaf_crossing& start, double level) const
  {
    return internal::Level_tracer(state()).trace(start, level);
  }

  bool is_essential(const Crossings& leaf) const
  {
    return !state().deck().group().are_equal(internal::translation_of(state(), leaf), {});
  }

  std::optional<Leaf<Point>> leaf_from(const std::optional<internal::Leaf_crossing>& start,
                                       int arc,
                                       double level) const
  {
    if (!start)
      return std::nullopt;
    const Crossings crossings = trace(*start, level);
    if (!is_essential(crossings))
      return std::nullopt;
    return made_of(crossings, static_cast<std::size_t>(arc), level);
  }

  Leaf<Point> made_of(const Crossings& crossings, std::size_t arc, double level) const
  {
    std::vector<internal::Point> points;
    for (const internal::Leaf_crossing& crossing : crossings)
      points.push_back(internal::point_of_crossing(state(), crossing, level));
    points.push_back(points.front());
    internal::Centroid centroid;
    for (std::size_t i = 1; i < points.size(); ++i)
      centroid.add(points[i - 1], points[i]);
    Leaf<Point> result = {arc, level, {}, centroid.length(), point(centroid.point())};
    for (const internal::Point& p : points)
      result.points.push_back(point(p));
    return result;
  }

  static Point point(const internal::Point& p) { return Point(p[0], p[1], p[2]); }

  internal::Face_location face_location(face_descriptor f,
                                        const Barycentric_coordinates& coordinates) const
  {
    const int first = m_foliation.system().data().mesh_index.index(halfedge(f, m_foliation.mesh()));
    const int face = state().mesh().face(first);
    double sum = 0;
    for (double c : coordinates)
      sum = c >= 0 ? sum + c : std::nan("");
    if (!(sum > 0 && std::isfinite(sum)))
      throw Invalid_parameter_exception(internal::problem(Problem_kind::INVALID_PARAMETER,
                                                          "the barycentric coordinates in face ",
                                                          face, " are negative, infinite or zero")
                                          .faces({internal::index(face)}));
    // the halfedge of a face may have changed since the mesh was copied
    const std::array<int, 3> halfedges = state().mesh().halfedges(face);
    std::array<double, 3> share;
    for (int i = 0, h = first; i < 3; ++i, h = state().mesh().next(h))
      for (int j : {0, 1, 2})
        if (halfedges[j] == h)
          share[j] = coordinates[i] / sum;
    return internal::Face_location(state(), face, share);
  }

  Measured_foliation<TriangleMesh> m_foliation;
  internal::Arc_paths m_paths;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_LEAF_TRACER_H
