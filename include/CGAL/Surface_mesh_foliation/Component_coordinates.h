// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_COMPONENT_COORDINATES_H
#define CGAL_SURFACE_MESH_FOLIATION_COMPONENT_COORDINATES_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Supernodal_cholesky_solver.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_chart.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Component_layout.h>
#include <CGAL/Surface_mesh_foliation/internal/Component_coordinates/Texture_layout.h>
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
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is the shape of the flat cylinder that the foliation makes of a surface component.
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
since a punctured disk has an infinite modulus.

\throws Invalid_parameter_exception if there is no such arc
*/
template <class TriangleMesh>
Component_shape component_shape(const Measured_foliation<TriangleMesh>& foliation, std::size_t arc)
{
  internal::require_parameter(arc < foliation.system().number_of_arcs(), "there is no arc ", arc);
  return {foliation.system().height(arc), foliation.flux(arc)};
}

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is where the chart of a surface component lies in texture space, the unit square; see
`Component_coordinates`.
*/
struct Texture_chart
{
  std::array<double, 2> origin; ///< the texture coordinates of \f$u = v = 0\f$
  std::array<double, 2> scale;  ///< texture units per unit of \f$u\f$ and of \f$v\f$
  std::array<double, 2> lower;  ///< the lower left corner of the box around the chart
  std::array<double, 2> upper;  ///< its upper right corner

  /// returns the texture coordinates of \f$u\f$ and \f$v\f$.
  std::array<double, 2> operator()(const std::array<double, 2>& uv) const
  {
    return {origin[0] + scale[0] * uv[0], origin[1] + scale[1] * uv[1]};
  }
};

namespace internal {

template <class T, class = void>
struct Is_point_2 : std::false_type
{};

template <class T>
struct Is_point_2<T, std::void_t<typename T::R::Point_2>> : std::is_same<T, typename T::R::Point_2>
{};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

are natural coordinates of the surface components: \f$v\f$, the distance \f$t\f$ from end 0 of the
arc, and \f$u\f$, conjugate to it, around the component. They map the component of an arc of height
\f$k\f$ and flux \f$c\f$ onto the flat cylinder of height \f$k\f$ and circumference \f$c\f$.

Each component has a <em>seam</em>, a path of edges of the refined mesh from end 0 to end 1, on
whose left side \f$u\f$ is larger than on its right side by \f$c\f$; so the coordinates belong to
corners of faces, not to vertices. They are defined on the refined mesh that `surface_components()`
makes. At a pole that is a vertex, \f$u\f$ is an angle, and has another value in each corner.

The coordinate \f$u\f$ is the equilibrium of springs between the vertices of a component, with
strengths such that \f$t\f$ is in equilibrium, too: inside, the weights of the edges; where an edge
is cut by critical leaves, each part is stronger in proportion as it is shorter in \f$t\f$; along
both ends, on which \f$u\f$ is free to slide, springs that only keep distances. If all weights are
positive and the solver of the foliation has converged, triangles keep their orientation; areas can
be so small that their signs depend on rounding only on a plateau, or where a vertex lies on a
critical leaf up to rounding. With cotangent weights on a Delaunay mesh \f$u\f$ is a discrete
harmonic function conjugate to \f$t\f$, and the map becomes conformal at second order under
refinement. With other weights it is not conformal.

<em>Texture coordinates</em> are these coordinates in units of length, with all charts side by side
in the unit square. Height and flux are measures, and their ratio depends on the weights. So the
chart of each component is stretched along both axes: to the area \f$A\f$ of the component, and to
the ratio of height and circumference that a conformal map with the same \f$t\f$ has, \f$k^2 / D\f$
for the Dirichlet energy \f$D\f$ of \f$t\f$ on the surface. That is, the width is
\f$\sqrt{AD}/k\f$, the height \f$\sqrt{A/D}\,k\f$; with cotangent weights, \f$D\f$ is about
\f$k c\f$ and the ratio is about the modulus. All charts have the same scale, `texture_size()`, so
that a pattern is equally fine on all components. Their boxes lie in rows, with gaps between them. A
chart is as wide as its jagged seam makes it; nothing is rotated or flipped.

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
      \cgalParamDefault{a `Supernodal_cholesky_solver`}
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
    Supernodal_cholesky_solver default_linear_solver;
    auto& linear_solver =
      choose_parameter(get_parameter(np, CGAL::internal_np::sparse_linear_solver),
                       std::ref(default_linear_solver))
        .get();
    m_layout = std::make_shared<internal::Component_layout>(foliation.state(),
                                                            foliation.extraction(), linear_solver);
    std::vector<double> heights, fluxes;
    for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
    {
      heights.push_back(foliation.system().height(a));
      fluxes.push_back(foliation.flux(a));
    }
    m_texture = std::make_shared<internal::Texture_layout>(*m_layout, heights, fluxes);
  }

  /// returns the foliation.
  const Measured_foliation<TriangleMesh>& foliation() const { return m_foliation; }

  /*!
  appends to `output` the mesh cut along the critical leaves, as `surface_components()` does, and
  writes the coordinates of the corner of `target(h)` in the face of `h` for each halfedge `h` of
  it. In faces that lie entirely at a node, and so in no component, they are not-a-number.

  \tparam OutputMesh a model of `MutableFaceGraph` in which a new element is the last to be iterated
  \tparam HalfedgeUvMap a model of `WritablePropertyMap` with
    `boost::graph_traits<OutputMesh>::%halfedge_descriptor` as key type and as value type `Uv`, a
    `Point_2` of a kernel, or another type constructible from two `double`
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
    add_mesh(output, halfedge_uv_map, np, [&](int h) { return uv(h); });
  }

  /*!
  does the same as `uv_mesh()` with texture coordinates in place of \f$u\f$ and \f$v\f$: those of
  component `a` are \f$u\f$ and \f$v\f$ mapped by `texture_chart(a)`.
  */
  template <class OutputMesh,
            class HalfedgeUvMap,
            class NamedParameters = CGAL::parameters::Default_named_parameters>
  void texture_mesh(OutputMesh& output,
                    HalfedgeUvMap halfedge_uv_map,
                    const NamedParameters& np = CGAL::parameters::default_values()) const
  {
    add_mesh(output, halfedge_uv_map, np, [&](int h) { return texture_uv(h); });
  }

  /*!
  returns where the chart of an arc lies in texture space, in constant time.

  \throws Invalid_parameter_exception if there is no such arc
  */
  Texture_chart texture_chart(std::size_t arc) const
  {
    component_shape(m_foliation, arc); // there must be such an arc
    const internal::Texture_layout::Chart& chart = m_texture->chart(arc);
    return {chart.origin, chart.scale, chart.lower, chart.upper};
  }

  /// returns the length on the surface that the unit of texture coordinates stands for, the side of
  /// the square.
  double texture_size() const { return m_texture->side(); }

  /*!
  appends to `output` the component of an arc, cut open along its seam and laid out flat, as a mesh
  with a border in the plane \f$z = 0\f$: a rectangle of height \f$k\f$ and width \f$c\f$, except
  that its left and right sides follow the seam, each a translate of the other. A pole becomes a
  side of the rectangle, and the faces around it become quadrilaterals, split into triangles.

  Whatever is drawn on the chart, such as a grid of quadrilaterals, is carried back to the surface
  by `surface_point_map`.

  \tparam OutputMesh a model of `MutableFaceGraph`
  \param arc the arc
  \param output the mesh to append to
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
    listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map to which \f$(u, v, 0)\f$ is written for each vertex, or
        \f$(u, v)\f$ if points are those of a plane}
      \cgalParamType{a class model of `WritablePropertyMap` with
        `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and a `Point_2` of a
        kernel or a point type constructible from three `double` as value type}
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
  Uv texture_uv(int h) const
  {
    const int arc = m_layout->nodes().arc(h);
    return arc < 0 ? uv(h) : texture_chart(static_cast<std::size_t>(arc))(uv(h));
  }
  /// \endcond

private:
  // appends the cut mesh; `coordinates(h)` gives the coordinates of the corner of source(h)
  template <class OutputMesh, class HalfedgeUvMap, class NamedParameters, class Coordinates>
  void add_mesh(OutputMesh& output,
                const HalfedgeUvMap& map,
                const NamedParameters& np,
                const Coordinates& coordinates) const
  {
    using Value = typename boost::property_traits<HalfedgeUvMap>::value_type;
    const auto faces = internal::add_components(m_foliation, output, np);
    const internal::Flat_mesh& mesh = m_layout->nodes().mesh();
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    {
      auto h = prev(halfedge(faces[f], output), output); // its target is the first corner
      for (int i : mesh.halfedges(f))
      {
        const Uv corner = coordinates(i);
        if constexpr (std::is_constructible_v<Value, double, double>)
          put(map, h, Value(corner[0], corner[1]));
        else
          put(map, h, Value{corner[0], corner[1]});
        h = next(h, output);
      }
    }
  }

  template <class PointMap, class Vertex>
  static void put_point(const PointMap& map, Vertex v, const internal::Point& p)
  {
    using Value = typename boost::property_traits<PointMap>::value_type;
    if constexpr (internal::Is_point_2<Value>::value)
      put(map, v, Value(p[0], p[1]));
    else
      put(map, v, Value(p[0], p[1], p[2]));
  }

  Measured_foliation<TriangleMesh> m_foliation;
  std::shared_ptr<const internal::Component_layout> m_layout;
  std::shared_ptr<const internal::Texture_layout> m_texture;
};

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_COMPONENT_COORDINATES_H
