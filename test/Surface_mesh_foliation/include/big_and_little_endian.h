// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_BIG_AND_LITTLE_ENDIAN_H
#define SMF_TEST_BIG_AND_LITTLE_ENDIAN_H

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace smf_test {

// the bytes of a number, the least significant one first, whatever the byte order of the machine
template <class Number>
std::string little_endian_bytes(Number number)
{
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(Number));
  const std::uint16_t one = 1;
  char first_byte;
  std::memcpy(&first_byte, &one, 1);
  if (first_byte != 1)
    std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

template <class Number>
std::string big_endian_bytes(Number number)
{
  const std::string bytes = little_endian_bytes(number);
  return std::string(bytes.rbegin(), bytes.rend());
}

} // namespace smf_test

#endif // SMF_TEST_BIG_AND_LITTLE_ENDIAN_H
