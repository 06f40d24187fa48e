// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/test_meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

// Poles found on real meshes, with default parameters. The places where they must be were chosen by
// looking at pictures of the meshes: the outermost vertex of a limb in a direction along it.

namespace {

namespace SMF = CGAL::Surface_mesh_foliation;

using smf_test::Mesh;

struct Place
{
  std::string name;
  std::size_t vertex;
  double radius = 0.05; // in diameters of the mesh
};

struct Shape
{
  std::string folder, file;
  std::vector<Place> places;
  std::size_t most; // poles

  std::string path() const { return folder.empty() ? "" : folder + "/" + file + ".off"; }
};

std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
  return out << shape.file;
}

std::string shared_folder()
{
  const std::string folder = SMF_SHARED_DIR;
  return folder.empty() ? folder : folder + "/meshes";
}

const std::vector<Place> body = {{"head", 411},
                                 {"left hand", 2445},
                                 {"right hand", 5906},
                                 {"left foot", 3217},
                                 {"right foot", 6617}};

std::vector<Shape> shapes()
{
  const std::string shared = shared_folder(), cgal = SMF_DATA_DIR;
  return {
    {shared, "human_man_6890", body, 5},
    {shared, "human_woman_6890", body, 5},
    {shared,
     "hand_7993",
     {{"thumb", 10},
      {"index finger", 1046},
      {"middle finger", 2146},
      {"ring finger", 3059},
      {"little finger", 3455},
      {"wrist", 5569, 0.12}}, // the middle of a flat end
     12},
    {shared,
     "cat_7949",
     {{"nose", 4466},
      {"tail", 7945},
      {"left hind paw", 6768},
      {"right hind paw", 7003},
      {"left fore paw", 5738},
      {"right fore paw", 6907}},
     12},
    {shared,
     "airplane_8730",
     {{"nose", 8695},
      {"left wing", 8506},
      {"right wing", 8257},
      {"fin", 2053},
      {"left tailplane", 2686},
      {"right tailplane", 2088}},
     12},
    {shared,
     "scorpion_6315",
     {{"tail", 6314},
      {"left claw", 5814},
      {"right claw", 6024},
      {"left leg 1", 4313},
      {"left leg 2", 4304},
      {"left leg 3", 24},
      {"left leg 4", 4817},
      {"right leg 1", 5464},
      {"right leg 2", 5452},
      {"right leg 3", 5554},
      {"right leg 4", 5861}},
     22},
    {shared,
     "scorpion_49997",
     {{"tail", 29583},
      {"left claw", 39966},
      {"right claw", 39969},
      {"left leg 1", 100},
      {"left leg 2", 28507},
      {"left leg 3", 11848},
      {"left leg 4", 26829},
      {"right leg 1", 23401},
      {"right leg 2", 31876},
      {"right leg 3", 18703},
      {"right leg 4", 38813}},
     22},
    {shared,
     "fish_945",
     {{"mouth", 604},
      {"back", 650},
      {"upper tail", 939},
      {"lower tail", 856},
      {"left fin", 897, 0.08},
      {"right fin", 287, 0.08}},
     12},
    {cgal,
     "elephant",
     {{"fore foot", 2759},
      {"other fore foot", 2555},
      {"hind foot", 2047},
      {"other hind foot", 1671},
      {"trunk", 2279},
      {"ear", 1401, 0.1}, // blunt
      {"other ear", 982, 0.1}},
     14},
    {cgal,
     "camel",
     {{"nose", 3548},
      {"hoof 1", 9213},
      {"hoof 2", 9495},
      {"hoof 3", 8802},
      {"hoof 4", 9067},
      {"tail", 512}},
     12},
  };
}

double distance(const Mesh::Point& p, const Mesh::Point& q)
{
  return std::sqrt(CGAL::squared_distance(p, q));
}

// the diagonal of the bounding box
double diameter(const Mesh& mesh)
{
  CGAL::Bbox_3 box;
  for (const auto v : vertices(mesh))
    box += mesh.point(v).bbox();
  return std::hypot(box.x_span(), box.y_span(), box.z_span());
}

std::vector<Mesh::Vertex_index> poles_of(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> poles;
  SMF::detect_feature_poles(mesh, std::back_inserter(poles));
  return poles;
}

double distance_from_poles(const Mesh& mesh,
                           const std::vector<Mesh::Vertex_index>& poles,
                           const Mesh::Point& p)
{
  double result = std::numeric_limits<double>::infinity();
  for (const auto pole : poles)
    result = std::min(result, distance(mesh.point(pole), p));
  return result / diameter(mesh);
}

class Feature_poles_of_meshes : public ::testing::TestWithParam<Shape>
{};

TEST_P(Feature_poles_of_meshes, are_where_a_person_would_put_them)
{
  const Shape& shape = GetParam();
  if (!std::filesystem::exists(shape.path()))
    GTEST_SKIP() << "no " << shape.file;
  Mesh mesh;
  SMF::read_triangle_mesh(shape.path(), mesh);
  const auto poles = poles_of(mesh);
  EXPECT_GE(poles.size(), shape.places.size());
  EXPECT_LE(poles.size(), shape.most);
  for (const Place& place : shape.places)
    EXPECT_LT(distance_from_poles(mesh, poles, mesh.point(smf_test::vertex(place.vertex))),
              place.radius)
      << place.name;
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Feature_poles_of_meshes,
                         ::testing::ValuesIn(shapes()),
                         [](const auto& info) { return info.param.file; });

// Two bodies with the same connectivity: the same vertex is the same place.
TEST(Feature_poles, correspond_on_two_bodies)
{
  if (shared_folder().empty())
    GTEST_SKIP() << "no shared meshes";
  Mesh man, woman;
  SMF::read_triangle_mesh(shared_folder() + "/human_man_6890.off", man);
  SMF::read_triangle_mesh(shared_folder() + "/human_woman_6890.off", woman);
  const auto poles = poles_of(man), others = poles_of(woman);
  for (const auto pole : poles)
    EXPECT_LT(distance_from_poles(woman, others, woman.point(pole)), 0.05);
  for (const auto pole : others)
    EXPECT_LT(distance_from_poles(man, poles, man.point(pole)), 0.05);
}

// Noise of a tenth of an edge length moves no pole far.
TEST(Feature_poles, of_a_noisy_body_are_the_same)
{
  if (shared_folder().empty())
    GTEST_SKIP() << "no shared meshes";
  Mesh man;
  SMF::read_triangle_mesh(shared_folder() + "/human_man_6890.off", man);
  const Mesh noisy = smf_test::noisy(man, 0.1, 1);
  const auto poles = poles_of(noisy);
  EXPECT_EQ(poles.size(), body.size());
  for (const Place& place : body)
    EXPECT_LT(distance_from_poles(man, poles, man.point(smf_test::vertex(place.vertex))), 0.05)
      << place.name;
}

} // namespace
