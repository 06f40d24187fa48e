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

const char* name_of(SMF::Problem_kind kind)
{
  using Kind = SMF::Problem_kind;
  switch (kind)
  {
  case Kind::FILE:
    return "file";
  case Kind::EMPTY_MESH:
    return "empty_mesh";
  case Kind::TOO_LARGE:
    return "too_large";
  case Kind::NOT_TRIANGLE_MESH:
    return "not_triangle_mesh";
  case Kind::NOT_CLOSED:
    return "not_closed";
  case Kind::NOT_MANIFOLD:
    return "not_manifold";
  case Kind::NOT_ORIENTABLE:
    return "not_orientable";
  case Kind::NOT_CONNECTED:
    return "not_connected";
  case Kind::ISOLATED_VERTEX:
    return "isolated_vertex";
  case Kind::NOT_FINITE:
    return "not_finite";
  case Kind::DEGENERATE_FACE:
    return "degenerate_face";
  case Kind::INVALID_POLE:
    return "invalid_pole";
  case Kind::INVALID_LOOP:
    return "invalid_loop";
  case Kind::INTERSECTING_LOOPS:
    return "intersecting_loops";
  case Kind::INESSENTIAL_LOOP:
    return "inessential_loop";
  case Kind::HOMOTOPIC_LOOPS:
    return "homotopic_loops";
  case Kind::NO_LOOP:
    return "no_loop";
  case Kind::INVALID_HEIGHT:
    return "invalid_height";
  case Kind::INVALID_WEIGHT:
    return "invalid_weight";
  case Kind::INVALID_EDGE_VALUE:
    return "invalid_edge_value";
  case Kind::OPEN_LEAF:
    return "open_leaf";
  case Kind::UNRESOLVED_LEAF:
    return "unresolved_leaf";
  case Kind::INVALID_PARAMETER:
    return "invalid_parameter";
  case Kind::SOLVER_FAILURE:
    return "solver_failure";
  case Kind::STOPPED:
    return "stopped";
  case Kind::CERTIFICATE_FAILURE:
    return "certificate_failure";
  }
  return "internal";
}

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
