// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_REQUIRE_H
#define SMF_FUZZ_REQUIRE_H

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <cstdlib>
#include <iostream>
#include <string>

namespace smf_fuzz {

namespace SMF = CGAL::Surface_mesh_foliation;

// whether the environment variable SMF_FUZZ_PRINT wants to see what the bytes of an input mean
inline bool is_printing()
{
  return std::getenv("SMF_FUZZ_PRINT") != nullptr;
}

// a find: libFuzzer keeps the input
inline void require(bool condition, const std::string& what)
{
  if (condition)
    return;
  std::cerr << "found: " << what << std::endl;
  std::abort();
}

// Calls the function, and tells whether it returned. An exception of the package that says in one
// line what is wrong with the input is its right, but for those that blame the package; any other
// exception ends the program. Linear systems may be unsolvable where numbers leave their range.
template <class Function>
bool survives(const Function& function, bool is_solvable = true)
{
  try
  {
    function();
    return true;
  }
  catch (const SMF::Certificate_exception& exception)
  {
    require(false, exception.what());
  }
  catch (const SMF::Solver_exception& exception)
  {
    require(!is_solvable, exception.what());
  }
  catch (const SMF::Foliation_exception& exception)
  {
    const std::string message = exception.what();
    require(!message.empty() && message.find('\n') == std::string::npos,
            "a message that is not one line: " + message);
    require(message == exception.problem().message, "two messages: " + message);
  }
  return false;
}

} // namespace smf_fuzz

#endif // SMF_FUZZ_REQUIRE_H
