// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_CANONICAL_REEB_GRAPH_H
#define CGAL_SURFACE_MESH_FOLIATION_CANONICAL_REEB_GRAPH_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/iterator.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

/// \file
/// finds poles and loops, and computes the graph, in one call.

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// The poles of a mesh, openings first, and the canonical loops between them. For least_modulus see
// Flat_loop_hierarchy.
template <class TriangleMesh>
class Canonical_system
{
public:
  Canonical_system(const Checked_mesh<TriangleMesh>& checked,
                   const Feature_pole_options& pole_options,
                   int number_of_proxy_vertices,
                   double least_modulus,
                   const Poll& poll)
    : m_checked(checked), m_poles(caps_of(checked.capped))
  {
    for (const Feature_pole& pole :
         feature_poles(checked, pole_options, Average_geodesic_distance(), poll))
      m_poles.push_back({pole.vertex});
    for (const int v : missing_poles(checked.flat, m_poles))
      m_poles.push_back({v});
    m_loops.emplace(
      checked.flat, m_poles,
      std::make_shared<const Proxy>(checked.flat, m_poles, Proxy::no_loops(),
                                    number_of_proxy_vertices + checked.flat.number_of_caps()),
      poll, least_modulus);
  }

  Canonical_system(const Canonical_system&) = delete;
  Canonical_system& operator=(const Canonical_system&) = delete;

  // Outputs the loops, too.
  template <class CanonicalLoopOutputIterator>
  void read(double min_modulus,
            bool shows_handles,
            Flat_loop_system& system,
            CanonicalLoopOutputIterator out) const
  {
    system.poles = m_poles;
    for (std::size_t p = 0; p < m_poles.size(); ++p)
    {
      Flat_loop loop;
      loop.height = 1;
      loop.pole = static_cast<int>(p);
      loop.is_tight = true;
      system.loops.push_back(loop);
    }
    for (const Loop_class& found : m_loops->hierarchy().loops())
      if (is_of_level(found, min_modulus, shows_handles))
      {
        system.loops.push_back(m_loops->proxy().on_fine_mesh(found.loop));
        system.loops.back().height = 1;
        *out++ = canonical_loop(found, m_loops->proxy(), m_checked.index);
      }
  }

private:
  const Checked_mesh<TriangleMesh>& m_checked;
  std::vector<Pole> m_poles;
  std::optional<Loops_on_proxy> m_loops;
};

template <class TriangleMesh, class NamedParameters>
Loop_system<TriangleMesh> canonical_loop_system(const TriangleMesh& mesh, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const double min_modulus =
    choose_parameter(get_parameter(np, internal_np::min_modulus), default_min_modulus);
  require_parameter(min_modulus >= 0, "the least modulus is not at least 0");
  const Feature_pole_options pole_options =
    feature_pole_options(select<internal_np::number_of_poles_t, internal_np::persistence_t,
                                internal_np::min_significance_t>(np),
                         Average_geodesic_distance());
  Checked_mesh<TriangleMesh> checked(mesh, select<CGAL::internal_np::vertex_point_t>(np));
  auto visitor =
    choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_foliation_visitor());
  const auto out = choose_parameter(get_parameter(np, internal_np::canonical_loop_output_iterator),
                                    CGAL::Emptyset_iterator());
  // whoever is told about the loops learns how they compare with all others
  constexpr bool tells_loops = !std::is_same_v<decltype(out), const CGAL::Emptyset_iterator>;
  Flat_loop_system flat;
  Canonical_system(checked, pole_options, number_of_proxy_vertices(np),
                   tells_loops ? 0 : min_modulus, poll_of(unwrapped(visitor)))
    .read(min_modulus, choose_parameter(get_parameter(np, internal_np::show_handles), true), flat,
          out);
  flat.mesh = checked.capped.mesh;
  Problems problems;
  complete(flat, problems);
  if (!problems.empty())
    throw Invalid_loops_exception(problems[0]);
  const auto data = std::make_shared<Loop_system_data<TriangleMesh>>(
    std::make_shared<const Indexed_mesh<TriangleMesh>>(std::move(checked.index),
                                                       std::move(checked.capped)));
  data->flat = std::move(flat);
  return Loop_system<TriangleMesh>(data);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationRef

computes the \ref SMFCanonical "canonical Reeb graph" of a mesh from nothing but the mesh, in one
call: finds its poles as `detect_feature_poles()` does, and those that `add_missing_poles()` adds,
with its openings as further ends; finds its canonical loops as `canonical_loops()` does; and
computes the harmonic foliation and the embedded Reeb graph, which is appended to `graph`. A visitor
is asked by all of them whether they should go on.

The result is that of these functions one after another, but the mesh is checked once.

\tparam ConcurrencyTag see `harmonic_foliation()`
\tparam TriangleMesh see `Loop_system`
\tparam Graph see `reeb_graph()`
\param mesh a mesh that `Loop_system` accepts, whose openings are ends
\param graph the graph to append to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": those of
  `harmonic_foliation()` and `reeb_graph()`, and the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{as for `Loop_system`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_poles, persistence, min_significance}
    \cgalParamDescription{as for `detect_feature_poles()`}
    \cgalParamDefault{those of `detect_feature_poles()`}
  \cgalParamNEnd
  \cgalParamNBegin{min_modulus, show_handles}
    \cgalParamDescription{as for `canonical_loops()`}
    \cgalParamDefault{0.6, `true`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_proxy_vertices}
    \cgalParamDescription{the number of vertices of the coarser mesh that loops are found on}
    \cgalParamType{`int`, at least 100}
    \cgalParamDefault{5000}
  \cgalParamNEnd
  \cgalParamNBegin{canonical_loop_output_iterator}
    \cgalParamDescription{receives the canonical loops, in the order of their arcs, which follow
      those of the poles. Without it, classes that are certain to have smaller moduli are not looked
      at more closely, which on surfaces without handles saves most of the time for loops.}
    \cgalParamType{an output iterator for `Canonical_loop<TriangleMesh>`}
    \cgalParamDefault{`CGAL::Emptyset_iterator`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the foliation; its `system()` has the poles and the loops

\throws whatever these functions throw; then `graph` is unchanged
\throws Invalid_loops_exception if a surface of genus 0 has fewer than two vertices that can be
  poles

\sa `foliation_reeb_graph()`
*/
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class TriangleMesh,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Measured_foliation<TriangleMesh> canonical_reeb_graph(
  const TriangleMesh& mesh,
  Graph& graph,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<
    CGAL::internal_np::vertex_point_t, internal_np::number_of_poles_t, internal_np::persistence_t,
    internal_np::min_significance_t, internal_np::min_modulus_t, internal_np::show_handles_t,
    internal_np::number_of_proxy_vertices_t, internal_np::canonical_loop_output_iterator_t,
    internal::Harmonic_foliation_parameters, internal::Reeb_graph_parameters>(np);
  const Measured_foliation<TriangleMesh> foliation = harmonic_foliation<ConcurrencyTag>(
    internal::canonical_loop_system(mesh, np),
    internal::select<internal::Harmonic_foliation_parameters>(np));
  reeb_graph(foliation, graph, internal::select<internal::Reeb_graph_parameters>(np));
  return foliation;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_CANONICAL_REEB_GRAPH_H
