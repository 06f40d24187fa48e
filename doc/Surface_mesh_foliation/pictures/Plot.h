// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PICTURES_PLOT_H
#define SMF_PICTURES_PLOT_H

#include "Canvas.h"
#include "Vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Curves, by number, of points whose x and y are powers of ten.
using Curves = std::map<int, std::vector<Vector>>;

// Reads the lines `curve x y` of a file.
inline Curves read_curves(const std::string& file_name)
{
  std::ifstream input(file_name);
  Curves result;
  int curve;
  for (double x, y; input >> curve >> x >> y;)
  {
    if (x <= 0 || y <= 0)
      throw std::runtime_error(file_name + " has a number that is not positive");
    result[curve].push_back({std::log10(x), std::log10(y), 0});
  }
  if (result.empty() || !input.eof())
    throw std::runtime_error(file_name + " cannot be read");
  return result;
}

// A diagram with logarithmic axes: a grid of powers of ten with their numbers, and curves. Curves
// of few points have the points marked.
class Plot
{
public:
  Plot(Canvas& canvas, Curves curves) : m_canvas(canvas), m_curves(std::move(curves))
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    m_lower = {infinity, infinity, 0};
    m_upper = {-infinity, -infinity, 0};
    for (const auto& [curve, points] : m_curves)
      for (const Vector& p : points)
      {
        m_lower = {std::min(m_lower.x, std::floor(p.x)), std::min(m_lower.y, std::floor(p.y)), 0};
        m_upper = {std::max(m_upper.x, std::ceil(p.x)), std::max(m_upper.y, std::ceil(p.y)), 0};
      }
    m_upper.x = std::max(m_upper.x, m_lower.x + 1);
    m_upper.y = std::max(m_upper.y, m_lower.y + 1);
  }

  void draw()
  {
    draw_curves();
    draw_grid();
  }

private:
  // in units of the canvas's height
  static constexpr double left_margin = 0.17, lower_margin = 0.13, other_margin = 0.06,
                          digit_height = 0.042, thin = 0.0015, thick = 0.005;
  static constexpr std::size_t most_marks = 20;

  double unit() const { return m_canvas.height(); }

  Vector place(const Vector& p) const
  {
    const double width = m_canvas.width() - (left_margin + other_margin) * unit();
    const double height = (1 - lower_margin - other_margin) * unit();
    return {left_margin * unit() + width * (p.x - m_lower.x) / (m_upper.x - m_lower.x),
            lower_margin * unit() + height * (p.y - m_lower.y) / (m_upper.y - m_lower.y), 0};
  }

  void draw_curves()
  {
    const std::array<Vector, 4> colors = {
      Vector{0.8, 0.15, 0.15}, {0.95, 0.6, 0.1}, {0.1, 0.25, 0.85}, {0.15, 0.65, 0.3}};
    for (const auto& [curve, points] : m_curves)
    {
      const Vector& color = colors.at(static_cast<std::size_t>(curve));
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Vector p = place(points[i]);
        m_canvas.draw_stroke(place(points[i == 0 ? 0 : i - 1]), p, thick * unit(), 1, color);
        if (points.size() < most_marks)
          m_canvas.draw_stroke(p, p, 2.5 * thick * unit(), 2, color);
      }
    }
  }

  void draw_grid()
  {
    const Vector gray = {0.8, 0.8, 0.82};
    constexpr int step = 2; // of the powers that have a number
    const auto line = [&](const Vector& a, const Vector& b) {
      m_canvas.draw_stroke(place(a), place(b), thin * unit(), 0, gray);
    };
    for (double x = m_lower.x; x <= m_upper.x; ++x)
    {
      line({x, m_lower.y, 0}, {x, m_upper.y, 0});
      draw_power(place({x, m_lower.y, 0}) - unit() * Vector{0.04, 0.07, 0}, std::lround(x));
    }
    for (double y = m_lower.y; y <= m_upper.y; ++y)
    {
      line({m_lower.x, y, 0}, {m_upper.x, y, 0});
      if (std::lround(y) % step == 0)
        draw_power(place({m_lower.x, y, 0}) - unit() * Vector{0.15, 0.02, 0}, std::lround(y));
    }
  }

  // the number 10^exponent, from its lower left corner
  void draw_power(Vector p, long exponent)
  {
    draw_text(p, digit_height * unit(), "10");
    p = p + unit() * digit_height * Vector{1.75, 0.6, 0};
    draw_text(p, 0.65 * digit_height * unit(), std::to_string(exponent));
  }

  // digits and minus signs
  void draw_text(Vector p, double height, const std::string& text)
  {
    for (char c : text)
    {
      draw_segments(p, height, c == '-' ? 0x40 : segments.at(static_cast<std::size_t>(c - '0')));
      p.x += 0.8 * height;
    }
  }

  // the segments of a digit, as bits: from the upper one clockwise, then the one in the middle
  static constexpr std::array<int, 10> segments = {0x3f, 0x06, 0x5b, 0x4f, 0x66,
                                                   0x6d, 0x7d, 0x07, 0x7f, 0x6f};

  void draw_segments(const Vector& p, double height, int bits)
  {
    const double half = height / 2;
    const std::array<Vector, 6> corners = {Vector{0, height, 0}, {half, height, 0}, {half, half, 0},
                                           {half, 0, 0},         {0, 0, 0},         {0, half, 0}};
    for (std::size_t i = 0; i < 7; ++i)
      if ((bits >> i & 1) != 0)
      {
        const Vector a = i < 6 ? corners[i] : corners[5],
                     b = i < 6 ? corners[(i + 1) % 6] : corners[2];
        m_canvas.draw_stroke(p + a, p + b, 0.07 * height, 1, {0.2, 0.2, 0.22});
      }
  }

  Canvas& m_canvas;
  Curves m_curves;
  Vector m_lower, m_upper; // the exponents at the ends of the axes
};

#endif // SMF_PICTURES_PLOT_H
