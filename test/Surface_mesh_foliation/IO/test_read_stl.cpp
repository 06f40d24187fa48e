#include "include/refused_files.h"
#include "include/stl_files.h"
#include "include/temporary_folder.h"
#include "generators/meshes.h"
#include "include/tetrahedron_files.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <CGAL/IO/STL.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace test_read_stl {

// STL, which has no vertices, and whose two formats look alike.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;
using SMF::Triangle_soup;
using smf_test::ascii_stl;
using smf_test::binary_stl;
using smf_test::expect_refused;
using smf_test::replaced;
using smf_test::Stl_corners;
using smf_test::tetrahedron_stl_corners;

// the tetrahedron, its vertices in the order in which they come first
const Triangle_soup welded_tetrahedron = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                          {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 3, 1}}};

Triangle_soup soup_of(const std::string& text)
{
  const smf_test::Temporary_folder folder;
  return SMF::read_triangle_soup(folder.write("a.stl", text));
}

void expect_tetrahedron(const std::string& text)
{
  Triangle_soup soup;
  ASSERT_NO_THROW(soup = soup_of(text));
  EXPECT_EQ(soup.points, welded_tetrahedron.points);
  EXPECT_EQ(soup.triangles, welded_tetrahedron.triangles);
}

void expect_stl_refused(const std::string& text,
                        const std::string& message_part,
                        Problem_kind kind = Problem_kind::FILE)
{
  const smf_test::Temporary_folder folder;
  expect_refused(folder.write("a.stl", text), kind, message_part);
}

} // namespace

// ===  Good files

TEST(Read_stl, welds_ascii_and_binary_files_alike)
{
  expect_tetrahedron(ascii_stl(tetrahedron_stl_corners()));
  expect_tetrahedron(binary_stl(tetrahedron_stl_corners()));
}

TEST(Read_stl, a_binary_file_may_begin_with_anything)
{
  for (const std::string comment :
       {"", "solid", "solid base exported by CAD", "   ", "\xEF\xBB\xBFsolid", "COLOR=\x01\x02"})
    expect_tetrahedron(binary_stl(tetrahedron_stl_corners(), comment));
  const std::string text = ascii_stl(tetrahedron_stl_corners());
  expect_tetrahedron(binary_stl(tetrahedron_stl_corners(), text.substr(0, 80)));
}

TEST(Read_stl, an_ascii_file_may_be_written_in_many_ways)
{
  const std::string text = ascii_stl(tetrahedron_stl_corners());
  const std::vector<std::string> texts = {
    replaced(text, "solid t\n", "solid\n"),
    replaced(text, "solid t\n", "SOLID facet normal\n"),
    replaced(text, "solid t\n", "\xEF\xBB\xBFsolid \xC3\xA4\r\n"),
    replaced(text, "outer loop", "OUTER LOOP\r"),
    replaced(text, "facet normal 0 0 0", "facet normal nan -nan(ind) 1,5"),
    replaced(text, "facet normal 0 0 0", "facet"),
    replaced(text, "endfacet\n", "\n  endfacet\n\n"),
    replaced(text, "endsolid t\n", "endsolid"),
    replaced(text, "vertex 1 0 0", "vertex +1.0e0 -0 -0.0"),
    text + "\n\n" + std::string(5, '\0'),
  };
  for (const std::string& sample : texts)
    expect_tetrahedron(sample);
}

TEST(Read_stl, several_solids_are_one_mesh)
{
  const Stl_corners corners = tetrahedron_stl_corners();
  expect_tetrahedron(ascii_stl({corners.begin(), corners.begin() + 3}) + "\n" +
                     ascii_stl({corners.begin() + 3, corners.end()}));
}

TEST(Read_stl, positions_must_be_exactly_equal)
{
  Stl_corners corners = tetrahedron_stl_corners();
  corners[1][0] = {-0.f, 0.f, -0.f};
  EXPECT_EQ(soup_of(binary_stl(corners)).points.size(), 4u);
  EXPECT_EQ(soup_of(ascii_stl(corners)).points.size(), 4u);
  corners[1][0][1] = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(soup_of(binary_stl(corners)).points.size(), 5u);
  EXPECT_EQ(soup_of(ascii_stl(corners)).points.size(), 5u);
}

TEST(Read_stl, files_that_cgal_writes_are_read)
{
  const smf_test::Temporary_folder folder;
  const smf_test::Mesh mesh = smf_test::icosphere(2);
  for (const bool is_binary : {false, true})
  {
    const std::string file_name = folder.file_name(is_binary ? "binary.stl" : "ascii.stl");
    CGAL::IO::write_STL(file_name, mesh,
                        CGAL::parameters::use_binary_mode(is_binary).stream_precision(17));
    smf_test::Mesh back;
    ASSERT_NO_THROW(SMF::read_triangle_mesh(file_name, back));
    EXPECT_EQ(num_vertices(back), num_vertices(mesh));
    EXPECT_EQ(num_faces(back), num_faces(mesh));
    EXPECT_TRUE(CGAL::is_closed(back));
  }
}

TEST(Read_stl, a_mesh_without_faces_is_empty)
{
  expect_stl_refused("solid\nendsolid\n", "no vertices", Problem_kind::EMPTY_MESH);
  expect_stl_refused(binary_stl({}), "no vertices", Problem_kind::EMPTY_MESH);
}

// ===  Bad files

TEST(Read_stl, binary_files_of_the_wrong_size_are_refused)
{
  const std::string text = binary_stl(tetrahedron_stl_corners(), "solid t");
  for (const std::string& damaged : {text.substr(0, text.size() - 1), text + '\0', text + text})
    expect_stl_refused(damaged,
                       "a binary file of 4 faces, as the header claims, has 284 bytes, but "
                       "this one has " +
                         std::to_string(damaged.size()));
  expect_stl_refused(text.substr(0, 84), "has 284 bytes, but this one has 84");
  expect_stl_refused(text.substr(0, 83), "too short for a binary file");
  expect_stl_refused("hello", "too short for a binary file");
  std::string false_claim = text;
  false_claim.replace(80, 4, "\xff\xff\xff\xff");
  expect_stl_refused(false_claim, "has 214748364834 bytes, but this one has 284");
}

TEST(Read_stl, bad_faces_of_binary_files_are_named_with_their_byte)
{
  Stl_corners corners = tetrahedron_stl_corners();
  corners[2][1] = corners[2][0];
  expect_stl_refused(binary_stl(corners),
                     ": byte 228: face 2 is degenerate: two of its corners have the position of "
                     "vertex 2",
                     Problem_kind::DEGENERATE_FACE);
  corners = tetrahedron_stl_corners();
  corners[0][2][1] = std::numeric_limits<float>::quiet_NaN();
  expect_stl_refused(binary_stl(corners),
                     ": byte 124: vertex 2 has a coordinate that is not finite",
                     Problem_kind::NOT_FINITE);
}

TEST(Read_stl, bad_ascii_files_are_refused_with_the_line)
{
  const std::string text = ascii_stl(tetrahedron_stl_corners());
  const auto expect = [&](const std::string& old_part, const std::string& new_part,
                          const std::string& message_part) {
    expect_stl_refused(replaced(text, old_part, new_part), message_part);
  };
  expect("vertex 1 0 0", "vertex 1 b 0", ":6: vertex 2: 'b' is not a number");
  expect("vertex 1 0 0", "vertex 1 0", ":6: vertex 2: the line ends too early");
  expect("vertex 1 0 0", "vertex 1 0 0 0", ":6: more than expected on the line: '0'");
  expect("vertex 1 0 0", "vortex 1 0 0", ":6: 'vortex' instead of 'vertex' or 'endloop' in face 0");
  expect("outer loop", "inner loop", ":3: 'inner' instead of 'outer'");
  expect("outer loop", "outer", ":3: '' instead of 'loop'");
  expect("endfacet", "endface", ":8: 'endface' instead of 'endfacet'");
  expect("facet normal", "faucet normal", ":2: 'faucet' instead of 'facet' or 'endsolid'");
  expect("endsolid t\n", "", "unexpected end of file: 'endsolid' is missing");
  expect("endsolid t\n", "endsolid t\nfacet", ":31: 'facet' instead of 'solid'");
  expect_stl_refused(text.substr(0, text.find("endloop")), "unexpected end of file in face 0");
  expect_stl_refused(replaced(text, "vertex 1 0 0\n", ""), ":6: face 0 has 2 corners",
                     Problem_kind::NOT_TRIANGLE_MESH);
  expect_stl_refused(replaced(text, "endloop", "vertex 1 1 1\nendloop"),
                     ":7: face 0 has more than 3 corners", Problem_kind::NOT_TRIANGLE_MESH);
  expect_stl_refused(replaced(text, "vertex 1 0 0", "vertex 0 -0 0"),
                     ":7: face 0 is degenerate: two of its corners have the position of vertex 0",
                     Problem_kind::DEGENERATE_FACE);
  expect_stl_refused(replaced(text, "vertex 1 0 0", "vertex 1 inf 0"),
                     ":6: vertex 2: the coordinate 'inf' is not finite", Problem_kind::NOT_FINITE);
}

} // namespace test_read_stl
