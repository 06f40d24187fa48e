// The Reeb graph of a mesh from poles and loops: the main program of the package.
//
// Reads a triangle mesh, computes the harmonic foliation of the given poles and loops, or of those
// that it finds, and prints its Reeb graph; with --output it also writes files to look at.
// `foliation_reeb_graph --help` tells more.

#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/feature_poles.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace SMF = CGAL::Surface_mesh_foliation;

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point_3>;
using Foliation = SMF::Measured_foliation<Mesh>;
using Graph = SMF::Reeb_graph<Point_3>;
using Json = nlohmann::ordered_json;

constexpr int unlimited = std::numeric_limits<int>::max();

struct Options
{
  std::string mesh, loops, output;
  std::string weights = "mean-value", solver = "newton";
  std::vector<std::string> poles;      // vertex indices
  std::vector<std::string> pole_lines; // vertex indices with commas between
  bool finds_lines = false, finds_poles = false, finds_loops = false;
  int max_found_poles = unlimited;
  std::optional<double> min_loop_length;
  double height = 1;
  std::vector<double> heights; // by loop; if empty, all are `height`
  double tolerance = 1e-12;
  std::optional<int> max_iterations;
  double relaxation = 1;
  bool prints_json = false, is_quiet = false;
};

// Everything that the program computes, with the seconds that each stage took.
struct Result
{
  Mesh mesh;
  SMF::Poles_and_loops<Mesh> input;
  std::vector<std::vector<std::size_t>> poles; // vertex indices
  std::optional<Foliation> foliation;
  std::vector<SMF::Singularity<Mesh>> singularities;
  Mesh components;
  SMF::Reeb_graph_embedding<Point_3> embedding;
  Graph graph;
  std::vector<std::pair<std::string, double>> seconds;
};

// Progress on a terminal: one line, replaced by the next and wiped out at the end. That a stage has
// begun is told once the program has run for a while, or if the stage may take a while.
class Progress
{
public:
  explicit Progress(bool is_on) : m_is_on(is_on && isatty(STDERR_FILENO) != 0) { m_timer.start(); }
  ~Progress() { show(""); }

  void begin(const std::string& stage, std::size_t size)
  {
    m_stage = stage;
    if (m_timer.time() > 1 || size > 50000) // vertices, or kilobytes of a file
      show(stage);
  }

  bool after_coarse_iteration(std::size_t size, const SMF::Foliation_statistics& statistics)
  {
    return tell(m_stage + " on " + std::to_string(size) + " vertices", statistics);
  }

  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    return tell(m_stage, statistics);
  }

private:
  bool tell(const std::string& where, const SMF::Foliation_statistics& statistics)
  {
    std::ostringstream text;
    text << where << ", iteration " << statistics.number_of_iterations << ", optimality "
         << statistics.optimality << ", " << statistics.number_of_moves << " moves";
    if (m_timer.time() > 1 && m_timer.time() > m_last_time + 0.1)
      show(text.str());
    return true;
  }

  void show(const std::string& text)
  {
    if (!m_is_on || text == m_text)
      return;
    std::cerr << '\r' << text
              << std::string(m_text.size() > text.size() ? m_text.size() - text.size() : 0, ' ')
              << (text.empty() ? "\r" : "") << std::flush;
    m_text = text;
    m_last_time = m_timer.time();
  }

  bool m_is_on;
  CGAL::Real_timer m_timer;
  double m_last_time = 0;
  std::string m_stage, m_text; // what is on the line
};

void set_up_search(CLI::App& app, Options& options, CLI::Option& loops)
{
  app
    .add_option_function<std::string>(
      "--auto-poles",
      [&options](const std::string& number) { // empty if there is none
        options.finds_poles = true;
        if (!number.empty())
          options.max_found_poles = std::stoi(number);
      },
      "find poles, at most N; with neither pole nor loop given, this and --auto-loops are on")
    ->expected(0, 1)
    ->check(CLI::Range(0, unlimited))
    ->option_text("[N]");
  app
    .add_option_function<std::string>(
      "--pole-lines", [&options](const std::string& how) { options.finds_lines = how == "auto"; },
      "auto: find line poles, the rims of fins and wings; none (default)")
    ->check(CLI::IsMember({"auto", "none"}));
  app.add_flag("--auto-loops", options.finds_loops, "find loops for the handles")->excludes(&loops);
  app
    .add_option("--min-loop-length", options.min_loop_length,
                "leave handles out that --auto-loops would find a shorter loop for")
    ->check(CLI::NonNegativeNumber);
}

void set_up(CLI::App& app, Options& options)
{
  app.add_option("MESH", options.mesh, "the mesh: .off, .obj or .ply")->required();
  app.add_option("--pole", options.poles, "a vertex that becomes a pole; may be repeated")
    ->allow_extra_args(false);
  app
    .add_option("--pole-line", options.pole_lines,
                "vertices of a line pole, with commas between; may be repeated")
    ->allow_extra_args(false);
  const auto loops =
    app.add_option("--loops", options.loops,
                   "a file of loops, one a line: cycle V..., through V..., separate V..., "
                   "plane A B C D V");
  set_up_search(app, options, *loops);
  const auto height = app.add_option("--height", options.height, "the height of all loops (1)");
  app.add_option("--heights", options.heights, "the height of each loop, with commas between")
    ->delimiter(',')
    ->allow_extra_args(false)
    ->excludes(height);
  app.add_option("--weights", options.weights, "mean-value (default) or cotangent")
    ->check(CLI::IsMember({"mean-value", "cotangent"}));
  app.add_option("--solver", options.solver, "newton (default) or whitehead, the paper's")
    ->check(CLI::IsMember({"newton", "whitehead"}));
  app
    .add_option("--relaxation", options.relaxation,
                "the over-relaxation of Whitehead moves, between 0 and 2 (1)")
    ->check(CLI::Range(0., 2.));
  app.add_option("--tolerance", options.tolerance, "the bound for optimality (1e-12)")
    ->check(CLI::PositiveNumber);
  app
    .add_option("--max-iterations", options.max_iterations,
                "the most iterations (100), or sweeps (1000000)")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--output", options.output, "the folder to write files to");
  app.add_flag("--json", options.prints_json, "print one JSON object");
  app.add_flag("--quiet", options.is_quiet, "print nothing but errors, and JSON if asked for");
}

Mesh::Vertex_index vertex(const Mesh& mesh, const std::string& text, const std::string& option)
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

std::vector<Mesh::Vertex_index> pole_line(const Mesh& mesh, const std::string& text)
{
  std::vector<Mesh::Vertex_index> result;
  for (std::size_t first = 0, end = 0; end != std::string::npos; first = end + 1)
  {
    end = text.find(',', first);
    result.push_back(vertex(mesh, text.substr(first, end - first), "--pole-line"));
  }
  return result;
}

bool has_pole_at(const Result& result, Mesh::Vertex_index v)
{
  const auto has_v = [&](const std::vector<std::size_t>& pole) {
    return std::find(pole.begin(), pole.end(), v) != pole.end();
  };
  return std::any_of(result.poles.begin(), result.poles.end(), has_v);
}

void add_line_pole(Result& result, const std::vector<Mesh::Vertex_index>& line)
{
  result.input.add_line_pole(line);
  result.poles.emplace_back(line.begin(), line.end());
}

// Lines that are found come after the poles that are given, which they must not meet. Returns the
// vertices of blades: those closer to a line than the width of its blade.
std::vector<bool> find_lines(Result& result)
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
void find_poles(const Options& options, const std::vector<bool>& is_on_blade, Result& result)
{
  std::vector<Mesh::Vertex_index> found;
  const auto parameters = SMF::parameters::number_of_poles(options.max_found_poles);
#ifdef CGAL_SURFACE_MESH_FOLIATION_HAS_SPECTRA
  SMF::detect_feature_poles(result.mesh, std::back_inserter(found), parameters);
#else
  SMF::detect_feature_poles(
    result.mesh, std::back_inserter(found),
    SMF::parameters::combine(parameters,
                             SMF::parameters::pole_detector(SMF::Average_geodesic_distance())));
#endif
  for (const Mesh::Vertex_index v : found)
  {
    if (has_pole_at(result, v) || is_on_blade[v])
      continue;
    result.input.add_pole(v);
    result.poles.push_back({v});
  }
}

void find_loops(const Options& options, Result& result)
{
  SMF::propose_loops(result.mesh, result.input,
                     SMF::parameters::min_loop_length(options.min_loop_length.value_or(0)));
}

// Loop ids: poles, line poles, lines and poles that are found, then the loops of the file or those
// that are found, each in order.
void read_loops(const Options& options, Result& result)
{
  const bool is_nothing_given = options.poles.empty() && options.pole_lines.empty() &&
                                options.loops.empty() && !options.finds_poles &&
                                !options.finds_lines && !options.finds_loops;
  const bool finds_loops = options.finds_loops || is_nothing_given;
  if (options.min_loop_length && !finds_loops)
    throw std::invalid_argument("--min-loop-length: no loops are to be found");
  for (const std::string& text : options.poles)
  {
    const Mesh::Vertex_index v = vertex(result.mesh, text, "--pole");
    result.input.add_pole(v);
    result.poles.push_back({v});
  }
  for (const std::string& text : options.pole_lines)
    add_line_pole(result, pole_line(result.mesh, text));
  std::vector<bool> is_on_blade(num_vertices(result.mesh), false);
  if (options.finds_lines)
    is_on_blade = find_lines(result);
  if (options.finds_poles || is_nothing_given)
    find_poles(options, is_on_blade, result);
  if (finds_loops)
    find_loops(options, result);
  if (!options.loops.empty())
    SMF::read_loops(options.loops, result.mesh, result.input);
  if (!options.heights.empty() && options.heights.size() != result.input.size())
    throw std::invalid_argument("--heights: " + std::to_string(options.heights.size()) +
                                " heights for " + std::to_string(result.input.size()) + " loops");
  for (std::size_t a = 0; a < result.input.size(); ++a)
    result.input.set_height(a, options.heights.empty() ? options.height : options.heights[a]);
}

template <class Weights>
Foliation solve(const Options& options,
                const SMF::Loop_system<Mesh>& system,
                Weights weights,
                Progress& progress)
{
  const bool is_newton = options.solver == "newton";
  const auto parameters = SMF::parameters::combine(
    SMF::parameters::weights(weights), SMF::parameters::tolerance(options.tolerance),
    CGAL::parameters::number_of_iterations(
      options.max_iterations.value_or(is_newton ? 100 : 1000000)),
    CGAL::parameters::visitor(std::ref(progress)));
  if (is_newton)
    return SMF::harmonic_foliation(system, parameters);
  return SMF::whitehead_foliation(
    system,
    SMF::parameters::combine(parameters, SMF::parameters::over_relaxation(options.relaxation)));
}

Foliation solve(const Options& options, const SMF::Loop_system<Mesh>& system, Progress& progress)
{
  return options.weights == "cotangent"
           ? solve(options, system, SMF::Cotangent_weights(), progress)
           : solve(options, system, SMF::Mean_value_weights(), progress);
}

Result run(const Options& options, Progress& progress)
{
  Result result;
  CGAL::Real_timer timer;
  timer.start();
  const auto stop = [&](const char* stage) {
    result.seconds.emplace_back(stage, timer.time());
    timer.reset();
  };
  std::error_code no_size;
  progress.begin("reading", std::filesystem::file_size(options.mesh, no_size) / 1024);
  SMF::read_triangle_mesh(options.mesh, result.mesh);
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
  return result;
}

Json to_json(const Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

Json singularities_to_json(const Result& result)
{
  int centre_poles = 0, thorn_poles = 0;
  std::map<int, int> saddles; // number by order
  for (const auto& singularity : result.singularities)
    if (singularity.index < 0)
      ++saddles[-singularity.index];
    else
      ++(singularity.index == 2 ? centre_poles : thorn_poles);
  Json orders = Json::object();
  for (const auto& [order, number] : saddles)
    orders[std::to_string(order)] = number;
  return {{"centre_poles", centre_poles}, {"thorn_poles", thorn_poles}, {"saddles", orders}};
}

Json graph_to_json(const Graph& graph)
{
  Json nodes = Json::array(), arcs = Json::array();
  std::vector<std::size_t> degrees;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
  {
    degrees.push_back(degree(v, graph));
    nodes.push_back({{"id", graph[v].id},
                     {"kind", SMF::name(graph[v].kind)},
                     {"pole", graph[v].pole},
                     {"genus", graph[v].genus},
                     {"degree", degrees.back()},
                     {"point", to_json(graph[v].point)}});
  }
  std::sort(degrees.begin(), degrees.end());
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    arcs.push_back({{"id", graph[e].loop},
                    {"nodes", {source(e, graph), target(e, graph)}},
                    {"loop", graph[e].loop},
                    {"height", graph[e].height},
                    {"flux", graph[e].flux},
                    {"length", SMF::length(graph[e].polyline)},
                    {"area", graph[e].area}});
  const std::size_t cycles = num_edges(graph) + 1 - num_vertices(graph); // it is connected
  return {{"nodes", nodes}, {"arcs", arcs}, {"cycles", cycles}, {"degrees", degrees}};
}

Json components_to_json(const Graph& graph)
{
  std::map<SMF::Component_kind, int> number;
  for (const auto& e : boost::make_iterator_range(edges(graph)))
    ++number[graph[e].component];
  return {{"disks", number[SMF::Component_kind::DISK]},
          {"cylinders", number[SMF::Component_kind::CYLINDER]},
          {"spheres", number[SMF::Component_kind::SPHERE]}};
}

Json to_json(const Options& options, const Result& result)
{
  const SMF::Foliation_statistics& statistics = result.foliation->statistics();
  Json seconds = Json::object();
  double total = 0;
  for (const auto& [stage, time] : result.seconds)
  {
    seconds[stage] = time;
    total += time;
  }
  seconds["total"] = total;
  return {{"vertices", num_vertices(result.mesh)},
          {"faces", num_faces(result.mesh)},
          {"genus", result.foliation->system().genus()},
          {"poles", result.poles},
          {"loops", result.input.size()},
          {"foliation",
           {{"solver", options.solver},
            {"energy", statistics.energy},
            {"optimality", statistics.optimality},
            {"iterations", statistics.number_of_iterations},
            {"converged", statistics.has_converged},
            {"certified", statistics.is_certified}}},
          {"singularities", singularities_to_json(result)},
          {"reeb_graph", graph_to_json(result.graph)},
          {"components", components_to_json(result.graph)},
          {"seconds", seconds}};
}

void print_table(const Result& result)
{
  const Graph& graph = result.graph;
  const SMF::Foliation_statistics& statistics = result.foliation->statistics();
  const std::size_t genus = result.foliation->system().genus();
  std::cout << num_vertices(result.mesh) << " vertices, " << num_faces(result.mesh)
            << " faces, genus " << genus << "\nfoliation: energy " << statistics.energy
            << ", optimality " << statistics.optimality << " after "
            << statistics.number_of_iterations << " iterations"
            << (statistics.has_converged ? "" : ", NOT CONVERGED")
            << ", certified\nReeb graph: " << num_vertices(graph) << " nodes, " << num_edges(graph)
            << " arcs, " << num_edges(graph) + 1 - num_vertices(graph) << " cycles\n\n";
  std::cout << "  arc  nodes        component   height      flux        length\n";
  for (const auto& e : boost::make_iterator_range(edges(graph)))
  {
    const std::string nodes =
      std::to_string(source(e, graph)) + " - " + std::to_string(target(e, graph));
    std::cout << std::setw(5) << graph[e].loop << "  " << std::left << std::setw(13) << nodes
              << std::setw(12) << SMF::name(graph[e].component) << std::setw(12) << graph[e].height
              << std::setw(12) << graph[e].flux << SMF::length(graph[e].polyline) << std::right
              << '\n';
  }
  std::cout << "\nseconds:";
  for (const auto& [stage, time] : result.seconds)
    std::cout << ' ' << stage << ' ' << std::setprecision(3) << time;
  std::cout << '\n';
}

void write_files(const Options& options, const Result& result)
{
  std::filesystem::create_directories(options.output);
  const auto file = [&](const char* name) {
    return (std::filesystem::path(options.output) / name).string();
  };
  SMF::write_reeb_graph_graphml(file("reeb_graph.graphml"), result.graph);
  SMF::write_reeb_graph_dot(file("reeb_graph.dot"), result.graph);
  SMF::write_skeleton_ply(file("skeleton.ply"), result.graph);
  SMF::write_leaves_ply(file("leaves.ply"), *result.foliation, result.embedding);
  SMF::write_components_ply(file("components.ply"), *result.foliation);
  SMF::write_foliation_ply(file("foliation.ply"), *result.foliation);
  SMF::write_skeleton_vtp(file("skeleton.vtp"), result.graph);
  SMF::write_leaves_vtp(file("leaves.vtp"), *result.foliation, result.embedding);
  SMF::write_components_vtp(file("components.vtp"), *result.foliation);
  SMF::write_foliation_vtp(file("foliation.vtp"), *result.foliation);
  SMF::write_singularities_vtp(file("singularities.vtp"), *result.foliation);
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
    const Result result = [&] {
      Progress progress(!options.is_quiet);
      Result run_result = run(options, progress);
      progress.begin("writing", num_vertices(run_result.mesh));
      if (!options.output.empty())
        write_files(options, run_result);
      return run_result;
    }();
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
