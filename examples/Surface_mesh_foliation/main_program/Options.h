// The options of the main program, and its command line.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_OPTIONS_H
#define SMF_EXAMPLES_MAIN_PROGRAM_OPTIONS_H

#include <CGAL/Surface_mesh_foliation/canonical_loops.h>
#include <CGAL/Surface_mesh_foliation/version.h>

#include <CLI/CLI.hpp>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace main_program {

constexpr char description[] = "The Reeb graph of a surface mesh by a harmonic measured foliation";
constexpr int unlimited = (std::numeric_limits<int>::max)();

struct Options
{
  std::string mesh, loops, output;
  std::string format = "off"; // of the standard input
  std::string weights = "mean-value", solver = "newton";
  // Openings of the mesh that are longer are ends, the others are filled; by default, it is a
  // twentieth of the diagonal.
  std::optional<double> max_filled_length;
  bool repairs = false;
  int max_parts = unlimited;
  std::vector<std::string> poles;          // vertex indices
  std::vector<std::string> pole_positions; // three coordinates separated by commas
  std::vector<std::string> pole_lines;     // vertex indices separated by commas
  bool finds_lines = false, finds_poles = false, finds_loops = false;
  int max_found_poles = unlimited;
  std::optional<double> min_loop_length;
  std::optional<double> min_modulus; // of canonical loops, if they are asked for
  bool is_star = false;
  double height = 1;
  std::vector<double> heights; // by loop; if empty, all are `height`
  double tolerance = 1e-12;
  std::optional<int> max_iterations;
  double relaxation = 1;
  std::optional<int> number_of_samples; // in each arc; as many as the shape needs by default
  bool shows_symmetry = false, prints_json = false, is_quiet = false;
};

inline bool is_standard_input(const Options& options)
{
  return options.mesh == "-";
}

// of canonical loops
inline double min_modulus(const Options& options)
{
  return options.min_modulus.value_or(CGAL::Surface_mesh_foliation::default_min_modulus);
}

inline void set_up_search(CLI::App& app, Options& options, CLI::Option& loops)
{
  app
    .add_option_function<std::string>(
      "--auto-poles",
      [&options](const std::string& number) { // empty if there is none
        options.finds_poles = true;
        if (!number.empty())
          options.max_found_poles = std::stoi(number);
      },
      "find poles, at most N; without any option that gives or finds poles or loops, this and "
      "--detail are on")
    ->expected(0, 1)
    ->check(CLI::Range(0, unlimited))
    ->option_text("[N]");
  app
    .add_option_function<std::string>(
      "--pole-lines", [&options](const std::string& how) { options.finds_lines = how == "auto"; },
      "auto: find line poles, the rims of fins and wings; none (default)")
    ->check(CLI::IsMember({"auto", "none"}));
  const auto handles =
    app.add_flag("--auto-loops", options.finds_loops, "find loops for the handles");
  handles->excludes(&loops);
  const auto detail =
    app
      .add_option("--detail", options.min_modulus,
                  "find the canonical loops whose moduli, heights of annuli around narrow parts "
                  "divided by circumferences, are at least M (0.6), and loops for the handles")
      ->check(CLI::NonNegativeNumber)
      ->option_text("M");
  detail->excludes(&loops)->excludes(handles);
  app
    .add_flag("--star", options.is_star,
              "no loops between groups of poles: without handles, the graph is a star")
    ->excludes(detail);
  app
    .add_option("--min-loop-length", options.min_loop_length,
                "leave out handles for which --auto-loops finds a shorter loop")
    ->check(CLI::NonNegativeNumber)
    ->excludes(detail);
}

inline void set_up_mesh(CLI::App& app, Options& options)
{
  app.add_flag("--repair", options.repairs,
               "repair the mesh: merge equal positions, cut polygons into triangles, orient faces, "
               "take non-manifold places apart, remove what is degenerate, repeated or unused");
  app
    .add_option_function<std::string>(
      "--parts",
      [&options](const std::string& which) {
        options.max_parts = which == "all" ? unlimited : which == "largest" ? 1 : std::stoi(which);
      },
      "of a mesh of several parts, take all (default), the largest, or the N largest")
    ->check(CLI::IsMember({"all", "largest"}) | CLI::Range(1, unlimited))
    ->option_text("all|largest|N");
  app
    .add_option_function<std::string>(
      "--borders",
      [&options](const std::string& which) {
        options.max_filled_length = which == "ends"   ? 0
                                    : which == "fill" ? std::numeric_limits<double>::infinity()
                                                      : std::stod(which);
      },
      "what openings of the mesh are: ends of its graph, to be filled (fill), or filled if their "
      "borders have at most this LENGTH (a twentieth of the diagonal)")
    ->check(CLI::IsMember({"ends", "fill"}) | CLI::NonNegativeNumber)
    ->option_text("ends|fill|LENGTH");
}

inline void set_up(CLI::App& app, Options& options)
{
  app
    .add_option("MESH", options.mesh,
                "the mesh: .off, .obj, .ply or .stl; .vtp, .vtu, .gltf or .glb if "
                "the program was compiled with VTK or Assimp; - for the standard input")
    ->required();
  app
    .add_option("--format", options.format, "of the standard input: off (default), obj, ply or stl")
    ->check(CLI::IsMember({"off", "obj", "ply", "stl"}));
  app.add_option("--pole", options.poles, "a vertex that becomes a pole; may be repeated")
    ->allow_extra_args(false)
    ->option_text("V");
  app
    .add_option("--pole-at", options.pole_positions,
                "the vertex nearest to these coordinates becomes a pole; may be repeated")
    ->allow_extra_args(false)
    ->option_text("X,Y,Z");
  app.add_option("--pole-line", options.pole_lines, "the vertices of a line pole; may be repeated")
    ->allow_extra_args(false)
    ->option_text("V0,V1,...");
  const auto loops =
    app
      .add_option("--loops", options.loops,
                  "a loops file, one loop per line: cycle V..., through V..., separate V..., "
                  "plane A B C D V")
      ->option_text("FILE");
  set_up_mesh(app, options);
  set_up_search(app, options, *loops);
  const auto height =
    app.add_option("--height", options.height, "the height of all loops (1)")->option_text("K");
  app.add_option("--heights", options.heights, "the height of each loop; not with --height")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->option_text("K0,K1,...")
    ->excludes(height);
  app.add_option("--weights", options.weights, "mean-value (default) or cotangent")
    ->check(CLI::IsMember({"mean-value", "cotangent"}));
  app
    .add_option("--solver", options.solver, "newton (default) or whitehead, the paper's algorithm")
    ->check(CLI::IsMember({"newton", "whitehead"}));
  app
    .add_option("--relaxation", options.relaxation,
                "the over-relaxation of Whitehead moves, between 0 and 2 (1)")
    ->check(CLI::Range(0., 2.));
  app.add_option("--tolerance", options.tolerance, "the bound for optimality (1e-12)")
    ->check(CLI::PositiveNumber);
  app
    .add_option("--max-iterations", options.max_iterations,
                "the largest number of iterations (100) or sweeps (1000000)")
    ->check(CLI::NonNegativeNumber);
  app
    .add_option_function<std::string>(
      "--samples",
      [&options](const std::string& number) {
        if (number != "auto")
          options.number_of_samples = std::stoi(number);
      },
      "the number of leaves sampled in each arc; auto (default): as many as its shape needs")
    ->check(CLI::IsMember({"auto"}) | CLI::Range(0, unlimited))
    ->option_text("auto|N");
  app.add_option("--output", options.output, "the folder to write files to")->option_text("DIR");
  app.add_flag("--symmetry", options.shows_symmetry,
               "in segments.ply, give arcs that symmetries exchange one number and one color");
  app.add_flag("--json", options.prints_json, "print one JSON object");
  app.add_flag("--quiet", options.is_quiet, "print nothing but errors, and JSON if requested");
  app.set_version_flag("--version", "Surface_mesh_foliation " CGAL_SURFACE_MESH_FOLIATION_VERSION,
                       "print the version of the package");
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_OPTIONS_H
