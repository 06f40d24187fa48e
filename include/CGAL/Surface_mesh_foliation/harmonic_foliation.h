// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_HARMONIC_FOLIATION_H
#define CGAL_SURFACE_MESH_FOLIATION_HARMONIC_FOLIATION_H

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <functional>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

using Harmonic_foliation_parameters =
  Joined_parameters<Solver_parameters, CGAL::internal_np::sparse_linear_solver_t>;

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFoliation

computes the harmonic measured foliation of a loop system [Sections 3.2 and 5.1 of the paper]: the
one that minimizes \f$ \sum_e \alpha_e w_e^2 \f$ among all foliations in which loop \f$a\f$ has
height
\f$k_a\f$. With positive weights it is unique.

The paper iterates local Whitehead moves. Here the foliation is an equivariant map to a tree, so the
energy is convex, and a Newton method with an active set finds its minimum with a few sparse solves.
It starts from the solution on a coarser mesh, found in the same way. Which cell a vertex lies in
and which path an edge takes are discrete facts that are updated, never guessed from numbers.

Every result carries a certificate, checked in \f$O(n \log n)\f$ time, that it belongs to the class
of its loops: critical leaves and components, derived from the connectivity of the cut mesh alone,
form the dual graph of the system arc by arc; each component is an annulus whose middle leaf is
freely homotopic to its loop in the mesh minus the poles; and there is no pole that was not
requested.

If the tolerance is not reached within the iterations allowed, or the visitor stops the solver, the
result is still a certified foliation in the class of the loops, with
`statistics().has_converged == false`. (If the solver would stop at a foliation with folds, which
are not certified, it continues until they are gone, usually for one or two iterations, which are
not reported to the visitor; if the visitor has stopped it, it smooths the folds out in place,
without another linear system if possible.)

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`. The parallel
  version, which needs TBB, computes in parallel: edge weights and right-hand sides, energies and
  balances, the certificate with the cut mesh, the factorization of the default linear solver, and
  later the embedding of the graph; and the linear solver analyzes the pattern of its matrix during
  the solution on the coarser mesh. Triangular solves, and everything that moves leaves over
  vertices, run sequentially. The result is the same, bit for bit, with either tag and with any
  number of threads.
\tparam TriangleMesh see `Loop_system`
\param system the loop system
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{weights}
    \cgalParamDescription{the weights \f$\alpha\f$ of the edges}
    \cgalParamType{`Mean_value_weights`, `Cotangent_weights`, or a model of `ReadablePropertyMap`
      with
      `boost::graph_traits<TriangleMesh>::%edge_descriptor` as key type and a number type as value
      type}
    \cgalParamDefault{`Mean_value_weights()`}
  \cgalParamNEnd
  \cgalParamNBegin{allow_any_weights}
    \cgalParamDescription{whether weights that are not positive are accepted; then the only
      guarantee is that a result is certified}
    \cgalParamType{Boolean}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{tolerance}
    \cgalParamDescription{the solver stops when `Foliation_statistics::resolved_optimality` is
      below this value}
    \cgalParamType{`double`, positive}
    \cgalParamDefault{`1e-12`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_iterations}
    \cgalParamDescription{the largest number of iterations}
    \cgalParamType{`int`, not negative}
    \cgalParamDefault{`100`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{is called after each iteration and can stop the solver, with or without a
      result; pass `std::ref(visitor)` to keep its state}
    \cgalParamType{a model of `FoliationVisitor`}
    \cgalParamDefault{`Default_foliation_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{solves the linear systems}
    \cgalParamType{a `std::reference_wrapper` of a model of `FoliationLinearSolver`}
    \cgalParamDefault{a `Supernodal_cholesky_solver`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the foliation

\sa `Foliation_solver`, which starts from its last solution

\throws Invalid_parameter_exception if a weight is not finite and positive, or a parameter out of
  range
\throws Solver_exception if a linear system cannot be factored or solved
\throws Certificate_exception if the certificate does not hold
\throws Stopped_exception if the visitor's `go_on()` returns `false`
\throws whatever a member function of the visitor throws

The time is that of one sparse Cholesky factorization (rarely a few) with the pattern of the mesh's
Laplacian, one pair of triangular solves per iteration, and \f$O(n \log n)\f$ for everything else. A
linear solver that is not a model of `UpdatableFoliationLinearSolver` factors in each iteration.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class TriangleMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Measured_foliation<TriangleMesh> harmonic_foliation(
  const Loop_system<TriangleMesh>& system,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<internal::Harmonic_foliation_parameters>(np);

  Supernodal_cholesky_solver default_linear_solver;
  auto& linear_solver = choose_parameter(get_parameter(np, CGAL::internal_np::sparse_linear_solver),
                                         std::ref(default_linear_solver))
                          .get();
  Foliation_solver<TriangleMesh, std::decay_t<decltype(linear_solver)>, ConcurrencyTag> solver(
    linear_solver);
  solver.expect_no_more_runs();
  return solver.solve(system, internal::select<internal::Solver_parameters>(np));
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_HARMONIC_FOLIATION_H
