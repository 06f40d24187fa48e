// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "require.h"
#include "targets.h"

#include "generators/meshes.h"
#include "generators/openings.h"

#include <CGAL/Surface_mesh_foliation/IO/read_loops.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>

#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using smf_test::Mesh;
namespace SMF = CGAL::Surface_mesh_foliation;

// a sphere, a torus, a surface of genus two, and one with an opening
const std::vector<Mesh>& meshes()
{
  static const std::vector<Mesh> result = {
    smf_test::icosphere(1), smf_test::torus(6, 5, 3, 1), smf_test::handle_surface(2),
    smf_test::to_open_mesh(smf_test::soups::part_below(smf_test::soups::icosphere(1), 2, 0.5))};
  return result;
}

} // namespace

// The text of a loops file, on one of several meshes, and the system that its loops form.
void smf_fuzz::read_loops(const std::uint8_t* data, std::size_t size)
{
  if (size == 0)
    return;
  const Mesh& mesh = meshes()[data[0] % meshes().size()];
  std::istringstream text(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  SMF::Poles_and_loops<Mesh> input;
  for (const auto h : smf_test::border_halfedges(mesh))
    input.add_border_pole(h);
  const auto np = CGAL::parameters::default_values();
  SMF::internal::Loops_reader<Mesh, std::decay_t<decltype(np)>> reader(
    mesh, np, SMF::internal::all_vertices(mesh), input);
  survives([&] { reader.read(text, "file"); });
  survives([&] { SMF::Loop_system<Mesh>(mesh, input); });
}
