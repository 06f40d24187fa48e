// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_EXCEPTIONS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_EXCEPTIONS_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationErrors

names what is wrong with an input or a result.
*/
enum class Problem_kind {
  FILE,               ///< a file cannot be read, or says something impossible
  EMPTY_MESH,         ///< no vertex or no face
  TOO_LARGE,          ///< so many faces that 32-bit numbers cannot count their halfedges
  NOT_TRIANGLE_MESH,  ///< a face that is not a triangle with three different vertices
  NOT_CLOSED,         ///< a border edge
  NOT_MANIFOLD,       ///< an edge with more than two faces, or a vertex with several umbrellas
  NOT_ORIENTABLE,     ///< faces that cannot be, or are not, oriented consistently
  NOT_CONNECTED,      ///< more than one connected component
  ISOLATED_VERTEX,    ///< a vertex without faces
  NOT_FINITE,         ///< a coordinate or value that is infinite or not a number
  DEGENERATE_FACE,    ///< a face with collinear corners
  INVALID_POLE,       ///< a pole that is not a vertex, is given twice, or is not an induced path
  INVALID_LOOP,       ///< a sequence of crossings that is not a closed curve, or crosses itself
  INTERSECTING_LOOPS, ///< two loops that cross or touch
  INESSENTIAL_LOOP,   ///< a loop that bounds a disk without a pole
  HOMOTOPIC_LOOPS,    ///< two loops that bound an annulus without a pole
  NO_LOOP,            ///< neither pole nor loop
  INVALID_HEIGHT,     ///< a height below 1e-300, or not finite
  INVALID_WEIGHT,     ///< an edge weight that is not positive and finite
  INVALID_EDGE_VALUE, ///< values that are negative, not finite, or not those of a triangle
  OPEN_LEAF,          ///< a leaf that does not close within the bound on its length
  UNRESOLVED_LEAF,    ///< leaves, given by edge values, that are closer than the accuracy of these
  INVALID_PARAMETER,  ///< another parameter out of its range
  SOLVER_FAILURE,     ///< a linear system that could not be factored or solved
  STOPPED,            ///< not an error: the visitor of a solver wanted no result
  CERTIFICATE_FAILURE ///< a computed foliation that is not of the class of its loops
};

/*!
\ingroup PkgSurfaceMeshFoliationErrors
\smfHeader{Common/exceptions.h,exceptions.h}

returns the name of a kind of problem in small letters, such as `"not_manifold"`.
*/
inline const char* name(Problem_kind kind)
{
  switch (kind)
  {
  case Problem_kind::FILE:
    return "file";
  case Problem_kind::EMPTY_MESH:
    return "empty_mesh";
  case Problem_kind::TOO_LARGE:
    return "too_large";
  case Problem_kind::NOT_TRIANGLE_MESH:
    return "not_triangle_mesh";
  case Problem_kind::NOT_CLOSED:
    return "not_closed";
  case Problem_kind::NOT_MANIFOLD:
    return "not_manifold";
  case Problem_kind::NOT_ORIENTABLE:
    return "not_orientable";
  case Problem_kind::NOT_CONNECTED:
    return "not_connected";
  case Problem_kind::ISOLATED_VERTEX:
    return "isolated_vertex";
  case Problem_kind::NOT_FINITE:
    return "not_finite";
  case Problem_kind::DEGENERATE_FACE:
    return "degenerate_face";
  case Problem_kind::INVALID_POLE:
    return "invalid_pole";
  case Problem_kind::INVALID_LOOP:
    return "invalid_loop";
  case Problem_kind::INTERSECTING_LOOPS:
    return "intersecting_loops";
  case Problem_kind::INESSENTIAL_LOOP:
    return "inessential_loop";
  case Problem_kind::HOMOTOPIC_LOOPS:
    return "homotopic_loops";
  case Problem_kind::NO_LOOP:
    return "no_loop";
  case Problem_kind::INVALID_HEIGHT:
    return "invalid_height";
  case Problem_kind::INVALID_WEIGHT:
    return "invalid_weight";
  case Problem_kind::INVALID_EDGE_VALUE:
    return "invalid_edge_value";
  case Problem_kind::OPEN_LEAF:
    return "open_leaf";
  case Problem_kind::UNRESOLVED_LEAF:
    return "unresolved_leaf";
  case Problem_kind::INVALID_PARAMETER:
    return "invalid_parameter";
  case Problem_kind::SOLVER_FAILURE:
    return "solver_failure";
  case Problem_kind::STOPPED:
    return "stopped";
  case Problem_kind::CERTIFICATE_FAILURE:
    return "certificate_failure";
  }
  return "unknown";
}

/*!
\ingroup PkgSurfaceMeshFoliationErrors
\smfHeader{Common/exceptions.h,exceptions.h}

describes one problem: a human-readable sentence, and the places that it is about.

A vertex or face is given by its position in `vertices(mesh)` or `faces(mesh)` (for a mesh just
read from a file, its position in the file), a loop by its id in `Poles_and_loops`.
*/
struct Problem
{
  Problem_kind kind;                 ///< what is wrong
  std::string message;               ///< one line that says what is wrong and where
  std::vector<std::size_t> vertices; ///< the vertices concerned, if any
  std::vector<std::size_t> faces;    ///< the faces concerned, if any
  std::vector<std::size_t> loops;    ///< the loops concerned, if any
};

/*!
\ingroup PkgSurfaceMeshFoliationErrors
\smfHeader{Common/exceptions.h,exceptions.h}

is the base of all exceptions of the package. They are thrown in every build type.
*/
class Foliation_exception : public std::runtime_error
{
public:
  explicit Foliation_exception(Problem problem)
    : std::runtime_error(problem.message), m_problem(std::move(problem))
  {}

  /// returns what is wrong and where.
  const Problem& problem() const noexcept { return m_problem; }

private:
  Problem m_problem;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when a file cannot be read as a polygon mesh.
class Invalid_file_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when a mesh is not a closed connected oriented manifold triangle mesh.
class Invalid_mesh_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when poles, loops or heights do not form a loop system.
class Invalid_loops_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when an edge weight or another parameter is out of its range.
class Invalid_parameter_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when values of edges are not those of a measured foliation with closed leaves.
class Invalid_foliation_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when a linear system could not be factored or solved.
class Solver_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when a computed foliation fails its certificate: no wrong graph is ever returned.
class Certificate_exception : public Foliation_exception
{
  using Foliation_exception::Foliation_exception;
};

/// \ingroup PkgSurfaceMeshFoliationErrors
/// \smfHeader{Common/exceptions.h,exceptions.h}
/// is thrown when the visitor of a solver no longer wants a result (see `FoliationVisitor`); a
/// visitor may also throw it itself.
class Stopped_exception : public Foliation_exception
{
public:
  Stopped_exception()
    : Foliation_exception({Problem_kind::STOPPED, "stopped by the visitor", {}, {}, {}})
  {}
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_EXCEPTIONS_H
