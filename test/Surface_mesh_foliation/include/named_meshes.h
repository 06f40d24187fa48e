// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_NAMED_MESHES_H
#define SMF_TEST_NAMED_MESHES_H

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

// Meshes by name: "genus3", a generated mesh of this genus, or the path of a file.

namespace smf_test {

// generated ones of genus 0 to 5 and, if there are any, the shared ones
inline std::vector<std::string> all_meshes()
{
  std::vector<std::string> result;
  for (int genus = 0; genus <= 5; ++genus)
    result.push_back("genus" + std::to_string(genus));
  const std::string shared = SMF_SHARED_DIR;
  if (!shared.empty())
    for (const std::string& file : all_shared_meshes(shared + "/meshes"))
      result.push_back(file);
  return result;
}

inline Mesh load(const std::string& name)
{
  if (name.rfind("genus", 0) == 0)
    return genus_surface(static_cast<std::size_t>(name[5] - '0'), 3);
  Mesh result;
  CGAL::Surface_mesh_foliation::read_triangle_mesh(name, result);
  return result;
}

inline std::string name_of_mesh(const ::testing::TestParamInfo<std::string>& info)
{
  std::string result = std::filesystem::path(info.param).stem().string();
  std::replace_if(
    result.begin(), result.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return result;
}

} // namespace smf_test

#endif // SMF_TEST_NAMED_MESHES_H
