// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_NUMBER_FROM_ENVIRONMENT_H
#define SMF_TEST_NUMBER_FROM_ENVIRONMENT_H

#include <cstddef>
#include <cstdlib>

namespace smf_test {

// the value of an environment variable that says how much a test does
inline std::size_t number_from_environment(const char* name, std::size_t otherwise)
{
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

} // namespace smf_test

#endif // SMF_TEST_NUMBER_FROM_ENVIRONMENT_H
