// The Reeb graph of a mesh from poles and loops: the main program of the package.
//
// Reads a triangle mesh, computes the harmonic foliation of the given poles and loops, or of those
// that it finds, and prints its Reeb graph; with --output it also writes files to view.
// `foliation_reeb_graph --help` lists the options. Options, loops and output are in main_program/.
// With -D SURFACE_MESH_FOLIATION_BUILD_PROGRAM=ON it is installed as surface-mesh-foliation.

#include "main_program/Interruption.h"
#include "main_program/Options.h"
#include "main_program/Progress.h"
#include "main_program/Result.h"
#include "main_program/collect_loops.h"
#include "main_program/print_table.h"
#include "main_program/read_mesh.h"
#include "main_program/result_to_json.h"
#include "main_program/write_files.h"

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Real_timer.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

using namespace main_program;

// More leaves are sampled where a chord between two is farther from the leaf between them than
// this, in units of its radius.
constexpr double max_chord_deviation = 0.1;

template <class Weights>
Part_foliation solve(const Options& options,
                     const SMF::Loop_system<Part_mesh>& system,
                     Weights weights,
                     Progress& progress)
{
  const bool is_newton = options.solver == "newton";
  const auto parameters =
    SMF::parameters::weights(weights)
      .tolerance(options.tolerance)
      .number_of_iterations(options.max_iterations.value_or(is_newton ? 100 : 1000000))
      .visitor(std::ref(progress));
  if (is_newton)
    return SMF::harmonic_foliation(system, parameters);
  return SMF::whitehead_foliation(system, parameters.over_relaxation(options.relaxation));
}

Part_foliation solve(const Options& options,
                     const SMF::Loop_system<Part_mesh>& system,
                     Progress& progress)
{
  return options.weights == "cotangent"
           ? solve(options, system, SMF::Cotangent_weights(), progress)
           : solve(options, system, SMF::Mean_value_weights(), progress);
}

SMF::Reeb_graph_embedding<Point_3> embed(const Options& options, const Part_foliation& foliation)
{
  if (options.number_of_samples)
    return SMF::reeb_graph_embedding(
      foliation, SMF::parameters::number_of_samples(*options.number_of_samples));
  return SMF::reeb_graph_embedding(foliation,
                                   SMF::parameters::max_chord_deviation(max_chord_deviation));
}

// The seconds of the stages, which come once for each part.
class Stopwatch
{
public:
  explicit Stopwatch(Result& result) : m_result(result)
  {
    for (const char* stage : {"read", "loops", "foliation", "extraction", "embedding"})
      m_result.seconds.emplace_back(stage, 0);
    m_timer.start();
  }

  // adds the time since the last call to a stage
  void stop(const std::string& stage)
  {
    for (auto& [name, seconds] : m_result.seconds)
      if (name == stage)
        seconds += m_timer.time();
    m_timer.reset();
  }

private:
  Result& m_result;
  CGAL::Real_timer m_timer;
};

void run_part(
  const Options& options, Progress& progress, Stopwatch& watch, const Part_mesh& mesh, Part& part)
{
  const std::size_t n = vertices(mesh).size();
  progress.begin("loops", n);
  const SMF::Loop_system<Part_mesh> system(mesh, part.input);
  watch.stop("loops");
  progress.begin("foliation", n);
  const Part_foliation foliation = solve(options, system, progress);
  watch.stop("foliation");
  progress.begin("extraction", n);
  SMF::singularities(foliation, std::back_inserter(part.singularities));
  watch.stop("extraction");
  progress.begin("embedding", n);
  part.embedding = embed(options, foliation);
  watch.stop("embedding");
  part.foliation = foliation;
}

// Loops and poles have numbers of their own also in parts that have no graph.
void join_graphs(Result& result)
{
  SMF::Part_numbers numbers;
  for (std::size_t i = 0; i < result.parts.size(); ++i)
  {
    const Part& part = result.parts[i];
    const SMF::Part_numbers before = numbers;
    if (part.foliation)
      SMF::reeb_graph_of_part(*part.foliation, result.graph, part.embedding, numbers);
    numbers.parts = i + 1;
    numbers.loops = before.loops + part.input.size();
    numbers.poles = before.poles;
    for (const auto& entry : part.input.entries())
      numbers.poles += entry.is_pole_loop();
  }
}

void run(const Options& options, Progress& progress, Result& result)
{
  Stopwatch watch(result);
  std::error_code no_size;
  progress.begin("reading", std::filesystem::file_size(options.mesh, no_size) / 1024);
  read_mesh(options, result);
  watch.stop("read");
  progress.begin("loops", num_vertices(result.mesh));
  collect_loops(options, result);
  watch.stop("loops");
  for (std::size_t i = 0; i < result.parts.size(); ++i)
    try_part(result, i,
             [&] { run_part(options, progress, watch, result.part_meshes[i], result.parts[i]); });
  join_graphs(result);
  watch.stop("embedding");
  if (num_vertices(result.graph) == 0)
    throw std::runtime_error("no part has a graph; " + result.parts[0].error);
}

// The first line of a message.
std::string one_line(const std::string& message)
{
  return message.substr(0, message.find('\n'));
}

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app(description);
  set_up(app, options);
  try
  {
    app.parse(argc, argv);
    Result result;
    {
      Progress progress(!options.is_quiet);
      run(options, progress, result);
      progress.begin("writing", num_vertices(result.mesh));
      if (!options.output.empty())
        write_files(options, result);
    } // the line of progress is gone before anything is printed
    for (const Part& part : result.parts)
      if (!part.error.empty())
        std::cerr << "warning: " << one_line(part.error) << std::endl;
    if (options.prints_json)
      std::cout << to_json(options, result).dump(2) << std::endl;
    else if (!options.is_quiet)
      print_table(options, result);
    if (!std::cout)
      throw std::runtime_error("the standard output cannot be written");
  }
  catch (const CLI::Success& success) // --help, --version
  {
    return app.exit(success);
  }
  catch (const Interrupted& interrupted)
  {
    std::cerr << "error: interrupted; some files are not written" << std::endl;
    return 128 + interrupted.signal; // as shells have it
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << one_line(error.what()) << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
