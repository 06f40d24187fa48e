// The Reeb graph of a mesh from poles and loops: the main program of the package.
//
// Reads a triangle mesh, computes the harmonic foliation of the given poles and loops, or of those
// that it finds, and prints its Reeb graph; with --output it also writes files to view.
// `foliation_reeb_graph --help` lists the options. Options, loops and output are in main_program/.

#include "main_program/Options.h"
#include "main_program/Progress.h"
#include "main_program/Result.h"
#include "main_program/read_loops.h"
#include "main_program/write_result.h"

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

template <class Weights>
Foliation solve(const Options& options,
                const SMF::Loop_system<Mesh>& system,
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

Foliation solve(const Options& options, const SMF::Loop_system<Mesh>& system, Progress& progress)
{
  return options.weights == "cotangent"
           ? solve(options, system, SMF::Cotangent_weights(), progress)
           : solve(options, system, SMF::Mean_value_weights(), progress);
}

// `result.foliation` refers to `result.mesh`, so a result stays where it is.
void run(const Options& options, Progress& progress, Result& result)
{
  CGAL::Real_timer timer;
  timer.start();
  const auto stop = [&](const char* stage) {
    result.seconds.emplace_back(stage, timer.time());
    timer.reset();
  };
  std::error_code no_size;
  progress.begin("reading", std::filesystem::file_size(options.mesh, no_size) / 1024);
  read_mesh(options, result);
  stop("read");
  const std::size_t n = num_vertices(result.mesh);
  progress.begin("loops", n);
  read_loops(options, result);
  const SMF::Loop_system<Mesh> system(result.mesh, result.input);
  stop("loops");
  progress.begin("foliation", n);
  const Foliation foliation = solve(options, system, progress);
  stop("foliation");
  progress.begin("extraction", n);
  SMF::singularities(foliation, std::back_inserter(result.singularities));
  SMF::surface_components(foliation, result.components);
  stop("extraction");
  progress.begin("embedding", n);
  result.embedding = SMF::reeb_graph_embedding(foliation);
  SMF::reeb_graph(foliation, result.graph, result.embedding);
  stop("embedding");
  result.foliation = foliation;
}

// The first line of a message.
std::string one_line(const std::string& message)
{
  return message.substr(0, message.find('\n'));
}

int main(int argc, char* argv[])
{
  Options options;
  CLI::App app("The Reeb graph of a closed triangle mesh by a harmonic measured foliation");
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
    if (options.prints_json)
      std::cout << to_json(options, result).dump(2) << std::endl;
    else if (!options.is_quiet)
      print_table(result);
    if (!std::cout)
      throw std::runtime_error("the standard output cannot be written");
  }
  catch (const CLI::Success& success) // --help
  {
    return app.exit(success);
  }
  catch (const std::exception& error)
  {
    std::cerr << "error: " << one_line(error.what()) << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
