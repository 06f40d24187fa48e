// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers in texts, by std::from_chars() and by streams.

#include <CGAL/Surface_mesh_foliation/internal/Common/parse_number.h>

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

namespace test_parse_number {

using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

template <class Number>
Parse_status status_of(std::string_view token)
{
  Number ignored{};
  return parse_number(token, ignored);
}

template <class Number>
Number parsed(std::string_view token)
{
  Number result{};
  EXPECT_EQ(parse_number(token, result), Parse_status::OK) << token;
  return result;
}

// with up to 18 digits before and after the point, and exponents up to 40
std::string random_decimal_number(smf_test::Random& random)
{
  std::string text;
  const auto add_digits = [&](std::size_t number) {
    for (std::size_t i = 0; i < number; ++i)
      text += static_cast<char>('0' + random.index(10));
  };
  add_digits(1 + random.index(9 * (1 + random.index(2))));
  if (random.index(4) > 0)
    text += '.';
  if (text.back() == '.')
    add_digits(random.index(9 * (1 + random.index(2))));
  if (random.index(2) == 0)
  {
    text += random.index(2) == 0 ? "e-" : "E";
    text += std::to_string(random.index(41));
  }
  return text;
}

} // namespace

TEST(Parse_number, reads_doubles_to_the_last_bit)
{
  EXPECT_EQ(parsed<double>("0.1"), 0.1);
  EXPECT_EQ(parsed<double>("-1e-3"), -1e-3);
  EXPECT_EQ(parsed<double>("+2.5E+2"), 250);
  EXPECT_EQ(parsed<double>(".5"), 0.5);
  EXPECT_EQ(parsed<double>("5."), 5);
  EXPECT_EQ(parsed<double>("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(parsed<double>("4.9e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::signbit(parsed<double>("-0")));
  EXPECT_EQ(parsed<double>("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(parsed<double>("nan")));
}

TEST(Parse_number, reads_integers_up_to_their_limits)
{
  EXPECT_EQ(parsed<int>("+7"), 7);
  EXPECT_EQ(parsed<int>("-0"), 0);
  EXPECT_EQ(parsed<int>("2147483647"), 2147483647);
  EXPECT_EQ(parsed<std::int64_t>("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(status_of<int>("2147483648"), Parse_status::OUT_OF_RANGE);
  EXPECT_EQ(status_of<std::uint64_t>("18446744073709551616"), Parse_status::OUT_OF_RANGE);
}

TEST(Parse_number, refuses_all_but_a_whole_number)
{
  for (const char* token :
       {"", "+", "-", "+-1", "-+1", "++1", "1 ", " 1", "1x", "1,5", "0x10", "1e", "."})
  {
    EXPECT_EQ(status_of<double>(token), Parse_status::NOT_A_NUMBER) << token;
    EXPECT_EQ(status_of<int>(token), Parse_status::NOT_A_NUMBER) << token;
  }
  for (const char* token : {"1.0", "1e2", "inf", "99999999999999999999x"})
    EXPECT_EQ(status_of<int>(token), Parse_status::NOT_A_NUMBER) << token;
  EXPECT_EQ(status_of<unsigned>("-1"), Parse_status::NOT_A_NUMBER);
  EXPECT_EQ(status_of<double>(std::string_view("1\0", 2)), Parse_status::NOT_A_NUMBER);
}

TEST(Parse_number, tells_numbers_that_do_not_fit_from_nonsense)
{
  EXPECT_EQ(status_of<double>("1e999"), Parse_status::OUT_OF_RANGE);
  EXPECT_EQ(status_of<double>("-1e999"), Parse_status::OUT_OF_RANGE);
  EXPECT_EQ(status_of<double>("1e999x"), Parse_status::NOT_A_NUMBER);
}

// What a standard library whose std::from_chars() knows integers only has to use.
TEST(Parse_by_stream, does_the_same_as_from_chars)
{
  for (const std::string text : {"0",
                                 "-0",
                                 "1",
                                 "-1.5",
                                 "5.",
                                 ".5",
                                 "-.5",
                                 "5.e3",
                                 "1E5",
                                 "1e+5",
                                 "1e-5",
                                 "0.1",
                                 "1e23",
                                 "123456789012345678901234567890",
                                 "1.7976931348623157e308",
                                 "1.7976931348623158e308",
                                 "1.7976931348623159e308",
                                 "1e999",
                                 "-1e999",
                                 "1e99999999999999999999",
                                 "0e999",
                                 "-0.0e99999999999999999999",
                                 "1e-308",
                                 "2.2250738585072011e-308",
                                 "4.9e-324",
                                 "-3e-324",
                                 "2.4703282292062328e-324",
                                 "2.4703282292062327e-324",
                                 "1e-400",
                                 "-1e-400",
                                 "1e-99999999999999999999",
                                 "0e-400",
                                 "nan",
                                 "-NaN",
                                 "nan()",
                                 "nan(a_1)",
                                 "nan(",
                                 "nan(a b)",
                                 "nan(a-b)",
                                 "nan()x",
                                 "inf",
                                 "-INF",
                                 "Infinity",
                                 "infinit",
                                 "infinity1",
                                 "",
                                 "+",
                                 "-",
                                 ".",
                                 "-.",
                                 "e5",
                                 ".e5",
                                 "1e",
                                 "1e+",
                                 "1e-",
                                 "1e5.",
                                 "1e5e5",
                                 "1.2.3",
                                 "+1",
                                 "++1",
                                 "+-1",
                                 "-+1",
                                 "--1",
                                 " 1",
                                 "1 ",
                                 "\t1",
                                 "1\n",
                                 "1,5",
                                 "1.000,5",
                                 "1'000",
                                 "0x10",
                                 "0x1p3",
                                 "1p3",
                                 "1.5abc",
                                 "1f",
                                 "1d5",
                                 "a",
                                 "1_0"})
  {
    for (const std::string& token : {text, text + "x", text + std::string(1, '\0')})
    {
      double number = 0, expected = 0;
      const Parse_status status = parse_by_stream(token, number);
#ifdef __cpp_lib_to_chars
      EXPECT_EQ(status, parse_by_from_chars(token, expected)) << token;
#else
      expected = std::strtod(token.c_str(), nullptr);
#endif
      if (status != Parse_status::OK)
        continue;
      EXPECT_TRUE(number == expected || (std::isnan(number) && std::isnan(expected)))
        << token << " is read as " << number;
      if (std::isnan(number)) // whose sign differs from one processor to the next
        continue;
      EXPECT_EQ(std::signbit(number), std::signbit(expected)) << token;
    }
  }
}

TEST(Parse_by_stream, rounds_numbers_of_any_length_right)
{
  smf_test::Random random(4);
  for (int i = 0; i < 20000; ++i)
  {
    const std::string token = random_decimal_number(random);
    double number = 0;
    EXPECT_EQ(parse_by_stream(token, number), Parse_status::OK) << token;
    EXPECT_EQ(number, std::strtod(token.c_str(), nullptr)) << token;
  }
}

TEST(Parse_by_stream, tells_numbers_that_do_not_fit_from_nonsense)
{
  const auto status_of = [](std::string_view token) {
    double ignored = 0;
    return parse_by_stream(token, ignored);
  };
  for (const char* token : {"1.5", "1.7976931348623157e308", "4.9e-324", "0e999", "inf", "nan(1)"})
    EXPECT_EQ(status_of(token), Parse_status::OK) << token;
  for (const char* token : {"1e999", "-1e999", "1e-400", "1.7976931348623159e308"})
    EXPECT_EQ(status_of(token), Parse_status::OUT_OF_RANGE) << token;
  for (const char* token : {"", "+1", " 1", "1 ", "1e", "0x1p3", "1.5abc", "nan(", "1e999x"})
    EXPECT_EQ(status_of(token), Parse_status::NOT_A_NUMBER) << token;
}

} // namespace test_parse_number
