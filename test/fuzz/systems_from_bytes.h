// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_SYSTEMS_FROM_BYTES_H
#define SMF_FUZZ_SYSTEMS_FROM_BYTES_H

#include "loops_from_bytes.h"
#include "require.h"

#include <CGAL/Surface_mesh_foliation/Loop_system.h>

#include <cstddef>
#include <vector>

namespace smf_fuzz {

using System = SMF::Loop_system<Mesh>;

inline bool is_valid(const Mesh& mesh, const std::vector<Entry>& entries)
{
  bool result = false;
  survives([&] { result = SMF::validate(mesh, to_input(entries)).empty(); });
  return result;
}

// Adds poles and loops as bytes say, those that fit to the ones before; the first few in any case,
// since one pole may be too few.
inline void add_entries(const Mesh& mesh,
                        Loops_from_bytes& source,
                        std::size_t number,
                        std::vector<Entry>& entries)
{
  const std::size_t few = entries.size() + 2;
  for (std::size_t i = 0; i < number; ++i)
    survives([&] {
      std::vector<Entry> more = entries;
      for (Entry& entry : source.next())
        more.push_back(std::move(entry));
      if (more.size() <= few || is_valid(mesh, more))
        entries = std::move(more);
    });
}

} // namespace smf_fuzz

#endif // SMF_FUZZ_SYSTEMS_FROM_BYTES_H
