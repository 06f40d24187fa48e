// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"

#include <cstddef>
#include <exception>
#include <vector>

namespace smf_python {

namespace {

const char* name_of(SMF::Problem_kind kind)
{
  using Kind = SMF::Problem_kind;
  switch (kind)
  {
  case Kind::FILE:
    return "file";
  case Kind::EMPTY_MESH:
    return "empty_mesh";
  case Kind::TOO_LARGE:
    return "too_large";
  case Kind::NOT_TRIANGLE_MESH:
    return "not_triangle_mesh";
  case Kind::NOT_CLOSED:
    return "not_closed";
  case Kind::NOT_MANIFOLD:
    return "not_manifold";
  case Kind::NOT_ORIENTABLE:
    return "not_orientable";
  case Kind::NOT_CONNECTED:
    return "not_connected";
  case Kind::ISOLATED_VERTEX:
    return "isolated_vertex";
  case Kind::NOT_FINITE:
    return "not_finite";
  case Kind::DEGENERATE_FACE:
    return "degenerate_face";
  case Kind::INVALID_POLE:
    return "invalid_pole";
  case Kind::INVALID_LOOP:
    return "invalid_loop";
  case Kind::INTERSECTING_LOOPS:
    return "intersecting_loops";
  case Kind::INESSENTIAL_LOOP:
    return "inessential_loop";
  case Kind::HOMOTOPIC_LOOPS:
    return "homotopic_loops";
  case Kind::NO_LOOP:
    return "no_loop";
  case Kind::INVALID_HEIGHT:
    return "invalid_height";
  case Kind::INVALID_WEIGHT:
    return "invalid_weight";
  case Kind::INVALID_EDGE_VALUE:
    return "invalid_edge_value";
  case Kind::OPEN_LEAF:
    return "open_leaf";
  case Kind::UNRESOLVED_LEAF:
    return "unresolved_leaf";
  case Kind::INVALID_PARAMETER:
    return "invalid_parameter";
  case Kind::SOLVER_FAILURE:
    return "solver_failure";
  case Kind::STOPPED:
    return "stopped";
  case Kind::CERTIFICATE_FAILURE:
    return "certificate_failure";
  }
  return "unknown";
}

const char* class_of(const SMF::Foliation_exception& exception)
{
  if (dynamic_cast<const SMF::Invalid_file_exception*>(&exception))
    return "FileError";
  if (dynamic_cast<const SMF::Invalid_mesh_exception*>(&exception))
    return "MeshError";
  if (dynamic_cast<const SMF::Invalid_loops_exception*>(&exception))
    return "LoopsError";
  if (dynamic_cast<const SMF::Invalid_parameter_exception*>(&exception))
    return "ParameterError";
  if (dynamic_cast<const SMF::Invalid_foliation_exception*>(&exception))
    return "EdgeValueError";
  if (dynamic_cast<const SMF::Solver_exception*>(&exception))
    return "SolverError";
  if (dynamic_cast<const SMF::Certificate_exception*>(&exception))
    return "CertificateError";
  if (dynamic_cast<const SMF::Stopped_exception*>(&exception))
    return "StoppedError";
  return "FoliationError";
}

py::tuple numbers(const std::vector<std::size_t>& values)
{
  py::tuple result(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    result[i] = py::int_(values[i]);
  return result;
}

void raise_in_python(const SMF::Foliation_exception& exception)
{
  const SMF::Problem& problem = exception.problem();
  const py::object type =
    py::module_::import("surface_mesh_foliation._errors").attr(class_of(exception));
  const py::object error = type(problem.message, name_of(problem.kind), numbers(problem.vertices),
                                numbers(problem.faces), numbers(problem.loops));
  PyErr_SetObject(type.ptr(), error.ptr());
}

} // namespace

void refuse_argument(const std::string& message)
{
  throw SMF::Invalid_parameter_exception(
    {SMF::Problem_kind::INVALID_PARAMETER, message, {}, {}, {}});
}

void refuse_mesh(SMF::Problem_kind kind, const std::string& message, Index face)
{
  SMF::Problem problem = {kind, message, {}, {}, {}};
  if (face >= 0)
    problem.faces.push_back(static_cast<std::size_t>(face));
  throw SMF::Invalid_mesh_exception(problem);
}

py::tuple problem_to_tuple(const SMF::Problem& problem)
{
  return py::make_tuple(name_of(problem.kind), problem.message, numbers(problem.vertices),
                        numbers(problem.faces), numbers(problem.loops));
}

void register_exceptions()
{
  py::register_exception_translator([](std::exception_ptr pointer) {
    try
    {
      if (pointer)
        std::rethrow_exception(pointer);
    }
    catch (const SMF::Foliation_exception& exception)
    {
      raise_in_python(exception);
    }
  });
}

} // namespace smf_python
