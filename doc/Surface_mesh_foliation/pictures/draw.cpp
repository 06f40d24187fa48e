// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws what the main program writes with --output, or what solve_steps writes: one panel per
// folder, side by side, as a PNG.
//
//   draw OUTPUT.png WIDTHxHEIGHT PANEL...
//
// where the size is that of a panel, and a PANEL is
//
//   --panel FOLDER        read components.ply, leaves.ply, skeleton.ply, reeb_graph.graphml there
//   --view X,Y,Z          the direction from the surface to the viewer (0,0,1)
//   --up X,Y,Z            the direction that is up in the picture (0,1,0)
//   --zoom Z              how much larger than to fit in (1)
//   --center X,Y,Z        the point in the middle of the panel (that of the bounding box)
//   --surface STYLE       opaque (default), transparent or none
//   --gray                ignore the colors of the surface
//   --squares S           a checkerboard in the coordinates of FOLDER/coordinates.ply, with squares
//                         of about side S
//   --critical            critical leaves, thick: black, those of poles red
//   --regular             regular leaves, thin
//   --leaves              both
//   --poles               of the critical leaves only those of poles
//   --skeleton            arcs as tubes; poles as red balls, other nodes as blue ones
//   --samples             the vertices of the arcs as small balls
//   --curves FILE.ply     more polylines, thick and orange; may be repeated
//   --plot                the curves of FOLDER/convergence.txt instead of a surface
//   --line-width W        the width of thick lines, in pixels (3.5)
//   --tube-radius R       the radius of tubes, relative to the panel's smaller side (0.008)

#include "Canvas.h"
#include "Plot.h"
#include "Scene.h"
#include "Vector.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct Panel
{
  std::string folder, style = "opaque";
  Vector view = {0, 0, 1}, up = {0, 1, 0}, center;
  double zoom = 1, line_width = 3.5, tube_radius = 0.008, square = 0;
  bool has_center = false, is_gray = false, draws_critical = false, draws_regular = false,
       draws_poles = false, draws_skeleton = false, draws_samples = false, is_plot = false;
  std::vector<std::string> curves;
};

struct Options
{
  std::string output;
  int width = 0, height = 0; // of a panel
  std::vector<Panel> panels;
};

const Vector pole_red = {0.85, 0.1, 0.1}, node_blue = {0.1, 0.25, 0.85}, black = {0.05, 0.05, 0.05},
             tube_gray = {0.33, 0.33, 0.36}, thin_gray = {0.28, 0.28, 0.3},
             orange = {0.95, 0.45, 0}, pale = {0.86, 0.86, 0.88};

Vector parse_vector(const std::string& text)
{
  Vector result;
  char comma;
  std::istringstream input(text);
  if (!(input >> result.x >> comma >> result.y >> comma >> result.z))
    throw std::invalid_argument("'" + text + "' is not of the form X,Y,Z");
  return result;
}

// Reads one option of a panel; `next` returns the word after it.
template <class NextWord>
void parse_option(const std::string& option, NextWord next, Panel& panel)
{
  if (option == "--view")
    panel.view = parse_vector(next());
  else if (option == "--up")
    panel.up = parse_vector(next());
  else if (option == "--zoom")
    panel.zoom = std::stod(next());
  else if (option == "--center")
  {
    panel.center = parse_vector(next());
    panel.has_center = true;
  }
  else if (option == "--surface")
    panel.style = next();
  else if (option == "--gray")
    panel.is_gray = true;
  else if (option == "--squares")
    panel.square = std::stod(next());
  else if (option == "--critical")
    panel.draws_critical = true;
  else if (option == "--regular")
    panel.draws_regular = true;
  else if (option == "--leaves")
    panel.draws_critical = panel.draws_regular = true;
  else if (option == "--poles")
    panel.draws_poles = true;
  else if (option == "--skeleton")
    panel.draws_skeleton = true;
  else if (option == "--samples")
    panel.draws_samples = true;
  else if (option == "--curves")
    panel.curves.push_back(next());
  else if (option == "--plot")
    panel.is_plot = true;
  else if (option == "--line-width")
    panel.line_width = std::stod(next());
  else if (option == "--tube-radius")
    panel.tube_radius = std::stod(next());
  else
    throw std::invalid_argument("unknown option " + option);
}

Options parse(int argc, char* argv[])
{
  Options options;
  int i = 1;
  const auto next = [&]() -> std::string {
    if (i == argc)
      throw std::invalid_argument("an argument is missing; draw.cpp begins with a list of all");
    return argv[i++];
  };
  options.output = next();
  std::istringstream size(next());
  char x;
  if (!(size >> options.width >> x >> options.height) || options.width < 1 || options.height < 1)
    throw std::invalid_argument("the size of a panel is not of the form WIDTHxHEIGHT");
  while (i < argc)
  {
    const std::string option = next();
    if (option == "--panel")
    {
      options.panels.push_back({});
      options.panels.back().folder = next();
    }
    else if (options.panels.empty())
      throw std::invalid_argument(option + " comes before the first --panel");
    else
      parse_option(option, next, options.panels.back());
  }
  return options;
}

// From the coordinates of the scene to those of the canvas, orthographic.
class Camera
{
public:
  Camera(const Panel& panel, const std::vector<Vector>& points, int width, int height)
  {
    m_toward = unit(panel.view);
    m_right = unit(cross(panel.up, m_toward));
    m_up = cross(m_toward, m_right);
    Vector lower = turned(points.at(0)), upper = lower;
    for (const Vector& point : points)
    {
      const Vector p = turned(point);
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
    }
    const double margin = 0.06;
    m_scale = panel.zoom * (1 - margin) *
              std::min(width / (upper.x - lower.x), height / (upper.y - lower.y));
    m_center = panel.has_center ? turned(panel.center) : 0.5 * (lower + upper);
    m_middle = {width / 2., height / 2., 0};
  }

  Vector turned(const Vector& p) const { return {dot(p, m_right), dot(p, m_up), dot(p, m_toward)}; }
  Vector operator()(const Vector& p) const { return m_scale * (turned(p) - m_center) + m_middle; }

private:
  Vector m_right, m_up, m_toward, m_center, m_middle;
  double m_scale;
};

// Squares of a component, an even number of them around.
class Checkerboard
{
public:
  Checkerboard(const Coordinates& coordinates, double square)
    : m_coordinates(coordinates), m_square(square)
  {}

  bool is_dark(std::size_t face, const Vector& weights) const
  {
    const int component = m_coordinates.components.at(face);
    if (component < 0)
      return false;
    const double c = m_coordinates.circumferences.at(component);
    const double side = c / std::max(2., 2 * std::round(c / m_square / 2));
    const auto& uv = m_coordinates.corners[face];
    double parity = 0;
    for (int i : {0, 1})
      parity +=
        std::floor((weights.x * uv[0][i] + weights.y * uv[1][i] + weights.z * uv[2][i]) / side);
    return std::fmod(std::abs(parity), 2) > 0.5;
  }

private:
  const Coordinates& m_coordinates;
  double m_square;
};

void draw_checkered_surface(Canvas& canvas,
                            const Camera& camera,
                            const Panel& panel,
                            const Surface& surface)
{
  const Coordinates coordinates = read_coordinates(panel.folder + "/coordinates.ply");
  const Checkerboard board(coordinates, panel.square);
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
  {
    std::array<Corner, 3> corners;
    for (int i : {0, 1, 2})
    {
      const std::size_t v = coordinates.triangles.at(f)[i];
      corners[i] = {camera(surface.points[v]), camera.turned(surface.normals[v])};
    }
    const Vector light = mix(surface.colors[f], {1, 1, 1}, 0.35);
    const Vector dark = mix(surface.colors[f], black, 0.4);
    canvas.draw_triangle(
      corners, [&](const Vector& weights) { return board.is_dark(f, weights) ? dark : light; });
  }
}

void draw_surface(Canvas& canvas, const Camera& camera, const Panel& panel, const Surface& surface)
{
  for (std::size_t f = 0; f < surface.triangles.size(); ++f)
  {
    std::array<Corner, 3> corners;
    for (int i : {0, 1, 2})
    {
      const std::size_t v = surface.triangles[f][i];
      corners[i] = {camera(surface.points[v]), camera.turned(surface.normals[v])};
    }
    const Vector color = panel.is_gray ? pale : mix(surface.colors[f], {1, 1, 1}, 0.12);
    if (panel.style == "opaque")
      canvas.draw_triangle(corners, color);
    else
      canvas.draw_translucent_triangle(corners, color);
  }
}

void draw_segment(Canvas& canvas,
                  const Camera& camera,
                  const Polylines& lines,
                  std::size_t segment,
                  double width,
                  double lift,
                  const Vector& color)
{
  const auto [a, b] = lines.segments[segment];
  canvas.draw_stroke(camera(lines.points[a]), camera(lines.points[b]), width / 2, lift, color);
}

void draw_leaves(Canvas& canvas, const Camera& camera, const Panel& panel)
{
  const Polylines leaves = read_polylines(panel.folder + "/leaves.ply");
  const std::vector<Node> nodes = read_nodes(panel.folder + "/reeb_graph.graphml");
  const double thick = Canvas::subpixels * panel.line_width, thin = thick / 3;
  const double lift = 0.01 * std::min(canvas.width(), canvas.height());
  for (std::size_t s = 0; s < leaves.segments.size(); ++s)
  {
    const bool is_critical = leaves.nodes[s] >= 0;
    const bool is_pole = is_critical && nodes.at(leaves.nodes[s]).is_pole;
    if (is_pole && (panel.draws_critical || panel.draws_poles))
      draw_segment(canvas, camera, leaves, s, thick, 2 * lift, pole_red);
    else if (is_critical && panel.draws_critical)
      draw_segment(canvas, camera, leaves, s, thick, 1.2 * lift, black);
    else if (!is_critical && panel.draws_regular)
      draw_segment(canvas, camera, leaves, s, thin, lift, thin_gray);
  }
  if (panel.draws_critical || panel.draws_poles)
    for (std::size_t v : leaves.isolated)
      canvas.draw_tube(camera(leaves.points[v]), camera(leaves.points[v]), 1.2 * thick, pole_red);
}

void draw_curves(Canvas& canvas, const Camera& camera, const Panel& panel)
{
  for (const std::string& file_name : panel.curves)
  {
    const Polylines curves = read_polylines(file_name);
    for (std::size_t s = 0; s < curves.segments.size(); ++s)
      draw_segment(canvas, camera, curves, s, Canvas::subpixels * panel.line_width,
                   0.014 * std::min(canvas.width(), canvas.height()), orange);
  }
}

void draw_skeleton(Canvas& canvas, const Camera& camera, const Panel& panel)
{
  const Polylines arcs = read_polylines(panel.folder + "/skeleton.ply");
  const double radius = panel.tube_radius * std::min(canvas.width(), canvas.height());
  for (const auto& [a, b] : arcs.segments)
  {
    const Vector from = camera(arcs.points[a]), to = camera(arcs.points[b]);
    canvas.draw_tube(from, to, radius, tube_gray);
    if (panel.draws_samples)
      canvas.draw_tube(to, to, 1.8 * radius, orange);
  }
  for (const Node& node : read_nodes(panel.folder + "/reeb_graph.graphml"))
    canvas.draw_tube(camera(node.point), camera(node.point), 2.6 * radius,
                     node.is_pole ? pole_red : node_blue);
}

std::vector<unsigned char> draw_panel(const Panel& panel, int width, int height)
{
  Canvas canvas(width, height);
  if (panel.is_plot)
  {
    Plot(canvas, read_curves(panel.folder + "/convergence.txt")).draw();
    return canvas.picture();
  }
  const Surface surface = read_surface(panel.folder + "/components.ply");
  const Camera camera(panel, surface.points, canvas.width(), canvas.height());
  if (panel.square > 0)
    draw_checkered_surface(canvas, camera, panel, surface);
  else if (panel.style != "none")
    draw_surface(canvas, camera, panel, surface);
  if (panel.draws_critical || panel.draws_regular || panel.draws_poles)
    draw_leaves(canvas, camera, panel);
  draw_curves(canvas, camera, panel);
  if (panel.draws_skeleton)
    draw_skeleton(canvas, camera, panel);
  return canvas.picture();
}

void write_png(const std::string& file_name,
               int width,
               int height,
               const std::vector<unsigned char>& rgb)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file_name.c_str(), 0, rgb.data(), 0, nullptr) == 0)
    throw std::runtime_error(file_name + " cannot be written: " + image.message);
}

int main(int argc, char* argv[])
{
  try
  {
    const Options options = parse(argc, argv);
    const int panels = static_cast<int>(options.panels.size());
    std::vector<unsigned char> rgb(3 * static_cast<std::size_t>(panels) * options.width *
                                   options.height);
    for (int i = 0; i < panels; ++i)
    {
      const std::vector<unsigned char> panel =
        draw_panel(options.panels[i], options.width, options.height);
      const auto row = 3 * static_cast<std::ptrdiff_t>(options.width);
      for (int y = 0; y < options.height; ++y)
        std::copy_n(panel.begin() + y * row, row, rgb.begin() + (y * panels + i) * row);
    }
    write_png(options.output, panels * options.width, options.height, rgb);
  }
  catch (const std::exception& error)
  {
    std::cerr << "draw: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
