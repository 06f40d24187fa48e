// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_COMPONENTS_H
#define CGAL_SURFACE_MESH_FOLIATION_COMPONENTS_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/component_labels.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is the kind of a surface component.
*/
enum class Component_kind {
  DISK,     ///< one end is a pole
  CYLINDER, ///< neither end is a pole; it may be the border of an opening
  SPHERE    ///< both ends are poles: an entire sphere with two poles
};

/// \ingroup PkgSurfaceMeshFoliationExtraction
/// returns the kind of the component of an arc.
template <class TriangleMesh>
Component_kind component_kind(const Loop_system<TriangleMesh>& system, std::size_t arc)
{
  int poles = 0;
  for (int end : {0, 1})
  {
    const int pole = system.pole(system.node(arc, end));
    poles += pole >= 0 && !system.is_border_pole(static_cast<std::size_t>(pole));
  }
  return poles == 0   ? Component_kind::CYLINDER
         : poles == 1 ? Component_kind::DISK
                      : Component_kind::SPHERE;
}

namespace internal {

// surface_components(); returns the faces of the refined mesh
template <class TriangleMesh, class OutputMesh, class NamedParameters>
std::vector<typename boost::graph_traits<OutputMesh>::face_descriptor> add_components(
  const Measured_foliation<TriangleMesh>& foliation, OutputMesh& output, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  check_parameters<CGAL::internal_np::vertex_point_t, internal_np::face_component_map_t,
                   CGAL::internal_np::edge_is_constrained_t>(np);
  using Traits = boost::graph_traits<OutputMesh>;
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_property_map(CGAL::vertex_point, output));
  const auto face_component_map =
    choose_parameter(get_parameter(np, internal_np::face_component_map),
                     CGAL::Constant_property_map<typename Traits::face_descriptor, std::size_t>());
  const auto is_critical_map =
    choose_parameter(get_parameter(np, CGAL::internal_np::edge_is_constrained),
                     CGAL::Constant_property_map<typename Traits::edge_descriptor, bool>());

  const Refined_mesh& refined = foliation.extraction().refined_mesh;
  const std::vector<int> label = component_labels(refined, foliation.extraction().leaf_graph);
  const auto faces = build_triangle_mesh(soup_of(refined), output, vertex_point_map);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    put(face_component_map, faces[f], static_cast<std::size_t>(label[f]));
    auto h = halfedge(faces[f], output);
    for (int i : {0, 1, 2})
    {
      put(is_critical_map, edge(h, output), refined.faces[f].is_critical[i]);
      h = next(h, output);
    }
  }
  return faces;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

appends to `output` a copy of the mesh that is cut along the critical leaves [Section 5.2.5], so
that every face lies in one surface component. The input mesh is not changed. The first vertices
appended are those of the input mesh, in its order.

Faces that lie entirely at a node, where the foliation has no leaves, are assigned the component of
the nearest other face, counted in faces; of equally near components, the one with the smallest
number.

\tparam TriangleMesh see `Loop_system`
\tparam OutputMesh a model of `MutableFaceGraph` in which a new element is the last to be iterated
\param foliation the foliation
\param output the mesh to append to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `output`}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and a point type
      constructible from three `double` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
  \cgalParamNEnd
  \cgalParamNBegin{face_component_map}
    \cgalParamDescription{a property map to which the component, an arc of the loop system, of each
      face
      of `output` is written}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<OutputMesh>::%face_descriptor` as key type and `std::size_t` as value
      type}
    \cgalParamDefault{nothing is written}
  \cgalParamNEnd
  \cgalParamNBegin{edge_is_constrained_map}
    \cgalParamDescription{a property map to which is written whether an edge of `output` lies on a
      critical leaf}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<OutputMesh>::%edge_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{nothing is written}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the number of components, which is the number of arcs

Time and memory are linear in the size of the mesh and the number of crossings of critical leaves
with its edges.
*/
template <class TriangleMesh,
          class OutputMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t surface_components(const Measured_foliation<TriangleMesh>& foliation,
                               OutputMesh& output,
                               const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::add_components(foliation, output, np);
  return foliation.system().number_of_arcs();
}

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

writes to each face of the input mesh the surface component that most of it lies in: a segmentation
of the mesh as it is, without cutting it.

A face crossed by a critical leaf goes to the component that has the largest part of its area; in a
tie, to the one with the smallest number. Faces that lie entirely at a node are treated as in
`surface_components()`. So the segments have jagged borders, a segment need not be connected where
its component is narrower than a face, and a component may have no face at all; for exact components
see `surface_components()`.

\tparam FaceComponentMap a model of `WritablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `std::size_t` as value type
\param foliation the foliation
\param map where the component, an arc of the loop system, of each face of the mesh is written

\returns the number of components, which is the number of arcs

The time is linear in the size of the mesh cut along its critical leaves.
*/
template <class TriangleMesh, class FaceComponentMap>
std::size_t face_segmentation(const Measured_foliation<TriangleMesh>& foliation,
                              FaceComponentMap map)
{
  const auto& mesh_index = foliation.system().data().mesh_index;
  const std::vector<int> component = internal::components_of_origins(
    foliation.extraction().refined_mesh, foliation.extraction().leaf_graph);
  for (std::size_t f = 0; f < component.size(); ++f)
    put(map, mesh_index.face(static_cast<int>(f)), static_cast<std::size_t>(component[f]));
  return foliation.system().number_of_arcs();
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_COMPONENTS_H
