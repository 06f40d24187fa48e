// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "targets.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

// A program has several targets, since what they have in common takes longest to compile. It is
// called by a link for each, fuzz_TARGET; SMF_FUZZ_TARGETS has {"fuzz_TARGET", &TARGET} for each.

namespace {

using Target = void (*)(const std::uint8_t* data, std::size_t size);
Target target = nullptr;

Target find_target(const std::string& name)
{
  using namespace smf_fuzz;
  const std::map<std::string, Target> targets = {SMF_FUZZ_TARGETS};
  const auto it = targets.find(name);
  return it == targets.end() ? nullptr : it->second;
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int*, char*** argv)
{
  const std::string name = std::filesystem::path((*argv)[0]).filename().string();
  target = find_target(name);
  if (!target)
  {
    std::cerr << name << " is no target; start the program by a link fuzz_TARGET\n";
    std::exit(EXIT_FAILURE);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  target(data, size);
  return 0;
}
