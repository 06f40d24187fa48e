// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_BENCHMARK_TABLE_H
#define SMF_BENCHMARK_TABLE_H

#include "benchmark_mesh.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

// Tables in units of one analysis, factorization and solve by Eigen::SimplicialLDLT.

namespace smf_benchmark {

// as One_solve wants it
struct Eigen_solver
{
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt;
  void analyze_pattern(const Eigen::SparseMatrix<double>& matrix) { ldlt.analyzePattern(matrix); }
  void factorize(const Eigen::SparseMatrix<double>& matrix) { ldlt.factorize(matrix); }
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side) const { return ldlt.solve(right_side); }
};

inline double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// what is measured, each with the seconds of its runs
class Series
{
public:
  template <class Run>
  void measure(const std::string& name, const Run& run)
  {
    const double seconds = seconds_of(run);
    for (auto& [other, all] : m_seconds)
      if (other == name)
      {
        all.push_back(seconds);
        return;
      }
    m_seconds.push_back({name, {seconds}});
  }

  double operator[](const std::string& name) const
  {
    for (const auto& [other, all] : m_seconds)
      if (other == name)
        return median(all);
    return 0;
  }

private:
  std::vector<std::pair<std::string, std::vector<double>>> m_seconds;
};

inline void print_row(const std::vector<std::string>& cells)
{
  for (const std::string& cell : cells)
    std::cout << "| " << cell << ' ';
  std::cout << '|' << std::endl;
}

inline void print_header(const std::vector<std::string>& titles)
{
  print_row(titles);
  print_row(std::vector<std::string>(titles.size(), "---"));
}

inline std::string number(double value, const char* format = "%.2f")
{
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// A table of series, in units of their "solve". A row has its number of vertices and a series.
template <class Row>
void print_in_solves(const std::vector<Row>& rows, const std::vector<std::string>& columns)
{
  std::vector<std::string> titles = {"vertices"};
  titles.insert(titles.end(), columns.begin(), columns.end());
  print_header(titles);
  for (const Row& row : rows)
  {
    std::vector<std::string> cells = {std::to_string(row.vertices)};
    for (const std::string& column : columns)
      cells.push_back(number(row.series[column] / row.series["solve"]));
    print_row(cells);
  }
  std::cout << std::endl;
}

// the number behind an option
inline int value_of(const std::string& argument, const std::string& option, int otherwise)
{
  return argument.rfind(option, 0) == 0 ? std::atoi(argument.c_str() + option.size()) : otherwise;
}

} // namespace smf_benchmark

#endif // SMF_BENCHMARK_TABLE_H
