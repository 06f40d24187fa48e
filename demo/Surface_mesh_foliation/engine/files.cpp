// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Session.h"

#include <CGAL/Surface_mesh_foliation/Component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_component_coordinates.h>
#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_segments.h>
#include <CGAL/Surface_mesh_foliation/IO/write_swc.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <boost/property_map/property_map.hpp>

#include <fstream>
#include <string>
#include <vector>

namespace smf_engine {

namespace {

void write_segments(const Foliation& foliation, const Loaded_mesh& loaded, const std::string& file)
{
  std::vector<std::size_t> arcs(loaded.mesh.number_of_faces());
  const auto map =
    boost::make_iterator_property_map(arcs.begin(), get(boost::face_index, loaded.mesh));
  SMF::face_segmentation(foliation, map);
  SMF::write_segments_ply(file, loaded.mesh, map,
                          SMF::parameters::filled_face_map(loaded.is_filled));
}

void write_edge_values(const Foliation& foliation, const std::string& file)
{
  std::ofstream output(file);
  output.precision(17);
  output << "vertex,vertex,value\n";
  for (const Edge e : foliation.mesh().edges())
    output << foliation.mesh().vertex(e, 0).idx() << ',' << foliation.mesh().vertex(e, 1).idx()
           << ',' << foliation.edge_value(e) << '\n';
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool write_graph(const std::string& what, const Graph& graph, const std::string& file)
{
  if (what == "reeb_graph.graphml")
    SMF::write_reeb_graph_graphml(file, graph);
  else if (what == "reeb_graph.dot")
    SMF::write_reeb_graph_dot(file, graph);
  else if (what == "skeleton.ply")
    SMF::write_skeleton_ply(file, graph);
  else if (what == "skeleton.vtp")
    SMF::write_skeleton_vtp(file, graph);
  else if (what == "skeleton.swc")
    SMF::write_skeleton_swc(file, graph);
  else
    return false;
  return true;
}

bool write_surface(const std::string& what,
                   const Foliation& foliation,
                   const Embedding& embedding,
                   const Loaded_mesh& loaded,
                   const std::string& file)
{
  const auto parameters = SMF::parameters::filled_face_map(loaded.is_filled);
  if (what == "components.ply")
    SMF::write_components_ply(file, foliation, parameters);
  else if (what == "components.vtp")
    SMF::write_components_vtp(file, foliation, parameters);
  else if (what == "foliation.ply")
    SMF::write_foliation_ply(file, foliation, parameters);
  else if (what == "foliation.vtp")
    SMF::write_foliation_vtp(file, foliation, parameters);
  else if (what == "leaves.ply")
    SMF::write_leaves_ply(file, foliation, embedding);
  else if (what == "leaves.vtp")
    SMF::write_leaves_vtp(file, foliation, embedding);
  else if (what == "singularities.vtp")
    SMF::write_singularities_vtp(file, foliation);
  else if (what == "segments.ply")
    write_segments(foliation, loaded, file);
  else if (what == "edge_values.csv")
    write_edge_values(foliation, file);
  else
    return false;
  return true;
}

bool write_coordinates(const std::string& what, const Foliation& foliation, const std::string& file)
{
  if (what != "components.obj" && what != "coordinates.vtp")
    return false;
  const SMF::Component_coordinates<Mesh> coordinates(foliation);
  if (ends_with(what, ".obj"))
    SMF::write_component_coordinates_obj(file, coordinates);
  else
    SMF::write_component_coordinates_vtp(file, coordinates);
  return true;
}

} // namespace

void Session::write(const std::string& what, const std::string& file) const
{
  const Foliation& foliation = last_foliation();
  if (!write_graph(what, m_graph, file) &&
      !write_surface(what, foliation, m_embedding, m_loaded, file) &&
      !write_coordinates(what, foliation, file))
    throw SMF::Invalid_parameter_exception(
      {SMF::Problem_kind::INVALID_PARAMETER, "there is no file " + what + " to write", {}, {}, {}});
}

} // namespace smf_engine
