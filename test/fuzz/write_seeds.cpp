// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// write_seeds FOLDER: writes what fuzzing begins with into FOLDER/<target>: files of the tests for
// the readers, and random bytes for what else is made from bytes.

#include "generators/Random.h"
#include "include/binary_off_file.h"
#include "include/stl_files.h"
#include "include/tetrahedron_files.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/IO/polygon_soup_io.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace {

class Seeds
{
public:
  explicit Seeds(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  void add(const std::string& target, const std::string& text)
  {
    std::ofstream(new_file(target), std::ios::binary) << text;
  }

  std::filesystem::path new_file(const std::string& target)
  {
    std::filesystem::create_directories(m_folder / target);
    return m_folder / target / std::to_string(m_number++);
  }

private:
  std::filesystem::path m_folder;
  std::size_t m_number = 0;
};

void add_off(Seeds& seeds)
{
  using smf_test::replaced, smf_test::tetrahedron_off;
  seeds.add("read_off", tetrahedron_off);
  seeds.add("read_off", replaced(tetrahedron_off, "OFF\n4 4 0\n", "COFF # c\n4 4 6\n\n"));
  seeds.add("read_off", replaced(tetrahedron_off, "OFF\n", "OFF"));
  seeds.add("read_off", replaced(tetrahedron_off, "3 0 2 1\n", "3 0 2 1 255 0 0\n"));
  seeds.add("read_off", replaced(tetrahedron_off, "3 0 2 1\n", "4 0 2 1 3\n"));
  seeds.add("read_off", replaced(tetrahedron_off, "1 0 0\n", "1 0\n0 "));
  seeds.add("read_off", smf_test::binary_off("OFF BINARY\n", 0));
  seeds.add("read_off", smf_test::binary_off("STCNOFF BINARY\n", 9));
}

void add_obj(Seeds& seeds)
{
  using smf_test::replaced, smf_test::tetrahedron_obj;
  seeds.add("read_obj", tetrahedron_obj);
  seeds.add("read_obj", replaced(tetrahedron_obj, "f 1 3 2", "vt 0 0\nvn 0 0 1\nf 1/1/1 3//1 2/1"));
  seeds.add("read_obj", replaced(tetrahedron_obj, "f 1 3 2", "g a\nusemtl b\nf -4 \\\n-2 -3"));
  seeds.add("read_obj", replaced(tetrahedron_obj, "f 1 3 2", "f 1 3 2 4"));
}

void add_ply(Seeds& seeds)
{
  using smf_test::replaced, smf_test::tetrahedron_ply;
  seeds.add("read_ply", tetrahedron_ply);
  seeds.add("read_ply",
            replaced(replaced(smf_test::ply_header, "element face 4", "element tristrips 1"),
                     "list uchar int", "list int int") +
              smf_test::tetrahedron_vertices + "6 0 2 1 3 0 2\n");
  seeds.add("read_ply",
            replaced(replaced(tetrahedron_ply, "float z", "float z\nproperty uchar red"),
                     smf_test::tetrahedron_vertices, "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n"));
  const std::vector<CGAL::Simple_cartesian<double>::Point_3> points = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::vector<std::size_t>> triangles = {
    {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  const std::string name = seeds.new_file("read_ply").string();
  CGAL::IO::write_PLY(name + ".ply", points, triangles, CGAL::parameters::use_binary_mode(true));
  // its header, with numbers in the other order
  std::string big_endian = replaced(smf_test::ply_header, "ascii", "binary_big_endian");
  for (const auto& point : points)
    for (const double coordinate : {point.x(), point.y(), point.z()})
      big_endian += smf_test::big_endian_bytes(static_cast<float>(coordinate));
  for (const auto& triangle : triangles)
  {
    big_endian += '\3';
    for (const std::size_t corner : triangle)
      big_endian += smf_test::big_endian_bytes(static_cast<std::int32_t>(corner));
  }
  seeds.add("read_ply", big_endian);
}

void add_stl(Seeds& seeds)
{
  const auto corners = smf_test::tetrahedron_stl_corners();
  seeds.add("read_stl", smf_test::ascii_stl(corners));
  seeds.add("read_stl", smf_test::binary_stl(corners));
  seeds.add("read_stl", smf_test::binary_stl(corners, "solid"));
}

// the first byte chooses the mesh: a sphere, a torus, one of genus two, and one with an opening
void add_loops(Seeds& seeds)
{
  const std::string texts[] = {"# loops\ncycle 0 1 2 3 4 5\n", "through 0 7 14\n\n",
                               "separate 0 1 2\n", "plane 1 0 0 0 0\nplane 0 1 0 0.1 3\n",
                               "crossing 0 1 0.5 1 2 0.25 2 0 0.75\n"};
  for (const char mesh : {'\0', '\1', '\2', '\3'})
    for (const std::string& text : texts)
      seeds.add("read_loops", mesh + text);
}

void add_bytes(Seeds& seeds)
{
  smf_test::Random random(1);
  for (const char* target : {"repair", "loop_systems", "edits", "three_ways", "python_boundary"})
    for (int i = 0; i < 100; ++i)
    {
      std::string text(16 + random.index(400), '\0');
      for (char& c : text)
        c = static_cast<char>(random.index(256));
      seeds.add(target, text);
    }
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: write_seeds FOLDER\n";
    return EXIT_FAILURE;
  }
  Seeds seeds(argv[1]);
  add_off(seeds);
  add_obj(seeds);
  add_ply(seeds);
  add_stl(seeds);
  add_loops(seeds);
  add_bytes(seeds);
  return EXIT_SUCCESS;
}
