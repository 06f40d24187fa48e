// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_LOOP_MODULUS_H
#define CGAL_SURFACE_MESH_FOLIATION_LOOP_MODULUS_H

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/check_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

computes the modulus of the homotopy class of a loop on a surface minus its poles and openings: the
largest ratio of height to circumference of an annulus that is embedded in the surface in this
class; see `loop_hierarchy()`.

Of the other loops only the poles count. The modulus depends on the shape, not on the heights or on
where in its class the loop is drawn. It is measured on one coarser mesh, which is as fine as `mesh`
beside the loop; `loop_hierarchy()`, which measures again where that mesh has few vertices around a
tube, may tell another modulus of it, by a percent or two. With as many proxy vertices as `mesh`
has, there is no coarser mesh.

\tparam TriangleMesh see `Loop_system`
\param mesh a mesh
\param poles_and_loops what `Loop_system` accepts
\param loop the id of the loop, which may be that of a pole
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `vertex_point_map`,
  and `number_of_proxy_vertices` as for `loop_hierarchy()`

\returns the modulus; infinity for a loop around a pole that is a single vertex, around which there
  are annuli of any modulus

\throws Invalid_parameter_exception if there is no such loop
\throws whatever `Loop_system` throws
\throws Solver_exception if a linear system cannot be solved

The time is that of `Loop_system`, of a coarser mesh, \f$ O(n \log n) \f$, and of one foliation on
it.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
double loop_modulus(const TriangleMesh& mesh,
                    const Poles_and_loops<TriangleMesh>& poles_and_loops,
                    std::size_t loop,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  using namespace internal;
  check_parameters<CGAL::internal_np::vertex_point_t, internal_np::number_of_proxy_vertices_t>(np);
  require_parameter(loop < poles_and_loops.size(), "there is no loop with the number given");
  const Loop_system<TriangleMesh> system(mesh, poles_and_loops,
                                         select<CGAL::internal_np::vertex_point_t>(np));
  const Flat_loop_system& flat = system.data().flat;
  const bool is_merged = !flat.merged_loops.empty();
  const Flat_loop& flat_loop = flat.loops[is_merged ? 0 : loop];
  const auto is_point = [](const Pole& pole) { return pole.size() == 1; };
  if (is_merged ? std::any_of(flat.poles.begin(), flat.poles.end(), is_point)
                : flat_loop.pole >= 0 && is_point(flat.poles[flat_loop.pole]))
    return std::numeric_limits<double>::infinity();
  const std::vector<Flat_loop> kept =
    flat_loop.pole >= 0 ? std::vector<Flat_loop>() : std::vector<Flat_loop>{flat_loop};
  const Proxy proxy(flat.mesh, flat.poles, kept, number_of_proxy_vertices(np));
  Class_moduli moduli(proxy.mesh(), proxy.lengths(), proxy.poles());
  return flat_loop.pole >= 0 ? moduli.of_pole(flat_loop.pole)
                             : moduli.of_loop(proxy.on_proxy(flat_loop)).modulus;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_LOOP_MODULUS_H
