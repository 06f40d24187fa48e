// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "problems.h"

#include <cctype>
#include <cstddef>
#include <string>

namespace smf_engine {

namespace {

// a loop of the package in words
std::string name_of_loop(std::size_t loop,
                         const Loop_numbers& numbers,
                         const std::vector<State_pole>& poles)
{
  if (numbers.loop(loop) >= 0)
    return "loop " + std::to_string(numbers.loop(loop));
  const int pole = numbers.pole_of_loop(loop);
  return pole < 0 ? "the loop around opening " + std::to_string(loop)
                  : "the loop around the pole at vertex " +
                      std::to_string(poles[static_cast<std::size_t>(pole)].vertex);
}

bool is_digit(char character)
{
  return std::isdigit(static_cast<unsigned char>(character)) != 0;
}

// Replaces the number that begins at `position` by the name of that loop; returns whether there
// was one. `position` moves behind it.
bool replace_number(std::string& message,
                    std::size_t& position,
                    const Loop_numbers& numbers,
                    const std::vector<State_pole>& poles)
{
  std::size_t end = position;
  while (end < message.size() && is_digit(message[end]))
    ++end;
  if (end == position)
    return false;
  const std::string name =
    name_of_loop(std::stoul(message.substr(position, end - position)), numbers, poles);
  message.replace(position, end - position, name);
  position += name.size();
  return true;
}

// "loop 5" and "loops 5 and 7" become the names of these
std::string rename_loops(std::string message,
                         const Loop_numbers& numbers,
                         const std::vector<State_pole>& poles)
{
  const std::string link = " and ";
  for (std::size_t word = message.find("loop"); word != std::string::npos;
       word = message.find("loop", word))
  {
    std::size_t number = word + 4;
    if (message.compare(number, 1, "s") == 0)
      ++number;
    if (message.compare(number, 1, " ") != 0 || number + 1 >= message.size() ||
        !is_digit(message[number + 1]))
    {
      word = number;
      continue;
    }
    message.erase(word, number + 1 - word);
    replace_number(message, word, numbers, poles);
    if (message.compare(word, link.size(), link) == 0)
    {
      std::size_t second = word + link.size();
      if (replace_number(message, second, numbers, poles))
        word = second;
    }
  }
  return message;
}

} // namespace

SMF::Problem in_terms_of_state(const SMF::Problem& problem,
                               const Loop_numbers& numbers,
                               const std::vector<State_pole>& poles)
{
  SMF::Problem result = problem;
  result.message = rename_loops(result.message, numbers, poles);
  result.loops.clear();
  for (const std::size_t loop : problem.loops)
    if (numbers.loop(loop) >= 0)
      result.loops.push_back(static_cast<std::size_t>(numbers.loop(loop)));
    else if (numbers.pole_of_loop(loop) >= 0)
      result.vertices.push_back(poles[static_cast<std::size_t>(numbers.pole_of_loop(loop))].vertex);
  return result;
}

} // namespace smf_engine
