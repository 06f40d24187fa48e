// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "minima.h"
#include "require.h"
#include "systems_from_bytes.h"
#include "targets.h"

#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using namespace smf_fuzz;

// wants no result after so many questions
struct Impatient_visitor : SMF::Default_foliation_visitor
{
  explicit Impatient_visitor(std::size_t* number) : questions_left(number) {}
  bool go_on() { return (*questions_left)-- > 0; }
  std::size_t* questions_left;
};

void edit(std::vector<Entry>& entries, Loops_from_bytes& source, FuzzedDataProvider& bytes)
{
  const std::size_t i = entries.empty() ? 0 : source.index(entries.size());
  const int kind = entries.empty() ? 0 : bytes.ConsumeIntegral<std::uint8_t>() % 8;
  if (kind <= 1)
    survives([&] {
      for (Entry& entry : source.next())
        entries.push_back(std::move(entry));
    });
  else if (kind == 2)
    entries[i].height = source.usual_height();
  else if (kind == 3)
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(i));
  else if (entries[i].pole.size() == 1) // it moves over some edges
  {
    entries[i].loop.clear();
    for (std::size_t step = 1 + source.index(4); step > 0; --step)
      entries[i].pole[0] = source.neighbor(entries[i].pole[0]);
  }
}

} // namespace

// Edits in a row of one loop system, solved by one solver: each gives what a new solver finds, also
// after runs that were stopped, or ended early.
void smf_fuzz::edits(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  const std::optional<Mesh> mesh = mesh_from_bytes(bytes, 12);
  if (!mesh)
    return;
  Loops_from_bytes source(*mesh, bytes);
  std::vector<Entry> entries = source.openings();
  add_entries(*mesh, source, 2 + source.index(4), entries);
  std::optional<System> system;
  if (!survives([&] { system.emplace(*mesh, to_input(entries)); }))
    return;
  SMF::Foliation_solver<Mesh> solver;
  for (int i = 0; i < 8 && bytes.remaining_bytes() > 0; ++i)
  {
    std::vector<Entry> edited = entries;
    if (i > 0)
      edit(edited, source, bytes);
    if (!survives([&] { system = System(*system, to_input(edited)); }))
      continue;
    entries = edited;
    if (is_printing())
      print(*mesh, entries);
    const auto way = bytes.ConsumeIntegral<std::uint8_t>() % 8;
    std::size_t questions = 3 * static_cast<std::size_t>(way);
    std::optional<Foliation> foliation;
    survives([&] {
      if (way < 2)
        foliation = solver.solve(*system, CGAL::parameters::visitor(Impatient_visitor(&questions)));
      else if (way < 4)
        foliation = solver.solve(*system, CGAL::parameters::number_of_iterations(way - 2));
      else
        foliation = solver.solve(*system);
    });
    require(foliation.has_value() || way < 2, "a loop system without a foliation");
    if (!foliation)
      continue;
    require(foliation->statistics().is_certified, "no certificate");
    if (way < 4)
      continue;
    require_minimum(*foliation);
    require_same_minimum(*foliation, SMF::harmonic_foliation(System(*mesh, to_input(entries))),
                         "edit " + std::to_string(i) + " and a new start");
  }
}
