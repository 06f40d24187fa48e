// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_FEATURE_PLACES_H
#define SMF_TEST_FEATURE_PLACES_H

#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

// The ends of limbs of real meshes, chosen by looking at pictures of them: the outermost vertex of
// a limb in a direction along it.

namespace smf_test {

// where a person would put a pole
struct Place
{
  std::string name;
  std::size_t vertex;
  double radius = 0.05; // in diameters of the mesh
};

// a mesh with its places, and the largest number of poles that is reasonable
struct Shape
{
  std::string folder, file;
  std::vector<Place> places;
  std::size_t most; // poles

  std::string path() const { return folder + "/" + file + ".off"; }
};

inline std::ostream& operator<<(std::ostream& out, const Shape& shape)
{
  return out << shape.file;
}

inline std::string shared_folder()
{
  const std::string folder = SMF_SHARED_DIR;
  return folder.empty() ? folder : folder + "/meshes";
}

inline const std::vector<Place> places_of_body = {{"head", 411},
                                                  {"left hand", 2445},
                                                  {"right hand", 5906},
                                                  {"left foot", 3217},
                                                  {"right foot", 6617}};

inline std::vector<Shape> shapes()
{
  const std::string shared = shared_folder(), cgal = SMF_DATA_DIR;
  return {
    {shared, "human_man_6890", places_of_body, 5},
    {shared, "human_woman_6890", places_of_body, 5},
    {shared,
     "hand_7993",
     {{"thumb", 10},
      {"index finger", 1046},
      {"middle finger", 2146},
      {"ring finger", 3059},
      {"little finger", 3455},
      {"wrist", 5880, 0.12}}, // the middle of a flat end
     12},
    {shared,
     "cat_7949",
     {{"nose", 4160}, // the foremost vertex of the head
      {"tail", 7945},
      {"left hind paw", 6768},
      {"right hind paw", 7003},
      {"left fore paw", 6302, 0.08}, // its foremost vertex; it lies on the right one
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

// the one of this file
inline Shape shape(const std::string& file)
{
  for (const Shape& result : shapes())
    if (result.file == file)
      return result;
  throw std::invalid_argument("no shape " + file);
}

} // namespace smf_test

#endif // SMF_TEST_FEATURE_PLACES_H
