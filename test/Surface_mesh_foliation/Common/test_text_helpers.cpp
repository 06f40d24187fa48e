// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What reading and writing of files rests on: numbers, lines and words, colors, messages.

#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Text_cursor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>
#include <CGAL/Surface_mesh_foliation/version.h>

#include "include/decimal_comma.h"
#include "include/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <ios>
#include <limits>
#include <locale>
#include <map>
#include <ostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace test_text_helpers {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;
using SMF::Problem_kind;

// ===  parse_number.h

namespace {

template <class Number>
Parse_status status_of(std::string_view token)
{
  Number ignored{};
  return parse_number(token, ignored);
}

template <class Number>
Number parsed(std::string_view token)
{
  Number result{};
  EXPECT_EQ(parse_number(token, result), Parse_status::OK) << token;
  return result;
}

} // namespace

TEST(Parse_number, reads_doubles_to_the_last_bit)
{
  EXPECT_EQ(parsed<double>("0.1"), 0.1);
  EXPECT_EQ(parsed<double>("-1e-3"), -1e-3);
  EXPECT_EQ(parsed<double>("+2.5E+2"), 250);
  EXPECT_EQ(parsed<double>(".5"), 0.5);
  EXPECT_EQ(parsed<double>("5."), 5);
  EXPECT_EQ(parsed<double>("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parsed<double>("4.9e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::signbit(parsed<double>("-0")));
  EXPECT_EQ(parsed<double>("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parsed<double>("nan")));
}

TEST(Parse_number, reads_integers_up_to_their_limits)
{
  EXPECT_EQ(parsed<int>("+7"), 7);
  EXPECT_EQ(parsed<int>("-0"), 0);
  EXPECT_EQ(parsed<int>("2147483647"), 2147483647);
  EXPECT_EQ(parsed<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(status_of<int>("2147483648"), Parse_status::OUT_OF_RANGE);
  EXPECT_EQ(status_of<std::uint64_t>("18446744073709551616"), Parse_status::OUT_OF_RANGE);
}

TEST(Parse_number, refuses_all_but_a_whole_number)
{
  for (const char* token :
       {"", "+", "-", "+-1", "-+1", "++1", "1 ", " 1", "1x", "1,5", "0x10", "1e", "."})
  {
    EXPECT_EQ(status_of<double>(token), Parse_status::NOT_A_NUMBER) << token;
    EXPECT_EQ(status_of<int>(token), Parse_status::NOT_A_NUMBER) << token;
  }
  for (const char* token : {"1.0", "1e2", "inf", "99999999999999999999x"})
    EXPECT_EQ(status_of<int>(token), Parse_status::NOT_A_NUMBER) << token;
  EXPECT_EQ(status_of<unsigned>("-1"), Parse_status::NOT_A_NUMBER);
  EXPECT_EQ(status_of<double>(std::string_view("1\0", 2)), Parse_status::NOT_A_NUMBER);
}

TEST(Parse_number, tells_numbers_that_do_not_fit_from_nonsense)
{
  EXPECT_EQ(status_of<double>("1e999"), Parse_status::OUT_OF_RANGE);
  EXPECT_EQ(status_of<double>("-1e999"), Parse_status::OUT_OF_RANGE);
  EXPECT_EQ(status_of<double>("1e999x"), Parse_status::NOT_A_NUMBER);
}

// What a standard library whose std::from_chars() knows integers only has to use.
TEST(Parse_by_stream, does_the_same_as_from_chars)
{
  for (const std::string text : {"0",
                                 "-0",
                                 "1",
                                 "-1.5",
                                 "5.",
                                 ".5",
                                 "-.5",
                                 "5.e3",
                                 "1E5",
                                 "1e+5",
                                 "1e-5",
                                 "0.1",
                                 "1e23",
                                 "123456789012345678901234567890",
                                 "1.7976931348623157e308",
                                 "1.7976931348623158e308",
                                 "1.7976931348623159e308",
                                 "1e999",
                                 "-1e999",
                                 "1e99999999999999999999",
                                 "0e999",
                                 "-0.0e99999999999999999999",
                                 "1e-308",
                                 "2.2250738585072011e-308",
                                 "4.9e-324",
                                 "-3e-324",
                                 "2.4703282292062328e-324",
                                 "2.4703282292062327e-324",
                                 "1e-400",
                                 "-1e-400",
                                 "1e-99999999999999999999",
                                 "0e-400",
                                 "nan",
                                 "-NaN",
                                 "nan()",
                                 "nan(a_1)",
                                 "nan(",
                                 "nan(a b)",
                                 "nan(a-b)",
                                 "nan()x",
                                 "inf",
                                 "-INF",
                                 "Infinity",
                                 "infinit",
                                 "infinity1",
                                 "",
                                 "+",
                                 "-",
                                 ".",
                                 "-.",
                                 "e5",
                                 ".e5",
                                 "1e",
                                 "1e+",
                                 "1e-",
                                 "1e5.",
                                 "1e5e5",
                                 "1.2.3",
                                 "+1",
                                 "++1",
                                 "+-1",
                                 "-+1",
                                 "--1",
                                 " 1",
                                 "1 ",
                                 "\t1",
                                 "1\n",
                                 "1,5",
                                 "1.000,5",
                                 "1'000",
                                 "0x10",
                                 "0x1p3",
                                 "1p3",
                                 "1.5abc",
                                 "1f",
                                 "1d5",
                                 "a",
                                 "1_0"})
  {
    for (const std::string& token : {text, text + "x", text + std::string(1, '\0')})
    {
      double number = 0, expected = 0;
      const Parse_status status = parse_by_stream(token, number);
#ifdef __cpp_lib_to_chars
      EXPECT_EQ(status, parse_by_from_chars(token, expected)) << token;
#else
      expected = std::strtod(token.c_str(), nullptr);
#endif
      if (status != Parse_status::OK)
        continue;
      EXPECT_TRUE(number == expected || (std::isnan(number) && std::isnan(expected)))
        << token << " is read as " << number;
      EXPECT_EQ(std::signbit(number), std::signbit(expected)) << token;
    }
  }
}

TEST(Parse_by_stream, tells_numbers_that_do_not_fit_from_nonsense)
{
  const auto status_of = [](std::string_view token) {
    double ignored = 0;
    return parse_by_stream(token, ignored);
  };
  for (const char* token : {"1.5", "1.7976931348623157e308", "4.9e-324", "0e999", "inf", "nan(1)"})
    EXPECT_EQ(status_of(token), Parse_status::OK) << token;
  for (const char* token : {"1e999", "-1e999", "1e-400", "1.7976931348623159e308"})
    EXPECT_EQ(status_of(token), Parse_status::OUT_OF_RANGE) << token;
  for (const char* token : {"", "+1", " 1", "1 ", "1e", "0x1p3", "1.5abc", "nan(", "1e999x"})
    EXPECT_EQ(status_of(token), Parse_status::NOT_A_NUMBER) << token;
}

TEST(Parse_by_stream, reads_what_is_written_whatever_the_locale)
{
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new smf_test::Decimal_comma));
  std::mt19937_64 random(1);
  for (int i = 0; i < 10000; ++i)
  {
    // all exponents alike, so that one in a thousand is subnormal
    double number;
    const std::uint64_t bits = random();
    std::memcpy(&number, &bits, sizeof(number));
    if (!std::isfinite(number))
      continue;
    std::string by_stream, by_to_chars;
    append_by_stream(by_stream, number);
    append_number(by_to_chars, number);
    EXPECT_EQ(by_stream, by_to_chars);
    double read = 0;
    EXPECT_EQ(parse_by_stream(by_stream, read), Parse_status::OK) << by_stream;
    EXPECT_EQ(read, number) << by_stream;
  }
  std::locale::global(before);
}

// ===  Text_cursor.h

namespace {

// all words of the text, line by line, each line with its place
std::vector<std::vector<std::string>> lines_of(std::string_view text, char comment_character = '#')
{
  Text_cursor cursor("f", text, comment_character);
  std::vector<std::vector<std::string>> result;
  while (cursor.next_line())
  {
    result.push_back({cursor.place()});
    EXPECT_FALSE(cursor.is_line_finished());
    while (!cursor.is_line_finished())
      result.back().emplace_back(cursor.next_word());
    EXPECT_TRUE(cursor.next_word().empty());
  }
  EXPECT_TRUE(cursor.is_line_finished());
  EXPECT_FALSE(cursor.next_line());
  return result;
}

using Lines = std::vector<std::vector<std::string>>;

} // namespace

TEST(Text_cursor, goes_over_lines_with_words)
{
  EXPECT_EQ(lines_of(""), Lines());
  EXPECT_EQ(lines_of("\n \n\t\r\n"), Lines());
  EXPECT_EQ(lines_of("a"), (Lines{{"f:1: ", "a"}}));
  EXPECT_EQ(lines_of("a b\n\nc\n"), (Lines{{"f:1: ", "a", "b"}, {"f:3: ", "c"}}));
  EXPECT_EQ(lines_of("\r\n  a\t\vb\f \r\nc"), (Lines{{"f:2: ", "a", "b"}, {"f:3: ", "c"}}));
}

TEST(Text_cursor, leaves_out_comments)
{
  EXPECT_EQ(lines_of("#a\nb#c d\n e # f\n#"), (Lines{{"f:2: ", "b"}, {"f:3: ", "e"}}));
  EXPECT_EQ(lines_of("#a\nb;c", ';'), (Lines{{"f:1: ", "#a"}, {"f:2: ", "b"}}));
  EXPECT_EQ(lines_of("#a\nb#", Text_cursor::no_comments),
            (Lines{{"f:1: ", "#a"}, {"f:2: ", "b#"}}));
}

TEST(Text_cursor, knows_what_remains_and_where_it_is)
{
  Text_cursor cursor("folder/f", "a b\nc\nd", '#');
  EXPECT_EQ(cursor.place(), "folder/f:1: ");
  EXPECT_EQ(cursor.remaining_text(), "a b\nc\nd");
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(cursor.next_word(), "a");
  EXPECT_EQ(cursor.remaining_text(), "c\nd"); // not the rest of the line
  ASSERT_TRUE(cursor.next_line());            // words may be left out
  EXPECT_EQ(cursor.place(), "folder/f:2: ");
  Text_cursor copy = cursor;
  EXPECT_EQ(copy.next_word(), "c");
  EXPECT_EQ(cursor.next_word(), "c");
  ASSERT_TRUE(cursor.next_line());
  EXPECT_EQ(cursor.remaining_text(), "");
  EXPECT_FALSE(cursor.next_line());
  EXPECT_EQ(cursor.place(), "folder/f:3: ");
}

TEST(Text_cursor, failures_name_the_place)
{
  Text_cursor cursor("f", "\na", '#');
  ASSERT_TRUE(cursor.next_line());
  try
  {
    cursor.fail("what");
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    EXPECT_STREQ(exception.what(), "f:2: what");
    EXPECT_EQ(exception.problem().kind, Problem_kind::FILE);
  }
  try
  {
    throw SMF::Invalid_mesh_exception(
      problem(Problem_kind::NOT_FINITE, cursor.place(), "what").vertices({7}).faces({8, 9}));
  }
  catch (const SMF::Invalid_mesh_exception& exception)
  {
    EXPECT_STREQ(exception.what(), "f:2: what");
    EXPECT_EQ(exception.problem().kind, Problem_kind::NOT_FINITE);
    EXPECT_EQ(exception.problem().vertices, std::vector<std::size_t>{7});
    EXPECT_EQ(exception.problem().faces, (std::vector<std::size_t>{8, 9}));
  }
  EXPECT_THROW(cursor.fail("what"), SMF::Invalid_file_exception);
}

TEST(Read_whole_file, reads_every_byte_whatever_the_size)
{
  const smf_test::Temporary_folder folder;
  for (const std::size_t size : {0, 1, 65535, 65536, 65537, 200000})
  {
    std::string text;
    for (std::size_t i = 0; i < size; ++i)
      text += static_cast<char>(i * i % 256);
    EXPECT_TRUE(read_whole_file(folder.write("f", text)) == text) << size;
  }
  EXPECT_THROW(read_whole_file(folder.file_name("missing")), SMF::Invalid_file_exception);
  std::filesystem::create_directory(folder.file_name("folder"));
  EXPECT_THROW(read_whole_file(folder.file_name("folder")), SMF::Invalid_file_exception);
}

// ===  text_output.h

namespace {

std::string text_of(double number)
{
  std::string result = "x";
  append_number(result, number);
  return result.substr(1);
}

} // namespace

TEST(Append_number, numbers_come_back_bit_for_bit)
{
  using Limits = std::numeric_limits<double>;
  for (const double number : {0.1, 1. / 3, -2e-308, 123456789.125, Limits::max(), Limits::min(),
                              Limits::denorm_min(), Limits::epsilon(), -Limits::max()})
    EXPECT_EQ(parsed<double>(text_of(number)), number) << text_of(number);
  EXPECT_EQ(text_of(0), "0");
  EXPECT_EQ(text_of(-0.), "-0");
  EXPECT_EQ(text_of(-2.5), "-2.5");
  EXPECT_EQ(text_of(1e300), "1.0000000000000001e+300");
}

TEST(Append_by_stream, does_the_same_as_to_chars)
{
  using Limits = std::numeric_limits<double>;
  for (const double number : {0., -0., 1., -2.5, 1e5, 123456., 1e16, 1e17, 1e-4, 1e-5, 1. / 3,
                              1e300, Limits::max(), Limits::min(), Limits::denorm_min(),
                              Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
  {
    std::string text = "x";
    append_by_stream(text, number);
    EXPECT_EQ(text, "x" + text_of(number));
  }
}

TEST(Check_output, reports_only_what_has_failed)
{
  std::ostringstream output;
  EXPECT_NO_THROW(check_output(output, "the stream"));
  output.setstate(std::ios::failbit);
  try
  {
    check_output(output, "the stream");
    ADD_FAILURE() << "a failed stream is not reported";
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    EXPECT_STREQ(exception.what(), "the stream: cannot be written");
  }
}

TEST(Write_file, writes_in_the_classic_locale_and_reports_failures)
{
  const smf_test::Temporary_folder folder;
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new smf_test::Decimal_comma));
  const std::string file_name = folder.file_name("f");
  write_file(file_name, [](std::ostream& output) { output << 1234.5 << "\r\n"; });
  std::locale::global(before);
  EXPECT_EQ(smf_test::file_text(file_name), "1234.5\r\n");
  write_file(file_name, [](std::ostream&) {}); // what was there is gone
  EXPECT_EQ(smf_test::file_text(file_name), "");

  const auto fail = [](std::ostream& output) { output.setstate(std::ios::badbit); };
  EXPECT_THROW(write_file(file_name, fail), SMF::Invalid_file_exception);
  const std::string missing = folder.file_name("none") + "/f";
  EXPECT_THROW(write_file(missing, [](std::ostream&) { FAIL() << "was called"; }),
               SMF::Invalid_file_exception);
}

// ===  arc_color.h

TEST(Arc_color, differs_for_the_first_hundred_arcs)
{
  std::map<std::array<int, 3>, std::size_t> arcs;
  for (std::size_t arc = 0; arc < 100; ++arc)
  {
    const CGAL::IO::Color color = SMF::arc_color(arc);
    const std::array<int, 3> rgb = {color.red(), color.green(), color.blue()};
    const auto [it, is_new] = arcs.emplace(rgb, arc);
    EXPECT_TRUE(is_new) << arc << " is like " << it->second;
    // neither gray nor dark
    const auto [least, largest] = std::minmax_element(rgb.begin(), rgb.end());
    EXPECT_GE(*largest, 200);
    EXPECT_GE(*largest - *least, 100);
  }
}

TEST(Arc_color, neighbors_differ_much)
{
  for (std::size_t arc = 0; arc < 1000; ++arc)
  {
    const auto p = SMF::arc_color(arc), q = SMF::arc_color(arc + 1);
    const int difference =
      std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) + std::abs(p.blue() - q.blue());
    EXPECT_GE(difference, 150) << arc;
  }
}

// ===  problem.h

TEST(Quoted, is_short_and_printable)
{
  const auto quoted = [](std::string_view text) { return SMF::internal::quoted(text); };
  EXPECT_EQ(quoted(""), "''");
  EXPECT_EQ(quoted("a b~"), "'a b~'");
  EXPECT_EQ(quoted(std::string_view("\0\t\n\x7f\xc3", 5)), "'" + std::string(5, '?') + "'");
  EXPECT_EQ(quoted(std::string(24, 'a')), "'" + std::string(24, 'a') + "'");
  EXPECT_EQ(quoted(std::string(25, 'a')), "'" + std::string(24, 'a') + "...'");
}

TEST(Problems, have_their_parts)
{
  const SMF::Problem found = problem(Problem_kind::NOT_CLOSED, "m", 5).vertices({1, 2}).faces({3});
  EXPECT_EQ(found.kind, Problem_kind::NOT_CLOSED);
  EXPECT_EQ(found.message, "m5");
  EXPECT_EQ(found.vertices, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(found.faces, std::vector<std::size_t>{3});
  EXPECT_TRUE(found.loops.empty());
  const SMF::Problem of_loops = problem(Problem_kind::INVALID_POLE, "m").loops({4});
  EXPECT_EQ(of_loops.loops, std::vector<std::size_t>{4});
  EXPECT_THROW(throw_file_problem("m", 5), SMF::Invalid_file_exception);
  try
  {
    throw_file_problem("m", 5);
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, Problem_kind::FILE);
    EXPECT_STREQ(exception.what(), "m5");
  }
  EXPECT_EQ(vertex_name(7), "vertex 7");
  EXPECT_EQ(face_name(0), "face 0");
}

// ===  exceptions.h and version.h

namespace {

template <class Exception>
void expect_carries_its_problem()
{
  static_assert(std::is_base_of_v<SMF::Foliation_exception, Exception>);
  static_assert(std::is_base_of_v<std::runtime_error, Exception>);
  try
  {
    throw Exception({Problem_kind::NO_LOOP, "text", {1}, {2}, {3, 4}});
  }
  catch (const SMF::Foliation_exception& exception)
  {
    EXPECT_NE(dynamic_cast<const Exception*>(&exception), nullptr);
    EXPECT_STREQ(exception.what(), "text");
    EXPECT_EQ(exception.problem().kind, Problem_kind::NO_LOOP);
    EXPECT_EQ(exception.problem().message, "text");
    EXPECT_EQ(exception.problem().vertices, std::vector<std::size_t>{1});
    EXPECT_EQ(exception.problem().faces, std::vector<std::size_t>{2});
    EXPECT_EQ(exception.problem().loops, (std::vector<std::size_t>{3, 4}));
  }
}

} // namespace

TEST(Exceptions, carry_their_problem)
{
  expect_carries_its_problem<SMF::Invalid_file_exception>();
  expect_carries_its_problem<SMF::Invalid_mesh_exception>();
  expect_carries_its_problem<SMF::Invalid_loops_exception>();
  expect_carries_its_problem<SMF::Invalid_parameter_exception>();
  expect_carries_its_problem<SMF::Solver_exception>();
  expect_carries_its_problem<SMF::Certificate_exception>();
  static_assert(!std::is_base_of_v<SMF::Invalid_file_exception, SMF::Invalid_mesh_exception>);
}

TEST(Version, text_and_number_agree)
{
  std::istringstream text(CGAL_SURFACE_MESH_FOLIATION_VERSION);
  int major = -1, minor = -1, patch = -1;
  char first_dot = 0, second_dot = 0;
  text >> major >> first_dot >> minor >> second_dot >> patch;
  EXPECT_EQ(first_dot, '.');
  EXPECT_EQ(second_dot, '.');
  EXPECT_EQ(10000 * major + 100 * minor + patch, CGAL_SURFACE_MESH_FOLIATION_VERSION_NR);
}

} // namespace test_text_helpers
