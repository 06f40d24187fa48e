// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes one harmonic foliation from a cold start and writes each intermediate state for `draw`.
//
//   solve_steps MESH OUTPUT POLE...
//
// The folder OUTPUT must exist. The program makes folders there with components.ply, leaves.ply and
// reeb_graph.graphml, of states that need not be certified: `loops`, where the leaves are in the
// loops, `0`, the start, `1`, `2`, ..., after each iteration, and `last`, the last of these again.
// The regular leaves have the same levels in all of them. OUTPUT/loops.ply contains the loops.
//
// OUTPUT/convergence.txt has a line per point of each curve: the curve, a number of sweeps or
// iterations, and the relative energy gap after them. Curves 0 and 1 are Whitehead moves with
// relaxation 1 and 1.9, 2 is Newton's method from the cold start, 3 from a coarser mesh.

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/Newton_solver.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/grow_fronts.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/start_from_coarse.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/weights_of_flat_mesh.h>

#include <CGAL/IO/Color.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using System = SMF::Loop_system<Mesh>;
using Graph = SMF::Reeb_graph<Point_3>;
using State = SMF::internal::Foliation_state;
using Refined_mesh = SMF::internal::Refined_mesh;
using Polylines = std::vector<std::vector<Point_3>>;

// What the pictures of all states have in common.
struct Frame
{
  Polylines poles;                         // of one point each
  std::vector<std::vector<double>> levels; // of regular leaves, by arc
  Graph graph;
};

Point_3 point(const SMF::internal::Point& p)
{
  return {p[0], p[1], p[2]};
}

// Faces with the colors of their arcs; those at a node are gray.
void write_components(const std::string& file_name, const Refined_mesh& refined)
{
  std::ofstream output(file_name);
  output << "ply\nformat ascii 1.0\nelement vertex " << refined.points.size()
         << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
         << refined.faces.size()
         << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
            "property uchar blue\nend_header\n";
  output.precision(17);
  for (const SMF::internal::Point& p : refined.points)
    output << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const Refined_mesh::Face& face : refined.faces)
  {
    const CGAL::IO::Color color =
      face.arc == Refined_mesh::NONE ? CGAL::IO::Color(222, 222, 226) : SMF::arc_color(face.arc);
    output << "3 " << face.vertices[0] << ' ' << face.vertices[1] << ' ' << face.vertices[2] << ' '
           << +color.red() << ' ' << +color.green() << ' ' << +color.blue() << '\n';
  }
}

// where a face crosses a level of its arc: two points, or none
std::vector<Point_3> level_segment(const Refined_mesh& refined,
                                   const Refined_mesh::Face& face,
                                   double level)
{
  std::vector<Point_3> result;
  for (int i : {0, 1, 2})
  {
    const int j = (i + 1) % 3;
    if ((face.t[i] >= level) == (face.t[j] >= level))
      continue;
    const double share = (level - face.t[i]) / (face.t[j] - face.t[i]);
    const Point_3 p = point(refined.points[face.vertices[i]]),
                  q = point(refined.points[face.vertices[j]]);
    result.push_back(p + share * (q - p));
  }
  return result;
}

// Leaves segment by segment: the state may have folds, so nothing is traced.
void write_leaves(const std::string& file_name, const Refined_mesh& refined, const Frame& frame)
{
  Polylines polylines = frame.poles;
  std::vector<int> nodes(polylines.size(), -1); // of critical leaves
  for (const Refined_mesh::Face& face : refined.faces)
  {
    if (face.arc == Refined_mesh::NONE)
      continue;
    for (double level : frame.levels[face.arc])
      polylines.push_back(level_segment(refined, face, level));
    nodes.resize(polylines.size(), -1);
    for (int i : {0, 1, 2})
      if (face.is_critical[i])
      {
        const int v = face.vertices[i], w = face.vertices[(i + 1) % 3];
        polylines.push_back({point(refined.points[v]), point(refined.points[w])});
        nodes.push_back(refined.node[v]);
      }
  }
  SMF::write_polylines_ply(
    file_name, polylines, {},
    {SMF::int_property("node", [&](std::size_t i, std::size_t) { return nodes[i]; })});
}

void write_state(const std::string& folder, const State& state, const Frame& frame)
{
  std::filesystem::create_directory(folder);
  const Refined_mesh refined = SMF::internal::Refinement(state).result();
  write_components(folder + "/components.ply", refined);
  write_leaves(folder + "/leaves.ply", refined, frame);
  SMF::write_reeb_graph_graphml(folder + "/reeb_graph.graphml", frame.graph);
}

// The relative energy gap of one curve after another, where it is above rounding.
class Convergence
{
public:
  Convergence(const std::string& file_name, double least_energy)
    : m_output(file_name), m_least_energy(least_energy)
  {}

  // returns whether the gap is above rounding
  bool add(int curve, int number, double energy)
  {
    constexpr double rounding = 1e-14;
    const double gap = energy / m_least_energy - 1;
    m_output << curve << ' ' << number << ' ' << (gap > rounding ? gap : rounding) << '\n';
    return gap > rounding;
  }

private:
  std::ofstream m_output;
  double m_least_energy;
};

void sweep(const System& system, double relaxation, int curve, Convergence& convergence)
{
  SMF::Whitehead_foliation_solver<Mesh> solver(system,
                                               SMF::parameters::over_relaxation(relaxation));
  constexpr int max_sweeps = 1000000;
  int next = 1; // the next sweep that gets a point in the plot
  for (int number = 1; number <= max_sweeps; ++number)
  {
    solver.sweep();
    if (number < next)
      continue;
    if (!convergence.add(curve, number, solver.statistics().energy))
      return;
    next = number + 1 + number / 20;
  }
}

// Calls after_iteration(number) when the state has changed.
template <class After_iteration>
void iterate(State& state,
             int curve,
             Convergence& convergence,
             const After_iteration& after_iteration)
{
  SMF::Supernodal_cholesky_solver linear_solver;
  SMF::internal::Newton_solver solver(state, linear_solver);
  SMF::internal::Solver_options options;
  options.goes_on = [&](const SMF::Foliation_statistics& iteration) {
    std::cout << "curve " << curve << ", iteration " << iteration.number_of_iterations
              << ": energy " << iteration.energy << ", optimality " << iteration.optimality << ", "
              << iteration.number_of_moves << " moves\n";
    const auto number = static_cast<int>(iteration.number_of_iterations);
    convergence.add(curve, number, iteration.energy);
    after_iteration(number);
    return true;
  };
  solver(options);
}

void write_loops(const std::string& file_name, const System& system)
{
  Polylines polylines;
  for (std::size_t arc = 0; arc < system.number_of_arcs(); ++arc)
  {
    polylines.emplace_back();
    for (const auto& [halfedge, position] : system.loop(arc))
    {
      const Point_3 p = system.mesh().point(source(halfedge, system.mesh())),
                    q = system.mesh().point(target(halfedge, system.mesh()));
      polylines.back().push_back(p + position * (q - p));
    }
    polylines.back().push_back(polylines.back().front());
  }
  SMF::write_polylines_ply(file_name, polylines);
}

void run(const std::string& mesh_file, const std::string& folder, const std::vector<int>& poles)
{
  Mesh mesh;
  SMF::read_triangle_mesh(mesh_file, mesh);
  SMF::Poles_and_loops<Mesh> input;
  Frame frame;
  for (int v : poles)
  {
    input.add_pole(Mesh::Vertex_index(v));
    frame.poles.push_back({mesh.point(Mesh::Vertex_index(v))});
  }
  const System system(mesh, input);
  write_loops(folder + "/loops.ply", system);

  const auto harmonic = SMF::harmonic_foliation(system);
  const auto embedding = SMF::reeb_graph_embedding(harmonic);
  SMF::reeb_graph(harmonic, frame.graph, embedding);
  frame.levels = embedding.levels;

  Convergence convergence(folder + "/convergence.txt", harmonic.statistics().energy);
  sweep(system, 1, 0, convergence);
  sweep(system, 1.9, 1, convergence);
  const SMF::internal::Flat_loop_system& flat = system.data().flat;
  State cold(flat, SMF::internal::mean_value_weights(flat.mesh));
  write_state(folder + "/loops", cold, frame);
  SMF::internal::grow_fronts(cold);
  write_state(folder + "/0", cold, frame);
  std::cout << "start: energy " << SMF::internal::energy_of(cold) << '\n';
  iterate(cold, 2, convergence,
          [&](int number) { write_state(folder + "/" + std::to_string(number), cold, frame); });
  write_state(folder + "/last", cold, frame);
  State carried(flat, SMF::internal::mean_value_weights(flat.mesh));
  SMF::internal::start_from_coarse(carried);
  iterate(carried, 3, convergence, [](int) {});
}

int main(int argc, char* argv[])
{
  try
  {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    std::vector<int> poles;
    for (std::size_t i = 2; i < arguments.size(); ++i)
      poles.push_back(std::stoi(arguments[i]));
    run(arguments.at(0), arguments.at(1), poles);
  }
  catch (const std::exception& error)
  {
    std::cerr << "solve_steps: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
