// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARSE_NUMBER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARSE_NUMBER_H

#include <algorithm>
#include <array>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <ios>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

enum class Parse_status {
  OK,
  NOT_A_NUMBER, // the token is not, or not only, a number of the desired type
  OUT_OF_RANGE  // a number that does not fit the type
};

#ifdef __cpp_lib_to_chars
constexpr bool from_chars_knows_doubles = true;
#else // libc++: perhaps integers only
constexpr bool from_chars_knows_doubles = false;
#endif

// reads the whole token as std::from_chars() does
template <class Number>
Parse_status parse_by_from_chars(std::string_view token, Number& number)
{
  const char* const end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, number);
  if (result.ec == std::errc::invalid_argument || result.ptr != end)
    return Parse_status::NOT_A_NUMBER;
  return result.ec == std::errc() ? Parse_status::OK : Parse_status::OUT_OF_RANGE;
}

// removes the leading digits of the text and returns whether there were any
inline bool remove_digits(std::string_view& text)
{
  const std::size_t size = (std::min)(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(size);
  return size != 0;
}

inline bool remove_first(std::string_view& text, std::string_view characters)
{
  if (text.empty() || characters.find(text[0]) == std::string_view::npos)
    return false;
  text.remove_prefix(1);
  return true;
}

// whether the text is a decimal number without a sign, such as `12`, `1.`, `.5` or `1.5e-3`
inline bool is_decimal_number(std::string_view text)
{
  const bool has_digits = remove_digits(text);
  const bool has_decimals = remove_first(text, ".") && remove_digits(text);
  if (!has_digits && !has_decimals)
    return false;
  if (!remove_first(text, "eE"))
    return text.empty();
  remove_first(text, "+-");
  return remove_digits(text) && text.empty();
}

// The value of a decimal number if it is a whole number below 10^15, times or divided by a power of
// ten up to 10^22: both have exact values of type double, so that the one operation rounds right.
// Almost all numbers of a mesh are like that, and streams are slow.
inline std::optional<double> value_of_short_number(std::string_view text)
{
  constexpr std::array<double, 23> powers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                             1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                             1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  double number = 0;
  int exponent = 0;
  bool has_point = false;
  for (; !text.empty() && text[0] != 'e' && text[0] != 'E'; text.remove_prefix(1))
  {
    if (text[0] == '.')
    {
      has_point = true;
      continue;
    }
    number = 10 * number + (text[0] - '0');
    exponent -= has_point;
    if (number >= 1e15)
      return std::nullopt;
  }
  if (!text.empty())
  {
    text.remove_prefix(1);
    remove_first(text, "+");
    int given = 0;
    if (parse_by_from_chars(text, given) != Parse_status::OK || given < -1000 || given > 1000)
      return std::nullopt;
    exponent += given;
  }
  if (FLT_EVAL_METHOD != 0 || exponent < -22 || exponent > 22)
    return std::nullopt;
  return exponent < 0 ? number / powers[static_cast<std::size_t>(-exponent)]
                      : number * powers[static_cast<std::size_t>(exponent)];
}

// `inf`, `infinity`, `nan` and `nan(...)`, in letters of any case
inline bool parse_special_number(std::string_view text, double& number)
{
  std::string lower_case(text);
  for (char& character : lower_case)
    if (character >= 'A' && character <= 'Z')
      character = static_cast<char>(character - 'A' + 'a');
  if (lower_case == "inf" || lower_case == "infinity")
    number = std::numeric_limits<double>::infinity();
  else if (lower_case == "nan" ||
           (lower_case.substr(0, 4) == "nan(" &&
            lower_case.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", 4) ==
              lower_case.size() - 1 &&
            lower_case.back() == ')'))
    number = std::numeric_limits<double>::quiet_NaN();
  else
    return false;
  return true;
}

// The same with a stream, which is slow, for standard libraries whose std::from_chars() knows
// integers only. The text is checked first, since streams accept more than std::from_chars() does;
// then the value alone tells whether it fits, since streams disagree about when reading a tiny
// number has failed.
inline Parse_status parse_by_stream(std::string_view token, double& number)
{
  std::string_view text = token;
  const bool is_negative = remove_first(text, "-");
  double value = 0;
  const bool is_decimal = is_decimal_number(text);
  if (const auto short_value = is_decimal ? value_of_short_number(text) : std::nullopt)
    value = *short_value;
  else if (is_decimal)
  {
    std::istringstream stream{std::string(text)};
    stream.imbue(std::locale::classic());
    stream >> value;
    const std::string_view mantissa = text.substr(0, text.find_first_of("eE"));
    const bool is_zero = mantissa.find_first_of("123456789") == std::string_view::npos;
    if (is_zero)
      value = 0; // even if the exponent is large
    else if (value == 0 || std::isinf(value) ||
             (stream.fail() && value == (std::numeric_limits<double>::max)()))
      return Parse_status::OUT_OF_RANGE;
  }
  else if (!parse_special_number(text, value))
    return Parse_status::NOT_A_NUMBER;
  number = is_negative ? -value : value;
  return Parse_status::OK;
}

// reads the whole token as a number, independently of the locale. `Number` is `double` or an
// integer type; `inf` and `nan` are numbers of type `double`.
template <class Number>
Parse_status parse_number(std::string_view token, Number& number)
{
  // std::from_chars() does not accept a plus sign
  if (token.size() > 1 && token[0] == '+' && token[1] != '-')
    token.remove_prefix(1);
  if constexpr (std::is_floating_point_v<Number> && !from_chars_knows_doubles)
    return parse_by_stream(token, number);
  else
    return parse_by_from_chars(token, number);
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_PARSE_NUMBER_H
