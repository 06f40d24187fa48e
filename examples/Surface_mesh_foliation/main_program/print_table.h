// A result as a table for people.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_PRINT_TABLE_H
#define SMF_EXAMPLES_MAIN_PROGRAM_PRINT_TABLE_H

#include "Options.h"
#include "Result.h"
#include "summarize_result.h"

#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace main_program {

// what was found, and by which detector
inline void print_poles(const Result& result)
{
  std::cout << "poles:";
  for (std::size_t i = 0; i < result.parts.size(); ++i)
  {
    const Part& part = result.parts[i];
    for (const auto& entry : part.input.entries())
      if (!entry.pole.empty() || entry.is_pole_loop())
      {
        const std::vector<std::size_t> numbers = pole_numbers(result, result.part_meshes[i], entry);
        if (entry.pole.empty())
          std::cout << " opening(" << numbers.size() << " vertices)";
        else
          for (std::size_t k = 0; k < numbers.size(); ++k)
            std::cout << (k == 0 ? ' ' : '-') << numbers[k];
      }
  }
  std::size_t found = 0, loops = 0;
  for (const Part& part : result.parts)
  {
    found += part.number_of_found_poles;
    loops += part.end_of_found_loops - part.first_found_loop;
  }
  if (found > 0)
    std::cout << "; " << found << " of them found"
              << (result.detector.empty() ? "" : " by the " + result.detector);
  std::cout << '\n';
  if (loops > 0)
    std::cout << "loops found: " << loops << '\n';
}

// by arc, the modulus and the margin of its loop if it is canonical
inline std::map<std::size_t, std::string> moduli_of_arcs(const Options& options,
                                                         const Result& result)
{
  std::map<std::size_t, std::string> moduli;
  std::size_t first = 0; // of the part
  for (const Part& part : result.parts)
  {
    for (std::size_t i = 0; i < part.canonical_loops.size(); ++i)
    {
      const auto& loop = part.canonical_loops[i];
      std::ostringstream text;
      text << std::setprecision(3) << loop.modulus;
      if (is_completing(options, loop))
        text << " for a handle";
      else
        text << " (margin " << loop.margin(min_modulus(options)) << ')';
      moduli[first + part.first_found_loop + i] = text.str();
    }
    first += part.input.size();
  }
  return moduli;
}

inline void print_summary(const Result& result)
{
  const Graph& graph = result.graph;
  const SMF::Foliation_statistics all = statistics(result);
  std::cout << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces, genus " << genus(result) << '\n';
  if (result.repaired)
    for (const std::string& line : SMF::descriptions(result.repaired->report))
      std::cout << "repair: " << line << '\n';
  if (number_of_ends(result) + result.number_of_filled_openings > 0)
    std::cout << "openings: " << number_of_ends(result) << " ends, "
              << result.number_of_filled_openings << " filled\n";
  if (has_several_parts(result))
    std::cout << "parts: " << result.parts.size() << '\n';
  if (result.parts.size() < result.number_of_all_parts)
    std::cout << "parts left out: " << result.number_of_all_parts - result.parts.size() << '\n';
  print_poles(result);
  std::cout << "foliation: energy " << all.energy << ", optimality " << all.optimality << " after "
            << all.number_of_iterations << " iterations"
            << (all.has_converged ? "" : ", NOT CONVERGED")
            << ", certified\nReeb graph: " << num_vertices(graph) << " nodes, " << num_edges(graph)
            << " arcs, " << number_of_cycles(result) << " cycles\n\n";
}

inline void print_symmetries(const Result& result)
{
  const std::vector<std::vector<std::size_t>> classes = classes_of_arcs(result.graph);
  if (classes.empty())
    return;
  std::cout << "\nsymmetric arcs:";
  for (const std::vector<std::size_t>& arcs : classes)
    for (std::size_t i = 0; i < arcs.size(); ++i)
      std::cout << (i > 0 ? ", " : &arcs == &classes[0] ? " " : "; ") << arcs[i];
  std::cout << '\n';
}

inline void print_table(const Options& options, const Result& result)
{
  const Graph& graph = result.graph;
  const std::map<std::size_t, std::string> moduli = moduli_of_arcs(options, result);
  print_summary(result);
  const bool tells_part = has_several_parts(result);
  std::cout << "  arc  " << (tells_part ? "part  " : "")
            << "nodes        component   height      flux        length"
            << (moduli.empty() ? "\n" : "      modulus\n");
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    const std::string nodes =
      std::to_string(source(e, graph)) + " - " + std::to_string(target(e, graph));
    std::cout << std::setw(5) << graph[e].loop << "  " << std::left;
    if (tells_part)
      std::cout << std::setw(6) << graph[e].part;
    std::cout << std::setw(13) << nodes << std::setw(12) << SMF::name(graph[e].component)
              << std::setw(12) << graph[e].height << std::setw(12) << graph[e].flux
              << std::setw(moduli.empty() ? 0 : 12) << SMF::length(graph[e].polyline);
    if (const auto found = moduli.find(graph[e].loop); found != moduli.end())
      std::cout << found->second;
    std::cout << std::right << '\n';
  }
  print_symmetries(result);
  std::cout << "\nseconds:";
  for (const auto& [stage, time] : result.seconds)
    std::cout << ' ' << stage << ' ' << std::setprecision(3) << time;
  std::cout << '\n';
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_PRINT_TABLE_H
