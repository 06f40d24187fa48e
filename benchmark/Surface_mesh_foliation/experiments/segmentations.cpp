// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Segmentation: components of foliations, and CGAL's segments by the shape diameter function,
// against the limbs and the trunk that were marked by hand. Also writes panels of pictures. Runs:
// the number of settings of CGAL's segmentation, the default first.

#include "Command_line.h"
#include "Panels.h"
#include "Part_graph.h"
#include "Parts.h"
#include "Shapes.h"

#include <CGAL/centroid.h>
#include <CGAL/mesh_segmentation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

using namespace smf_experiments;

using Segments = std::vector<int>; // by face

struct Setting
{
  std::size_t number_of_clusters;
  double smoothing;
};

const std::vector<Setting> settings = {{5, 0.26}, {2, 0.26}, {3, 0.26}, {4, 0.26}, {6, 0.26},
                                       {8, 0.26}, {2, 0.1},  {3, 0.1},  {5, 0.1},  {8, 0.1},
                                       {2, 0.5},  {3, 0.5},  {5, 0.5},  {8, 0.5}};

// the ends of the edges between two segments
std::vector<Vertex> vertices_of_cuts(const Mesh& mesh, const Segments& segments)
{
  std::set<Vertex> result;
  for (const auto h : halfedges(mesh))
    if (segments[mesh.face(h).idx()] != segments[mesh.face(mesh.opposite(h)).idx()])
      result.insert(mesh.target(h));
  return {result.begin(), result.end()};
}

// the mean distance of the cuts of one segmentation from those of another
double mean_cut_distance(const Mesh& mesh, const Segments& from, const Segments& to)
{
  const std::vector<Vertex> cuts = vertices_of_cuts(mesh, from);
  const std::vector<double> distances = geodesic_distances(mesh, vertices_of_cuts(mesh, to));
  double sum = 0;
  for (const Vertex v : cuts)
    sum += distances[v.idx()];
  return cuts.empty() ? 0 : sum / static_cast<double>(cuts.size());
}

// Both ways, as a multiple of the mean distance of vertices from their centroid (Chen,
// Golovinskiy and Funkhouser, A benchmark for 3D mesh segmentation, 2009).
double cut_discrepancy(const Mesh& mesh, const Segments& first, const Segments& second)
{
  const Point center = CGAL::centroid(mesh.points().begin(), mesh.points().end());
  double radius = 0;
  for (const Vertex v : vertices(mesh))
    radius += std::sqrt(CGAL::squared_distance(mesh.point(v), center)) /
              static_cast<double>(num_vertices(mesh));
  return (mean_cut_distance(mesh, first, second) + mean_cut_distance(mesh, second, first)) / radius;
}

void print(const Shape& shape,
           const std::string& method,
           const std::string& setting,
           const Segments& segments)
{
  const Overlaps overlaps(segments, shape.part_of_face, face_areas(shape.mesh));
  const bool has_cuts = !vertices_of_cuts(shape.mesh, segments).empty();
  print_row(shape.name, method, setting, std::set<int>(segments.begin(), segments.end()).size(),
            overlaps.rand_difference(), overlaps.hamming_difference(),
            has_cuts ? std::to_string(cut_discrepancy(shape.mesh, segments, shape.part_of_face))
                     : "",
            overlaps.number_of_pairs(0.5), shape.limbs.size() + 1);
}

void write_picture(const Shape& shape, const std::string& method, const Segments& segments)
{
  write_panel(panel_name(shape.name + " " + method), shape.mesh, segments);
}

void print_segments_of_cgal(const Shape& shape, std::size_t number_of_settings)
{
  const Mesh& mesh = shape.mesh;
  std::vector<double> diameters(num_faces(mesh));
  const auto index = get(CGAL::face_index, mesh);
  const auto diameter_map = boost::make_iterator_property_map(diameters.begin(), index);
  CGAL::sdf_values(mesh, diameter_map);
  for (std::size_t i = 0; i < number_of_settings; ++i)
  {
    std::vector<std::size_t> segments(num_faces(mesh));
    CGAL::segmentation_from_sdf_values(mesh, diameter_map,
                                       boost::make_iterator_property_map(segments.begin(), index),
                                       settings[i].number_of_clusters, settings[i].smoothing);
    const Segments result(segments.begin(), segments.end());
    print(shape, "shape diameter function",
          std::to_string(settings[i].number_of_clusters) + " clusters " +
            std::to_string(settings[i].smoothing).substr(0, 4),
          result);
    if (i == 0)
      write_picture(shape, "shape diameter function", result);
  }
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, settings.size(), [](const Options& options) {
    print_row("shape", "method", "setting", "segments", "rand difference", "hamming difference",
              "cut discrepancy", "parts like one segment", "parts");
    for_each_shape(options, [&](const Shape& shape) {
      write_picture(shape, "marked by hand", shape.part_of_face);
      for (const Named_graph& named :
           graphs_of_foliations(shape.mesh, shape.tips(), shape.part_of_vertex))
      {
        print(shape, named.name, "", named.graph.arc_of_face);
        write_picture(shape, named.name, named.graph.arc_of_face);
      }
      print_segments_of_cgal(shape, (std::min)(options.runs, settings.size()));
    });
  });
}
