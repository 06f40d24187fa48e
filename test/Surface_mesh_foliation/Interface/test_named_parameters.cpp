// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "include/example_systems.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/internal/Common/check_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Named_parameters.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_statistics.h>
#include <CGAL/Surface_mesh_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_options.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>

#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_named_parameters {

// Named parameters: in any order, each with its effect, and none that is not known. (That unknown
// ones do not compile is tested by misuse.cpp.)

namespace {

using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace np = CGAL::parameters;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;
namespace tags = CGAL::Surface_mesh_foliation::internal_np;

using Foliation = SMF::Measured_foliation<Mesh>;
using Point = Mesh::Point;
using Graph = SMF::Reeb_graph<Point>;
using smf_np::combine;

// ===  Which are known

template <class NamedParameters, class... Tags>
constexpr bool are_known = SMF::internal::Are_parameters_known<NamedParameters, Tags...>::value;

using Tolerance = decltype(smf_np::tolerance(1.));
using Iterations = decltype(np::number_of_iterations(1));
using Both = decltype(smf_np::tolerance(1.).number_of_iterations(1));
using Three = decltype(combine(
  np::number_of_iterations(1), smf_np::tolerance(1.), smf_np::number_of_samples(1)));
using Iterations_tag = CGAL::internal_np::number_of_iterations_t;

static_assert(are_known<np::Default_named_parameters>);
static_assert(are_known<decltype(np::default_values()), tags::weights_t>);
static_assert(are_known<Tolerance, tags::tolerance_t>);
static_assert(are_known<Tolerance, tags::weights_t, tags::tolerance_t, Iterations_tag>);
static_assert(!are_known<Tolerance>);
static_assert(!are_known<Tolerance, tags::weights_t>);
static_assert(are_known<Iterations, Iterations_tag>);
static_assert(!are_known<Iterations, tags::tolerance_t>);
static_assert(are_known<Both, Iterations_tag, tags::tolerance_t>);
static_assert(!are_known<Both, Iterations_tag>);
static_assert(!are_known<Both, tags::tolerance_t>);
static_assert(are_known<Three, tags::number_of_samples_t, Iterations_tag, tags::tolerance_t>);
static_assert(!are_known<Three, tags::number_of_samples_t, tags::tolerance_t>);

static_assert(are_known<decltype(smf_np::tolerance(1.).number_of_samples(1)),
                        tags::number_of_samples_t,
                        tags::tolerance_t>);
static_assert(!are_known<decltype(smf_np::tolerance(1.).number_of_samples(1)), tags::tolerance_t>);
static_assert(!are_known<decltype(smf_np::number_of_iterations(1).weights(1)), tags::weights_t>);

using Two_lists =
  SMF::internal::Joined_parameters<SMF::internal::Parameter_list<tags::weights_t, Iterations_tag>,
                                   tags::tolerance_t,
                                   SMF::internal::Parameter_list<>>;
static_assert(std::is_same_v<
              Two_lists,
              SMF::internal::Parameter_list<tags::weights_t, Iterations_tag, tags::tolerance_t>>);

// ===  Order

// by CGAL's functions as by ours
TEST(Order, of_a_chain_does_not_matter)
{
  const auto check = [](const auto& chain) {
    using Chain = std::decay_t<decltype(chain)>;
    EXPECT_EQ(np::get_parameter(chain, tags::tolerance), 0.5);
    EXPECT_EQ(np::get_parameter(chain, tags::number_of_samples), 7);
    EXPECT_EQ(np::get_parameter(chain, CGAL::internal_np::number_of_iterations), 3u);
    EXPECT_EQ(get_parameter(chain, tags::tolerance), 0.5);
    EXPECT_EQ(get_parameter_reference(chain, tags::number_of_samples), 7);
    static_assert(np::is_default_parameter<Chain, tags::weights_t>::value);
    static_assert(!np::is_default_parameter<Chain, tags::tolerance_t>::value);
    const auto selected = SMF::internal::select<tags::tolerance_t>(chain);
    EXPECT_EQ(np::get_parameter(selected, tags::tolerance), 0.5);
    static_assert(
      np::is_default_parameter<std::decay_t<decltype(selected)>, Iterations_tag>::value);
  };
  check(smf_np::tolerance(0.5).number_of_samples(7).number_of_iterations(3u));
  check(smf_np::tolerance(0.5).number_of_iterations(3u).number_of_samples(7));
  check(smf_np::number_of_samples(7).tolerance(0.5).number_of_iterations(3u));
  check(smf_np::number_of_samples(7).number_of_iterations(3u).tolerance(0.5));
  check(smf_np::number_of_iterations(3u).tolerance(0.5).number_of_samples(7));
  check(smf_np::number_of_iterations(3u).number_of_samples(7).tolerance(0.5));
  check(smf_np::tolerance(1.).number_of_samples(7).number_of_iterations(3u).tolerance(0.5));
  check(combine(np::number_of_iterations(3u), smf_np::number_of_samples(7)).tolerance(0.5));
  check(combine(np::number_of_iterations(3u).verbose(true),
                smf_np::number_of_samples(7).tolerance(0.5)));
}

TEST(Order, does_not_matter)
{
  const Solved_example<> example(smf_test::theta_example());
  const auto weight = example.mesh->add_property_map<Mesh::Edge_index, double>("e:w", 2).first;
  const auto check = [&](const auto& parameters) {
    const Foliation foliation = SMF::harmonic_foliation(example.system, parameters);
    EXPECT_EQ(foliation.statistics().number_of_iterations, 1u);
    EXPECT_FALSE(foliation.statistics().has_converged);
    return foliation.statistics().energy;
  };
  const double energy =
    check(smf_np::weights(weight).number_of_iterations(1)); // own first: a chain
  SMF::Default_foliation_visitor visitor;
  const auto own = smf_np::weights(weight);
  const auto other = smf_np::tolerance(1e-11);
  const auto of_cgal = np::number_of_iterations(1);
  EXPECT_EQ(check(other.visitor(std::ref(visitor)).weights(weight).number_of_iterations(1)),
            energy);
  EXPECT_EQ(check(combine(own, of_cgal)), energy);
  EXPECT_EQ(check(combine(of_cgal, own)), energy);
  EXPECT_EQ(check(combine(of_cgal, own, other)), energy);
  EXPECT_EQ(check(combine(other, of_cgal, own)), energy);
  EXPECT_EQ(check(combine(own, other, of_cgal)), energy);
  EXPECT_EQ(check(combine(other.number_of_iterations(1), own)), energy);
  EXPECT_EQ(check(combine(np::visitor(std::ref(visitor)).number_of_iterations(1), own, other)),
            energy);
  EXPECT_EQ(check(combine(np::default_values(), own, other, of_cgal)), energy);
  EXPECT_EQ(check(combine(combine(own, other), of_cgal)), energy);
  EXPECT_EQ(check(combine(combine(own).number_of_iterations(1))), energy);
}

TEST(Order, the_last_of_two_equal_ones_is_taken)
{
  const Solved_example<> example(smf_test::theta_example());
  const auto embedding = SMF::reeb_graph_embedding(
    example.foliation, combine(smf_np::number_of_samples(3), smf_np::number_of_samples(8)));
  EXPECT_EQ(embedding.levels[0].size(), 8u);
}

TEST(Order, sequences_hold_values_and_outlive_their_parts)
{
  const Solved_example<> example(smf_test::theta_example());
  const auto make = [] {
    const int samples = 4;
    return combine(smf_np::number_of_samples(samples), smf_np::use_uniform_levels(true));
  };
  const auto parameters = make();
  EXPECT_EQ(SMF::reeb_graph_embedding(example.foliation, parameters).levels[0].size(), 4u);
}

// ===  How the solvers read them

TEST(User_count, fits_an_int_whatever_its_type)
{
  using SMF::internal::user_count;
  constexpr int largest = std::numeric_limits<int>::max();
  EXPECT_EQ(user_count(0), 0);
  EXPECT_EQ(user_count(7u), 7);
  EXPECT_EQ(user_count(2.5), 2);
  EXPECT_EQ(user_count(largest), largest);
  EXPECT_EQ(user_count(largest - 1), largest - 1);
  EXPECT_EQ(user_count(2147483648u), largest);
  EXPECT_EQ(user_count(std::uint64_t(1) << 32), largest);
  EXPECT_EQ(user_count(std::numeric_limits<double>::infinity()), largest);
  EXPECT_EQ(user_count(-1), -1);
  EXPECT_EQ(user_count(-0.5), -1);
  EXPECT_EQ(user_count(std::numeric_limits<double>::quiet_NaN()), -1);
}

TEST(Solver_parameters, options)
{
  SMF::internal::Solver_options defaults;
  defaults.tolerance = 0.25;
  defaults.max_iterations = 7;
  const auto options = [&](const auto& parameters) {
    return SMF::internal::solver_options(parameters, defaults);
  };
  EXPECT_EQ(options(np::default_values()).tolerance, 0.25);
  EXPECT_EQ(options(np::default_values()).max_iterations, 7);
  EXPECT_EQ(options(smf_np::tolerance(0.5)).tolerance, 0.5);
  EXPECT_EQ(options(np::number_of_iterations(0)).max_iterations, 0);
  EXPECT_EQ(options(np::number_of_iterations(std::uint64_t(1) << 32)).max_iterations,
            std::numeric_limits<int>::max());
  for (double tolerance : {0., -1., std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(options(smf_np::tolerance(tolerance)), SMF::Invalid_parameter_exception);
  EXPECT_THROW(options(np::number_of_iterations(-1)), SMF::Invalid_parameter_exception);
}

TEST(Solver_parameters, visitors_come_by_value_and_by_reference)
{
  SMF::Default_foliation_visitor visitor;
  auto reference = std::ref(visitor);
  EXPECT_EQ(&SMF::internal::unwrapped(visitor), &visitor);
  EXPECT_EQ(&SMF::internal::unwrapped(reference), &visitor);
}

TEST(Solver_parameters, visitors_are_told_the_statistics_of_coarse_meshes)
{
  struct Visitor
  {
    bool after_coarse_iteration(std::size_t n, const SMF::Foliation_statistics& told)
    {
      number_of_vertices = n;
      statistics = told;
      return false;
    }
    std::size_t number_of_vertices = 0;
    SMF::Foliation_statistics statistics = {};
  } visitor;
  SMF::Foliation_statistics statistics;
  statistics.number_of_iterations = 3;
  statistics.energy = 4.5;
  statistics.optimality = 0.125;
  statistics.resolved_optimality = 0.0625;
  statistics.number_of_moves = 6;
  statistics.number_of_changed_vertices = 7;
  statistics.has_converged = true;
  EXPECT_FALSE(SMF::internal::progress_of(visitor).after_coarse_iteration(20, statistics));
  EXPECT_EQ(visitor.number_of_vertices, 20u);
  EXPECT_EQ(visitor.statistics.number_of_iterations, 3u);
  EXPECT_EQ(visitor.statistics.energy, 4.5);
  EXPECT_EQ(visitor.statistics.optimality, 0.125);
  EXPECT_EQ(visitor.statistics.resolved_optimality, 0.0625);
  EXPECT_EQ(visitor.statistics.number_of_moves, 6u);
  EXPECT_EQ(visitor.statistics.number_of_changed_vertices, 7u);
  EXPECT_FALSE(visitor.statistics.has_converged) << "the mesh itself is another matter";
}

TEST(Solver_parameters, visitors_are_polled_if_they_can_be)
{
  struct Visitor
  {
    bool go_on() { return ++polls < 2; }
    int polls = 0;
  } visitor;
  const SMF::internal::Poll poll = SMF::internal::poll_of(visitor);
  EXPECT_NO_THROW(poll());
  EXPECT_THROW(poll(), SMF::Stopped_exception);
  EXPECT_EQ(visitor.polls, 2);
  SMF::Default_foliation_visitor other;
  EXPECT_NO_THROW(SMF::internal::poll_of(other)());
}

// ===  Every parameter of every function

// the example with its points at another place
struct Moved_example
{
  Moved_example() : example(smf_test::dumbbell_example()), mesh(*example.mesh)
  {
    points = mesh.add_property_map<Mesh::Vertex_index, Point>("v:moved").first;
    for (const auto v : vertices(mesh))
    {
      points[v] = mesh.point(v);
      mesh.point(v) = Point(0, 0, 0);
    }
  }
  Solved_example<> example;
  Mesh& mesh;
  Mesh::Property_map<Mesh::Vertex_index, Point> points;
};

TEST(Vertex_point_map, of_loops_and_systems)
{
  Moved_example moved;
  const auto points = np::vertex_point_map(moved.points);
  EXPECT_FALSE(SMF::validate(moved.mesh, moved.example.input).empty());
  EXPECT_TRUE(SMF::validate(moved.mesh, moved.example.input, points).empty());
  EXPECT_THROW(SMF::Loop_system<Mesh>(moved.mesh, moved.example.input),
               SMF::Invalid_mesh_exception);
  EXPECT_EQ(SMF::Loop_system<Mesh>(moved.mesh, moved.example.input, points).number_of_arcs(), 3u);
  std::vector<SMF::Loop<Mesh>> none, some;
  SMF::plane_section_loops(moved.mesh, {1, 0, 0, -5}, std::back_inserter(none));
  SMF::plane_section_loops(moved.mesh, {1, 0, 0, -5}, std::back_inserter(some), points);
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(some.empty());
  const auto v = *vertices(moved.mesh).begin();
  EXPECT_FALSE(SMF::plane_section_loop(moved.mesh, {1, 0, 0, -5}, v, points).empty());
  EXPECT_THROW(SMF::plane_section_loop(moved.mesh, {1, 0, 0, -5}, v), SMF::Invalid_loops_exception);
  const smf_test::Temporary_folder folder;
  SMF::Poles_and_loops<Mesh> read;
  SMF::read_loops(folder.write("loops", "plane 1 0 0 -5 0\n"), moved.mesh, read, points);
  EXPECT_EQ(read.size(), 1u);
  Graph graph;
  SMF::foliation_reeb_graph(moved.mesh, moved.example.input, graph, points);
  EXPECT_EQ(num_edges(graph), 3u);
}

TEST(Vertex_point_map, of_meshes_that_are_made)
{
  const auto soup = smf_test::soups::octahedron();
  Mesh mesh;
  std::map<Mesh::Vertex_index, Point> points;
  SMF::triangle_soup_to_triangle_mesh(soup, mesh,
                                      np::vertex_point_map(boost::make_assoc_property_map(points)));
  EXPECT_EQ(points.size(), 6u);
  EXPECT_EQ(points[Mesh::Vertex_index(4)], Point(0, 0, 1));
  const Solved_example<> example(smf_test::theta_example());
  Mesh cut;
  std::map<Mesh::Vertex_index, Point> cut_points;
  SMF::surface_components(example.foliation, cut,
                          np::vertex_point_map(boost::make_assoc_property_map(cut_points)));
  EXPECT_EQ(cut_points.size(), num_vertices(cut));
}

TEST(Parameters, of_harmonic_foliation)
{
  const Solved_example<> example(smf_test::theta_example());
  std::size_t calls = 0;
  struct Visitor
  {
    bool after_iteration(const SMF::Foliation_statistics&) { return ++*calls < 2; }
    std::size_t* calls;
  } visitor = {&calls};
  const CGAL::Constant_property_map<Mesh::Edge_index, double> negative(-1);
  EXPECT_THROW(SMF::harmonic_foliation(example.system, smf_np::weights(negative)),
               SMF::Invalid_parameter_exception);
  EXPECT_TRUE(
    SMF::harmonic_foliation(example.system, smf_np::tolerance(1e300)).statistics().has_converged);
  EXPECT_EQ(SMF::harmonic_foliation(example.system, np::number_of_iterations(1))
              .statistics()
              .number_of_iterations,
            1u);
  EXPECT_EQ(SMF::harmonic_foliation(example.system, np::visitor(std::ref(visitor)))
              .statistics()
              .number_of_iterations,
            2u);
  EXPECT_EQ(calls, 2u);
  const CGAL::Constant_property_map<Mesh::Edge_index, double> positive(0.5);
  EXPECT_TRUE(
    SMF::harmonic_foliation(example.system, smf_np::weights(positive).allow_any_weights(true))
      .statistics()
      .has_converged);
}

TEST(Parameters, of_extraction)
{
  const Solved_example<> example(smf_test::theta_example());
  Mesh cut;
  const auto component = cut.add_property_map<Mesh::Face_index, std::size_t>("f:c", 99).first;
  const auto is_critical = cut.add_property_map<Mesh::Edge_index, bool>("e:c", false).first;
  SMF::surface_components(
    example.foliation, cut,
    smf_np::edge_is_constrained_map(is_critical).face_component_map(component));
  std::size_t number_of_critical_edges = 0;
  for (const auto e : edges(cut))
    number_of_critical_edges += is_critical[e];
  EXPECT_GT(number_of_critical_edges, 0u);
  for (const auto f : faces(cut))
    EXPECT_LT(component[f], 3u);
  const auto uniform = SMF::reeb_graph_embedding(
    example.foliation, smf_np::use_uniform_levels(true).number_of_samples(1));
  EXPECT_NEAR(uniform.levels[0].at(0), 0.5, 1e-12);
}

TEST(Parameters, of_one_call_all_together)
{
  using Plain_graph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                          boost::property<boost::edge_index_t, std::size_t>>;
  using Edge = boost::graph_traits<Plain_graph>::edge_descriptor;
  Moved_example moved;
  Plain_graph graph;
  std::map<std::size_t, SMF::Reeb_node<Point>> nodes;
  std::map<Edge, SMF::Reeb_arc<Point>> arcs;
  std::size_t iterations = 0;
  struct Visitor
  {
    bool after_iteration(const SMF::Foliation_statistics& statistics)
    {
      *iterations = statistics.number_of_iterations;
      return true;
    }
    std::size_t* iterations;
  } visitor = {&iterations};
  const auto weight = moved.mesh.add_property_map<Mesh::Edge_index, double>("e:w", 3).first;
  const auto parameters =
    combine(np::vertex_point_map(moved.points).number_of_iterations(90).visitor(std::ref(visitor)),
            smf_np::weights(weight), smf_np::allow_any_weights(false), smf_np::tolerance(1e-10),
            smf_np::node_map(boost::make_assoc_property_map(nodes)),
            smf_np::arc_map(boost::make_assoc_property_map(arcs)), smf_np::number_of_samples(6),
            smf_np::use_uniform_levels(true), smf_np::number_of_smoothing_steps(1000));
  const Foliation foliation =
    SMF::foliation_reeb_graph(moved.mesh, moved.example.input, graph, parameters);
  EXPECT_EQ(iterations, foliation.statistics().number_of_iterations);
  EXPECT_EQ(nodes.size(), 2u);
  ASSERT_EQ(arcs.size(), 3u);
  for (const auto& [edge, arc] : arcs)
  {
    ASSERT_EQ(arc.polyline.size(), 8u);
    const double ends = CGAL::squared_distance(arc.polyline.front(), arc.polyline.back());
    const Point& p = arc.polyline[1];
    EXPECT_NEAR(CGAL::squared_distance(arc.polyline.front(), p), ends / 49, 1e-6 * ends + 1e-20)
      << "smooth: a straight line";
  }
}

TEST(Parameters, default_values_can_be_passed)
{
  const Solved_example<> example(smf_test::theta_example());
  const SMF::Loop_system<Mesh> system(*example.mesh, example.input, np::default_values());
  const Foliation foliation = SMF::harmonic_foliation(system, np::default_values());
  Graph graph;
  SMF::reeb_graph(foliation, graph, np::default_values());
  Mesh cut;
  EXPECT_EQ(SMF::surface_components(foliation, cut, np::default_values()), 3u);
}

} // namespace

} // namespace test_named_parameters
