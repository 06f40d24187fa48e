// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/binary_off_file.h"
#include "include/refused_files.h"
#include "include/stl_files.h"
#include "include/temporary_folder.h"
#include "generators/meshes.h"
#include "generators/Random.h"
#include "include/tetrahedron_files.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Face_collectors.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_obj.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_off.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_ply.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/read_stl.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <CGAL/IO/polygon_soup_io.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

// Files whose counts are false, that end too early, or that were damaged at random.

// ===  The memory taken is counted

namespace test_read_damaged_files {
std::size_t allocated_bytes = 0; // the tests have one thread
}

// Not inlined, or else GCC sees free() called for what operator new() returned, and warns.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  test_read_damaged_files::allocated_bytes += size;
  if (void* memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace test_read_damaged_files {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem;
using SMF::Problem_kind;
using SMF::Triangle_soup;
using smf_test::expect_refused;
using smf_test::Mesh;
using smf_test::replaced;
using smf_test::tetrahedron_obj;
using smf_test::tetrahedron_off;
using smf_test::tetrahedron_ply;

std::string strips_ply()
{
  return replaced(replaced(smf_test::ply_header, "element face 4", "element tristrips 1"),
                  "list uchar int", "list int int") +
         smf_test::tetrahedron_vertices + "6 0 2 1 3 0 2\n";
}

TEST(Read_damaged_file, false_claims_take_no_memory)
{
  const smf_test::Temporary_folder folder;
  const std::vector<std::string> file_names = {
    folder.write("a.off", replaced(tetrahedron_off, "4 4 0", "1000000000 4 0")),
    folder.write("b.off", replaced(tetrahedron_off, "4 4 0", "4 1000000000 0")),
    folder.write("c.off", replaced(tetrahedron_off, "3 0 1 3", "1000000000 0 1 3")),
    folder.write("d.ply", replaced(tetrahedron_ply, "vertex 4", "vertex 1000000000")),
    folder.write("e.ply", replaced(tetrahedron_ply, "face 4", "face 1000000000")),
    folder.write("f.ply", replaced(tetrahedron_ply, "3 0 1 3", "1000000000 0 1 3")),
    folder.write("g.ply", replaced(tetrahedron_ply, "element face",
                                   "element none 1000000000000\nelement face")),
    folder.write("h.ply", replaced(strips_ply(), "6 0 2", "1000000000 0 2")),
    folder.write("i.off",
                 std::string("OFF BINARY\n\0\0\0\1\x7f\0\0\0\0\0\0\0", 23) + std::string(12, '\0')),
    folder.write("j.off",
                 std::string("OFF BINARY\n\x7f\0\0\0\0\0\0\1\0\0\0\0", 23) + std::string(12, '\0')),
    folder.write("k.stl", std::string(83, ' ') + "\x7f" + std::string(50, '\0')),
  };
  for (const std::string& file_name : file_names)
  {
    const std::size_t before = allocated_bytes;
    try
    {
      SMF::read_triangle_soup(file_name);
    }
    catch (const SMF::Foliation_exception&)
    {}
    EXPECT_LT(allocated_bytes - before, std::size_t(1) << 20) << file_name;
  }
}

std::string binary_ply()
{
  const smf_test::Temporary_folder folder;
  const std::vector<smf_test::Kernel::Point_3> points = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::vector<std::size_t>> triangles = {
    {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  CGAL::IO::write_PLY(folder.file_name("a.ply"), points, triangles,
                      CGAL::parameters::use_binary_mode(true));
  return smf_test::file_text(folder.file_name("a.ply"));
}

TEST(Read_damaged_file, a_damaged_binary_file_is_refused)
{
  const smf_test::Temporary_folder folder;
  const std::string text = binary_ply();
  Mesh mesh;
  ASSERT_NO_THROW(SMF::read_triangle_mesh(folder.write("good.ply", text), mesh));
  expect_refused(folder.write("short.ply", text.substr(0, text.size() - 1)), Problem_kind::FILE,
                 "unexpected end of file in face 3");
  expect_refused(folder.write("long.ply", text + "\n"), Problem_kind::FILE, "extra data");
}

// ===  Damaged files

using SMF::internal::Polygon_collector;
using SMF::internal::Triangle_collector;

void check(const Triangle_soup& soup)
{
  for (const Problem& problem : SMF::check_triangle_soup(soup))
    EXPECT_NE(problem.kind, Problem_kind::FILE) << problem.message;
}

// Whatever it is, repaired it is a surface: nothing is left but that may be flat beyond repair, or
// that no face remains.
void check(const SMF::Polygon_soup& soup)
{
  const SMF::Repaired_soup repaired = SMF::repair_polygon_soup(soup);
  for (const Problem& problem : SMF::check_triangle_soup(
         repaired.soup, SMF::parameters::allow_openings(true).allow_parts(true)))
    EXPECT_TRUE(problem.kind == Problem_kind::EMPTY_MESH ||
                problem.kind == Problem_kind::DEGENERATE_FACE)
      << problem.message;
}

// what comes out is an exception of ours, or a soup with valid indices, which can be repaired
template <class Reader>
void read_damaged_files(const std::string& text, std::uint64_t seed, const Reader& reader)
{
  smf_test::Random random(seed);
  for (int i = 0; i < 3000; ++i)
  {
    std::string damaged = text;
    for (std::size_t j = random.index(4); j > 0; --j)
      damaged[random.index(damaged.size())] = static_cast<char>(random.index(256));
    if (random.index(3) == 0)
      damaged.resize(random.index(damaged.size()));
    try
    {
      check(reader("file", damaged));
    }
    catch (const SMF::Foliation_exception& exception)
    {
      EXPECT_EQ(std::string(exception.what()).find('\n'), std::string::npos);
    }
  }
}

TEST(Damaged_file, off_is_survived)
{
  read_damaged_files(tetrahedron_off, 1, SMF::internal::read_off<Triangle_collector>);
  read_damaged_files(tetrahedron_off, 1, SMF::internal::read_off<Polygon_collector>);
}
TEST(Damaged_file, obj_is_survived)
{
  read_damaged_files(tetrahedron_obj, 2, SMF::internal::read_obj<Triangle_collector>);
  read_damaged_files(tetrahedron_obj, 2, SMF::internal::read_obj<Polygon_collector>);
}
TEST(Damaged_file, ply_is_survived)
{
  read_damaged_files(tetrahedron_ply, 3, SMF::internal::read_ply<Triangle_collector>);
  read_damaged_files(tetrahedron_ply, 3, SMF::internal::read_ply<Polygon_collector>);
}
TEST(Damaged_file, binary_ply_is_survived)
{
  read_damaged_files(binary_ply(), 4, SMF::internal::read_ply<Triangle_collector>);
  read_damaged_files(binary_ply(), 4, SMF::internal::read_ply<Polygon_collector>);
}
TEST(Damaged_file, strips_are_survived)
{
  read_damaged_files(strips_ply(), 5, SMF::internal::read_ply<Triangle_collector>);
  read_damaged_files(strips_ply(), 5, SMF::internal::read_ply<Polygon_collector>);
}
TEST(Damaged_file, binary_off_is_survived)
{
  read_damaged_files(smf_test::binary_off("STCNOFF BINARY\n", 9), 6,
                     SMF::internal::read_off<Triangle_collector>);
  read_damaged_files(smf_test::binary_off("STCNOFF BINARY\n", 9), 6,
                     SMF::internal::read_off<Polygon_collector>);
}
TEST(Damaged_file, ascii_stl_is_survived)
{
  read_damaged_files(smf_test::ascii_stl(smf_test::tetrahedron_stl_corners()), 7,
                     SMF::internal::read_stl<Triangle_collector>);
  read_damaged_files(smf_test::ascii_stl(smf_test::tetrahedron_stl_corners()), 7,
                     SMF::internal::read_stl<Polygon_collector>);
}
TEST(Damaged_file, binary_stl_is_survived)
{
  read_damaged_files(smf_test::binary_stl(smf_test::tetrahedron_stl_corners(), "solid"), 8,
                     SMF::internal::read_stl<Triangle_collector>);
  read_damaged_files(smf_test::binary_stl(smf_test::tetrahedron_stl_corners(), "solid"), 8,
                     SMF::internal::read_stl<Polygon_collector>);
}

} // namespace

} // namespace test_read_damaged_files
