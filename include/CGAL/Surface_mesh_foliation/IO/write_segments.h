// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_SEGMENTS_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_SEGMENTS_H

#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Kept_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes a mesh in PLY as it is, not cut, with the face property `component` and a color for each
component, `arc_color()`.

\tparam FaceComponentMap a model of `ReadablePropertyMap` with
  `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `std::size_t` as value type
\param file_name the name of the file
\param mesh a triangle mesh; it may have several parts
\param face_component_map the component of each face, for example from `face_segmentation()`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` as value
      type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{filled_face_map}
    \cgalParamDescription{a property map of `fill_openings()`; faces for which it is `true` are not
      written, nor vertices that only these use}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%face_descriptor` as key type and `bool` as value type}
    \cgalParamDefault{all faces are written}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_mesh_exception if a face is not a triangle
\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh,
          class FaceComponentMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_segments_ply(const std::string& file_name,
                        const TriangleMesh& mesh,
                        FaceComponentMap face_component_map,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::filled_face_map_t>(np);
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_const_property_map(CGAL::vertex_point, mesh));
  const auto filled = choose_parameter(get_parameter(np, internal_np::filled_face_map),
                                       CGAL::Constant_property_map<face_descriptor, bool>(false));
  using Output_mesh =
    CGAL::Surface_mesh<typename boost::property_traits<decltype(vertex_point_map)>::value_type>;
  const internal::Mesh_index<TriangleMesh> index(mesh);
  std::vector<Problem> problems;
  const Triangle_soup soup = index.soup(vertex_point_map, problems);
  if (!problems.empty())
    throw Invalid_mesh_exception(problems[0]);
  const internal::Kept_soup kept(soup, [&](int f) { return !get(filled, index.face(f)); });
  Output_mesh output;
  const auto new_faces = internal::build_triangle_mesh(kept.soup, output, output.points());
  const auto component =
    output.template add_property_map<typename Output_mesh::Face_index, int>("f:component").first;
  const auto color =
    output.template add_property_map<typename Output_mesh::Face_index, CGAL::IO::Color>("f:color")
      .first;
  for (std::size_t i = 0; i < new_faces.size(); ++i)
  {
    const std::size_t c = get(face_component_map, index.face(kept.faces[i]));
    put(component, new_faces[i], static_cast<int>(c));
    put(color, new_faces[i], arc_color(c));
  }
  internal::write_mesh_ply(file_name, output);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_SEGMENTS_H
