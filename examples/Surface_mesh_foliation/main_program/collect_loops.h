// The poles and loops of all parts: those that are given, and those that are found.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_COLLECT_LOOPS_H
#define SMF_EXAMPLES_MAIN_PROGRAM_COLLECT_LOOPS_H

#include "Options.h"
#include "Result.h"
#include "find_loops.h"
#include "read_loops.h"

#include <cstddef>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace main_program {

// Of several parts, one that has no graph is no reason to give up the others, unless something was
// given there.
template <class Function>
void try_part(Result& result, std::size_t i, const Function& function)
{
  Part& part = result.parts[i];
  if (!part.error.empty())
    return;
  if (!has_several_parts(result))
    return function();
  try
  {
    function();
  }
  catch (const std::exception& exception)
  {
    part.error = "part " + std::to_string(i) + ": " + exception.what();
    if (part.number_of_given > 0)
      throw std::invalid_argument(part.error);
  }
}

// Loop ids, for each part: poles, poles at positions, line poles, openings, lines and poles that
// are found, then the loops that are found or those of the file, each in order.
inline void collect_loops(const Options& options, Result& result)
{
  const auto poles =
    SMF::poles_and_loops_of_parts(result.part_meshes, given_poles(options, result));
  const auto loops =
    SMF::poles_and_loops_of_parts(result.part_meshes, given_loops(options, result));
  bool finds_loops = false;
  for (std::size_t i = 0; i < result.parts.size(); ++i)
  {
    Part& part = result.parts[i];
    part.input = poles[i];
    part.number_of_given = poles[i].size() + loops[i].size();
    finds_loops = finds_loops || Search(options, part).handles;
  }
  if (options.min_loop_length && !finds_loops)
    throw std::invalid_argument("--min-loop-length: no loops for handles are to be found");
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    try_part(result, i, [&] {
      Part& part = result.parts[i];
      part.number_of_ends = SMF::add_border_poles(result.part_meshes[i], part.input);
      find_poles_and_loops(options, result.part_meshes[i], part, result.detector);
      for (const auto& entry : loops[i].entries())
        part.input.add_loop(entry.loop);
      check_that_there_are_enough(options, result.part_meshes[i], part);
    });
  set_heights(options, result);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_COLLECT_LOOPS_H
