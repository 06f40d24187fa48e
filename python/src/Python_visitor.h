// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_PYTHON_VISITOR_H
#define SMF_PYTHON_PYTHON_VISITOR_H

#include "types.h"

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>

#include <cstddef>

namespace smf_python {

// Tells a function of Python how far a solver has come, and lets Ctrl-C end it: what the function
// or a signal handler raises is thrown, and ends the run. It is called without the GIL.
class Python_visitor
{
public:
  // The function takes the number of vertices of the mesh at work, and of it the number of
  // iterations and the optimality. If it returns False, the solver stops, with a result. None if
  // nobody wants to know.
  Python_visitor(const py::object& function, std::size_t number_of_vertices)
    : m_function(function), m_number_of_vertices(number_of_vertices)
  {}

  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    return tell(m_number_of_vertices, statistics);
  }

  bool after_coarse_iteration(std::size_t number_of_vertices,
                              const SMF::Foliation_statistics& statistics)
  {
    return tell(number_of_vertices, statistics);
  }

  bool go_on()
  {
    const py::gil_scoped_acquire acquire;
    check_signals();
    return true;
  }

private:
  bool tell(std::size_t number_of_vertices, const SMF::Foliation_statistics& statistics)
  {
    const py::gil_scoped_acquire acquire;
    check_signals();
    if (m_function.is_none())
      return true;
    const py::object answer =
      m_function(number_of_vertices, statistics.number_of_iterations, statistics.optimality);
    return answer.ptr() != Py_False;
  }

  // (Python's handlers of signals run in its main thread only.)
  static void check_signals()
  {
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
  }

  const py::object& m_function;
  std::size_t m_number_of_vertices;
};

} // namespace smf_python

#endif // SMF_PYTHON_PYTHON_VISITOR_H
