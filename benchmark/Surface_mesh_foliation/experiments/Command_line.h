// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_COMMAND_LINE_H
#define SMF_EXPERIMENTS_COMMAND_LINE_H

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

// What all experiments take, and print:
//
//   EXPERIMENT [--shapes NAME,...] [--runs N]
//
// writes a table as CSV to the standard output, and what it is doing to the standard error.

namespace smf_experiments {

struct Options
{
  std::vector<std::string> shapes; // empty: all that there are
  std::size_t runs = 0;            // poses, meshes or levels for each shape
};

inline std::vector<std::string> split(const std::string& line, char separator = ',')
{
  std::vector<std::string> result;
  std::istringstream input(line);
  for (std::string field; std::getline(input, field, separator);)
    result.push_back(field);
  return result;
}

inline Options options(const std::vector<std::string>& arguments, std::size_t runs)
{
  Options result;
  result.runs = runs;
  for (std::size_t i = 0; i < arguments.size(); i += 2)
  {
    if (i + 1 == arguments.size())
      throw std::invalid_argument(arguments[i] + " needs a value");
    if (arguments[i] == "--shapes")
      result.shapes = split(arguments[i + 1]);
    else if (arguments[i] == "--runs")
      result.runs = std::stoul(arguments[i + 1]);
    else
      throw std::invalid_argument("there is no option " + arguments[i] +
                                  "; there are --shapes NAME,... and --runs N");
  }
  return result;
}

// the body of main(): `run` gets the options, whose number of runs is `runs` by default
template <class Run>
int run_experiment(int argc, char* argv[], std::size_t runs, Run run)
{
  try
  {
    run(options({argv + 1, argv + argc}, runs));
    return EXIT_SUCCESS;
  }
  catch (const std::exception& exception)
  {
    std::cerr << exception.what() << std::endl;
    return EXIT_FAILURE;
  }
}

// prints a row of a table
template <class Field, class... Fields>
void print_row(const Field& field, const Fields&... fields)
{
  std::cout << field;
  ((std::cout << ',' << fields), ...);
  std::cout << std::endl;
}

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_COMMAND_LINE_H
