// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_CANONICAL_LOOPS_H
#define CGAL_SURFACE_MESH_FOLIATION_CANONICAL_LOOPS_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Loops_on_proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/check_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/to_loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

is the least modulus of a canonical loop unless another one is asked for. Any value above
\f$ 1/2 \f$ gives unique loops; on the shapes that were looked at, few moduli lie near this one.
*/
constexpr double default_min_modulus = 0.6;

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

is a loop of a `Loop_hierarchy`.

\tparam TriangleMesh see `Loop_system`
*/
template <class TriangleMesh>
struct Canonical_loop
{
  Loop<TriangleMesh> loop; ///< a simple loop, disjoint from all others of the hierarchy
  /// the modulus of its homotopy class on the surface minus its poles and openings: the largest
  /// ratio of height to circumference of an annulus in the class, without unit
  double modulus = 0;
  /// its modulus divided by the largest one found of a class that crosses it, or by the largest one
  /// that Minsky's inequality admits, if that is less; infinite if there is none, or if the modulus
  /// is below a quarter. The inequality makes it at least \f$ 4 \f$ times the square of the modulus
  /// if the loop separates the surface, and at least the square otherwise.
  double dominance = 0;
  bool is_separating = false; ///< whether the surface falls apart along it
  /// whether the surface loses a handle if it is cut along the loop after all before it
  bool cuts_handle = false;
  /// the position in the hierarchy of the last loop before it that bounds the piece it divides, or
  /// -1 if it divides a piece that is bounded by none
  std::ptrdiff_t parent = -1;

  /// The factor up to which the modulus and the dominance keep the loop chosen, if the least
  /// modulus is `min_modulus`: deformations of the surface that stretch every small circle to an
  /// ellipse whose axes have a ratio below this number, \f$ K \f$, change no modulus by more than a
  /// factor of \f$ K \f$.
  double margin(double min_modulus = default_min_modulus) const
  {
    return (std::min)(modulus / min_modulus, std::sqrt(dominance));
  }

  /// tells whether the modulus is so close to the bound, within a sixth of it, that a shape not
  /// much different has another graph. (From 0.5 to 0.7 by default.)
  bool is_near_bound(double min_modulus = default_min_modulus) const
  {
    return modulus >= min_modulus * 5 / 6 && modulus <= min_modulus * 7 / 6;
  }
};

namespace internal {

// whether a loop of a hierarchy is one of those with some detail
template <class HierarchyLoop>
bool is_of_level(const HierarchyLoop& loop, double min_modulus, bool shows_handles)
{
  return loop.modulus >= min_modulus || (shows_handles && loop.cuts_handle);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

contains disjoint loops that cut a surface with poles into pairs of pants, by falling modulus. The
first loops, with moduli above a bound, are a description of the surface with as much detail as the
bound admits; see `canonical_loops()`.

\tparam TriangleMesh see `Loop_system`
*/
template <class TriangleMesh>
class Loop_hierarchy
{
public:
  /// returns the loops by falling modulus.
  const std::vector<Canonical_loop<TriangleMesh>>& loops() const { return m_loops; }

  /// returns the positions of the loops with at least the given modulus and, if `shows_handles`,
  /// of those below that are needed so that the dual graph has as many independent cycles as the
  /// surface has handles. Takes linear time.
  std::vector<std::size_t> level(double min_modulus = default_min_modulus,
                                 bool shows_handles = true) const
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < m_loops.size(); ++i)
      if (internal::is_of_level(m_loops[i], min_modulus, shows_handles))
        result.push_back(i);
    return result;
  }

  /// tells whether the loops cut the surface into pairs of pants. They do, unless no sweep meets a
  /// loop where one is missing, as with long line poles, or with very many poles or handles.
  bool is_complete() const { return m_is_complete; }

  /// returns the bound above which no separating class other than those of the loops has a modulus,
  /// whatever loops were looked at: \f$ 1 / (4m) \f$, where \f$ m \f$ is the smallest modulus.
  /// Infinity on surfaces with handles, and if the loops do not cut the surface into pairs of
  /// pants.
  double completeness_bound() const { return m_completeness_bound; }

  /// \cond SKIP_IN_MANUAL
  Loop_hierarchy(std::vector<Canonical_loop<TriangleMesh>> loops,
                 bool is_complete,
                 double completeness_bound)
    : m_loops(std::move(loops)),
      m_is_complete(is_complete),
      m_completeness_bound(completeness_bound)
  {}
  /// \endcond

private:
  std::vector<Canonical_loop<TriangleMesh>> m_loops;
  bool m_is_complete;
  double m_completeness_bound;
};

namespace internal {

inline double completeness_bound(const Flat_loop_hierarchy& hierarchy, int genus)
{
  if (genus > 0 || !hierarchy.is_complete())
    return std::numeric_limits<double>::infinity();
  return hierarchy.loops().empty() ? 0 : 1 / (4 * hierarchy.loops().back().modulus);
}

// a loop that was found on a proxy, carried to the mesh itself
template <class TriangleMesh>
Canonical_loop<TriangleMesh> canonical_loop(const Loop_class& found,
                                            const Proxy& proxy,
                                            const Mesh_index<TriangleMesh>& index)
{
  Canonical_loop<TriangleMesh> result;
  result.loop = to_loop(proxy.on_fine_mesh(found.loop), index);
  result.modulus = found.modulus;
  result.dominance = found.largest_crossing > 0 ? found.modulus / found.largest_crossing
                                                : std::numeric_limits<double>::infinity();
  result.is_separating = found.is_separating;
  result.cuts_handle = found.cuts_handle;
  result.parent = found.parent;
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

finds loops that cut a surface with poles into pairs of pants, those with large moduli first.

The <em>modulus</em> of a homotopy class of loops is the largest ratio of height to circumference of
an annulus that is embedded in the surface in this class, without covering a pole: one over the
extremal length of the class. It is that of the component that a foliation with this loop alone has.
Loops are chosen greedily: of the classes found that can be moved off all loops chosen before,
always the one with the largest modulus. By Minsky's inequality \cgalCite{m-tgtht-93},
\f$ i(a, b)^2 \, \mathrm{Mod}(a) \, \mathrm{Mod}(b) \le 1 \f$ for two classes with geometric
intersection number \f$ i(a, b) \f$, which is even if one of them separates the surface. So
separating loops with moduli above \f$ 1/2 \f$, and others with moduli above \f$ 1 \f$, cross no
class above these bounds, and are independent of everything but the shape.

Classes are those of the loops that `propose_loops()` finds with poles as punctures, for the
distance from all poles and for that from each of them. Two loops are in one class, or can be moved
apart, by exact computations with words in the fundamental group.

Moduli are computed on a coarser mesh, whose edges are as long as the way along `mesh`, and are
flipped until it is an intrinsic Delaunay triangulation, so that moduli do not depend on the
triangles of `mesh`. They are lower bounds of those of the surface that the coarser mesh represents.
Where it has too few vertices around a handle or a narrow part, moduli are measured again on another
one that is finer there, with up to three times as many vertices, and all vertices of `mesh` beside
the loops. On a surface without handles, only loops with moduli of at least 0.57 are measured again.

\tparam TriangleMesh see `Loop_system`
\param mesh a mesh that `Loop_system` accepts
\param poles poles without loops of their own; may be empty on a surface with handles
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{as for `Loop_system`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_proxy_vertices}
    \cgalParamDescription{the number of vertices of the coarser mesh that moduli are computed on,
      where it need not be finer}
    \cgalParamType{`int`, at least 100}
    \cgalParamDefault{5000}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{its `go_on()` is called before each step that may take long; if it returns
      `false`, there is no result}
    \cgalParamType{a model of `FoliationVisitor`}
    \cgalParamDefault{`Default_foliation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_mesh_exception if `Loop_system` would
\throws Invalid_loops_exception if a pole is invalid, or there is a loop other than one that hugs
  its pole
\throws Certificate_exception if moduli are found that contradict Minsky's inequality
\throws Solver_exception if a linear system cannot be solved
\throws Stopped_exception if the visitor's `go_on()` returns `false`

The time is that of a foliation of the coarser mesh for each class, of one of the finer one for each
class that is measured again, and \f$ O(n \log n) \f$ for these meshes themselves.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Loop_hierarchy<TriangleMesh> loop_hierarchy(
  const TriangleMesh& mesh,
  const Poles_and_loops<TriangleMesh>& poles,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t,
                             internal_np::number_of_proxy_vertices_t, CGAL::internal_np::visitor_t>(
    np);
  auto visitor = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::visitor), Default_foliation_visitor());
  const internal::Checked_mesh<TriangleMesh> checked(
    mesh, internal::select<CGAL::internal_np::vertex_point_t>(np));
  const internal::Flat_mesh& flat = checked.flat;
  const std::vector<internal::Pole> fine_poles =
    internal::poles_to_sweep_from(poles, checked.index, checked.capped);
  const internal::Loops_on_proxy found(
    flat, fine_poles,
    std::make_shared<const internal::Proxy>(flat, fine_poles, internal::Proxy::no_loops(),
                                            internal::number_of_proxy_vertices(np) +
                                              flat.number_of_caps()),
    internal::poll_of(internal::unwrapped(visitor)));
  const internal::Flat_loop_hierarchy& hierarchy = found.hierarchy();
  std::vector<Canonical_loop<TriangleMesh>> loops;
  for (const internal::Loop_class& loop : hierarchy.loops())
    loops.push_back(internal::canonical_loop(loop, found.proxy(), checked.index));
  return Loop_hierarchy<TriangleMesh>(std::move(loops), hierarchy.is_complete(),
                                      internal::completeness_bound(hierarchy, flat.genus()));
}

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

adds to a collection of poles the loops of one level of the `loop_hierarchy()`: those with at least
a given modulus and, by default, those that show the remaining handles. The foliation then has a
component for each narrow part of the surface, such as the waist of a body or the trunk between two
branchings of a vessel, and its Reeb graph depends on nothing but the shape.

\param mesh a mesh that `Loop_system` accepts
\param poles_and_loops poles without loops of their own, to which loops of height 1 are added; may
  be empty on a surface with handles
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those of
  `loop_hierarchy()` and the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{min_modulus}
    \cgalParamDescription{the least modulus of a loop. Above \f$ 1/2 \f$, separating loops are
      unique; shapes whose moduli lie close to the bound are near to another graph.}
    \cgalParamType{`double`, not negative; infinity adds only what shows handles}
    \cgalParamDefault{0.6}
  \cgalParamNEnd
  \cgalParamNBegin{show_handles}
    \cgalParamDescription{whether loops with smaller moduli are added, too, as long as the dual
      graph has fewer independent cycles than the surface has handles}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the loops that were added, in the order of addition

\throws as `loop_hierarchy()`
\throws Invalid_parameter_exception if the modulus is negative or not a number

\sa `propose_loops()`
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Canonical_loop<TriangleMesh>> canonical_loops(
  const TriangleMesh& mesh,
  Poles_and_loops<TriangleMesh>& poles_and_loops,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<CGAL::internal_np::vertex_point_t,
                             internal_np::number_of_proxy_vertices_t, CGAL::internal_np::visitor_t,
                             internal_np::min_modulus_t, internal_np::show_handles_t>(np);
  const double min_modulus =
    choose_parameter(get_parameter(np, internal_np::min_modulus), default_min_modulus);
  internal::require_parameter(min_modulus >= 0, "the least modulus is not at least 0");
  const bool shows_handles = choose_parameter(get_parameter(np, internal_np::show_handles), true);
  const Loop_hierarchy<TriangleMesh> hierarchy = loop_hierarchy(
    mesh, poles_and_loops,
    internal::select<CGAL::internal_np::vertex_point_t, internal_np::number_of_proxy_vertices_t,
                     CGAL::internal_np::visitor_t>(np));
  std::vector<Canonical_loop<TriangleMesh>> result;
  for (const std::size_t i : hierarchy.level(min_modulus, shows_handles))
  {
    result.push_back(hierarchy.loops()[i]);
    poles_and_loops.add_loop(result.back().loop);
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_CANONICAL_LOOPS_H
