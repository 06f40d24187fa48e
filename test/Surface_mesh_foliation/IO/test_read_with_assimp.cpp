// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generators/genus_soups.h"
#include "include/big_and_little_endian.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/read_with_assimp.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace test_read_with_assimp {

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;
using SMF::Triangle_soup;

// A binary glTF file, moved by (10, 0, 0), in which each face has corners of its own.
std::string glb(const Triangle_soup& soup)
{
  using smf_test::little_endian_bytes;
  std::string data;
  for (const auto& triangle : soup.triangles)
    for (const std::size_t v : triangle)
      for (const double coordinate : soup.points[v])
        data += little_endian_bytes(static_cast<float>(coordinate));
  const std::string size = std::to_string(data.size());
  std::string json =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
    "\"nodes\":[{\"mesh\":0,\"translation\":[10,0,0]}],"
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":4}]}],"
    "\"buffers\":[{\"byteLength\":" +
    size +
    "}],"
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":" +
    size +
    "}],"
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":" +
    std::to_string(3 * soup.triangles.size()) +
    ",\"min\":[-100,-100,-100],\"max\":[100,100,100]}]}";
  while (json.size() % 4 != 0)
    json += ' ';
  const auto number = [](std::size_t n) {
    return little_endian_bytes(static_cast<std::uint32_t>(n));
  };
  return "glTF" + number(2) + number(12 + 8 + json.size() + 8 + data.size()) + number(json.size()) +
         "JSON" + json + number(data.size()) + std::string("BIN\0", 4) + data;
}

TEST(Read_with_assimp, gltf_whose_faces_are_loose)
{
  const smf_test::Temporary_folder folder;
  for (const Triangle_soup& soup :
       {soups::icosphere(2), soups::torus(8, 6, 3, 1), soups::genus_surface(2)})
  {
    const SMF::Polygon_soup found =
      SMF::read_polygon_soup_with_assimp(folder.write("a.glb", glb(soup)));
    ASSERT_EQ(found.polygons.size(), soup.triangles.size());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          EXPECT_NEAR(found.points[found.polygons[f][i]][axis],
                      soup.points[soup.triangles[f][i]][axis] + (axis == 0 ? 10 : 0),
                      100 * std::numeric_limits<float>::epsilon());
    const SMF::Repaired_soup repaired = SMF::repair_polygon_soup(found);
    EXPECT_EQ(repaired.soup.points.size(), soup.points.size());
    EXPECT_TRUE(SMF::check_triangle_soup(repaired.soup).empty());
  }
}

TEST(Read_with_assimp, refuses_what_it_cannot_read)
{
  const smf_test::Temporary_folder folder;
  const std::string good = glb(soups::icosphere(0));
  for (const std::string& file : {folder.file_name("none.glb"), folder.write("text.gltf", "hello"),
                                  folder.write("short.glb", good.substr(0, 100))})
    EXPECT_THROW(SMF::read_polygon_soup_with_assimp(file), SMF::Invalid_file_exception) << file;
}

} // namespace

} // namespace test_read_with_assimp
