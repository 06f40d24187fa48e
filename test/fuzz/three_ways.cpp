// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "minima.h"
#include "require.h"
#include "systems_from_bytes.h"
#include "targets.h"

#include "include/two_roads.h"

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/integrate_foliation.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_fuzz;

void compare_with_moves(const Foliation& newton)
{
  const Foliation moves = SMF::whitehead_foliation(
    newton.system(),
    SMF::parameters::over_relaxation(1.9).tolerance(1e-10).number_of_iterations(2000));
  require(moves.statistics().is_certified, "moves without a certificate");
  require(moves.statistics().energy >=
            newton.statistics().energy * (1 - 1e-9) - Numbers(newton).remaining_work,
          "moves find less energy");
  if (moves.statistics().has_converged)
    require_same_minimum(newton, moves, "Newton's method and moves");
}

// Leaves closer together than its tolerance are one to the second road. What can be seen of that
// here is whether edge values are told apart: each two are the same up to rounding, or clearly not.
bool are_told_apart(const Foliation& foliation)
{
  std::vector<double> values = {0};
  for (const auto e : edges(foliation.mesh()))
    values.push_back(foliation.edge_value(e));
  std::sort(values.begin(), values.end());
  for (std::size_t i = 1; i < values.size(); ++i)
    if (const double gap = (values[i] - values[i - 1]) / values.back(); gap > 1e-14 && gap < 1e-6)
      return false;
  return true;
}

// The edge values may be closer together than the second road can tell.
void compare_with_second_road(const Foliation& newton)
{
  auto values = get(CGAL::dynamic_edge_property_t<double>(), const_cast<Mesh&>(newton.mesh()));
  SMF::edge_values(newton, values);
  std::optional<Foliation> other;
  survives([&] { other = SMF::integrate_foliation(newton.mesh(), values); });
  if (!other)
    return;
  require(other->statistics().is_certified, "the second road has no certificate");
  require(!are_told_apart(newton) || smf_test::have_same_graph(newton.system(), other->system()),
          "the second road leads to another graph");
  const double difference = smf_test::difference(newton, *other);
  require(difference < 1e-7, "the second road leads elsewhere, by " + std::to_string(difference));
}

} // namespace

// Newton's method, Whitehead moves, and the road from nothing but edge values, on tiny meshes.
void smf_fuzz::three_ways(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  const std::optional<Mesh> mesh = mesh_from_bytes(bytes, 8);
  if (!mesh || !CGAL::is_closed(*mesh))
    return;
  Loops_from_bytes source(*mesh, bytes);
  std::vector<Entry> entries;
  add_entries(*mesh, source, 2 + source.index(5), entries);
  if (is_printing())
    print(*mesh, entries);
  survives([&] {
    const System system(*mesh, to_input(entries));
    const Foliation newton = SMF::harmonic_foliation(system);
    compare_with_moves(newton);
    compare_with_second_road(newton);
  });
}
