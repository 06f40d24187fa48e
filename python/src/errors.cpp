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
  const py::object error = type(problem.message, SMF::name(problem.kind), numbers(problem.vertices),
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
  return py::make_tuple(SMF::name(problem.kind), problem.message, numbers(problem.vertices),
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
