// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/decimal_comma.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/write_polylines.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cstddef>
#include <filesystem>
#include <list>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

namespace test_write_polylines {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Polylines = std::vector<std::vector<Point_3>>;

const std::string coordinates = "property double x\nproperty double y\nproperty double z\n";
const std::string edge_ends = "property int vertex1\nproperty int vertex2\n";

template <class PolylineRange>
std::string text_of(const PolylineRange& polylines,
                    const std::vector<SMF::Polyline_property>& vertex_properties = {},
                    const std::vector<SMF::Polyline_property>& edge_properties = {})
{
  std::ostringstream output;
  SMF::write_polylines_ply(output, polylines, vertex_properties, edge_properties);
  return output.str();
}

TEST(Write_polylines, two_polylines)
{
  const Polylines polylines = {{{0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}}, {{2, 0, -1}, {3, 1e100, 0}}};
  EXPECT_EQ(text_of(polylines), "ply\nformat ascii 1.0\nelement vertex 5\n" + coordinates +
                                  "element edge 3\n" + edge_ends +
                                  "end_header\n"
                                  "0 0 0\n1 0 0\n1 0.5 0\n2 0 -1\n3 1e+100 0\n"
                                  "0 1\n1 2\n3 4\n");
}

TEST(Write_polylines, empty_ranges_and_single_points)
{
  EXPECT_EQ(text_of(Polylines()), "ply\nformat ascii 1.0\nelement vertex 0\n" + coordinates +
                                    "element edge 0\n" + edge_ends + "end_header\n");
  EXPECT_EQ(text_of(Polylines{{}, {{1, 2, 3}}, {}, {{4, 5, 6}, {7, 8, 9}}}),
            "ply\nformat ascii 1.0\nelement vertex 3\n" + coordinates + "element edge 1\n" +
              edge_ends + "end_header\n1 2 3\n4 5 6\n7 8 9\n1 2\n");
}

TEST(Write_polylines, properties)
{
  const Polylines polylines = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{3, 0, 0}, {4, 0, 0}}};
  const std::vector<double> heights = {0.5, -2};
  const auto height = SMF::double_property(
    "height", [&](std::size_t polyline, std::size_t) { return heights[polyline]; });
  const auto position = SMF::int_property("position", [](std::size_t polyline, std::size_t vertex) {
    return static_cast<int>(10 * polyline + vertex);
  });
  EXPECT_EQ(text_of(polylines, {height, position}, {position}),
            "ply\nformat ascii 1.0\nelement vertex 5\n" + coordinates +
              "property double height\nproperty int position\nelement edge 3\n" + edge_ends +
              "property int position\nend_header\n"
              "0 0 0 0.5 0\n1 0 0 0.5 1\n2 0 0 0.5 2\n3 0 0 -2 10\n4 0 0 -2 11\n"
              "0 1 0\n1 2 1\n3 4 10\n");
}

TEST(Write_polylines, coordinates_come_back_exactly)
{
  const std::array<double, 3> values = {0.1, 1.0 / 3, -4.9406564584124654e-324};
  const std::string text = text_of(Polylines{{{values[0], values[1], values[2]}}});
  std::istringstream line(text.substr(text.find("end_header\n") + 11));
  for (const double value : values)
  {
    std::string word;
    line >> word;
    EXPECT_EQ(std::strtod(word.c_str(), nullptr), value);
  }
}

TEST(Write_polylines, other_ranges_and_kernels)
{
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  const std::list<std::array<Exact_point, 2>> polylines = {
    {Exact_point(0, 0, 0), Exact_point(1, 2, 3)}};
  EXPECT_NE(text_of(polylines).find("end_header\n0 0 0\n1 2 3\n0 1\n"), std::string::npos);
}

TEST(Write_polylines, the_locale_does_not_matter)
{
  std::ostringstream output;
  output.imbue(std::locale(output.getloc(), new smf_test::Decimal_comma));
  const auto large = SMF::int_property("large", [](std::size_t, std::size_t) { return 1234567; });
  SMF::write_polylines_ply(output, Polylines{{{1234.5, 0, 0}}}, {large});
  EXPECT_NE(output.str().find("\n1234.5 0 0 1234567\n"), std::string::npos);
}

TEST(Write_polylines, a_file_is_written)
{
  const smf_test::Temporary_folder folder;
  const std::string file_name = folder.file_name("lines.ply");
  const Polylines polylines = {{{0, 0, 0}, {1, 0, 0}}};
  SMF::write_polylines_ply(file_name, polylines);
  EXPECT_EQ(smf_test::file_text(file_name), text_of(polylines));
}

void expect_failure(const std::string& file_name, const Polylines& polylines)
{
  try
  {
    SMF::write_polylines_ply(file_name, polylines);
    ADD_FAILURE() << file_name << " was written";
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::FILE);
    EXPECT_EQ(std::string(exception.what()).rfind(file_name + ": cannot be ", 0), 0u)
      << exception.what();
  }
}

TEST(Write_polylines, a_missing_folder_is_reported)
{
  const smf_test::Temporary_folder folder;
  expect_failure(folder.file_name("missing/lines.ply"), {});
  expect_failure(folder.file_name("."), {});
}

TEST(Write_polylines, a_full_disk_is_reported)
{
  const std::string full_device = "/dev/full";
  if (!std::filesystem::exists(full_device))
    GTEST_SKIP() << "there is no " << full_device;
  expect_failure(full_device, {{{0, 0, 0}}});
  expect_failure(full_device, Polylines(1000, std::vector<Point_3>(100, Point_3(1, 2, 3))));
}

TEST(Write_polylines, a_failed_stream_is_reported)
{
  std::ostringstream output;
  output.setstate(std::ios::badbit);
  EXPECT_THROW(SMF::write_polylines_ply(output, Polylines()), SMF::Invalid_file_exception);
}

} // namespace

} // namespace test_write_polylines
