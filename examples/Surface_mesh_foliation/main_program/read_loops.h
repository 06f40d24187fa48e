// Poles and loops: those of the command line, and those that are found.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_READ_LOOPS_H
#define SMF_EXAMPLES_MAIN_PROGRAM_READ_LOOPS_H

#include "Options.h"
#include "Result.h"

#include <CGAL/Surface_mesh_foliation/feature_poles.h>
#include <CGAL/Surface_mesh_foliation/fill_openings.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace main_program {

inline Mesh::Vertex_index vertex(const Mesh& mesh,
                                 const std::string& text,
                                 const std::string& option)
{
  std::size_t index = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, index);
  if (text.empty() || error == std::errc::invalid_argument || end != last)
    throw std::invalid_argument(option + ": '" + text + "' is not a vertex index");
  if (error != std::errc() || index >= num_vertices(mesh))
    throw std::invalid_argument(option + ": there is no vertex " + text + "; the mesh has " +
                                std::to_string(num_vertices(mesh)));
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(index));
}

// three coordinates separated by commas, whatever the locale
inline Mesh::Point position(const std::string& text, const std::string& option)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  double x = 0, y = 0, z = 0;
  char first_comma = 0, second_comma = 0;
  stream >> x >> first_comma >> y >> second_comma >> z;
  if (stream.fail() || first_comma != ',' || second_comma != ',' || stream.peek() != EOF)
    throw std::invalid_argument(option + ": '" + text + "' is not a position X,Y,Z");
  return Mesh::Point(x, y, z);
}

// the first of them if there are several
inline Mesh::Vertex_index nearest_vertex(const Mesh& mesh, const Mesh::Point& position)
{
  const auto is_nearer = [&](Mesh::Vertex_index u, Mesh::Vertex_index v) {
    return CGAL::has_smaller_distance_to_point(position, mesh.point(u), mesh.point(v));
  };
  return *std::min_element(mesh.vertices_begin(), mesh.vertices_end(), is_nearer);
}

inline std::vector<Mesh::Vertex_index> pole_line(const Mesh& mesh, const std::string& text)
{
  std::vector<Mesh::Vertex_index> result;
  for (std::size_t first = 0, end = 0; end != std::string::npos; first = end + 1)
  {
    end = text.find(',', first);
    result.push_back(vertex(mesh, text.substr(first, end - first), "--pole-line"));
  }
  return result;
}

inline bool has_pole_at(const Result& result, Mesh::Vertex_index v)
{
  const auto has_v = [&](const std::vector<std::size_t>& pole) {
    return std::find(pole.begin(), pole.end(), v) != pole.end();
  };
  return std::any_of(result.poles.begin(), result.poles.end(), has_v);
}

inline void add_pole(Result& result, Mesh::Vertex_index v)
{
  result.input.add_pole(v);
  result.poles.push_back({v});
}

inline void add_line_pole(Result& result, const std::vector<Mesh::Vertex_index>& line)
{
  result.input.add_line_pole(line);
  result.poles.emplace_back(line.begin(), line.end());
}

// Reads the mesh, and fills the openings that are not to be ends.
inline void read_mesh(const Options& options, Result& result)
{
  SMF::read_triangle_mesh(options.mesh, result.mesh, SMF::parameters::allow_openings(true));
  result.number_of_vertices = num_vertices(result.mesh);
  result.number_of_faces = num_faces(result.mesh);
  if (CGAL::is_closed(result.mesh))
    return;
  result.number_of_filled_openings =
    options.max_filled_length
      ? SMF::fill_openings(result.mesh,
                           SMF::parameters::max_opening_length(*options.max_filled_length))
      : SMF::fill_openings(result.mesh);
}

// Openings that are left are ends.
inline void add_border_poles(Result& result)
{
  result.number_of_ends = SMF::add_border_poles(result.mesh, result.input);
  for (const auto& entry : result.input.entries())
    if (entry.pole.empty())
    {
      result.poles.emplace_back();
      for (const Mesh::Vertex_index v : vertices_around_face(entry.border, result.mesh))
        result.poles.back().push_back(v);
    }
}

// Lines that are found come after the poles that are given, which they must not meet. Returns the
// vertices of blades: those closer to a line than the width of its blade.
inline std::vector<bool> find_lines(Result& result)
{
  std::vector<std::vector<Mesh::Vertex_index>> lines;
  SMF::detect_feature_lines(result.mesh, std::back_inserter(lines));
  const double width =
    SMF::default_blade_width * std::sqrt(CGAL::Polygon_mesh_processing::area(result.mesh));
  std::vector<bool> is_on_blade(num_vertices(result.mesh), false);
  for (const std::vector<Mesh::Vertex_index>& line : lines)
  {
    if (std::any_of(line.begin(), line.end(), [&](auto v) { return has_pole_at(result, v); }))
      continue;
    add_line_pole(result, line);
    for (const Mesh::Vertex_index v : line)
      for (const Mesh::Vertex_index u : vertices(result.mesh))
        if (CGAL::squared_distance(result.mesh.point(u), result.mesh.point(v)) < width * width)
          is_on_blade[u] = true;
  }
  return is_on_blade;
}

// Poles that are found come after those that are given. On a blade with a line there are none.
inline void find_poles(const Options& options, const std::vector<bool>& is_on_blade, Result& result)
{
  std::vector<Mesh::Vertex_index> found;
  const auto parameters = SMF::parameters::number_of_poles(options.max_found_poles);
#ifdef CGAL_SURFACE_MESH_FOLIATION_HAS_SPECTRA
  SMF::detect_feature_poles(result.mesh, std::back_inserter(found), parameters);
#else
  SMF::detect_feature_poles(result.mesh, std::back_inserter(found),
                            parameters.pole_detector(SMF::Average_geodesic_distance()));
#endif
  for (const Mesh::Vertex_index v : found)
    if (!has_pole_at(result, v) && !is_on_blade[v])
      add_pole(result, v);
}

// A sphere needs two poles, even if it has no limb.
inline void add_missing_poles(Result& result)
{
  const std::size_t before = result.input.size();
  SMF::add_missing_poles(result.mesh, result.input);
  for (std::size_t a = before; a < result.input.size(); ++a)
    result.poles.push_back({static_cast<std::size_t>(result.input.entries()[a].pole[0])});
}

inline void find_loops(const Options& options, Result& result)
{
  SMF::propose_loops(result.mesh, result.input,
                     SMF::parameters::min_loop_length(options.min_loop_length.value_or(0)));
}

// Says what else to try if neither poles nor loops have been found.
inline void check_that_some_are_found(const Options& options, const Result& result)
{
  if (result.input.size() > 0)
    return;
  std::string message = "no pole and no loop was found";
  if (options.finds_poles != options.finds_loops) // otherwise both were looked for
    message += options.finds_poles ? "; try --auto-loops as well" : "; try --auto-poles as well";
  throw std::invalid_argument(message + "; or give poles by --pole V, or loops by --loops FILE");
}

// Loop ids: poles, poles at positions, line poles, openings, lines and poles that are found, then
// the loops of the file or those that are found, each in order.
inline void read_loops(const Options& options, Result& result)
{
  const bool is_nothing_given =
    options.poles.empty() && options.pole_positions.empty() && options.pole_lines.empty() &&
    options.loops.empty() && !options.finds_poles && !options.finds_lines && !options.finds_loops;
  const bool finds_loops = options.finds_loops || is_nothing_given;
  if (options.min_loop_length && !finds_loops)
    throw std::invalid_argument("--min-loop-length: no loops are to be found");
  for (const std::string& text : options.poles)
    add_pole(result, vertex(result.mesh, text, "--pole"));
  for (const std::string& text : options.pole_positions)
    add_pole(result, nearest_vertex(result.mesh, position(text, "--pole-at")));
  for (const std::string& text : options.pole_lines)
    add_line_pole(result, pole_line(result.mesh, text));
  add_border_poles(result);
  std::vector<bool> is_on_blade(num_vertices(result.mesh), false);
  if (options.finds_lines)
    is_on_blade = find_lines(result);
  if (options.finds_poles || is_nothing_given)
    find_poles(options, is_on_blade, result);
  if (is_nothing_given)
    add_missing_poles(result);
  if (finds_loops)
    find_loops(options, result);
  if (!options.loops.empty())
    SMF::read_loops(options.loops, result.mesh, result.input);
  check_that_some_are_found(options, result);
  if (!options.heights.empty() && options.heights.size() != result.input.size())
    throw std::invalid_argument("--heights: " + std::to_string(options.heights.size()) +
                                " heights for " + std::to_string(result.input.size()) + " loops");
  for (std::size_t a = 0; a < result.input.size(); ++a)
    result.input.set_height(a, options.heights.empty() ? options.height : options.heights[a]);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_READ_LOOPS_H
