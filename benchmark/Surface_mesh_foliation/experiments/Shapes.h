// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_SHAPES_H
#define SMF_EXPERIMENTS_SHAPES_H

#include "Command_line.h"
#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The shapes of the experiments, with the limbs that were marked by hand in limbs.csv.

namespace smf_experiments {

namespace SMF = CGAL::Surface_mesh_foliation;

using smf_test::Kernel;
using smf_test::Mesh;
using Point = Kernel::Point_3;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

// What is nearer to the tip than the length, along the surface. Lengths are shares of the diagonal
// of the bounding box.
struct Limb
{
  std::string name;
  Vertex tip;
  double length;
};

// Parts are numbered: first the limbs, then the trunk, which is the rest.
struct Shape
{
  std::string name;
  Mesh mesh;
  int up = 1; // which coordinate is the height
  bool is_posed = false;
  std::vector<Limb> limbs;
  std::vector<std::vector<double>> distances; // of the vertices from the tip of each limb
  std::vector<int> part_of_vertex, part_of_face;

  int trunk() const { return static_cast<int>(limbs.size()); }
  std::vector<Vertex> tips() const
  {
    std::vector<Vertex> result;
    for (const Limb& limb : limbs)
      result.push_back(limb.tip);
    return result;
  }
};

inline double diagonal(const Mesh& mesh)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  return std::sqrt(CGAL::squared_distance(Point(box.xmin(), box.ymin(), box.zmin()),
                                          Point(box.xmax(), box.ymax(), box.zmax())));
}

inline SMF::internal::Flat_mesh flat_mesh(const Mesh& mesh)
{
  return SMF::internal::Checked_mesh<Mesh>(mesh, CGAL::parameters::default_values()).flat;
}

// in the unit of the mesh
inline std::vector<double> geodesic_distances(const Mesh& mesh, const std::vector<Vertex>& sources)
{
  const SMF::internal::Flat_mesh flat = flat_mesh(mesh);
  const std::vector<double> lengths = SMF::internal::edge_lengths(flat);
  const auto h = SMF::internal::halfedge_of(0);
  const double unit = std::sqrt(CGAL::squared_distance(mesh.point(Vertex(flat.source(h))),
                                                       mesh.point(Vertex(flat.target(h))))) /
                      lengths[0];
  std::vector<int> numbers;
  for (const Vertex v : sources)
    numbers.push_back(static_cast<int>(v.idx()));
  std::vector<double> result =
    SMF::internal::Geodesic_distances(flat, lengths, numbers).distances();
  for (double& distance : result)
    distance *= unit;
  return result;
}

// the three vertices of a face
inline std::array<Vertex, 3> corners(const Mesh& mesh, Face f)
{
  const auto h = mesh.halfedge(f);
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
}

// the limb that is nearest to a place with the given distances from the tips, as shares of the
// lengths of limbs, or the trunk
template <class Distance>
int part_at(const std::vector<Limb>& limbs, double unit, Distance distance)
{
  int result = static_cast<int>(limbs.size());
  double least = 1;
  for (std::size_t i = 0; i < limbs.size(); ++i)
  {
    const double share = distance(i) / (limbs[i].length * unit);
    if (share < least)
    {
      least = share;
      result = static_cast<int>(i);
    }
  }
  return result;
}

inline void mark_parts(Shape& shape)
{
  const double unit = diagonal(shape.mesh);
  for (const Limb& limb : shape.limbs)
    shape.distances.push_back(geodesic_distances(shape.mesh, {limb.tip}));
  const auto part = [&](auto distance) { return part_at(shape.limbs, unit, distance); };
  for (const Vertex v : vertices(shape.mesh))
    shape.part_of_vertex.push_back(
      part([&](std::size_t limb) { return shape.distances[limb][v.idx()]; }));
  for (const Face f : faces(shape.mesh))
    shape.part_of_face.push_back(part([&](std::size_t limb) {
      double sum = 0;
      for (const Vertex v : corners(shape.mesh, f))
        sum += shape.distances[limb][v.idx()];
      return sum / 3;
    }));
}

// the path of the file of a shape, or nothing
inline std::string path_of_shape(const std::string& name)
{
  const std::string data = SMF_DATA_DIR, shared = SMF_SHARED_DIR;
  for (const std::string& folder : {data, shared.empty() ? shared : shared + "/meshes"})
    if (!folder.empty() && std::ifstream(folder + "/" + name + ".off"))
      return folder + "/" + name + ".off";
  return "";
}

// the lines of a table in this folder, without comments and titles
inline std::vector<std::vector<std::string>> read_marks(const std::string& name)
{
  std::ifstream file(std::string(SMF_EXPERIMENTS_DIR) + "/" + name);
  if (!file)
    throw std::runtime_error("cannot read " + name + " in " SMF_EXPERIMENTS_DIR);
  std::vector<std::vector<std::string>> result;
  bool has_titles = false;
  for (std::string line; std::getline(file, line);)
    if (!line.empty() && line[0] != '#' && std::exchange(has_titles, true))
      result.push_back(split(line));
  return result;
}

// the shape with the given name, and its limbs
inline Shape load_shape(const std::string& name)
{
  Shape result;
  result.name = name;
  SMF::read_triangle_mesh(path_of_shape(name), result.mesh);
  for (const std::vector<std::string>& row : read_marks("shapes.csv"))
    if (row.at(0) == name)
    {
      result.up = row.at(1)[0] - 'x';
      result.is_posed = row.at(2) == "yes";
    }
  for (const std::vector<std::string>& row : read_marks("limbs.csv"))
    if (row.at(0) == name)
      result.limbs.push_back(
        {row.at(1), smf_test::vertex(std::stoul(row.at(2))), std::stod(row.at(3))});
  mark_parts(result);
  return result;
}

// calls `visit` with each shape that was asked for, or all; shapes whose meshes are not there are
// left out, with a message
template <class Visit>
void for_each_shape(const Options& options, Visit visit)
{
  std::vector<std::string> names = options.shapes;
  if (names.empty())
    for (const std::vector<std::string>& row : read_marks("shapes.csv"))
      names.push_back(row.at(0));
  for (const std::string& name : names)
    if (path_of_shape(name).empty())
      std::cerr << name << ": there is no mesh" << std::endl;
    else
    {
      std::cerr << name << std::endl;
      visit(load_shape(name));
    }
}

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_SHAPES_H
