// time_session MESH REPETITIONS: how long the engine takes, compiled natively: medians in
// milliseconds of processor time, which other programs disturb less, and by the clock for the
// stages of a solve, as one JSON object. time_engine.mjs does the same in WebAssembly.

#include "engine/Session.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using namespace smf_engine;
using Json = nlohmann::json;

namespace {

template <class Function>
double milliseconds_of(const Function& function)
{
  const std::clock_t start = std::clock();
  function();
  return 1000. * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Index neighbor_of(Index vertex, const Indices& edges)
{
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (edges[i] == vertex)
      return edges[i ^ 1];
  throw std::runtime_error("vertex " + std::to_string(vertex) + " has no edge");
}

// The states follow one another, again and again.
Json times_of_edits(Session& session, const std::vector<State>& states, int repetitions)
{
  std::vector<double> loops, solve, extract, total;
  for (int i = 0; i < repetitions; ++i)
    for (const State& state : states)
      total.push_back(milliseconds_of([&] {
        const Milliseconds& stages =
          session.solve(state, [](const std::string&) { return true; }).milliseconds;
        loops.push_back(stages.loops);
        solve.push_back(stages.solve);
        extract.push_back(stages.extract);
      }));
  return {{"first", total[0]},
          {"total", median(total)},
          {"loops", median(loops)},
          {"solve", median(solve)},
          {"extract", median(extract)}};
}

Json times_of(const std::string& file, int repetitions)
{
  std::optional<Session> session;
  Json times;
  times["load"] = milliseconds_of([&] { session.emplace(file, false, false); });
  State state;
  const auto find_poles = [&] { state.poles = session->find_poles().poles; };
  times["poles, first"] = milliseconds_of(find_poles);
  std::vector<double> of_poles;
  for (int i = 0; i < repetitions; ++i)
    of_poles.push_back(milliseconds_of(find_poles));
  times["poles"] = median(of_poles);
  State moved = state, higher = state;
  moved.poles.front().vertex = neighbor_of(state.poles.front().vertex, session->loaded().edges());
  higher.poles.front().height = 2;
  times["canonical, moved pole"] = times_of_edits(*session, {state, moved}, repetitions);
  times["canonical, height"] = times_of_edits(*session, {state, higher}, repetitions);
  state.mode = moved.mode = Mode::STAR;
  times["star, moved pole"] = times_of_edits(*session, {state, moved}, repetitions);
  times["leaves, 10 per arc"] = milliseconds_of([&] { session->leaves(10); });
  times["vertices"] = session->loaded().mesh.number_of_vertices();
  return times;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "time_session MESH REPETITIONS" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    std::cout << times_of(argv[1], std::stoi(argv[2])).dump() << std::endl;
  }
  catch (const std::exception& exception)
  {
    std::cerr << exception.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
