// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_TARGETS_H
#define SMF_FUZZ_TARGETS_H

#include <cstddef>
#include <cstdint>

// What is fuzzed. Each of these functions takes arbitrary bytes, makes an input of them, and ends
// the program if it finds something wrong; see require() and survives().

namespace smf_fuzz {

void read_off(const std::uint8_t* data, std::size_t size);
void read_obj(const std::uint8_t* data, std::size_t size);
void read_ply(const std::uint8_t* data, std::size_t size);
void read_stl(const std::uint8_t* data, std::size_t size);
void read_loops(const std::uint8_t* data, std::size_t size);
void repair(const std::uint8_t* data, std::size_t size);
void loop_systems(const std::uint8_t* data, std::size_t size);
void edits(const std::uint8_t* data, std::size_t size);
void three_ways(const std::uint8_t* data, std::size_t size);
void python_boundary(const std::uint8_t* data, std::size_t size);

} // namespace smf_fuzz

#endif // SMF_FUZZ_TARGETS_H
