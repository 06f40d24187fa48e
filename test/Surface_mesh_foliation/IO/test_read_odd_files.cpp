#include "include/refused_files.h"
#include "include/binary_off_file.h"
#include "include/temporary_folder.h"
#include "include/tetrahedron_files.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Generic_writer.h>
#include <CGAL/IO/OFF/File_writer_OFF.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

namespace test_read_odd_files {

// OFF, OBJ and PLY files as programs write them, with all that is unusual: they are read without a
// loss, or refused if there is a doubt.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;
using SMF::Triangle_soup;
using smf_test::big_endian_bytes;
using smf_test::binary_off;
using smf_test::expect_refused;
using smf_test::ply_header;
using smf_test::replaced;
using smf_test::Sample;
using smf_test::sample_name;
using smf_test::tetrahedron_faces;
using smf_test::tetrahedron_obj;
using smf_test::tetrahedron_off;
using smf_test::tetrahedron_ply;
using smf_test::tetrahedron_vertices;

const Triangle_soup tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

class Odd_file : public ::testing::TestWithParam<Sample>
{};

TEST_P(Odd_file, is_read_without_loss)
{
  const smf_test::Temporary_folder folder;
  const Sample& sample = GetParam();
  Triangle_soup soup;
  ASSERT_NO_THROW(
    soup = SMF::read_triangle_soup(folder.write(std::string("a") + sample.extension, sample.text)));
  EXPECT_EQ(soup.points, tetrahedron.points);
  EXPECT_EQ(soup.triangles, tetrahedron.triangles);
}

class Doubtful_file : public ::testing::TestWithParam<Sample>
{};

TEST_P(Doubtful_file, is_refused)
{
  const smf_test::Temporary_folder folder;
  const Sample& sample = GetParam();
  expect_refused(folder.write(std::string("a") + sample.extension, sample.text), sample.kind,
                 sample.message_part);
}

// with another text behind each line that begins with `beginning`
std::string with_line_ends(const std::string& text,
                           const std::string& beginning,
                           const std::string& end)
{
  std::string result;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t line_end = text.find('\n', begin);
    const std::string line = text.substr(begin, line_end - begin);
    result += line + (line.rfind(beginning, 0) == 0 ? end : "") + "\n";
    begin = line_end + 1;
  }
  return result;
}

std::string with_characters_replaced(std::string text, char old_character, char new_character)
{
  std::replace(text.begin(), text.end(), old_character, new_character);
  return text;
}

const std::string bom = "\xEF\xBB\xBF";
const std::string nul(1, '\0');

// ===  All text formats

std::vector<Sample> odd_texts()
{
  std::vector<Sample> samples;
  samples.push_back({"off_with_byte_order_mark", ".off", bom + tetrahedron_off});
  samples.push_back({"obj_with_byte_order_mark", ".obj", bom + tetrahedron_obj});
  samples.push_back({"ply_with_byte_order_mark", ".ply", bom + tetrahedron_ply});
  samples.push_back({"obj_byte_order_mark_and_carriage_returns", ".obj",
                     bom + "# c\r\n" + with_line_ends(tetrahedron_obj, "", "\r")});
  samples.push_back(
    {"off_with_nul_lines", ".off",
     replaced(tetrahedron_off, "1 0 0\n", "1 0 0\n" + nul + nul + "\n") + nul + nul});
  samples.push_back(
    {"obj_with_nul_lines", ".obj", nul + "\n" + tetrahedron_obj + nul + nul + "\n"});
  samples.push_back(
    {"obj_with_nul_at_line_ends", ".obj", with_line_ends(tetrahedron_obj, "", nul + "\r") + nul});
  return samples;
}

// ===  OBJ

std::vector<Sample> odd_obj_files()
{
  const std::string free_form =
    "mg 1 0.5\ncstype rat bspline\ndeg 3 3\nbmat u 1 0 0\nstep 1 1\n"
    "curv2 1 2\ncurv 0 1 1 2\nsurf 0 1 0 1 1/1/1 2 3\nparm u 0 0 1\ntrim 0 1 1\nhole 0 1 1\n"
    "scrv 0 1 1\nsp 1\nend\ncon 1 0 1 1 2 0 1 1\nvp 0 0 1\nbsp 1 2\nbzp 1 2\ncdc 1 2\n"
    "cdp 1 2\nres 1 2\np 1 2\nl 1/1 2/2\ng\ns off\no\nbevel on\nc_interp off\nd_interp off\n"
    "lod 1\nmaplib a b\nusemap off\nmtllib a b.mtl\nusemtl m\nshadow_obj a.obj\n"
    "trace_obj a.obj\nctech cparm 1\nstech cparma 1 1\nvt 0.5\nvn 0 0 1\n";
  return {
    {"obj_free_form_statements", ".obj", free_form + tetrahedron_obj + free_form},
    {"obj_continued_face", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 \\\n  2 \\\r\n\t4")},
    {"obj_continued_by_blank_line", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 4 \\\n")},
    {"obj_continued_keyword", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f\\\n 1 2 4")},
    {"obj_continued_vertex", ".obj",
     replaced(tetrahedron_obj, "v 1 0 0", "\\\nv 1 0 \\\n\\\n0 # and a comment")},
    {"obj_continued_ignored_statement", ".obj", "vp 0 \\\n1 \\\n2\n" + tetrahedron_obj},
    {"obj_continued_at_the_end", ".obj", tetrahedron_obj + "g a \\"},
    {"obj_comment_is_not_continued", ".obj", "# C:\\folder\\\n" + tetrahedron_obj},
    {"obj_comment_after_statement_is_not_continued", ".obj", "g a # \\\n" + tetrahedron_obj},
    {"obj_backslash_within_a_line", ".obj", "mtllib C:\\folder\\a.mtl\n" + tetrahedron_obj},
  };
}

std::vector<Sample> doubtful_obj_files()
{
  return {
    {"obj_split_word", ".obj", replaced(tetrahedron_obj, "f 1 2 4", "f 1 2\\\n4"),
     Problem_kind::FILE, ":6: the line is continued in the middle of a word"},
    {"obj_split_ignored_word", ".obj", "g C:\\\n" + tetrahedron_obj, Problem_kind::FILE,
     ":1: the line is continued in the middle of a word"},
    {"obj_call", ".obj", "call a.obj\n" + tetrahedron_obj, Problem_kind::FILE,
     ":1: unknown OBJ statement 'call'"},
    {"obj_csh", ".obj", "csh ls\n" + tetrahedron_obj, Problem_kind::FILE,
     ":1: unknown OBJ statement 'csh'"},
    {"obj_wrong_word_before_continuation", ".obj",
     replaced(tetrahedron_obj, "f 1 2 4", "f 1 2x \\\n4"), Problem_kind::FILE,
     ":6: face 1: '2x' is not an index"},
    {"obj_wrong_word_after_continuation", ".obj",
     replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 \\\n4x"), Problem_kind::FILE,
     ":7: face 1: '4x' is not an index"},
    {"obj_nul_in_number", ".obj", replaced(tetrahedron_obj, "v 1 0 0", "v 1" + nul + "0 0 0"),
     Problem_kind::FILE, "'1?0' is not a number"},
    {"obj_statement_after_continuation", ".obj",
     replaced(tetrahedron_obj, "f 1 2 4", "f 1 2 \\\nf 1 2 4"), Problem_kind::FILE,
     ":7: face 1: 'f' is not an index"},
  };
}

// ===  OFF

std::vector<Sample> odd_off_files()
{
  std::vector<Sample> samples = {
    {"off_glued_counts", ".off", replaced(tetrahedron_off, "OFF\n", "OFF")},
    {"off_glued_count", ".off", replaced(tetrahedron_off, "OFF\n4 4 0", "OFF4\t4")},
    {"off_one_number_per_line", ".off",
     "OFF\n4 4 0\n" +
       with_characters_replaced(tetrahedron_vertices + tetrahedron_faces, ' ', '\n')},
    {"off_all_on_a_line", ".off",
     "OFF 4 4\n" + with_characters_replaced(tetrahedron_vertices + tetrahedron_faces, '\n', ' ')},
    {"off_two_records_per_line", ".off",
     "OFF\n4 4 0\n0 0 0 1 0 0 # c\n0 1 0 0 0 1\n\n3 0 2 1 3 0 1 3\n3 1 2 3 3 0 3 2\n# c"},
    {"off_records_across_lines", ".off", replaced(tetrahedron_off, "3 0 1 3", "3\n0 1\n3")},
  };
  for (const char* attributes :
       {" 0.5 0.5", " 255 0 0", " 1 0 0 0.5", " 0 0 1  255 0 0 255", " 0 0 1  1 1 1 1  0 0"})
    for (const char* prefix : {"", "C", "STCN"})
    {
      const std::string vertices = with_line_ends(tetrahedron_vertices, "", attributes);
      samples.push_back(
        {"", ".off", prefix + replaced(tetrahedron_off, tetrahedron_vertices, vertices)});
    }
  return samples;
}

std::string numbered_name(const ::testing::TestParamInfo<Sample>& info)
{
  return *info.param.name == '\0' ? "attributes_" + std::to_string(info.index) : info.param.name;
}

std::vector<Sample> doubtful_off_files()
{
  const std::string two_on_a_line = replaced(tetrahedron_off, "0 0 0\n1 0 0", "0 0 0 1 0 0");
  return {
    {"off_glued_to_something_else", ".off", replaced(tetrahedron_off, "OFF\n", "OFF-"),
     Problem_kind::FILE, ":1: not an OFF file: it starts with 'OFF-4'"},
    {"off_homogeneous", ".off", "4" + with_line_ends(tetrahedron_off, "", " 1"), Problem_kind::FILE,
     "starts with '4OFF'"},
    {"off_fourth_coordinate", ".off",
     replaced(tetrahedron_off, tetrahedron_vertices,
              with_line_ends(tetrahedron_vertices, "", " 1")),
     Problem_kind::FILE, ":3: vertex 0 has more than 3 coordinates"},
    {"off_as_many_lines_as_records", ".off", replaced(two_on_a_line, "3 0 1 3", "3 0\n1 3"),
     Problem_kind::FILE, ":6: vertex 3 has more than 3 coordinates"},
    {"off_a_color_and_no_records", ".off", two_on_a_line + "7", Problem_kind::FILE,
     ":6: vertex 3 has more than 3 coordinates"},
    {"off_colors_on_one_line", ".off",
     "OFF\n4 4 0\n0 0 0 1 1 1 1 0 0 1 1 1 0 1 0 1 1 1 0 0 1 1 1 1\n" + tetrahedron_faces,
     Problem_kind::FILE, ":3: vertex 0 has more than 3 coordinates, a normal, a color and "},
    {"off_announced_colors_and_no_records", ".off", "C" + two_on_a_line, Problem_kind::FILE,
     "face"},
    {"off_quads_without_records", ".off",
     "OFF\n4 4 0\n" +
       with_characters_replaced(
         tetrahedron_vertices + replaced(tetrahedron_faces, "3 0 1 3", "4 0 1 3 2"), ' ', '\n'),
     Problem_kind::FILE, ":3: vertex 0: the line ends too early"},
    {"off_text_without_records", ".off", replaced(two_on_a_line, "3 0 1 3", "3 0 1 x"),
     Problem_kind::FILE, ":7: face 1: 'x' is not an integer"},
    {"off_range_without_records", ".off", replaced(two_on_a_line, "3 0 1 3", "3 0 1 4"),
     Problem_kind::FILE, ":7: face 1 uses vertex 4"},
    {"off_corners_without_records", ".off", replaced(two_on_a_line, "3 0 1 3", "4 0 1 3"),
     Problem_kind::NOT_TRIANGLE_MESH, ":7: face 1 has 4 corners"},
  };
}

std::vector<Sample> binary_off_files()
{
  return {
    {"binary_off", ".off", binary_off("OFF BINARY\n", 0)},
    {"binary_off_after_comments", ".off", binary_off("# a\n\nOFF BINARY # b\r\n", 0)},
    {"binary_off_with_line_end", ".off", binary_off("OFF BINARY\n", 0) + "\n"},
    {"binary_off_with_normals", ".off", binary_off("NOFF BINARY\n", 3)},
    {"binary_off_with_colors_of_geomview", ".off", binary_off("COFF BINARY\n", 4)},
    {"binary_off_with_colors_of_cgal", ".off", binary_off("COFF BINARY\n", 3)},
    {"binary_off_with_everything", ".off", binary_off("STCNOFF BINARY\n", 9)},
    {"binary_off_with_everything_of_cgal", ".off", binary_off("STCNOFF BINARY\n", 8)},
  };
}

// with another integer at a place
std::string with_integer(std::string text, std::size_t position, std::int32_t integer)
{
  return text.replace(position, sizeof(integer), big_endian_bytes(integer));
}

std::vector<Sample> bad_binary_off_files()
{
  const std::string text = binary_off("OFF BINARY\n", 0);
  const std::size_t begin = std::string("OFF BINARY\n").size();
  const std::size_t faces = begin + 12 + 48;
  const float infinity = std::numeric_limits<float>::infinity();
  std::string infinite = text;
  infinite.replace(begin + 12 + 16, 4, big_endian_bytes(infinity));
  return {
    {"binary_off_short", ".off", text.substr(0, text.size() - 1), Problem_kind::FILE,
     "unexpected end of file in face 3"},
    {"binary_off_short_vertices", ".off", text.substr(0, faces - 1), Problem_kind::FILE,
     "the header claims 4 vertices, but only 47 bytes follow"},
    {"binary_off_short_header", ".off", text.substr(0, begin + 7), Problem_kind::FILE,
     "unexpected end of file in header"},
    {"binary_off_long", ".off", text + "\n\1", Problem_kind::FILE,
     "extra data after the last face: the header claims only 4 faces"},
    {"binary_off_claims_vertices", ".off", with_integer(text, begin, 1000000000),
     Problem_kind::FILE, "the header claims 1000000000 vertices"},
    {"binary_off_claims_faces", ".off", with_integer(text, begin + 4, 1000000000),
     Problem_kind::FILE, "unexpected end of file in face 4"},
    {"binary_off_negative_count", ".off", with_integer(text, begin + 4, -1), Problem_kind::FILE,
     ": byte 15: the number of faces, -1, is negative"},
    {"binary_off_infinite_coordinate", ".off", infinite, Problem_kind::NOT_FINITE,
     ": byte 39: vertex 1 has a coordinate that is not finite"},
    {"binary_off_quad", ".off", with_integer(text, faces, 4), Problem_kind::NOT_TRIANGLE_MESH,
     ": byte 71: face 0 has 4 corners"},
    {"binary_off_claims_corners", ".off", with_integer(text, faces, 1000000000),
     Problem_kind::NOT_TRIANGLE_MESH, "face 0 has 1000000000 corners"},
    {"binary_off_index", ".off", with_integer(text, faces + 8, 4), Problem_kind::FILE,
     ": byte 79: face 0 uses vertex 4"},
    {"binary_off_negative_index", ".off", with_integer(text, faces + 8, -1), Problem_kind::FILE,
     "face 0 uses vertex -1"},
    {"binary_off_repeated_index", ".off", with_integer(text, faces + 8, 0),
     Problem_kind::NOT_TRIANGLE_MESH, "face 0 uses vertex 0 more than once"},
    {"binary_off_color", ".off", with_integer(text, faces + 16, 5), Problem_kind::FILE,
     "face 0: a color of 5 numbers"},
  };
}

TEST(Binary_off, that_cgal_writes_is_read)
{
  std::vector<CGAL::Epick::Point_3> points;
  for (const auto& [x, y, z] : tetrahedron.points)
    points.emplace_back(x, y, z);
  std::ostringstream file;
  const CGAL::File_header_OFF binary(true, false, false);
  CGAL::Generic_writer<std::ostream, CGAL::File_writer_OFF> writer(file, binary);
  ASSERT_TRUE(writer(points, tetrahedron.triangles, CGAL::parameters::stream_precision(17)));
  ASSERT_EQ(file.str().rfind("OFF BINARY\n", 0), 0u);

  const smf_test::Temporary_folder folder;
  const Triangle_soup soup = SMF::read_triangle_soup(folder.write("a.off", file.str()));
  EXPECT_EQ(soup.points, tetrahedron.points);
  EXPECT_EQ(soup.triangles, tetrahedron.triangles);
}

// ===  PLY

std::string strips(const std::string& lists, int number_of_lists = 1)
{
  return replaced(replaced(ply_header, "element face 4",
                           "element tristrips " + std::to_string(number_of_lists)),
                  "list uchar int", "list int int") +
         tetrahedron_vertices + lists;
}

Triangle_soup soup_of_strips(const std::string& lists, int number_of_lists = 1)
{
  const smf_test::Temporary_folder folder;
  return SMF::read_triangle_soup(folder.write("a.ply", strips(lists, number_of_lists)));
}

// the tetrahedron with coordinates of four bytes
std::string binary_ply()
{
  std::string result = replaced(ply_header, "ascii", "binary_big_endian");
  for (const auto& point : tetrahedron.points)
    for (const double coordinate : point)
      result += big_endian_bytes(static_cast<float>(coordinate));
  for (const auto& triangle : tetrahedron.triangles)
  {
    result += '\3';
    for (const std::size_t v : triangle)
      result += big_endian_bytes(static_cast<std::int32_t>(v));
  }
  return result;
}

std::vector<Sample> odd_ply_files()
{
  return {
    {"ply_binary_with_floats", ".ply", binary_ply()},
    {"ply_strips", ".ply", strips("16 0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2 -1\n")},
    {"ply_strips_without_last_end", ".ply", strips("15 0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2\n")},
    {"ply_strips_in_several_lists", ".ply",
     strips("7 0 2 1 -1 0 1 3\n8 -1 1 2 3 -1 -1 -1 -1\n"
            "3 0 3 2\n",
            3)},
    {"ply_faces_and_strips", ".ply",
     replaced(tetrahedron_ply, "end_header\n",
              "element tristrips 1\nproperty list int int vertex_indices\nend_header\n") +
       "3 0 1 2\n"},
    {"ply_no_face_but_strips", ".ply",
     replaced(strips("15 0 2 1 -1 0 1 3 -1 1 2 3 -1 0 3 2\n"), "element tristrips",
              "element face 0\nproperty list uchar int vertex_indices\nelement tristrips")},
  };
}

std::vector<Sample> bad_ply_files()
{
  return {
    {"ply_binary_too_long", ".ply", binary_ply() + "\1", Problem_kind::FILE,
     "extra data after the last element"},
    {"ply_vertex_without_last_property", ".ply",
     replaced(tetrahedron_ply, "property float z\n", "property float z\nproperty float quality\n"),
     Problem_kind::FILE, "vertex 0: the line ends too early"},
    {"ply_strip_of_two", ".ply", strips("6 0 2 1 -1 0 1\n"), Problem_kind::FILE,
     ":14: item of tristrips 0: a strip of less than 3 vertices"},
    {"ply_strip_of_one", ".ply", strips("6 0 -1 0 2 1 3\n"), Problem_kind::FILE,
     "a strip of less than 3 vertices"},
    {"ply_strip_index", ".ply", strips("7 0 2 1 -1 0 1 4\n"), Problem_kind::FILE,
     ":14: face 1 uses vertex 4, but there are only the vertices 0 to 3"},
    {"ply_strip_negative_index", ".ply", strips("7 0 2 1 -2 0 1 3\n"), Problem_kind::FILE,
     "uses vertex -2"},
    {"ply_strip_too_short", ".ply", strips("8 0 2 1 -1 0 1 3\n"), Problem_kind::FILE,
     "unexpected end of file in item of tristrips 0"},
    {"ply_strip_too_long", ".ply", strips("6 0 2 1 -1 0 1 3\n"), Problem_kind::FILE,
     "a strip of less than 3 vertices"},
    {"ply_strips_without_list", ".ply",
     replaced(strips("7 0 2 1 -1 0 1 3\n"), "vertex_indices", "corners"), Problem_kind::FILE,
     "'tristrips' has no list vertex_indices"},
    {"ply_strips_without_properties", ".ply",
     replaced(strips(""), "property list int int vertex_indices\n", ""), Problem_kind::FILE,
     "no PLY element 'tristrips' with properties"},
    {"ply_two_elements_with_strips", ".ply",
     replaced(strips(""), "element tristrips",
              "element tristrips 1\nproperty int a\nelement tristrips"),
     Problem_kind::FILE, "two PLY elements 'tristrips'"},
  };
}

TEST(Ply_strips, turn_every_second_triangle_over)
{
  using Triangles = std::vector<std::array<std::size_t, 3>>;
  EXPECT_EQ(soup_of_strips("6 0 2 1 3 0 2\n").triangles,
            (Triangles{{0, 2, 1}, {1, 2, 3}, {1, 3, 0}, {0, 3, 2}}));
  EXPECT_TRUE(SMF::check_triangle_soup(soup_of_strips("6 0 2 1 3 0 2\n")).empty());
  // Each strip begins anew; a repeated vertex changes the direction.
  EXPECT_EQ(soup_of_strips("8 0 2 1 3 -1 0 1 3\n").triangles,
            (Triangles{{0, 2, 1}, {1, 2, 3}, {0, 1, 3}}));
  EXPECT_EQ(soup_of_strips("5 0 2 1 2 3\n").triangles, (Triangles{{0, 2, 1}, {1, 2, 3}}));
  EXPECT_EQ(soup_of_strips("7 0 2 1 1 0 0 3\n").triangles, (Triangles{{0, 2, 1}}));
}

INSTANTIATE_TEST_SUITE_P(Texts, Odd_file, ::testing::ValuesIn(odd_texts()), sample_name);
INSTANTIATE_TEST_SUITE_P(Obj, Odd_file, ::testing::ValuesIn(odd_obj_files()), sample_name);
INSTANTIATE_TEST_SUITE_P(Off, Odd_file, ::testing::ValuesIn(odd_off_files()), numbered_name);
INSTANTIATE_TEST_SUITE_P(Binary_off,
                         Odd_file,
                         ::testing::ValuesIn(binary_off_files()),
                         sample_name);
INSTANTIATE_TEST_SUITE_P(Ply, Odd_file, ::testing::ValuesIn(odd_ply_files()), sample_name);
INSTANTIATE_TEST_SUITE_P(Obj,
                         Doubtful_file,
                         ::testing::ValuesIn(doubtful_obj_files()),
                         sample_name);
INSTANTIATE_TEST_SUITE_P(Off,
                         Doubtful_file,
                         ::testing::ValuesIn(doubtful_off_files()),
                         sample_name);
INSTANTIATE_TEST_SUITE_P(Binary_off,
                         Doubtful_file,
                         ::testing::ValuesIn(bad_binary_off_files()),
                         sample_name);
INSTANTIATE_TEST_SUITE_P(Ply, Doubtful_file, ::testing::ValuesIn(bad_ply_files()), sample_name);

} // namespace

} // namespace test_read_odd_files
