// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Accidental poles (figures 9 and 10 of the paper): Whitehead moves with cotangent and with mean
// value weights on meshes that are not Delaunay, and what the default solver makes of them. Runs:
// the number of triangulations of each shape.

#include "Command_line.h"
#include "Part_graph.h"
#include "Shapes.h"
#include "Variants.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/edge_weights.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace smf_experiments;

using System = SMF::Loop_system<Mesh>;

// the share of edges whose cotangent weight is not positive
double non_delaunay_share(const System& system)
{
  std::vector<double> weights(num_edges(system.mesh()));
  SMF::edge_weights(
    system, SMF::Cotangent_weights(),
    boost::make_iterator_property_map(weights.begin(), get(boost::edge_index, system.mesh())));
  return static_cast<double>(
           std::count_if(weights.begin(), weights.end(), [](double w) { return w <= 0; })) /
         static_cast<double>(weights.size());
}

struct Count
{
  std::size_t sweeps, accidental_poles;
};

template <class EdgeWeights>
Count whitehead_moves(const System& system, EdgeWeights weights, bool are_literal)
{
  constexpr std::size_t step = 100, most = 2000;
  SMF::Whitehead_foliation_solver<Mesh> solver(system, SMF::parameters::weights(weights)
                                                         .allow_any_weights(true)
                                                         .over_relaxation(are_literal ? 1. : 1.9)
                                                         .use_literal_moves(are_literal));
  std::size_t sweeps = 0;
  for (; sweeps < most && !solver.statistics(1e-8).has_converged; sweeps += step)
    for (std::size_t i = 0; i < step; ++i)
      solver.sweep();
  return {sweeps, solver.accidental_thorns().size()};
}

// what the default solver makes of it: "certified", or what is wrong
template <class EdgeWeights>
std::string default_solver(const System& system, EdgeWeights weights)
{
  try
  {
    SMF::harmonic_foliation(system, SMF::parameters::weights(weights).allow_any_weights(true));
    return "certified";
  }
  catch (const SMF::Foliation_exception& exception)
  {
    std::string message = exception.what();
    std::replace(message.begin(), message.end(), ',', ';');
    return message;
  }
}

template <class EdgeWeights>
void print(const Shape& shape,
           const Variant& variant,
           const System& system,
           const std::string& name,
           EdgeWeights weights)
{
  const Count literal = whitehead_moves(system, weights, true);
  const Count repaired = whitehead_moves(system, weights, false);
  print_row(shape.name, variant.name, num_vertices(variant.mesh), non_delaunay_share(system), name,
            literal.accidental_poles, repaired.accidental_poles, repaired.sweeps,
            default_solver(system, weights));
}

// Triangulations of a shape, small ones because moves take many sweeps: all are made from one with
// at most about 1,500 vertices.
std::vector<Variant> triangulations(const Shape& shape)
{
  const double ratio = 1500. / static_cast<double>(num_vertices(shape.mesh));
  const Mesh mesh = simplified(shape.mesh, (std::min)(ratio, 0.75));
  const Mesh stretched = anisotropic(mesh, shape.up, 4);
  const std::string kind = "triangulation";
  return {{kind, "simplified", mesh},
          {kind, "10% of edges flipped", smf_test::flip_random_edges(mesh, 0.1, 1)},
          {kind, "30% of edges flipped", smf_test::flip_random_edges(mesh, 0.3, 1)},
          {kind, "slivers", with_slivers(mesh, 0.3, 1)},
          {kind, "anisotropic", stretched},
          {kind, "anisotropic with 30% flipped", smf_test::flip_random_edges(stretched, 0.3, 1)}};
}

int main(int argc, char* argv[])
{
  return run_experiment(argc, argv, 6, [](const Options& options) {
    print_row("shape", "triangulation", "vertices", "edges that are not Delaunay", "weights",
              "accidental poles of literal moves", "of repaired moves", "sweeps of repaired moves",
              "default solver");
    for_each_shape(options, [&](const Shape& shape) {
      std::vector<Variant> variants = triangulations(shape);
      variants.resize((std::min)(options.runs, variants.size()));
      for (const Variant& variant : variants)
      {
        const std::vector<Vertex> poles = nearest_vertices(shape.mesh, shape.tips(), variant.mesh);
        const System system(variant.mesh, with_poles(poles));
        print(shape, variant, system, "cotangent", SMF::Cotangent_weights());
        print(shape, variant, system, "mean value", SMF::Mean_value_weights());
      }
    });
  });
}
