// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "solve.h"

#include "Mesh.h"
#include "Python_visitor.h"
#include "Result.h"
#include "arrays.h"
#include "errors.h"
#include "poles_and_loops.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

// the numbers of a list as a property map of edges
auto edge_map(const std::vector<double>& values)
{
  return boost::make_function_property_map<Edge>(
    [&values](Edge e) { return values[static_cast<std::size_t>(e)]; });
}

std::vector<double> values_of_edges(const Mesh& mesh, const Doubles& array, const char* name)
{
  require_shape(array, name, 0);
  if (static_cast<std::size_t>(array.size()) != mesh.surface.number_of_edges())
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(array.size()) +
                                " numbers for " + std::to_string(mesh.surface.number_of_edges()) +
                                " edges");
  return to_vector(array);
}

// Edge weights: "mean-value", "cotangent", or a number for each edge.
struct Weights
{
  Weights(const Mesh& mesh, const py::object& weights, bool allow_any) : allows_any(allow_any)
  {
    if (!py::isinstance<py::str>(weights))
      values = values_of_edges(mesh, weights.cast<Doubles>(), "weights");
    else
      name = weights.cast<std::string>();
    if (values.empty() && name != "mean-value" && name != "cotangent")
      refuse_argument("weights: '" + name + "' is neither 'mean-value' nor 'cotangent'");
  }

  // calls a function with the named parameters
  template <class Function>
  auto apply(const Function& function) const
  {
    const auto np = SMF::parameters::allow_any_weights(allows_any);
    if (name == "mean-value")
      return function(np.weights(SMF::Mean_value_weights()));
    if (name == "cotangent")
      return function(np.weights(SMF::Cotangent_weights()));
    return function(np.weights(edge_map(values)));
  }

  std::string name;
  std::vector<double> values;
  bool allows_any;
};

// Computes foliations of one mesh, one after another. One thread at a time.
class Solver
{
public:
  explicit Solver(Mesh_pointer mesh) : m_mesh(std::move(mesh)) {}

  Result solve(const py::list& entries,
               const py::object& weights,
               bool allow_any_weights,
               double tolerance,
               int max_iterations,
               const py::object& progress)
  {
    const In_use in_use(m_is_in_use);
    const Poles_and_loops input = poles_and_loops_of(*m_mesh, entries);
    const Weights checked_weights(*m_mesh, weights, allow_any_weights);
    Python_visitor visitor(progress, m_mesh->surface.number_of_vertices());
    return without_gil([&] {
      m_system = m_system ? System(*m_system, input) : System(m_mesh->surface, input);
      return checked_weights.apply([&](const auto& parameters) {
        return Result{m_mesh, m_solver.solve(*m_system, parameters.tolerance(tolerance)
                                                          .number_of_iterations(max_iterations)
                                                          .visitor(std::ref(visitor)))};
      });
    });
  }

private:
  // The flag is read and set with the GIL held; a second thread, or a function that is told of the
  // progress, is turned away.
  class In_use
  {
  public:
    explicit In_use(bool& flag) : m_flag(flag)
    {
      if (flag)
        throw std::runtime_error("the solver is at work already; use one for each thread");
      flag = true;
    }
    ~In_use() { m_flag = false; }
    In_use(const In_use&) = delete;
    In_use& operator=(const In_use&) = delete;

  private:
    bool& m_flag;
  };

  using System = SMF::Loop_system<Surface>;

  Mesh_pointer m_mesh;
  std::optional<System> m_system; // the last one; the next need not check the mesh again
  SMF::Foliation_solver<Surface> m_solver;
  bool m_is_in_use = false;
};

Result whitehead_foliation(const Mesh_pointer& mesh,
                           const py::list& entries,
                           const py::object& weights,
                           bool allow_any_weights,
                           double over_relaxation,
                           bool stage_critical_moves,
                           bool spread_by_rings,
                           double tolerance,
                           int max_sweeps,
                           const py::object& progress)
{
  const Poles_and_loops input = poles_and_loops_of(*mesh, entries);
  const Weights checked_weights(*mesh, weights, allow_any_weights);
  Python_visitor visitor(progress, mesh->surface.number_of_vertices());
  return without_gil([&] {
    const SMF::Loop_system<Surface> system(mesh->surface, input);
    return checked_weights.apply([&](const auto& parameters) {
      return Result{mesh,
                    SMF::whitehead_foliation(system, parameters.over_relaxation(over_relaxation)
                                                       .stage_critical_moves(stage_critical_moves)
                                                       .spread_by_rings(spread_by_rings)
                                                       .tolerance(tolerance)
                                                       .number_of_iterations(max_sweeps)
                                                       .visitor(std::ref(visitor)))};
    });
  });
}

Result integrate_foliation(const Mesh_pointer& mesh,
                           const Doubles& edge_values,
                           const py::object& weights,
                           bool allow_any_weights,
                           double tolerance)
{
  const std::vector<double> values = values_of_edges(*mesh, edge_values, "edge_values");
  const Weights checked_weights(*mesh, weights, allow_any_weights);
  return without_gil([&] {
    return checked_weights.apply([&](const auto& parameters) {
      return Result{mesh, SMF::integrate_foliation(mesh->surface, edge_map(values),
                                                   parameters.tolerance(tolerance))};
    });
  });
}

} // namespace

void define_solve(py::module_& module)
{
  py::class_<Solver>(module, "Solver")
    .def(py::init<Mesh_pointer>(), py::arg("mesh").none(false))
    .def("solve", &Solver::solve, py::arg("entries"), py::arg("weights"),
         py::arg("allow_any_weights"), py::arg("tolerance"), py::arg("max_iterations"),
         py::arg("progress"));
  module.def("whitehead_foliation", &whitehead_foliation, py::arg("mesh").none(false),
             py::arg("entries"), py::arg("weights"), py::arg("allow_any_weights"),
             py::arg("over_relaxation"), py::arg("stage_critical_moves"),
             py::arg("spread_by_rings"), py::arg("tolerance"), py::arg("max_sweeps"),
             py::arg("progress"));
  module.def("integrate_foliation", &integrate_foliation, py::arg("mesh").none(false),
             py::arg("edge_values"), py::arg("weights"), py::arg("allow_any_weights"),
             py::arg("tolerance"));
}

} // namespace smf_python
