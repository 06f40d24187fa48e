// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_COMPONENT_COORDINATES_H
#define CGAL_SURFACE_MESH_FOLIATION_COMPONENT_COORDINATES_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Simplicial_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_chart.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_layout.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is the shape of the flat cylinder that a surface component is, seen through its foliation.
*/
struct Component_shape
{
  double height;        ///< the measure \f$k\f$ of its leaves, the height of its loop
  double circumference; ///< the flux \f$c\f$ through each of its leaves

  /// returns \f$k / c\f$, the modulus of the annulus: the extremal length of the curves that join
  /// its ends.
  double modulus() const { return height / circumference; }

  /// returns \f$c / k\f$, the extremal length of the closed curves that run around the component as
  /// its leaves do.
  double extremal_length() const { return circumference / height; }
};

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

returns the shape of the component of an arc, in constant time.

It says something about the conformal structure of the surface if the foliation is harmonic with
cotangent weights on a Delaunay mesh. Mean value weights are not conformal: then, height and
circumference are those of the network of weighted edges. The modulus of a component with a pole at
a vertex grows like \f$ \log(1/h) \f$ with the length \f$h\f$ of the edges there, and has no limit,
since a disk without a point has an infinite modulus.

\throws Invalid_parameter_exception if there is no such arc
*/
template <class TriangleMesh>
Component_shape component_shape(const Measured_foliation<TriangleMesh>& foliation, std::size_t arc)
{
  if (arc >= foliation.system().number_of_arcs())
    throw Invalid_parameter_exception(
      internal::problem(Problem_kind::INVALID_PARAMETER, "there is no arc ", arc));
  return {foliation.system().height(arc), foliation.flux(arc)};
}

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

are natural coordinates of the surface components: \f$v\f$, the distance \f$t\f$ from end 0 of the
arc, and \f$u\f$, conjugate to it, around. They map the component of an arc of height \f$k\f$ and
flux \f$c\f$ onto the flat cylinder of height \f$k\f$ and circumference \f$c\f$.

Each component has a <em>seam</em>, a path of edges of the refined mesh from end 0 to end 1, on
whose left side \f$u\f$ is larger than on its right side by \f$c\f$; so the coordinates belong to
corners of faces, not to vertices. They are defined on the refined mesh that `surface_components()`
makes. At a pole that is a vertex, \f$u\f$ is an angle, and has another value in each corner.

The coordinate \f$u\f$ is the equilibrium of springs between the vertices of a component, with
strengths such that \f$t\f$ is in equilibrium, too: inside, the weights of the edges; where an edge
is cut by critical leaves, every part of it is as much stronger as it is shorter in \f$t\f$; along
both ends, which \f$u\f$ is free to slide on, springs that only keep distances. If all weights are
positive and the solver of the foliation has converged, triangles keep their orientation; only on a
plateau, or where a vertex lies on a critical leaf up to rounding, can areas be so small that
their sign is a matter of rounding. With cotangent weights on a Delaunay mesh \f$u\f$ is a discrete
harmonic function conjugate to \f$t\f$, and the map becomes conformal at second order under
refinement. With other weights it is not conformal.

\tparam TriangleMesh see `Loop_system`
*/
template <class TriangleMesh>
class Component_coordinates
{
public:
  using Point = typename Loop_system<TriangleMesh>::Point; ///< a point with `double` coordinates
  using Uv = std::array<double, 2>;                        ///< \f$u\f$ and \f$v\f$

  /*!
  computes the coordinates of all components of a foliation, which is shared.

  \param foliation the foliation
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
    listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{sparse_linear_solver}
      \cgalParamDescription{solves the linear system}
      \cgalParamType{a `std::reference_wrapper` of a model of `FoliationLinearSolver`}
      \cgalParamDefault{a `Simplicial_cholesky_solver`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws Solver_exception if the linear system cannot be solved

  The time is that of one factorization with the pattern of the refined mesh, and linear for the
  rest.
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Component_coordinates(const Measured_foliation<TriangleMesh>& foliation,
                                 const NamedParameters& np = CGAL::parameters::default_values())
    : m_foliation(foliation)
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    internal::check_parameters<CGAL::internal_np::sparse_linear_solver_t>(np);
    Simplicial_cholesky_solver default_linear_solver;
    auto& linear_solver =
      choose_parameter(get_parameter(np, CGAL::internal_np::sparse_linear_solver),
                       std::ref(default_linear_solver))
        .get();
    m_layout = std::make_shared<internal::Component_layout>(foliation.state(),
                                                            foliation.certificate(), linear_solver);
  }

  /// returns the foliation.
  const Measured_foliation<TriangleMesh>& foliation() const { return m_foliation; }

  /*!
  appends to `output` the mesh cut along the critical leaves, as `surface_components()` does, and
  writes the coordinates of the corner of `target(h)` in the face of `h` for each halfedge `h` of
  it. In faces that lie at a node as a whole, and so in no component, they are not-a-number.

  \tparam OutputMesh a model of `MutableFaceGraph` in which a new element is the last to be iterated
  \tparam HalfedgeUvMap a model of `WritablePropertyMap` with
    `boost::graph_traits<OutputMesh>::%halfedge_descriptor` as key type and `Uv` as value type
  \param output the mesh to append to
  \param halfedge_uv_map the map to write to
  \param np the named parameters of `surface_components()`

  Time and memory are linear in the size of the refined mesh.
  */
  template <class OutputMesh,
            class HalfedgeUvMap,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  void uv_mesh(OutputMesh& output,
               HalfedgeUvMap halfedge_uv_map,
               const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    const auto faces = internal::add_components(m_foliation, output, np);
    const internal::Flat_mesh& mesh = m_layout->nodes().mesh();
    for (int f = 0; f < mesh.number_of_faces(); ++f)
    {
      auto h = prev(halfedge(faces[f], output), output); // its target is the first corner
      for (int i : mesh.halfedges(f))
      {
        put(halfedge_uv_map, h, uv(i));
        h = next(h, output);
      }
    }
  }

  /*!
  appends to `output` the component of an arc, cut open along its seam and laid out flat, as a mesh
  with border in the plane \f$z = 0\f$: a rectangle of height \f$k\f$ and width \f$c\f$, except
  that its left and right sides follow the seam, each a translate of the other. A pole becomes a
  side of the rectangle, and the faces around it quadrangles, split into triangles.

  What is drawn on the chart, such as a grid of quadrangles, is brought back to the surface by the
  map `surface_point_map`.

  \tparam OutputMesh a model of `MutableFaceGraph`
  \param arc the arc
  \param output the mesh to append to
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
    listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map to which \f$(u, v, 0)\f$ is written for each vertex}
      \cgalParamType{a class model of `WritablePropertyMap` with
        `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and a point type
        constructible from three `double` as value type}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
    \cgalParamNEnd
    \cgalParamNBegin{surface_point_map}
      \cgalParamDescription{a property map to which the point of the surface is written for each
        vertex}
      \cgalParamType{a class model of `WritablePropertyMap` with
        `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and a point type
        constructible from three `double` as value type}
      \cgalParamDefault{nothing is written}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws Invalid_parameter_exception if there is no such arc

  The time is linear in the size of the refined mesh, and \f$O(n \log n)\f$ in that of the chart.
  */
  template <class OutputMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
  void chart(std::size_t arc,
             OutputMesh& output,
             const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::surface_point_map_t>(
      np);
    using Vertex = typename boost::graph_traits<OutputMesh>::vertex_descriptor;
    const auto vertex_point_map =
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                       get_property_map(CGAL::vertex_point, output));
    const auto surface_point_map =
      choose_parameter(get_parameter(np, internal_np::surface_point_map),
                       CGAL::Constant_property_map<Vertex, Point>());
    component_shape(m_foliation, arc); // there must be such an arc
    const internal::Component_chart chart(*m_layout, static_cast<int>(arc));
    std::vector<Vertex> vertices;
    for (const auto& [uv, origin] : chart.vertices())
    {
      vertices.push_back(add_vertex(output));
      put_point(vertex_point_map, vertices.back(), {uv[0], uv[1], 0});
      put_point(surface_point_map, vertices.back(), m_layout->nodes().refined().points[origin]);
    }
    std::vector<std::array<Vertex, 3>> triangles;
    for (const internal::Triangle& t : chart.triangles())
      triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
    CGAL::Euler::add_faces(triangles, output);
  }

  /// \cond SKIP_IN_MANUAL
  const internal::Component_layout& layout() const { return *m_layout; }
  // of the corner of source(h), a halfedge of the refined mesh
  Uv uv(int h) const
  {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return m_layout->nodes().arc(h) < 0 ? Uv{nan, nan} : m_layout->corner(h);
  }
  /// \endcond

private:
  template <class PointMap, class Vertex>
  static void put_point(const PointMap& map, Vertex v, const internal::Point& p)
  {
    using Value = typename boost::property_traits<PointMap>::value_type;
    put(map, v, Value(p[0], p[1], p[2]));
  }

  Measured_foliation<TriangleMesh> m_foliation;
  std::shared_ptr<const internal::Component_layout> m_layout;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_COMPONENT_COORDINATES_H
