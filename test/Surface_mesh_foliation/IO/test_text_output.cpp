// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers in files, files that are written, and the colors of arcs.

#include <CGAL/Surface_mesh_foliation/IO/arc_color.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/text_output.h>

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
#include <ios>
#include <limits>
#include <locale>
#include <map>
#include <ostream>
#include <random>
#include <sstream>
#include <string>

namespace test_text_output {

using namespace CGAL::Surface_mesh_foliation::internal;
namespace SMF = CGAL::Surface_mesh_foliation;

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
  {
    double read = 0;
    EXPECT_EQ(parse_number(text_of(number), read), Parse_status::OK) << text_of(number);
    EXPECT_EQ(read, number) << text_of(number);
  }
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

TEST(Append_by_stream, writes_what_is_read_whatever_the_locale)
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

} // namespace test_text_output
