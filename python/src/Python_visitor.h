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

// Lets Ctrl-C end a run: what a signal handler raises is thrown. It is called without the GIL.
class Ctrl_c : public SMF::Default_foliation_visitor
{
public:
  bool go_on()
  {
    const py::gil_scoped_acquire acquire;
    check_signals();
    return true;
  }

protected:
  // (Python's handlers of signals run in its main thread only.)
  static void check_signals()
  {
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
  }
};

// Tells a function of Python how far a solver has come, too; what it raises ends the run.
class Python_visitor : public Ctrl_c
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

  const py::object& m_function;
  std::size_t m_number_of_vertices;
};

} // namespace smf_python

#endif // SMF_PYTHON_PYTHON_VISITOR_H
