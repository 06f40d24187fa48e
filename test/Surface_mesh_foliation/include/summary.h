// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_SUMMARY_H
#define SMF_TEST_SUMMARY_H

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace smf_test {

// What the package says about a mesh, in numbers and texts that do not depend on the type of the
// mesh. Vertices and faces are given by their positions.
struct Summary
{
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::string> files;

  template <class Point>
  void add(const std::string& key, const Point& p)
  {
    for (const double x : {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())})
      numbers[key].push_back(x);
  }
};

inline void expect_equal(const Summary& found, const Summary& expected)
{
  EXPECT_EQ(found.numbers.size(), expected.numbers.size());
  for (const auto& [key, numbers] : expected.numbers)
  {
    const auto it = found.numbers.find(key);
    EXPECT_TRUE(it != found.numbers.end() && it->second == numbers) << "different: " << key;
  }
  for (const auto& [name, text] : expected.files)
  {
    const auto it = found.files.find(name);
    EXPECT_TRUE(it != found.files.end() && it->second == text) << "different file: " << name;
  }
}

} // namespace smf_test

#endif // SMF_TEST_SUMMARY_H
