// Numbers of a result that are printed, for people and as JSON.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_SUMMARIZE_RESULT_H
#define SMF_EXAMPLES_MAIN_PROGRAM_SUMMARIZE_RESULT_H

#include "Options.h"
#include "Result.h"

#include <CGAL/boost/graph/iterator.h>

#include <CGAL/Surface_mesh_foliation/reeb_graph_symmetries.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace main_program {

// the vertices of a pole: of an opening, those of its border
inline std::vector<std::size_t> pole_numbers(const Result& result,
                                             const Part_mesh& mesh,
                                             const Part_input::Entry& entry)
{
  std::vector<std::size_t> numbers;
  for (const Vertex v : entry.pole)
    numbers.push_back(result.number_of_vertex[v]);
  if (entry.pole.empty())
    for (const Vertex v : vertices_around_face(entry.border, mesh))
      numbers.push_back(result.number_of_vertex[v]);
  return numbers;
}

// The number of independent cycles. Each part of the graph is connected.
inline std::size_t number_of_cycles(const Result& result)
{
  const auto has_graph = [](const Part& part) { return part.error.empty(); };
  return num_edges(result.graph) +
         std::count_if(result.parts.begin(), result.parts.end(), has_graph) -
         num_vertices(result.graph);
}

// The statistics of all parts: sums, and the worst.
inline SMF::Foliation_statistics statistics(const Result& result)
{
  SMF::Foliation_statistics all;
  all.has_converged = all.is_certified = true;
  for (const Part& part : result.parts)
    if (part.foliation)
    {
      const SMF::Foliation_statistics& one = part.foliation->statistics();
      all.energy += one.energy;
      all.optimality = (std::max)(all.optimality, one.optimality);
      all.number_of_iterations = (std::max)(all.number_of_iterations, one.number_of_iterations);
      all.has_converged = all.has_converged && one.has_converged;
      all.is_certified = all.is_certified && one.is_certified;
    }
  return all;
}

inline std::size_t number_of_ends(const Result& result)
{
  std::size_t number = 0;
  for (const Part& part : result.parts)
    number += part.number_of_ends;
  return number;
}

// The arcs that symmetries of the graph exchange, class by class, each by its number. (The graphs
// of parts that are alike are exchanged, too.) None if sums of areas are too large for a number.
inline std::vector<std::vector<std::size_t>> classes_of_arcs(const Graph& graph)
{
  std::vector<std::size_t> class_of_arc;
  try
  {
    class_of_arc = SMF::reeb_graph_symmetries(graph).arc_classes;
  }
  catch (const SMF::Invalid_parameter_exception&)
  {
    return {};
  }
  std::map<std::size_t, std::vector<std::size_t>> classes;
  std::size_t i = 0;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    classes[class_of_arc[i++]].push_back(graph[e].loop);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [first, numbers] : classes)
    if (numbers.size() > 1)
      result.push_back(std::move(numbers));
  return result;
}

// whether a canonical loop is one only because it shows a handle
inline bool is_completing(const Options& options, const SMF::Canonical_loop<Part_mesh>& loop)
{
  return loop.modulus < min_modulus(options);
}

inline std::size_t genus(const Result& result)
{
  std::size_t sum = 0;
  for (const Part& part : result.parts)
    sum += part.foliation ? part.foliation->system().genus() : 0;
  return sum;
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_SUMMARIZE_RESULT_H
