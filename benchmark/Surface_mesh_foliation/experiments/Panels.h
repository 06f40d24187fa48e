// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_PANELS_H
#define SMF_EXPERIMENTS_PANELS_H

#include "Part_graph.h"
#include "Shapes.h"

#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>
#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_segments.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

// What doc/Surface_mesh_foliation/pictures/draw reads: a folder panels/NAME for each panel of a
// picture.

namespace smf_experiments {

// words become one, in letters, digits, underscores and hyphens
inline std::string panel_name(std::string words)
{
  std::replace(words.begin(), words.end(), ' ', '_');
  for (const char bracket : {'(', ')'})
    words.erase(std::remove(words.begin(), words.end(), bracket), words.end());
  return words;
}

// a surface in the colors of its parts; returns the folder
inline std::string write_panel(const std::string& name,
                               const Mesh& mesh,
                               const std::vector<int>& part_of_face)
{
  const std::string folder = "panels/" + name;
  std::filesystem::create_directories(folder);
  const std::vector<std::size_t> components(part_of_face.begin(), part_of_face.end());
  SMF::write_segments_ply(
    folder + "/components.ply", mesh,
    boost::make_iterator_property_map(components.begin(), get(CGAL::face_index, mesh)));
  return folder;
}

// with its graph
inline void write_panel(const std::string& name, const Mesh& mesh, const Part_graph& graph)
{
  const std::string folder = write_panel(name, mesh, graph.arc_of_face);
  SMF::write_skeleton_ply(folder + "/skeleton.ply", graph.graph);
  SMF::write_reeb_graph_graphml(folder + "/reeb_graph.graphml", graph.graph);
}

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_PANELS_H
