// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/refused_files.h"
#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace test_read_shared_files {

// The shared files: bad ones are refused for their defects, all others read.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;
using smf_test::expect_refused;
using smf_test::Mesh;

const std::map<std::string, Problem_kind> shared_bad_files = {
  {"binary_garbage", Problem_kind::FILE},
  {"claims_1e9_corners", Problem_kind::NOT_TRIANGLE_MESH},
  {"claims_1e9_faces", Problem_kind::FILE},
  {"claims_1e9_vertices", Problem_kind::FILE},
  {"claims_2_64_vertices", Problem_kind::FILE},
  {"claims_negative", Problem_kind::FILE},
  {"duplicate_face", Problem_kind::NOT_MANIFOLD},
  {"duplicate_positions_soup", Problem_kind::NOT_CLOSED},
  {"duplicate_positions_touching", Problem_kind::NOT_CONNECTED},
  {"empty_file", Problem_kind::FILE},
  {"empty_mesh", Problem_kind::EMPTY_MESH},
  {"extra_data_after_end", Problem_kind::FILE},
  {"face_of_two", Problem_kind::NOT_TRIANGLE_MESH},
  {"flipped_face", Problem_kind::NOT_ORIENTABLE},
  {"float_index", Problem_kind::FILE},
  {"index_huge", Problem_kind::FILE},
  {"index_negative", Problem_kind::FILE},
  {"index_one_based", Problem_kind::FILE},
  {"index_out_of_range", Problem_kind::FILE},
  {"infinite_coordinate", Problem_kind::NOT_FINITE},
  {"isolated_vertex", Problem_kind::ISOLATED_VERTEX},
  {"isolated_vertex_first", Problem_kind::ISOLATED_VERTEX},
  {"klein_bottle", Problem_kind::NOT_ORIENTABLE},
  {"mixed_polygons", Problem_kind::NOT_TRIANGLE_MESH},
  {"moebius_strip", Problem_kind::NOT_CLOSED},
  {"nan_coordinate", Problem_kind::NOT_FINITE},
  {"no_faces", Problem_kind::EMPTY_MESH},
  {"no_header", Problem_kind::FILE},
  {"nonmanifold_edge_fin", Problem_kind::NOT_MANIFOLD},
  {"nonmanifold_edge_inner_wall", Problem_kind::NOT_MANIFOLD},
  {"nonmanifold_edge_two_cubes", Problem_kind::NOT_MANIFOLD},
  {"nonmanifold_vertex_horn_torus", Problem_kind::NOT_MANIFOLD},
  {"nonmanifold_vertex_two_tetrahedra", Problem_kind::NOT_MANIFOLD},
  {"open_disk", Problem_kind::NOT_CLOSED},
  {"open_one_face_missing", Problem_kind::NOT_CLOSED},
  {"open_torus_two_holes", Problem_kind::NOT_CLOSED},
  {"overflow_coordinate", Problem_kind::NOT_FINITE},
  {"pillow_two_faces", Problem_kind::NOT_MANIFOLD},
  {"projective_plane_6", Problem_kind::NOT_ORIENTABLE},
  {"quad_cube", Problem_kind::NOT_TRIANGLE_MESH},
  {"repeated_index_in_face", Problem_kind::NOT_TRIANGLE_MESH},
  {"text_in_number", Problem_kind::FILE},
  {"truncated_in_faces", Problem_kind::FILE},
  {"truncated_in_vertices", Problem_kind::FILE},
  {"truncated_last_face", Problem_kind::FILE},
  {"two_components", Problem_kind::NOT_CONNECTED},
  {"two_components_nested", Problem_kind::NOT_CONNECTED},
  {"two_components_torus_pair", Problem_kind::NOT_CONNECTED},
  {"wrong_magic", Problem_kind::FILE},
  {"zero_area_coincident", Problem_kind::DEGENERATE_FACE},
  {"zero_area_collinear", Problem_kind::DEGENERATE_FACE},
};

// besides those whose names begin with "ok_"
const std::vector<std::string> shared_awkward_files = {"duplicate_positions_horn_torus",
                                                       "far_from_origin_1e8",
                                                       "huge_coordinates_1e200",
                                                       "inside_out",
                                                       "sliver_1e-9",
                                                       "tiny_coordinates_1e-200"};

void expect_accepted(const std::string& file_name)
{
  Mesh mesh;
  EXPECT_NO_THROW(SMF::read_triangle_mesh(file_name, mesh)) << file_name;
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh)) << file_name;
  EXPECT_GT(num_vertices(mesh), 0u) << file_name;
}

TEST(Shared_files, bad_meshes_are_refused_for_their_defect)
{
  const std::string folder = SMF_SHARED_DIR;
  if (folder.empty())
    GTEST_SKIP() << "SMF_SHARED_DIR is not set";
  for (const auto& [name, kind] : shared_bad_files)
    expect_refused(folder + "/bad_meshes/" + name + ".off", kind, "");
}

TEST(Shared_files, all_others_are_accepted)
{
  const std::string folder = SMF_SHARED_DIR;
  if (folder.empty())
    GTEST_SKIP() << "SMF_SHARED_DIR is not set";
  for (const std::string& name : shared_awkward_files)
    EXPECT_TRUE(std::filesystem::exists(folder + "/bad_meshes/" + name + ".off")) << name;
  for (const std::string& file_name : smf_test::all_shared_meshes(folder + "/bad_meshes"))
    if (shared_bad_files.count(std::filesystem::path(file_name).stem().string()) == 0)
      expect_accepted(file_name);
  for (const std::string& file_name : smf_test::all_shared_meshes(folder + "/meshes"))
    expect_accepted(file_name);
}

// the same mesh, in files as people have them
const std::vector<std::string> shared_odd_files = {"01_binary_space_header.stl",
                                                   "02_ascii.stl",
                                                   "02_binary_solid_header.stl",
                                                   "03_continuation.obj",
                                                   "03b_nul_line.obj",
                                                   "03c_free_form_keywords.obj",
                                                   "03d_capital_and_texture.obj",
                                                   "03g_bom_crlf.obj",
                                                   "04_tristrips.ply",
                                                   "17_be_double_ushort_extra.ply",
                                                   "20_off_vertex_colours.off",
                                                   "20d_tokens_flow.off",
                                                   "20e_counts_glued.off"};

TEST(Shared_files, odd_ones_are_read_as_they_are)
{
  const std::string folder = SMF_SHARED_DIR;
  if (folder.empty() || !std::filesystem::exists(folder + "/cases"))
    GTEST_SKIP() << "SMF_SHARED_DIR is not set, or has no folder cases";
  for (const std::string& name : shared_odd_files)
  {
    Mesh mesh;
    EXPECT_NO_THROW(SMF::read_triangle_mesh(folder + "/cases/" + name, mesh)) << name;
    EXPECT_EQ(num_vertices(mesh), 620u) << name;
    EXPECT_EQ(num_faces(mesh), 1236u) << name;
  }
}

} // namespace

} // namespace test_read_shared_files
