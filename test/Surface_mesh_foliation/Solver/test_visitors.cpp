// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Visitors can stop a solver wherever they are called: softly, with a certified result, or for
// good, by an exception that leaves nothing broken.

#include <CGAL/Surface_mesh_foliation/internal/Solver/Progress.h>
#include <CGAL/Surface_mesh_foliation/Foliation_solver.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/whitehead_foliation.h>

#include "include/edge_value_difference.h"
#include "generators/meshes.h"

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_visitors {

namespace SMF = CGAL::Surface_mesh_foliation;

using namespace smf_test;
using Foliation = SMF::Measured_foliation<Mesh>;
using System = SMF::Loop_system<Mesh>;

namespace {

constexpr std::size_t never = (std::numeric_limits<std::size_t>::max)();

struct Case
{
  std::string name;
  Mesh mesh;

  System system() const
  {
    SMF::Poles_and_loops<Mesh> poles;
    for (std::size_t pole : {0, 1, 77})
      poles.add_pole(vertex(pole));
    return System(mesh, poles);
  }
};

// of three genera, each with coarser meshes
std::vector<Case> cases()
{
  return {
    {"genus 0", icosphere(4)}, {"genus 1", torus(48, 32, 3, 1)}, {"genus 3", genus_surface(3, 6)}};
}

// Stops at the n-th call of those that return `false` to stop.
struct Soft_stop
{
  explicit Soft_stop(std::size_t n) : limit(n) {}

  bool after_coarse_iteration(std::size_t, const SMF::Foliation_statistics&)
  {
    ++coarse_calls;
    return goes_on();
  }
  bool after_iteration(const SMF::Foliation_statistics&)
  {
    ++calls;
    return goes_on();
  }
  // is asked, but never says no
  bool go_on()
  {
    polls_after_stop += coarse_calls + calls >= limit;
    return true;
  }
  bool goes_on() const { return coarse_calls + calls < limit; }

  std::size_t limit, coarse_calls = 0, calls = 0, polls_after_stop = 0;
};

// Says at the n-th call of `go_on()` that no result is wanted.
struct Hard_stop : SMF::Default_foliation_visitor
{
  explicit Hard_stop(std::size_t n) : limit(n) {}

  bool after_iteration(const SMF::Foliation_statistics&)
  {
    EXPECT_LT(polls, limit) << "a call after the stop";
    return true;
  }
  bool after_coarse_iteration(std::size_t, const SMF::Foliation_statistics& s)
  {
    return after_iteration(s);
  }
  bool go_on() { return ++polls < limit; }

  std::size_t limit, polls = 0;
};

// what solvers catch from linear systems, thrown by a visitor
struct Thrower
{
  explicit Thrower(std::size_t n) : limit(n) {}

  bool call()
  {
    if (++calls == limit)
      throw SMF::Solver_exception({SMF::Problem_kind::SOLVER_FAILURE, "visitor's own", {}, {}, {}});
    EXPECT_LT(calls, limit) << "a call after the exception";
    return true;
  }
  bool after_iteration(const SMF::Foliation_statistics&) { return call(); }
  bool after_coarse_iteration(std::size_t, const SMF::Foliation_statistics&) { return call(); }
  void at_start(const std::vector<std::size_t>&) { call(); }
  bool go_on() { return call(); }

  std::size_t limit, calls = 0;
};

// Keeps the arcs of vertices that it is told at the start.
struct Start_keeper : SMF::Default_foliation_visitor
{
  bool after_iteration(const SMF::Foliation_statistics&)
  {
    EXPECT_FALSE(arcs.empty()) << "an iteration before the start";
    return true;
  }
  void at_start(const std::vector<std::size_t>& start)
  {
    EXPECT_TRUE(arcs.empty()) << "a second start";
    arcs = start;
  }

  // the share of vertices that lie elsewhere in the foliation
  double share_of_others(const Foliation& foliation) const
  {
    const Mesh& mesh = foliation.mesh();
    EXPECT_EQ(arcs.size(), mesh.number_of_vertices());
    std::size_t others = 0, i = 0;
    for (const auto v : mesh.vertices())
    {
      const Foliation::Cell cell = foliation.cell(v);
      others += arcs[i++] != (cell.is_arc ? cell.index : foliation.system().number_of_arcs());
    }
    return static_cast<double>(others) / static_cast<double>(mesh.number_of_vertices());
  }

  std::vector<std::size_t> arcs;
};

// Calls run(visitor) with a visitor that throws at its first call, then one at its second, and so
// on until none is thrown; after each exception check(). Returns how many were thrown.
template <class Visitor, class Exception, class Run, class Check>
std::size_t throw_everywhere(const Run& run, const Check& check)
{
  for (std::size_t n = 1;; ++n)
  {
    SCOPED_TRACE("call " + std::to_string(n));
    Visitor visitor(n);
    try
    {
      run(visitor);
      return n - 1;
    }
    catch (const Exception& exception)
    {
      EXPECT_EQ(exception.problem().kind == SMF::Problem_kind::STOPPED,
                (std::is_same_v<Exception, SMF::Stopped_exception>));
    }
    check();
  }
}

template <class ConcurrencyTag>
class Each_tag : public testing::Test
{};

using Tags = testing::Types<CGAL::Sequential_tag
#ifdef CGAL_LINKED_WITH_TBB
                            ,
                            CGAL::Parallel_tag
#endif
                            >;
TYPED_TEST_SUITE(Each_tag, Tags);

} // namespace

TYPED_TEST(Each_tag, soft_stops_leave_certified_foliations)
{
  std::size_t stops = 0, stops_with_linear_systems = 0;
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system = c.system();
    Soft_stop all(never);
    SMF::harmonic_foliation<TypeParam>(system, CGAL::parameters::visitor(std::ref(all)));
    EXPECT_GT(all.coarse_calls, 2u);
    EXPECT_GT(all.calls, 1u);
    EXPECT_EQ(all.polls_after_stop, 0u);
    for (std::size_t limit = 1; limit <= all.coarse_calls + all.calls; ++limit)
    {
      SCOPED_TRACE("after call " + std::to_string(limit));
      Soft_stop some(limit);
      const Foliation stopped =
        SMF::harmonic_foliation<TypeParam>(system, CGAL::parameters::visitor(std::ref(some)));
      EXPECT_EQ(some.coarse_calls + some.calls, limit) << "a call after the stop";
      EXPECT_TRUE(stopped.statistics().is_certified);
      EXPECT_GT(some.polls_after_stop, 1u);
      ++stops;
      stops_with_linear_systems += stopped.statistics().number_of_iterations > some.calls;
    }
  }
  EXPECT_GT(stops, 20u);
  EXPECT_LE(10 * stops_with_linear_systems, stops) << "folds are smoothed out where they are";
}

TYPED_TEST(Each_tag, a_visitor_ends_the_run_wherever_it_is_polled)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system = c.system();
    const auto run = [&](Hard_stop& visitor) {
      SMF::harmonic_foliation<TypeParam>(system, CGAL::parameters::visitor(std::ref(visitor)));
    };
    Hard_stop all(never);
    run(all);
    const std::size_t thrown = throw_everywhere<Hard_stop, SMF::Stopped_exception>(run, [] {});
    EXPECT_EQ(thrown, all.polls);
    // before the run, on two coarser meshes, between and in the iterations, before the certificate
    EXPECT_GT(thrown, 15u);
  }
}

TYPED_TEST(Each_tag, solvers_work_after_any_exception_of_a_visitor)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system = c.system();
    const Foliation expected = SMF::harmonic_foliation(system);
    std::optional<SMF::Foliation_solver<Mesh, SMF::Supernodal_cholesky_solver, TypeParam>> solver;
    const auto run = [&](auto& visitor) {
      solver.emplace(); // so that it does not start from its last solution
      solver->solve(system, CGAL::parameters::visitor(std::ref(visitor)));
    };
    const auto check = [&] {
      EXPECT_THROW(solver->iterate(), SMF::Solver_exception) << "the run is over";
      const Foliation again = solver->solve(system);
      EXPECT_TRUE(again.statistics().is_certified);
      EXPECT_TRUE(again.statistics().has_converged);
      EXPECT_LT(difference(again, expected), 1e-9);
    };
    const std::size_t stops = throw_everywhere<Hard_stop, SMF::Stopped_exception>(run, check);
    EXPECT_GT(stops, 15u);
    if (c.name == "genus 1")
    {
      EXPECT_GT((throw_everywhere<Thrower, SMF::Solver_exception>(run, check)), stops);
    }
  }
}

TYPED_TEST(Each_tag, a_visitor_is_told_where_arcs_lie_at_the_start)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system = c.system();
    SMF::Foliation_solver<Mesh, SMF::Supernodal_cholesky_solver, TypeParam> solver;
    Start_keeper cold, warm;
    const Foliation foliation = solver.solve(system, CGAL::parameters::visitor(std::ref(cold)));
    EXPECT_GT(cold.share_of_others(foliation), 0);
    EXPECT_LT(cold.share_of_others(foliation), 0.3);
    solver.solve(system, CGAL::parameters::visitor(std::ref(warm)));
    EXPECT_EQ(warm.share_of_others(foliation), 0) << "it starts from the last solution";
  }
}

TEST(Whitehead_moves, stop_softly)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(c.name);
    const System system = c.system();
    for (std::size_t limit : {1, 2, 5, 30})
    {
      SCOPED_TRACE("after sweep " + std::to_string(limit));
      Soft_stop visitor(limit);
      const Foliation stopped =
        SMF::whitehead_foliation(system, CGAL::parameters::visitor(std::ref(visitor)));
      EXPECT_EQ(visitor.calls, limit);
      EXPECT_TRUE(stopped.statistics().is_certified);
      EXPECT_FALSE(stopped.statistics().has_converged);
      EXPECT_GE(stopped.statistics().number_of_iterations, limit);
      EXPECT_GT(visitor.polls_after_stop,
                stopped.statistics().number_of_iterations - limit); // in each sweep
    }
  }
}

TEST(Whitehead_moves, are_ended_wherever_the_visitor_is_polled)
{
  const Case c = cases()[1];
  const System system = c.system();
  const auto run = [&](auto& visitor) {
    SMF::whitehead_foliation(
      system, SMF::parameters::combine(SMF::parameters::tolerance(1e-2),
                                       CGAL::parameters::visitor(std::ref(visitor))));
  };
  Hard_stop all(never);
  run(all);
  const std::size_t stops = throw_everywhere<Hard_stop, SMF::Stopped_exception>(run, [] {});
  EXPECT_EQ(stops, all.polls);
  EXPECT_GT(stops, 2u);
  EXPECT_GT((throw_everywhere<Thrower, SMF::Solver_exception>(run, [] {})), stops);
}

// A user's own bad news, a visitor's ready-made ones: all are as they were thrown.
TEST(Visitors, may_throw_what_they_like)
{
  struct News
  {
    int number;
  };
  struct Visitor
  {
    bool after_iteration(const SMF::Foliation_statistics&) { throw News{7}; }
  };
  struct Stopper
  {
    bool after_iteration(const SMF::Foliation_statistics&) { throw SMF::Stopped_exception(); }
  };
  const Case c = cases()[0];
  const System system = c.system();
  for (bool is_whitehead : {false, true})
    try
    {
      if (is_whitehead)
        SMF::whitehead_foliation(system, CGAL::parameters::visitor(Visitor()));
      else
        SMF::harmonic_foliation(system, CGAL::parameters::visitor(Visitor()));
      ADD_FAILURE() << "nothing was thrown";
    }
    catch (const News& news)
    {
      EXPECT_EQ(news.number, 7);
    }
  try
  {
    SMF::harmonic_foliation(system, CGAL::parameters::visitor(Stopper()));
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const SMF::Foliation_exception& exception)
  {
    EXPECT_EQ(exception.problem().kind, SMF::Problem_kind::STOPPED);
    EXPECT_STREQ(exception.what(), "stopped by the visitor");
  }
}

} // namespace test_visitors
