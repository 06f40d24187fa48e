// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PICTURES_CANVAS_H
#define SMF_PICTURES_CANVAS_H

#include "Vector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// How a surface reflects light: one light from the upper left, one from the right, both in front.
inline Vector shade(const Vector& color, const Vector& normal, double gloss)
{
  const Vector key = unit({-0.45, 0.55, 0.75}), fill = unit({0.8, -0.1, 0.5});
  const double diffuse =
    0.34 + 0.56 * std::max(0., dot(normal, key)) + 0.18 * std::max(0., dot(normal, fill));
  const Vector half = unit(key + Vector{0, 0, 1});
  const double highlight = gloss * std::pow(std::max(0., dot(normal, half)), 40);
  return diffuse * color + Vector{highlight, highlight, highlight};
}

// A corner of a triangle in canvas coordinates: x to the right, y up, in sub-pixels from the lower
// left corner; z toward the viewer.
struct Corner
{
  Vector position, normal;
};

// An image with a z-buffer, three times as wide and high as the picture that it will be scaled down
// to. Opaque objects hide each other; translucent triangles are kept and blended at the end.
class Canvas
{
public:
  static constexpr int subpixels = 3;

  Canvas(int width, int height)
    : m_width(subpixels * width),
      m_height(subpixels * height),
      m_pixels(static_cast<std::size_t>(m_width) * m_height)
  {}

  int width() const { return m_width; }
  int height() const { return m_height; }

  void draw_triangle(const std::array<Corner, 3>& corners, const Vector& color)
  {
    draw_triangle(corners, [&](const Vector&) { return color; });
  }

  // color_at(weights) is the color of the point with these barycentric coordinates
  template <class ColorAt>
  auto draw_triangle(const std::array<Corner, 3>& corners, const ColorAt& color_at)
    -> decltype(color_at(Vector()), void())
  {
    rasterize(corners, [&](Pixel& pixel, double z, const Vector& normal, const Vector& weights) {
      if (z > pixel.z)
        pixel.set(z, shade(color_at(weights), normal.z < 0 ? -1 * normal : normal, 0.08));
    });
  }

  // Like glass: more opaque where it is seen from the side.
  void draw_translucent_triangle(const std::array<Corner, 3>& corners, const Vector& color)
  {
    rasterize(corners, [&](Pixel& pixel, double z, const Vector& normal, const Vector&) {
      const Vector toward_viewer = normal.z < 0 ? -1 * normal : normal;
      const double opacity = 0.22 + 0.5 * std::pow(1 - toward_viewer.z, 2);
      m_fragments.push_back({z, opacity, shade(color, toward_viewer, 0.05), pixel.last_fragment});
      pixel.last_fragment = static_cast<int>(m_fragments.size()) - 1;
    });
  }

  // A flat stroke with round ends. It hides what is up to `lift` in front of it, so that lines on a
  // surface are visible.
  void draw_stroke(
    const Vector& a, const Vector& b, double radius, double lift, const Vector& color)
  {
    rasterize_capsule(a, b, radius, [&](Pixel& pixel, double z, double, double, double) {
      if (z + lift > pixel.z)
        pixel.set(z + lift, color);
    });
  }

  // A tube with round ends, or a ball if both ends are the same.
  void draw_tube(const Vector& a, const Vector& b, double radius, const Vector& color)
  {
    const double gloss = a.x == b.x && a.y == b.y ? 0.35 : 0.08;
    rasterize_capsule(a, b, radius, [&](Pixel& pixel, double z, double x, double y, double rest) {
      const double bulge = std::sqrt(std::max(0., rest));
      if (z + radius * bulge > pixel.z)
        pixel.set(z + radius * bulge, shade(color, {x, y, bulge}, gloss));
    });
  }

  // The picture, row by row from the top, three bytes per pixel.
  std::vector<unsigned char> picture()
  {
    blend();
    constexpr int area = subpixels * subpixels;
    constexpr int step = 5; // fewer colors make a smaller file
    std::vector<unsigned char> result;
    for (int y = m_height - subpixels; y >= 0; y -= subpixels)
      for (int x = 0; x < m_width; x += subpixels)
      {
        Vector sum;
        for (int i = 0; i < area; ++i)
          sum = sum + pixel(x + i % subpixels, y + i / subpixels).clamped_color();
        for (double channel : {sum.x, sum.y, sum.z})
          result.push_back(
            static_cast<unsigned char>(step * std::lround(255 * channel / (area * step))));
      }
    return result;
  }

private:
  struct Pixel
  {
    double z = -std::numeric_limits<double>::infinity();
    Vector color = {1, 1, 1};
    int last_fragment = -1;

    void set(double new_z, const Vector& new_color)
    {
      z = new_z;
      color = new_color;
    }

    Vector clamped_color() const
    {
      return {std::clamp(color.x, 0., 1.), std::clamp(color.y, 0., 1.),
              std::clamp(color.z, 0., 1.)};
    }
  };

  // A piece of a translucent triangle in one pixel; `previous` is the next one of that pixel.
  struct Fragment
  {
    double z, opacity;
    Vector color;
    int previous;
  };

  Pixel& pixel(int x, int y) { return m_pixels[static_cast<std::size_t>(y) * m_width + x]; }

  // Calls `draw(pixel, z, normal, weights of the corners)` for all pixels with their center in the
  // triangle.
  template <class Draw>
  void rasterize(const std::array<Corner, 3>& corners, Draw draw)
  {
    const Vector &a = corners[0].position, &b = corners[1].position, &c = corners[2].position;
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0)
      return;
    for (int y = first(std::min({a.y, b.y, c.y})); y <= last(std::max({a.y, b.y, c.y}), m_height);
         ++y)
      for (int x = first(std::min({a.x, b.x, c.x})); x <= last(std::max({a.x, b.x, c.x}), m_width);
           ++x)
      {
        const double px = x + 0.5, py = y + 0.5;
        const double u = ((b.x - px) * (c.y - py) - (b.y - py) * (c.x - px)) / area;
        const double v = ((c.x - px) * (a.y - py) - (c.y - py) * (a.x - px)) / area;
        const double w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0)
          continue;
        const Vector normal = u * corners[0].normal + v * corners[1].normal + w * corners[2].normal;
        draw(pixel(x, y), u * a.z + v * b.z + w * c.z, unit(normal), Vector{u, v, w});
      }
  }

  // Calls `draw(pixel, z, x, y, rest)` for all pixels with their center near the segment, where z
  // is that of the nearest point of the segment, (x, y) the way from it in radii, and
  // rest = 1 - x² - y².
  template <class Draw>
  void rasterize_capsule(const Vector& a, const Vector& b, double radius, Draw draw)
  {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    for (int y = first(std::min(a.y, b.y) - radius);
         y <= last(std::max(a.y, b.y) + radius, m_height); ++y)
      for (int x = first(std::min(a.x, b.x) - radius);
           x <= last(std::max(a.x, b.x) + radius, m_width); ++x)
      {
        const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
        const double t = square > 0 ? std::clamp((px * dx + py * dy) / square, 0., 1.) : 0;
        const double qx = (px - t * dx) / radius, qy = (py - t * dy) / radius;
        const double rest = 1 - qx * qx - qy * qy;
        if (rest >= 0)
          draw(pixel(x, y), a.z + t * (b.z - a.z), qx, qy, rest);
      }
  }

  static int first(double coordinate)
  {
    return std::max(0, static_cast<int>(std::floor(coordinate)));
  }

  static int last(double coordinate, int size)
  {
    return std::min(size - 1, static_cast<int>(std::ceil(coordinate)));
  }

  void blend()
  {
    std::vector<Fragment> layers;
    for (Pixel& pixel : m_pixels)
    {
      layers.clear();
      for (int i = pixel.last_fragment; i >= 0; i = m_fragments[i].previous)
        if (m_fragments[i].z > pixel.z)
          layers.push_back(m_fragments[i]);
      std::sort(layers.begin(), layers.end(),
                [](const Fragment& a, const Fragment& b) { return a.z < b.z; });
      for (const Fragment& layer : layers)
        pixel.color = mix(pixel.color, layer.color, layer.opacity);
      pixel.last_fragment = -1;
    }
  }

  int m_width, m_height;
  std::vector<Pixel> m_pixels;
  std::vector<Fragment> m_fragments;
};

#endif // SMF_PICTURES_CANVAS_H
