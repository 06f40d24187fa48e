// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_TETRAHEDRON_FILES_H
#define SMF_TEST_TETRAHEDRON_FILES_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <ostream>
#include <string>

// The texts of mesh files of a tetrahedron, to be changed a little.

namespace smf_test {

inline const std::string tetrahedron_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
inline const std::string tetrahedron_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
inline const std::string tetrahedron_off =
  "OFF\n4 4 0\n" + tetrahedron_vertices + tetrahedron_faces;
inline const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                           "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
inline const std::string ply_header =
  "ply\nformat ascii 1.0\nelement vertex 4\n"
  "property float x\nproperty float y\nproperty float z\n"
  "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
inline const std::string tetrahedron_ply = ply_header + tetrahedron_vertices + tetrahedron_faces;

// one change of a text that must be there
inline std::string replaced(std::string text,
                            const std::string& old_part,
                            const std::string& new_part)
{
  const std::size_t position = text.find(old_part);
  EXPECT_NE(position, std::string::npos) << "nothing to replace: " << old_part;
  return text.replace(position, old_part.size(), new_part);
}

// a file with one peculiarity
struct Sample
{
  const char* name;
  const char* extension;
  std::string text;
  CGAL::Surface_mesh_foliation::Problem_kind kind =
    CGAL::Surface_mesh_foliation::Problem_kind::FILE; // of bad files only
  std::string message_part = {};
};

inline void PrintTo(const Sample& sample, std::ostream* output)
{
  *output << sample.name;
}

inline std::string sample_name(const ::testing::TestParamInfo<Sample>& info)
{
  return info.param.name;
}

} // namespace smf_test

#endif // SMF_TEST_TETRAHEDRON_FILES_H
