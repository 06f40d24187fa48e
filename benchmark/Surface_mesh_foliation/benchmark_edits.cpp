// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Edits of poles and loops with Foliation_solver, in units of one analysis, factorization and solve
// of the mesh's Laplacian by Eigen::SimplicialLDLT, measured in turns:
//
//   benchmark_edits [--levels=N] [--runs=R]
//
// prints a table of medians of R runs (5): the first foliation; then another height, a pole moved
// to a neighbor and by a fiftieth of the way across, one pole less and one more. Each edit is the
// new loop system and its foliation. The meshes are a human body (shared meshes, 6,890 vertices)
// or, without shared meshes, CGAL's hand, subdivided up to N times (3).

#include "benchmark_mesh.h"
#include "benchmark_table.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/squared_distance_3.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

using namespace smf_benchmark;

namespace {

using System = SMF::Loop_system<Mesh>;

const std::vector<std::string> edits = {
  "first", "height", "pole moved by an edge", "pole moved by 2%", "pole removed", "pole added"};

Vertex neighbor_of(const Mesh& mesh, Vertex v)
{
  return source(halfedge(v, mesh), mesh);
}

// the vertex whose distance from `from` is closest to this share of the diagonal
Vertex vertex_at_distance(const Mesh& mesh, Vertex from, double share)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double wanted =
    share * std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  const auto error = [&](Vertex v) {
    return std::abs(std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(from))) - wanted);
  };
  Vertex result = from;
  for (const Vertex v : vertices(mesh))
    if (error(v) < error(result))
      result = v;
  return result;
}

// poles at vertices, the second of which has this height
SMF::Poles_and_loops<Mesh> input_of(const std::vector<Vertex>& poles, double height = 1)
{
  SMF::Poles_and_loops<Mesh> result;
  for (const Vertex v : poles)
    result.add_pole(v);
  result.set_height(1, height);
  return result;
}

struct Row
{
  std::size_t vertices;
  Series series;
};

// The solver goes from edit to edit, and back to the poles given.
void measure_once(const Mesh& mesh, const std::vector<Vertex>& poles, Series& series)
{
  const One_solve<Eigen_solver> solve(System(mesh, input_of(poles)));
  series.measure("solve", [&] { benchmark::DoNotOptimize(solve()); });
  SMF::Foliation_solver<Mesh> solver;
  System system(mesh, input_of(poles));
  series.measure("first", [&] {
    system = System(mesh, input_of(poles));
    solver.solve(system);
  });
  const auto edit = [&](const std::string& name, const std::vector<Vertex>& edited, double height) {
    series.measure(name, [&] {
      system = System(system, input_of(edited, height));
      solver.solve(system);
    });
    system = System(system, input_of(poles));
    solver.solve(system);
  };
  edit("height", poles, 1.3);
  std::vector<Vertex> edited = poles;
  edited[0] = neighbor_of(mesh, poles[0]);
  edit("pole moved by an edge", edited, 1);
  edited[0] = vertex_at_distance(mesh, poles[0], 0.02);
  edit("pole moved by 2%", edited, 1);
  edited = {poles.begin(), poles.end() - 1};
  edit("pole removed", edited, 1);
  edited = poles;
  edited.push_back(vertex_at_distance(mesh, poles[0], 0.3));
  edit("pole added", edited, 1);
}

Row measured(const Mesh& mesh, const std::vector<Vertex>& poles, int runs)
{
  Row row = {num_vertices(mesh), {}};
  for (int run = 0; run < runs; ++run)
    measure_once(mesh, poles, row.series);
  return row;
}

std::vector<Vertex> poles_of_body()
{
  std::vector<Vertex> result;
  for (const int v : body_tips())
    result.emplace_back(static_cast<Mesh::size_type>(v));
  return result;
}

} // namespace

int main(int argc, char* argv[])
try
{
  int levels = 3, runs = 5;
  for (int i = 1; i < argc; ++i)
  {
    levels = value_of(argv[i], "--levels=", levels);
    runs = value_of(argv[i], "--runs=", runs);
  }
  std::vector<Row> rows;
  for (int level = 0; level <= levels; ++level)
    rows.push_back(measured(subdivided(level), poles_of_body(), runs));
  std::cout << "Times in units of one solve, " << runs << " runs.\n" << std::endl;
  print_in_solves(rows, edits);
  return EXIT_SUCCESS;
}
catch (const std::exception& exception)
{
  std::cerr << exception.what() << std::endl;
  return EXIT_FAILURE;
}
