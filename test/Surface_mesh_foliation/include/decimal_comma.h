// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_DECIMAL_COMMA_H
#define SMF_TEST_DECIMAL_COMMA_H

#include <locale>
#include <string>

namespace smf_test {

// a locale in which 1234.5 is written 1.2.3.4,5
struct Decimal_comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\1"; }
};

} // namespace smf_test

#endif // SMF_TEST_DECIMAL_COMMA_H
