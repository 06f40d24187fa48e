// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "require.h"
#include "targets.h"

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>
#include <CGAL/Surface_mesh_foliation/parts.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
using smf_fuzz::require;
using smf_fuzz::survives;

// Points of a small grid, so that many coincide or lie on lines, with a few odd numbers.
double coordinate(FuzzedDataProvider& bytes)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::array<double, 12> odd = {-0.0,  0.1,    1. / 3,   1e-150, 1e-308, 5e-324,
                                          1e150, -1e150, 1.7e+308, 1e16,   1e-16,  infinity};
  const auto byte = bytes.ConsumeIntegral<std::uint8_t>();
  return byte < 240 ? byte % 4 : odd[(byte - 240) % odd.size()];
}

SMF::Polygon_soup soup_of(FuzzedDataProvider& bytes)
{
  SMF::Polygon_soup result;
  const auto number_of_points = bytes.ConsumeIntegralInRange<std::size_t>(0, 14);
  for (std::size_t v = 0; v < number_of_points; ++v)
  {
    const double x = coordinate(bytes), y = coordinate(bytes), z = coordinate(bytes);
    result.points.push_back({x, y, z});
  }
  while (bytes.remaining_bytes() > 0)
  {
    // mostly triangles
    const auto size = bytes.ConsumeIntegral<std::uint8_t>();
    std::vector<std::size_t> polygon(size < 192 ? 3 : size % 8);
    for (std::size_t& corner : polygon)
    {
      const auto byte = bytes.ConsumeIntegral<std::uint8_t>();
      corner = byte == 255 ? number_of_points : byte % std::max<std::size_t>(1, number_of_points);
    }
    result.polygons.push_back(std::move(polygon));
  }
  return result;
}

// as the text of an OFF file
void print(const SMF::Polygon_soup& soup)
{
  std::cerr.precision(17);
  std::cerr << "OFF\n" << soup.points.size() << ' ' << soup.polygons.size() << " 0\n";
  for (const auto& [x, y, z] : soup.points)
    std::cerr << x << ' ' << y << ' ' << z << '\n';
  for (const std::vector<std::size_t>& polygon : soup.polygons)
  {
    std::cerr << polygon.size();
    for (const std::size_t v : polygon)
      std::cerr << ' ' << v;
    std::cerr << '\n';
  }
}

void check_origins(const SMF::Polygon_soup& soup, const SMF::Repaired_soup& repaired)
{
  constexpr std::size_t none = SMF::Repaired_soup::none;
  const auto is_below = [](const std::vector<std::size_t>& numbers, std::size_t bound) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [=](std::size_t i) { return i == none || i < bound; });
  };
  require(repaired.vertex_origins.size() == repaired.soup.points.size() &&
            is_below(repaired.vertex_origins, soup.points.size()),
          "wrong origins of vertices");
  require(repaired.face_origins.size() == repaired.soup.triangles.size() &&
            is_below(repaired.face_origins, soup.polygons.size()),
          "wrong origins of faces");
  require(repaired.vertices.size() == soup.points.size() &&
            is_below(repaired.vertices, repaired.soup.points.size()),
          "wrong vertices by those of the input");
  require(repaired.first_faces.size() == soup.polygons.size() + 1 &&
            std::is_sorted(repaired.first_faces.begin(), repaired.first_faces.end()),
          "wrong faces by those of the input");
}

// whether the soup is a surface; what is repaired is, unless a face is flat beyond repair, or none
// is left
bool is_surface(const SMF::Triangle_soup& soup)
{
  const auto problems =
    SMF::check_triangle_soup(soup, SMF::parameters::allow_openings(true).allow_parts(true));
  for (const SMF::Problem& problem : problems)
    require(problem.kind == SMF::Problem_kind::EMPTY_MESH ||
              problem.kind == SMF::Problem_kind::DEGENERATE_FACE,
            "after repair: " + problem.message);
  return problems.empty();
}

SMF::Polygon_soup to_polygons(const SMF::Triangle_soup& soup)
{
  SMF::Polygon_soup result;
  result.points = soup.points;
  for (const auto& triangle : soup.triangles)
    result.polygons.emplace_back(triangle.begin(), triangle.end());
  return result;
}

} // namespace

// A polygon soup, repaired, and repaired again; its openings filled; its parts taken.
void smf_fuzz::repair(const std::uint8_t* data, std::size_t size)
{
  FuzzedDataProvider bytes(data, size);
  const SMF::Polygon_soup soup = soup_of(bytes);
  if (is_printing())
    print(soup);
  SMF::Repaired_soup repaired;
  if (!survives([&] { repaired = SMF::repair_polygon_soup(soup); }))
    return;
  check_origins(soup, repaired);
  SMF::descriptions(repaired.report);
  if (!is_surface(repaired.soup))
    return;
  require(survives([&] { is_surface(SMF::repair_polygon_soup(to_polygons(repaired.soup)).soup); }),
          "what is repaired cannot be repaired");
  smf_test::Mesh mesh;
  require(survives([&] {
            SMF::triangle_soup_to_triangle_mesh(
              repaired.soup, mesh, SMF::parameters::allow_openings(true).allow_parts(true));
          }),
          "what is repaired is no mesh");
  survives([&] {
    SMF::fill_openings(mesh);
    require(mesh.is_valid(), "an invalid mesh with filled openings");
  });
  survives([&] { require(!SMF::mesh_parts(mesh).empty(), "a mesh without parts"); });
}
