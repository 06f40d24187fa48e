// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/refused_files.h"
#include "include/temporary_folder.h"
#include "include/tetrahedron_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <cstddef>
#include <string>
#include <vector>

namespace test_read_bad_files {

// Files with one defect each.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;
using smf_test::expect_refused;
using smf_test::replaced;
using smf_test::Sample;
using smf_test::sample_name;
using smf_test::tetrahedron_faces;
using smf_test::tetrahedron_obj;
using smf_test::tetrahedron_off;
using smf_test::tetrahedron_ply;
using smf_test::tetrahedron_vertices;

constexpr bool has_64_bits = sizeof(std::size_t) > 4;

class Bad_file : public ::testing::TestWithParam<Sample>
{};

TEST_P(Bad_file, is_refused)
{
  const smf_test::Temporary_folder folder;
  const Sample& sample = GetParam();
  expect_refused(folder.write(std::string("mesh") + sample.extension, sample.text), sample.kind,
                 sample.message_part);
}

std::string off(int number_of_vertices, int number_of_faces, const std::string& records)
{
  return "OFF\n" + std::to_string(number_of_vertices) + " " + std::to_string(number_of_faces) +
         " 0\n" + records;
}

std::vector<Sample> bad_off_headers()
{
  return {
    {"empty_file", ".off", "", Problem_kind::FILE, "empty"},
    {"blank_file", ".off", " \n\n", Problem_kind::FILE, "empty"},
    {"only_comments", ".off", "# OFF\n", Problem_kind::FILE, "empty"},
    {"no_header", ".off", replaced(tetrahedron_off, "OFF\n", ""), Problem_kind::FILE,
     ":1: not an OFF file"},
    {"wrong_magic", ".off", replaced(tetrahedron_off, "OFF", "PLY"), Problem_kind::FILE, "'PLY'"},
    {"lower_case_magic", ".off", replaced(tetrahedron_off, "OFF", "off"), Problem_kind::FILE,
     "'off'"},
    {"binary_garbage", ".off", std::string("\x00\xff\x7f\n\x01 3\n\xfe", 8), Problem_kind::FILE,
     "starts with '?"},
    {"ascii_named_binary", ".off", replaced(tetrahedron_off, "OFF\n", "OFF BINARY\n"),
     Problem_kind::FILE, "unexpected end of file: the header claims"},
    {"nothing_after_magic", ".off", "OFF\n", Problem_kind::FILE, "unexpected end of file"},
    {"no_face_count", ".off", replaced(tetrahedron_off, "4 4 0", "4"), Problem_kind::FILE,
     ":2: the number of faces is missing"},
    {"float_count", ".off", replaced(tetrahedron_off, "4 4 0", "4.0 4 0"), Problem_kind::FILE,
     "'4.0'"},
    {"four_counts", ".off", replaced(tetrahedron_off, "4 4 0", "4 4 0 0"), Problem_kind::FILE,
     "more than three"},
    {"claims_1e9_vertices", ".off", replaced(tetrahedron_off, "4 4 0", "1000000000 4 0"),
     Problem_kind::FILE, ":2: unexpected end of file: the header claims 1000000000 vertices"},
    {"claims_1e9_faces", ".off", replaced(tetrahedron_off, "4 4 0", "4 1000000000 0"),
     Problem_kind::FILE, "the header claims 1000000000 faces"},
    {"claims_2_64_vertices", ".off", replaced(tetrahedron_off, "4 4 0", "18446744073709551620 4 0"),
     Problem_kind::FILE, "out of range"},
    {"claims_2_63_faces", ".off", replaced(tetrahedron_off, "4 4 0", "4 9223372036854775809 0"),
     Problem_kind::FILE, has_64_bits ? "claims 9223372036854775809 faces" : "out of range"},
    {"claims_negative", ".off", replaced(tetrahedron_off, "4 4 0", "-4 4 0"), Problem_kind::FILE,
     "'-4'"},
    {"empty_mesh", ".off", "OFF\n0 0 0\n", Problem_kind::EMPTY_MESH, "no vertices"},
    {"no_faces", ".off", "OFF\n4 0 0\n" + tetrahedron_vertices, Problem_kind::EMPTY_MESH,
     "no faces"},
    {"only_faces", ".off", "OFF\n0 4 0\n" + tetrahedron_faces, Problem_kind::FILE,
     "there are no vertices"},
    {"extra_data_after_end", ".off", tetrahedron_off + "3 0 1 2\n", Problem_kind::FILE,
     ":11: extra data"},
  };
}

std::vector<Sample> bad_off_records()
{
  return {
    {"text_in_number", ".off", replaced(tetrahedron_off, "1 0 0", "abc 0 0"), Problem_kind::FILE,
     ":4: vertex 1: 'abc' is not a number"},
    {"text_behind_number", ".off", replaced(tetrahedron_off, "1 0 0", "1x 0 0"), Problem_kind::FILE,
     "'1x'"},
    {"decimal_comma", ".off", replaced(tetrahedron_off, "1 0 0", "1,5 0 0"), Problem_kind::FILE,
     "'1,5'"},
    {"long_text_in_number", ".off",
     replaced(tetrahedron_off, "1 0 0", std::string(1000, 'a') + " 0 0"), Problem_kind::FILE,
     "'aaaaaaaaaaaaaaaaaaaaaaaa...'"},
    {"nul_in_number", ".off", replaced(tetrahedron_off, "1 0 0", std::string("1\0 0 0", 6)),
     Problem_kind::FILE, "'1?'"},
    {"nan_coordinate", ".off", replaced(tetrahedron_off, "1 0 0", "nan 0 0"),
     Problem_kind::NOT_FINITE, ":4: vertex 1"},
    {"infinite_coordinate", ".off", replaced(tetrahedron_off, "1 0 0", "0 -inf 0"),
     Problem_kind::NOT_FINITE, "'-inf' is not finite"},
    {"overflow_coordinate", ".off", replaced(tetrahedron_off, "1 0 0", "1e999 0 0"),
     Problem_kind::NOT_FINITE, "'1e999' does not fit"},
    {"two_coordinates", ".off", replaced(tetrahedron_off, "1 0 0", "1 0"), Problem_kind::FILE,
     ":4: vertex 1: the line ends too early"},
    {"four_coordinates", ".off", replaced(tetrahedron_off, "1 0 0", "1 0 0 0"), Problem_kind::FILE,
     ":4: vertex 1 has more than 3 coordinates"},
    {"face_of_zero", ".off", replaced(tetrahedron_off, "3 0 1 3", "0"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 has 0 corners"},
    {"face_of_two", ".off", replaced(tetrahedron_off, "3 0 1 3", "2 0 1"),
     Problem_kind::NOT_TRIANGLE_MESH, ":8: face 1 has 2 corners"},
    {"quad", ".off", replaced(tetrahedron_off, "3 0 1 3", "4 0 1 3 2"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 has 4 corners"},
    {"claims_1e9_corners", ".off", replaced(tetrahedron_off, "3 0 1 3", "1000000000 0 1 3"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 has 1000000000 corners"},
    {"claims_2_64_corners", ".off",
     replaced(tetrahedron_off, "3 0 1 3", "18446744073709551619 0 1 3"), Problem_kind::FILE,
     "'18446744073709551619' is out of range"},
    {"negative_corners", ".off", replaced(tetrahedron_off, "3 0 1 3", "-3 0 1 3"),
     Problem_kind::NOT_TRIANGLE_MESH, "-3 corners"},
    {"text_for_corners", ".off", replaced(tetrahedron_off, "3 0 1 3", "three 0 1 3"),
     Problem_kind::FILE, "'three' is not an integer"},
    {"repeated_index", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 1 0 1"),
     Problem_kind::NOT_TRIANGLE_MESH, ":8: face 1 uses vertex 1 more than once"},
    {"index_out_of_range", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 4"),
     Problem_kind::FILE, ":8: face 1 uses vertex 4, but there are only the vertices 0 to 3"},
    {"index_negative", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 -2"), Problem_kind::FILE,
     "vertex -2"},
    {"index_2_32", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 4294967298"),
     Problem_kind::FILE, "vertex 4294967298"},
    {"index_2_64", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 18446744073709551619"),
     Problem_kind::FILE, "out of range"},
    {"float_index", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 2.5"), Problem_kind::FILE,
     ":8: face 1: '2.5' is not an integer"},
    {"exponent_index", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 2e0"),
     Problem_kind::FILE, "'2e0'"},
    {"short_face", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1"), Problem_kind::FILE,
     ":8: face 1: the line ends too early"},
    {"text_for_color", ".off", replaced(tetrahedron_off, "3 0 1 3", "3 0 1 3 red"),
     Problem_kind::FILE, "'red'"},
    {"two_faces_on_a_line", ".off", replaced(tetrahedron_off, "3 0 1 3\n3 1", "3 0 1 3 1 3 1"),
     Problem_kind::FILE, "face 1: more numbers"},
    {"truncated_in_vertices", ".off", tetrahedron_off.substr(0, 20), Problem_kind::FILE,
     "unexpected end of file"},
    {"truncated_in_faces", ".off", replaced(tetrahedron_off, "3 1 2 3\n3 0 3 2\n", ""),
     Problem_kind::FILE, "unexpected end of file: face 2 of 4 is missing"},
    {"truncated_last_face", ".off", tetrahedron_off.substr(0, tetrahedron_off.size() - 2),
     Problem_kind::FILE, "unexpected end of file in face 3"},
  };
}

std::vector<Sample> bad_surfaces()
{
  const std::string five_vertices = tetrahedron_vertices + "1 1 1\n";
  const std::string seven_vertices = tetrahedron_vertices + "5 0 0\n6 0 0\n5 1 0\n5 0 1\n";
  const std::string projective_plane = "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n3 0 5 1\n"
                                       "3 1 2 4\n3 2 3 5\n3 3 4 1\n3 4 5 2\n3 5 1 3\n";
  const std::string moebius_strip = "3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n";
  return {
    {"one_triangle", ".off", off(3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), Problem_kind::NOT_CLOSED,
     "1 opening bounded by 3 edges, of length 3.41421; one is at the edge between the vertices 0 "
     "and 1"},
    {"face_missing", ".off", off(4, 3, tetrahedron_vertices + "3 0 2 1\n3 0 1 3\n3 1 2 3\n"),
     Problem_kind::NOT_CLOSED, "not closed"},
    {"unwelded", ".off", off(6, 2, "0 0 0\n1 0 0\n0 1 0\n0 0 0\n0 1 0\n1 0 0\n3 0 1 2\n3 3 4 5\n"),
     Problem_kind::NOT_CLOSED, "merging vertices at equal positions may help"},
    {"edge_with_three_faces", ".off", off(5, 5, five_vertices + tetrahedron_faces + "3 0 1 4\n"),
     Problem_kind::NOT_MANIFOLD,
     "vertices 1 and 0 is not manifold: it has 3 faces, among them 0, 1 and 4"},
    {"vertex_with_two_umbrellas", ".off",
     off(7, 8,
         tetrahedron_vertices + "-1 0 0\n0 -1 0\n0 0 -1\n" + tetrahedron_faces +
           "3 0 4 5\n3 0 6 4\n3 4 6 5\n3 0 5 6\n"),
     Problem_kind::NOT_MANIFOLD, "vertex 0 is not manifold: its faces form 2 separate umbrellas"},
    {"duplicate_face", ".off", off(4, 5, tetrahedron_vertices + tetrahedron_faces + "3 2 1 0\n"),
     Problem_kind::NOT_MANIFOLD, "faces 0 and 4 have the same three vertices"},
    {"pillow", ".off", off(3, 2, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n"),
     Problem_kind::NOT_MANIFOLD, "faces 0 and 1 have the same three vertices 0, 1 and 2"},
    {"flipped_face", ".off", replaced(tetrahedron_off, "3 1 2 3", "3 2 1 3"),
     Problem_kind::NOT_ORIENTABLE, "face 2 is oriented against its neighbors"},
    {"projective_plane", ".off",
     off(6, 10, "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 4\n3 1 7\n" + projective_plane),
     Problem_kind::NOT_ORIENTABLE, "not orientable"},
    {"moebius_strip", ".off", off(5, 5, "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 2 4\n" + moebius_strip),
     Problem_kind::NOT_CLOSED, "1 opening bounded by 5 edges"},
    {"two_components", ".off",
     off(8, 8, seven_vertices + tetrahedron_faces + "3 4 6 5\n3 4 5 7\n3 5 6 7\n3 4 7 6\n"),
     Problem_kind::NOT_CONNECTED, "2 components; the vertices 0 and 4"},
    {"isolated_vertex", ".off", off(5, 4, five_vertices + tetrahedron_faces),
     Problem_kind::ISOLATED_VERTEX, "vertex 4"},
    {"isolated_first_vertex", ".off",
     off(5, 4, "9 9 9\n" + tetrahedron_vertices + "3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n"),
     Problem_kind::ISOLATED_VERTEX, "vertex 0"},
    {"collinear_face", ".off", replaced(tetrahedron_off, "0 1 0\n", "3 0 0\n"),
     Problem_kind::DEGENERATE_FACE, "face 0 is degenerate: its vertices 0, 2 and 1"},
    {"coincident_vertices", ".off", replaced(tetrahedron_off, "0 1 0\n", "1 0 0\n"),
     Problem_kind::DEGENERATE_FACE, "face 0"},
    {"tiny_collinear_face", ".off",
     off(4, 4, "0 0 0\n1e-200 0 0\n3e-200 0 0\n0 0 1e-200\n" + tetrahedron_faces),
     Problem_kind::DEGENERATE_FACE, "face 0"},
    {"huge_collinear_face", ".off",
     off(4, 4, "0 0 0\n1e300 1e300 0\n-1e300 -1e300 0\n0 0 1e300\n" + tetrahedron_faces),
     Problem_kind::DEGENERATE_FACE, "face 0"},
  };
}

std::vector<Sample> bad_other_formats()
{
  return {
    {"unknown_extension", ".xyz", tetrahedron_off, Problem_kind::FILE, "unknown file name"},
    {"no_extension", "", tetrahedron_off, Problem_kind::FILE, "unknown file name"},
    {"obj_empty", ".obj", "# nothing\n", Problem_kind::EMPTY_MESH, "no vertices"},
    {"obj_unknown_statement", ".obj", "hello\n" + tetrahedron_obj, Problem_kind::FILE,
     ":1: unknown OBJ statement 'hello'"},
    {"obj_text_in_number", ".obj", replaced(tetrahedron_obj, "v 1 0 0", "v 1 b 0"),
     Problem_kind::FILE, ":2: vertex 1: 'b'"},
    {"obj_nan", ".obj", replaced(tetrahedron_obj, "v 1 0 0", "v 1 nan 0"), Problem_kind::NOT_FINITE,
     "vertex 1"},
    {"obj_index_zero", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 0 2 4"), Problem_kind::FILE,
     ":6: face 1: the index '0' is out of range"},
    {"obj_index_too_large", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 5"),
     Problem_kind::FILE, "face 1 uses vertex 4, but there are only the vertices 0 to 3"},
    {"obj_index_too_negative", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 -5"),
     Problem_kind::FILE, "'-5' is out of range"},
    {"obj_index_2_32", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 4294967300"),
     Problem_kind::FILE, has_64_bits ? "vertex 4294967299" : "out of range"},
    {"obj_fourth_index_2_64", ".obj",
     replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 4 18446744073709551619"), Problem_kind::FILE,
     "out of range"},
    {"obj_float_index", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 4.5"),
     Problem_kind::FILE, "'4.5' is not an index"},
    {"obj_quad", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 4 3"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 has 4 corners"},
    {"obj_two_corners", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 has 2 corners"},
    {"obj_repeated_index", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 -4"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 uses vertex 0 more than once"},
    {"ply_wrong_magic", ".ply", tetrahedron_off, Problem_kind::FILE, "not a PLY file"},
    {"ply_wrong_format", ".ply", replaced(tetrahedron_ply, "ascii", "utf8"), Problem_kind::FILE,
     "'utf8'"},
    {"ply_wrong_type", ".ply", replaced(tetrahedron_ply, "float y", "real y"), Problem_kind::FILE,
     "'real' is not a PLY type"},
    {"ply_endless_header", ".ply", "ply\nformat ascii 1.0\nelement vertex 4\n", Problem_kind::FILE,
     "header does not end"},
    {"ply_wrong_statement", ".ply", replaced(tetrahedron_ply, "end_header", "end"),
     Problem_kind::FILE, "'end'"},
    {"ply_negative_count", ".ply", replaced(tetrahedron_ply, "vertex 4", "vertex -4"),
     Problem_kind::FILE, "'-4'"},
    {"ply_no_faces_element", ".ply", replaced(tetrahedron_ply, "element face", "element facet"),
     Problem_kind::FILE, "no PLY element 'face'"},
    {"ply_two_vertex_elements", ".ply",
     replaced(tetrahedron_ply, "element face", "element vertex 4\nproperty float x\nelement face"),
     Problem_kind::FILE, "two PLY elements 'vertex'"},
    {"ply_vertices_without_properties", ".ply",
     "ply\nformat ascii 1.0\nelement vertex 4\nelement face 4\n"
     "property list uchar int vertex_indices\nend_header\n" +
       tetrahedron_faces,
     Problem_kind::FILE, "'vertex' with properties"},
    {"ply_no_z", ".ply", replaced(tetrahedron_ply, "float z", "float w"), Problem_kind::FILE,
     "no x, y or z"},
    {"ply_no_index_list", ".ply", replaced(tetrahedron_ply, "vertex_indices", "corners"),
     Problem_kind::FILE, "no list vertex_indices"},
    {"ply_float_length", ".ply", replaced(tetrahedron_ply, "list uchar", "list float"),
     Problem_kind::FILE, "length of a list"},
    {"ply_negative_length", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "-3 0 1 3"),
     Problem_kind::FILE, "negative length"},
    {"ply_claims_1e9_vertices", ".ply", replaced(tetrahedron_ply, "vertex 4", "vertex 1000000000"),
     Problem_kind::FILE, "vertex 4: more values"},
    {"ply_claims_1e9_faces", ".ply", replaced(tetrahedron_ply, "face 4", "face 1000000000"),
     Problem_kind::FILE, "unexpected end of file: face 4"},
    {"ply_claims_1e9_corners", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "1000000000 0 1 3"),
     Problem_kind::NOT_TRIANGLE_MESH, "1000000000 corners"},
    {"ply_float_index", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "3 0 1 2.5"),
     Problem_kind::FILE, "face 1: '2.5'"},
    {"ply_index_out_of_range", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "3 0 1 4"),
     Problem_kind::FILE, "face 1 uses vertex 4"},
    {"ply_index_negative", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "3 0 1 -1"),
     Problem_kind::FILE, "face 1 uses vertex -1"},
    {"ply_index_2_32", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "3 0 1 4294967299"),
     Problem_kind::FILE, "face 1 uses vertex 4294967299"},
    {"ply_repeated_index", ".ply", replaced(tetrahedron_ply, "3 0 1 3", "3 0 1 0"),
     Problem_kind::NOT_TRIANGLE_MESH, "face 1 uses vertex 0"},
    {"ply_infinite_coordinate", ".ply", replaced(tetrahedron_ply, "1 0 0\n", "inf 0 0\n"),
     Problem_kind::NOT_FINITE, "vertex 1"},
    {"ply_overflow_coordinate", ".ply", replaced(tetrahedron_ply, "1 0 0\n", "1e999 0 0\n"),
     Problem_kind::FILE, "vertex 1: '1e999'"},
    {"ply_extra_data", ".ply", tetrahedron_ply + "7\n", Problem_kind::FILE, "extra data"},
  };
}

INSTANTIATE_TEST_SUITE_P(Headers, Bad_file, ::testing::ValuesIn(bad_off_headers()), sample_name);
INSTANTIATE_TEST_SUITE_P(Records, Bad_file, ::testing::ValuesIn(bad_off_records()), sample_name);
INSTANTIATE_TEST_SUITE_P(Surfaces, Bad_file, ::testing::ValuesIn(bad_surfaces()), sample_name);
INSTANTIATE_TEST_SUITE_P(Formats, Bad_file, ::testing::ValuesIn(bad_other_formats()), sample_name);

TEST(Read_bad_file, a_file_that_cannot_be_read_is_refused)
{
  const smf_test::Temporary_folder folder;
  expect_refused(folder.file_name("missing.off"), Problem_kind::FILE, "No such file");
  std::filesystem::create_directory(folder.file_name("folder.off"));
  expect_refused(folder.file_name("folder.off"), Problem_kind::FILE, "cannot be");
}

} // namespace

} // namespace test_read_bad_files
