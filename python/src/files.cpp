// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files.h"

#include "Embedded_graph.h"
#include "Result.h"

#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_segments.h>
#include <CGAL/Surface_mesh_foliation/IO/write_swc.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/components.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace smf_python {

namespace {

// What is written about faces: those that fill openings are left out.
auto without_filled_faces(const Mesh& mesh)
{
  return SMF::parameters::filled_face_map(boost::make_function_property_map<Face>(
    [&mesh](Face f) { return static_cast<bool>(mesh.is_filled[f]); }));
}

void write_segments(const Result& result, const std::string& file)
{
  const Surface& surface = result.mesh->surface;
  std::vector<std::size_t> arcs(surface.number_of_faces());
  const auto map = boost::make_iterator_property_map(arcs.begin(), get(boost::face_index, surface));
  SMF::face_segmentation(result.foliation, map);
  SMF::write_segments_ply(file, surface, map, without_filled_faces(*result.mesh));
}

void write_graph(const Embedded_graph& embedded, const std::string& folder)
{
  SMF::write_reeb_graph_graphml(folder + "/reeb_graph.graphml", embedded.graph);
  SMF::write_reeb_graph_dot(folder + "/reeb_graph.dot", embedded.graph);
  SMF::write_skeleton_ply(folder + "/skeleton.ply", embedded.graph);
  SMF::write_skeleton_vtp(folder + "/skeleton.vtp", embedded.graph);
  SMF::write_skeleton_swc(folder + "/skeleton.swc", embedded.graph);
}

void write_surface(const Result& result, const Embedding& embedding, const std::string& folder)
{
  const Foliation& foliation = result.foliation;
  const auto parameters = without_filled_faces(*result.mesh);
  write_segments(result, folder + "/segments.ply");
  SMF::write_components_ply(folder + "/components.ply", foliation, parameters);
  SMF::write_components_vtp(folder + "/components.vtp", foliation, parameters);
  SMF::write_foliation_ply(folder + "/foliation.ply", foliation, parameters);
  SMF::write_foliation_vtp(folder + "/foliation.vtp", foliation, parameters);
  SMF::write_leaves_ply(folder + "/leaves.ply", foliation, embedding);
  SMF::write_leaves_vtp(folder + "/leaves.vtp", foliation, embedding);
  SMF::write_singularities_vtp(folder + "/singularities.vtp", foliation);
}

void write_coordinates(const Result& result, const std::string& folder)
{
  const SMF::Component_coordinates<Surface> coordinates(result.foliation);
  SMF::write_component_coordinates_obj(folder + "/coordinates.obj", coordinates);
  SMF::write_component_coordinates_vtp(folder + "/coordinates.vtp", coordinates);
}

void write_files(const Result& result, const Embedded_graph& embedded, const std::string& folder)
{
  without_gil([&] {
    write_graph(embedded, folder);
    write_surface(result, embedded.embedding, folder);
    write_coordinates(result, folder);
  });
}

} // namespace

void define_files(py::module_& module)
{
  module.def("write_files", &write_files, py::arg("result"), py::arg("graph"), py::arg("folder"));
}

} // namespace smf_python
