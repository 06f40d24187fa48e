// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "find.h"

#include "Mesh.h"
#include "Python_visitor.h"
#include "arrays.h"
#include "poles_and_loops.h"

#include <CGAL/Surface_mesh_foliation/add_missing_poles.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/feature_lines.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/loop_modulus.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

namespace smf_python {

namespace {

// vertices and their significances
py::tuple find_poles(const Mesh& mesh,
                     double number_of_poles,
                     double persistence,
                     double min_significance)
{
  std::vector<Vertex> poles;
  std::vector<double> significances;
  Ctrl_c visitor;
  without_gil([&] {
    SMF::detect_feature_poles(mesh.surface, std::back_inserter(poles),
                              SMF::parameters::number_of_poles(number_of_poles)
                                .persistence(persistence)
                                .min_significance(min_significance)
                                .significance_output_iterator(std::back_inserter(significances))
                                .visitor(std::ref(visitor)));
  });
  return py::make_tuple(to_indices(poles), to_array(std::move(significances)));
}

py::list find_lines(const Mesh& mesh)
{
  std::vector<std::vector<Vertex>> lines;
  without_gil([&] { SMF::detect_feature_lines(mesh.surface, std::back_inserter(lines)); });
  py::list result;
  for (const std::vector<Vertex>& line : lines)
    result.append(to_indices(line));
  return result;
}

// The vertices of the poles that a surface needs besides those it has.
py::array_t<Index> missing_poles(const Mesh& mesh, const py::list& entries)
{
  Poles_and_loops input = poles_and_loops_of(mesh, entries);
  const std::size_t number = input.size();
  without_gil([&] { SMF::add_missing_poles(mesh.surface, input); });
  std::vector<Vertex> added;
  for (std::size_t i = number; i < input.size(); ++i)
    added.push_back(input.entries()[i].pole[0]);
  return to_indices(added);
}

py::list handle_loops(const Mesh& mesh,
                      const py::list& entries,
                      bool uses_poles_as_punctures,
                      double min_loop_length)
{
  Poles_and_loops input = poles_and_loops_of(mesh, entries);
  const std::size_t number = input.size();
  without_gil([&] {
    SMF::propose_loops(mesh.surface, input,
                       SMF::parameters::use_poles_as_punctures(uses_poles_as_punctures)
                         .min_loop_length(min_loop_length));
  });
  py::list result;
  for (std::size_t i = number; i < input.size(); ++i)
    result.append(loop_to_tuple(mesh, input.entries()[i].loop));
  return result;
}

py::tuple canonical_loop_to_tuple(const Mesh& mesh, const SMF::Canonical_loop<Surface>& loop)
{
  return py::make_tuple(loop_to_tuple(mesh, loop.loop), loop.modulus, loop.dominance,
                        loop.is_separating, loop.cuts_handle, loop.parent);
}

// (loops, is it complete, completeness bound)
py::tuple loop_hierarchy(const Mesh& mesh, const py::list& entries, int number_of_proxy_vertices)
{
  const Poles_and_loops input = poles_and_loops_of(mesh, entries);
  Ctrl_c visitor;
  const auto hierarchy = without_gil([&] {
    return SMF::loop_hierarchy(mesh.surface, input,
                               SMF::parameters::number_of_proxy_vertices(number_of_proxy_vertices)
                                 .visitor(std::ref(visitor)));
  });
  py::list loops;
  for (const SMF::Canonical_loop<Surface>& loop : hierarchy.loops())
    loops.append(canonical_loop_to_tuple(mesh, loop));
  return py::make_tuple(loops, hierarchy.is_complete(), hierarchy.completeness_bound());
}

double loop_modulus(const Mesh& mesh,
                    const py::list& entries,
                    std::size_t loop,
                    int number_of_proxy_vertices)
{
  const Poles_and_loops input = poles_and_loops_of(mesh, entries);
  return without_gil([&] {
    return SMF::loop_modulus(mesh.surface, input, loop,
                             SMF::parameters::number_of_proxy_vertices(number_of_proxy_vertices));
  });
}

} // namespace

void define_find(py::module_& module)
{
  module.attr("default_min_modulus") = SMF::default_min_modulus;
  module.attr("default_min_significance") = SMF::default_min_significance;
  module.attr("default_persistence") =
    SMF::internal::default_persistence(SMF::Average_geodesic_distance());
  module.attr("default_blade_width") = SMF::default_blade_width;
  module.def("find_poles", &find_poles, py::arg("mesh"), py::arg("number_of_poles"),
             py::arg("persistence"), py::arg("min_significance"));
  module.def("find_lines", &find_lines, py::arg("mesh"));
  module.def("missing_poles", &missing_poles, py::arg("mesh"), py::arg("entries"));
  module.def("handle_loops", &handle_loops, py::arg("mesh"), py::arg("entries"),
             py::arg("use_poles_as_punctures"), py::arg("min_loop_length"));
  module.def("loop_hierarchy", &loop_hierarchy, py::arg("mesh"), py::arg("entries"),
             py::arg("number_of_proxy_vertices"));
  module.def("loop_modulus", &loop_modulus, py::arg("mesh"), py::arg("entries"), py::arg("loop"),
             py::arg("number_of_proxy_vertices"));
}

} // namespace smf_python
