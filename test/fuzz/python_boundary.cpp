// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "require.h"
#include "targets.h"

#include <pybind11/embed.h>

#include <cstdlib>
#include <exception>
#include <string>

namespace py = pybind11;

extern "C" PyObject* PyInit__core(); // the compiled part of the module, which is linked in

// What the interpreter and numpy keep to their end is no leak of ours.
extern "C" const char* __asan_default_options()
{
  return "detect_leaks=0";
}

namespace {

// Starts the interpreter, which is never shut down, and returns the function that makes the calls.
py::object start_python()
{
  PyImport_AppendInittab("_core", &PyInit__core);
  py::initialize_interpreter(false); // signals are libFuzzer's
  const py::module_ sys = py::module_::import("sys");
  sys.attr("dont_write_bytecode") = true;
  for (const char* folder : {SMF_PYTHON_DIR "/examples", SMF_PYTHON_DIR, SMF_FUZZ_DIR})
    sys.attr("path").attr("insert")(0, folder);
  sys.attr("modules")["surface_mesh_foliation._core"] = py::module_::import("_core");
  return py::module_::import("python_boundary").attr("make_calls");
}

} // namespace

// Calls of the module for Python, with arguments of all kinds: each returns, or raises an exception
// that is documented.
void smf_fuzz::python_boundary(const std::uint8_t* data, std::size_t size)
{
  try
  {
    static const py::object* const make_calls = new py::object(start_python());
    (*make_calls)(py::bytes(reinterpret_cast<const char*>(data), size), is_printing());
  }
  catch (const std::exception& exception)
  {
    require(false, exception.what());
  }
}
