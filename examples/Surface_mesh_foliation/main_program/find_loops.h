// Poles and loops that the program finds on a part of the mesh.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_FIND_LOOPS_H
#define SMF_EXAMPLES_MAIN_PROGRAM_FIND_LOOPS_H

#include "Options.h"
#include "Result.h"

#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace main_program {

// What is to be found on a part: what the options say; if they say nothing and give nothing there,
// poles and canonical loops, or loops for the handles if something is said about these.
struct Search
{
  Search(const Options& options, const Part& part)
    : everything(!options.finds_poles && !options.finds_lines && !options.finds_loops &&
                 part.number_of_given == 0),
      lines(options.finds_lines),
      poles(options.finds_poles || everything),
      handles(options.finds_loops || (everything && (options.is_star || options.min_loop_length))),
      canonical_loops(options.min_modulus || (everything && !handles))
  {}

  bool everything, lines, poles, handles, canonical_loops;
};

// The vertices that belong to poles, and those near line poles, where no others are wanted.
class Occupied_vertices
{
public:
  Occupied_vertices(const Mesh& mesh, const Part_mesh& part, const Part_input& input)
    : m_is_on_pole(num_vertices(mesh), false), m_is_on_blade(num_vertices(mesh), false)
  {
    for (const auto& entry : input.entries())
    {
      add_pole(entry.pole);
      if (entry.is_pole_loop() && entry.pole.empty())
        for (const Vertex v : vertices_around_face(entry.border, part))
          m_is_on_pole[v] = true;
    }
  }

  void add_pole(const std::vector<Vertex>& pole)
  {
    for (const Vertex v : pole)
      m_is_on_pole[v] = true;
  }
  void add_to_blade(Vertex v) { m_is_on_blade[v] = true; }
  bool is_on_pole(Vertex v) const { return m_is_on_pole[v]; }
  bool is_on_blade(Vertex v) const { return m_is_on_blade[v]; }

private:
  std::vector<bool> m_is_on_pole, m_is_on_blade;
};

// Lines that are found come after the poles that are given, which they must not meet. A blade has
// the vertices closer to a line than its width.
inline void find_lines(const Part_mesh& mesh, Part& part, Occupied_vertices& occupied)
{
  std::vector<std::vector<Vertex>> lines;
  SMF::detect_feature_lines(mesh, std::back_inserter(lines));
  const double width =
    SMF::default_blade_width * std::sqrt(CGAL::Polygon_mesh_processing::area(mesh));
  const auto& points = mesh.graph().points();
  for (const std::vector<Vertex>& line : lines)
  {
    if (std::any_of(line.begin(), line.end(), [&](Vertex v) { return occupied.is_on_pole(v); }))
      continue;
    part.input.add_line_pole(line);
    ++part.number_of_found_poles;
    occupied.add_pole(line);
    for (const Vertex v : line)
      for (const Vertex u : vertices(mesh))
        if (CGAL::squared_distance(points[u], points[v]) < width * width)
          occupied.add_to_blade(u);
  }
}

// Poles that are found come after those that are given. On a blade with a line there are none.
inline void find_poles(const Options& options,
                       const Part_mesh& mesh,
                       Part& part,
                       const Occupied_vertices& occupied,
                       std::string& detector)
{
  std::vector<Vertex> found;
  const auto parameters = SMF::parameters::number_of_poles(options.max_found_poles);
  detector = "average geodesic distance";
  std::vector<double> significances;
  SMF::detect_feature_poles(
    mesh, std::back_inserter(found),
    parameters.significance_output_iterator(std::back_inserter(significances)));
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!occupied.is_on_pole(found[i]) && !occupied.is_on_blade(found[i]))
    {
      part.significances[part.input.add_pole(found[i])] = significances[i];
      ++part.number_of_found_poles;
    }
}

// of the part with its openings closed
inline int euler_characteristic(const Part_mesh& mesh, const Part& part)
{
  return static_cast<int>(vertices(mesh).size()) - static_cast<int>(edges(mesh).size()) +
         static_cast<int>(faces(mesh).size()) + static_cast<int>(part.number_of_ends);
}

// Whether canonical loops are found within seconds: a pants decomposition has few loops.
inline bool is_simple_enough(const Part_mesh& mesh, const Part& part)
{
  constexpr int most_loops = 50;
  const int genus = 1 - euler_characteristic(mesh, part) / 2;
  return 3 * genus - 3 + static_cast<int>(part.input.size()) <= most_loops;
}

inline void find_loops(const Options& options,
                       const Search& search,
                       const Part_mesh& mesh,
                       Part& part)
{
  part.first_found_loop = part.end_of_found_loops = part.input.size();
  const bool are_canonical =
    search.canonical_loops && (options.min_modulus || is_simple_enough(mesh, part));
  if (search.handles || (search.canonical_loops && !are_canonical))
    SMF::propose_loops(mesh, part.input,
                       SMF::parameters::min_loop_length(options.min_loop_length.value_or(0)));
  if (are_canonical)
    part.canonical_loops =
      SMF::canonical_loops(mesh, part.input, SMF::parameters::min_modulus(min_modulus(options)));
  part.end_of_found_loops = part.input.size();
}

// Says what else to try if there are too few poles and loops.
inline void check_that_there_are_enough(const Options& options,
                                        const Part_mesh& mesh,
                                        const Part& part)
{
  const Search search(options, part);
  if (part.input.size() == 1 && euler_characteristic(mesh, part) == 2 && search.poles &&
      part.input.entries()[0].is_pole_loop() && part.input.entries()[0].loop.empty() &&
      !search.everything)
    throw std::invalid_argument(
      std::to_string(part.number_of_found_poles) + " pole" +
      (part.number_of_found_poles == 1 ? " was" : "s were") +
      " found, and a surface without handles needs two: give others by --pole V, or neither give "
      "nor look for anything, for the ends of a diameter");
  if (part.input.size() > 0)
    return;
  std::string message = "no pole and no loop was found";
  const bool finds_loops = search.handles || search.canonical_loops;
  if (search.poles != finds_loops) // otherwise both were looked for
    message += search.poles ? "; try --auto-loops as well" : "; try --auto-poles as well";
  throw std::invalid_argument(message + "; or give poles by --pole V, or loops by --loops FILE");
}

inline void find_poles_and_loops(const Options& options,
                                 const Part_mesh& mesh,
                                 Part& part,
                                 std::string& detector)
{
  const Search search(options, part);
  Occupied_vertices occupied(mesh.graph(), mesh, part.input);
  if (search.lines)
    find_lines(mesh, part, occupied);
  if (search.poles)
    find_poles(options, mesh, part, occupied, detector);
  if (search.everything) // a sphere needs two poles, even if it has no limb
    part.number_of_found_poles += SMF::add_missing_poles(mesh, part.input);
  find_loops(options, search, mesh, part);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_FIND_LOOPS_H
