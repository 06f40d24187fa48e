// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_EXACT_SUM_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_EXACT_SUM_H

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

// Whether three points lie on a line, exactly, without CGAL's exact kernels: parsing these takes
// longer than parsing all of this package.

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A sum of products of doubles, exact for all that are finite: a long fixed-point number, in which
// the product of the two least ones and that of the two largest ones have their places. It has room
// for some thousands of products.
class Exact_sum
{
public:
  void add_product(double x, double y)
  {
    const Binary a(x), b(y);
    const std::int64_t sign = (a.mantissa < 0) == (b.mantissa < 0) ? 1 : -1;
    const std::uint64_t a_low = a.size() & half_mask, a_high = a.size() >> half,
                        b_low = b.size() & half_mask, b_high = b.size() >> half;
    const int place = a.place + b.place;
    add(sign, a_low * b_low, place);
    add(sign, a_low * b_high, place + half);
    add(sign, a_high * b_low, place + half);
    add(sign, a_high * b_high, place + 2 * half);
  }

  bool is_zero() const
  {
    std::int64_t carry = 0;
    for (const std::int64_t digit : m_digits)
    {
      const std::int64_t sum = digit + carry;
      if (sum % base != 0)
        return false;
      carry = sum / base;
    }
    return carry == 0;
  }

private:
  static constexpr int bits_of_mantissa = 53, half = 27, bits_of_digit = 32;
  static constexpr std::int64_t base = std::int64_t(1) << bits_of_digit;
  static constexpr std::uint64_t half_mask = (std::uint64_t(1) << half) - 1,
                                 digit_mask = (std::uint64_t(1) << bits_of_digit) - 1;
  // of the last bit of the mantissa of the least positive double, 2^-1074, and the largest one
  static constexpr int least_exponent = -1073 - bits_of_mantissa,
                       largest_exponent = 1024 - bits_of_mantissa;
  static constexpr std::size_t number_of_digits =
    (2 * (largest_exponent - least_exponent) + 2 * bits_of_mantissa) / bits_of_digit + 3;

  // a double, its mantissa a whole number
  struct Binary
  {
    explicit Binary(double x)
    {
      int exponent = 0;
      mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), bits_of_mantissa));
      place = mantissa == 0 ? 0 : exponent - bits_of_mantissa - least_exponent;
    }
    std::uint64_t size() const { return static_cast<std::uint64_t>(std::abs(mantissa)); }

    std::int64_t mantissa;
    int place; // of its last bit, not negative
  };

  // `part` is less than 2^54
  void add(std::int64_t sign, std::uint64_t part, int place)
  {
    auto i = static_cast<std::size_t>(place / bits_of_digit);
    for (const std::uint64_t piece : {part & digit_mask, part >> bits_of_digit})
    {
      const std::uint64_t shifted = piece << (place % bits_of_digit);
      m_digits[i] += sign * static_cast<std::int64_t>(shifted & digit_mask);
      m_digits[++i] += sign * static_cast<std::int64_t>(shifted >> bits_of_digit);
    }
  }

  std::array<std::int64_t, number_of_digits> m_digits{}; // the least first; of any sign and size
};

// Two edges of the triangle are parallel if all components of their cross product vanish.
inline bool are_collinear(const std::array<double, 3>& a,
                          const std::array<double, 3>& b,
                          const std::array<double, 3>& c)
{
  for (const std::size_t i : {0, 1, 2})
  {
    const std::size_t j = (i + 1) % 3;
    Exact_sum component; // (b - a)_i (c - a)_j - (b - a)_j (c - a)_i
    component.add_product(b[i], c[j]);
    component.add_product(-b[i], a[j]);
    component.add_product(-a[i], c[j]);
    component.add_product(-b[j], c[i]);
    component.add_product(b[j], a[i]);
    component.add_product(a[j], c[i]);
    if (!component.is_zero())
      return false;
  }
  return true;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_MESH_EXACT_SUM_H
