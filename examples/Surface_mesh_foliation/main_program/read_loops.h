// Poles and loops that options give, by the numbers of the file.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_READ_LOOPS_H
#define SMF_EXAMPLES_MAIN_PROGRAM_READ_LOOPS_H

#include "Options.h"
#include "Result.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace main_program {

inline Vertex vertex(const Result& result, const std::string& text, const std::string& option)
{
  std::size_t index = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, index);
  if (text.empty() || error == std::errc::invalid_argument || end != last)
    throw std::invalid_argument(option + ": '" + text + "' is not a vertex index");
  const std::vector<Vertex>& numbered = result.numbered_vertices;
  if (error != std::errc() || index >= numbered.size())
    throw std::invalid_argument(option + ": there is no vertex " + text + "; the mesh has " +
                                std::to_string(numbered.size()));
  if (numbered[index] == Mesh::null_vertex())
    throw std::invalid_argument(option + ": vertex " + text + " is no vertex of the repaired mesh");
  return numbered[index];
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
inline Vertex nearest_vertex(const Mesh& mesh, const Mesh::Point& position)
{
  const auto is_nearer = [&](Vertex u, Vertex v) {
    return CGAL::has_smaller_distance_to_point(position, mesh.point(u), mesh.point(v));
  };
  return *std::min_element(mesh.vertices_begin(), mesh.vertices_end(), is_nearer);
}

inline std::vector<Vertex> pole_line(const Result& result, const std::string& text)
{
  std::vector<Vertex> line;
  for (std::size_t first = 0, end = 0; end != std::string::npos; first = end + 1)
  {
    end = text.find(',', first);
    line.push_back(vertex(result, text.substr(first, end - first), "--pole-line"));
  }
  return line;
}

// poles, poles at positions, line poles
inline SMF::Poles_and_loops<Mesh> given_poles(const Options& options, const Result& result)
{
  SMF::Poles_and_loops<Mesh> poles;
  for (const std::string& text : options.poles)
    poles.add_pole(vertex(result, text, "--pole"));
  for (const std::string& text : options.pole_positions)
    poles.add_pole(nearest_vertex(result.mesh, position(text, "--pole-at")));
  for (const std::string& text : options.pole_lines)
    poles.add_line_pole(pole_line(result, text));
  return poles;
}

inline SMF::Poles_and_loops<Mesh> given_loops(const Options& options, const Result& result)
{
  SMF::Poles_and_loops<Mesh> loops;
  if (!options.loops.empty())
    SMF::read_loops(options.loops, result.mesh, loops,
                    SMF::parameters::numbered_vertices(result.numbered_vertices));
  return loops;
}

inline void set_heights(const Options& options, Result& result)
{
  const std::size_t number = number_of_loops(result);
  if (!options.heights.empty() && options.heights.size() != number)
    throw std::invalid_argument("--heights: " + std::to_string(options.heights.size()) +
                                " heights for " + std::to_string(number) + " loops");
  std::size_t loop = 0; // counted over all parts
  for (Part& part : result.parts)
    for (std::size_t a = 0; a < part.input.size(); ++a, ++loop)
      part.input.set_height(a, options.heights.empty() ? options.height : options.heights[loop]);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_READ_LOOPS_H
