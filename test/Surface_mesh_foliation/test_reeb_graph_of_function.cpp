#include "include/brute_force_reeb_graph.h"
#include "include/test_meshes.h"
#include "include/test_models.h"

#include <CGAL/Surface_mesh_foliation/internal/Flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/flat_surface.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_of_function.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>
#include <boost/range/iterator_range.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Reeb graphs of functions, compared with a tracer of all contours.

namespace {

using smf_test::Brute_force_reeb_graph;
using smf_test::Edges_of_soup;
using smf_test::Mesh;
using smf_test::Triangle_soup;
using smf_test::vertex;
namespace smf = CGAL::Surface_mesh_foliation;
namespace smf_np = CGAL::Surface_mesh_foliation::parameters;
namespace soups = smf_test::soups;

using Kind = smf::Critical_kind;
using Values = std::vector<double>;

// a Reeb graph with vertices by number
struct Result
{
  struct Node
  {
    std::size_t vertex;
    Kind kind;
    std::size_t multiplicity, genus;
  };
  struct Arc
  {
    std::size_t lower, upper; // nodes
    std::size_t number_of_vertices;
  };

  std::vector<Node> nodes;
  std::vector<Arc> arcs;
  std::vector<std::size_t> arc_of_vertex;

  std::array<std::size_t, 2> ends(std::size_t arc) const
  {
    return {nodes[arcs[arc].lower].vertex, nodes[arcs[arc].upper].vertex};
  }
  std::size_t number_of_cycles() const { return arcs.size() + 1 - nodes.size(); }
};

template <class Map>
auto as_map(Map& map)
{
  return boost::associative_property_map<Map>(map);
}

template <class TriangleMesh, class NamedParameters>
Result reeb_graph(const TriangleMesh& mesh, const Values& values, const NamedParameters& np)
{
  using Graph = smf::Scalar_reeb_graph<TriangleMesh>;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, std::size_t> number;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, double> function;
  for (const auto v : vertices(mesh))
  {
    const std::size_t i = number.size();
    number[v] = i;
    function[v] = values[i];
  }
  Graph graph;
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
           typename boost::graph_traits<Graph>::edge_descriptor>
    arc_of_vertex;
  const auto nodes = smf::reeb_graph_of_function(
    mesh, as_map(function), graph,
    smf_np::combine(np, smf_np::vertex_to_arc_map(as_map(arc_of_vertex))));
  EXPECT_EQ(nodes.size(), num_vertices(graph));

  Result result;
  for (const auto node : nodes)
  {
    result.nodes.push_back({number.at(graph[node].vertex), graph[node].kind,
                            graph[node].multiplicity, graph[node].genus});
    EXPECT_EQ(graph[node].value, function.at(graph[node].vertex));
  }
  std::map<const void*, std::size_t> number_of_arc;
  for (const auto& arc : boost::make_iterator_range(edges(graph)))
  {
    number_of_arc[&graph[arc]] = result.arcs.size();
    result.arcs.push_back({source(arc, graph), target(arc, graph), graph[arc].number_of_vertices});
    EXPECT_EQ(graph[arc].lower, graph[source(arc, graph)].value);
    EXPECT_EQ(graph[arc].upper, graph[target(arc, graph)].value);
  }
  for (const auto v : vertices(mesh))
    result.arc_of_vertex.push_back(number_of_arc.at(&graph[arc_of_vertex.at(v)]));
  return result;
}

template <class TriangleMesh>
Result reeb_graph(const TriangleMesh& mesh, const Values& values)
{
  return reeb_graph(mesh, values, CGAL::parameters::default_values());
}

struct Surface
{
  std::size_t genus;
  Triangle_soup soup;
  Edges_of_soup edges;
  Mesh mesh;

  explicit Surface(const Triangle_soup& s)
    : genus(soups::genus(s)), soup(s), edges(soup), mesh(smf_test::to_mesh(soup))
  {}
};

const std::vector<Surface>& surfaces()
{
  static const std::vector<Surface> result = [] {
    std::vector<Surface> surfaces;
    for (const Triangle_soup& soup :
         {soups::tetrahedron(), soups::octahedron(), soups::icosphere(1), soups::torus(3, 3, 3, 1),
          soups::torus(7, 5, 3, 1), soups::genus_surface(2, 1), soups::genus_surface(3, 1),
          soups::genus_surface(4, 1), soups::genus_surface(5, 1)})
      surfaces.emplace_back(soup);
    return surfaces;
  }();
  return result;
}

// kind 0: no ties. 1: many ties. 2: few different values. 3: constant. 4: smooth, so few nodes
Values random_function(const Surface& surface, std::size_t kind, smf_test::Random& random)
{
  Values result;
  const std::array<double, 3> direction = {random.between(-1, 1), random.between(-1, 1),
                                           random.between(-1, 1)};
  for (const auto& p : surface.soup.points)
    result.push_back(kind == 0 ? random.between(-1, 1)
                     : kind == 1
                       ? static_cast<double>(random.index(surface.soup.points.size() / 3 + 1))
                     : kind == 2 ? static_cast<double>(random.index(3))
                     : kind == 3 ? 7.
                                 : direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2]);
  return result;
}

// calls check(surface, values) with many functions
template <class Check>
void for_each_function(int number_per_surface, const Check& check)
{
  smf_test::Random random(5);
  for (const Surface& surface : surfaces())
    for (int i = 0; i < number_per_surface && !testing::Test::HasFailure(); ++i)
    {
      SCOPED_TRACE("genus " + std::to_string(surface.genus) + ", function " + std::to_string(i));
      check(surface, random_function(surface, static_cast<std::size_t>(i % 5), random));
    }
}

// ===  Against brute force

template <class Ends>
std::vector<std::array<std::size_t, 2>> sorted(Ends ends)
{
  std::sort(ends.begin(), ends.end());
  return ends;
}

void expect_equal_nodes(const Result& result, const Brute_force_reeb_graph& expected)
{
  ASSERT_EQ(result.nodes.size(), expected.nodes.size());
  std::set<std::size_t> vertices;
  for (const Result::Node& node : result.nodes)
  {
    vertices.insert(node.vertex);
    const Brute_force_reeb_graph::Node& other = expected.nodes.at(node.vertex);
    EXPECT_EQ(node.kind, other.contours_below == 0   ? Kind::MINIMUM
                         : other.contours_above == 0 ? Kind::MAXIMUM
                                                     : Kind::SADDLE);
    const std::size_t multiplicity = node.kind == Kind::SADDLE ? other.lower_wedges - 1 : 0;
    EXPECT_EQ(node.multiplicity, multiplicity);
    // the surface near the critical level has Euler characteristic -multiplicity
    const bool is_saddle = node.kind == Kind::SADDLE;
    EXPECT_EQ(2 * node.genus,
              is_saddle ? 2 + multiplicity - other.contours_below - other.contours_above : 0);
  }
  EXPECT_EQ(vertices.size(), result.nodes.size());
}

// Arcs have the same ends, and the same vertices lie on them.
void expect_equal_arcs(const Result& result, const Brute_force_reeb_graph& expected)
{
  std::vector<std::array<std::size_t, 2>> ends;
  for (std::size_t a = 0; a < result.arcs.size(); ++a)
    ends.push_back(result.ends(a));
  EXPECT_EQ(sorted(ends), sorted(expected.arcs));
  std::map<std::size_t, std::size_t> arc_of_arc;
  std::vector<std::size_t> sizes(result.arcs.size(), 0);
  for (const auto& [v, arc] : expected.arc_of_vertex)
  {
    const std::size_t found = result.arc_of_vertex[v];
    ++sizes[found];
    EXPECT_EQ(arc_of_arc.emplace(arc, found).first->second, found);
    EXPECT_EQ(result.ends(found), expected.arcs[arc]);
  }
  std::set<std::size_t> images;
  for (const auto& entry : arc_of_arc)
    EXPECT_TRUE(images.insert(entry.second).second);
  for (std::size_t a = 0; a < sizes.size(); ++a)
    EXPECT_EQ(sizes[a], result.arcs[a].number_of_vertices);
  for (const Result::Node& node : result.nodes)
  {
    const auto [lower, upper] = result.ends(result.arc_of_vertex[node.vertex]);
    EXPECT_TRUE(lower == node.vertex || upper == node.vertex);
  }
}

TEST(Reeb_graph_of_function, is_that_of_all_contours)
{
  std::size_t number_of_hidden_handles = 0, number_of_multiple_saddles = 0;
  for_each_function(400, [&](const Surface& surface, const Values& values) {
    const Brute_force_reeb_graph expected(surface.soup, surface.edges, values);
    const Result result = reeb_graph(surface.mesh, values, smf_np::unfold_saddles(false));
    expect_equal_nodes(result, expected);
    expect_equal_arcs(result, expected);
    std::size_t genus = result.number_of_cycles();
    for (const Result::Node& node : result.nodes)
    {
      genus += node.genus;
      number_of_hidden_handles += node.genus;
      number_of_multiple_saddles += node.multiplicity > 1;
    }
    EXPECT_EQ(genus, surface.genus);
  });
  EXPECT_GT(number_of_hidden_handles, 100u) << "the test has the cases that it is meant to have";
  EXPECT_GT(number_of_multiple_saddles, 1000u);
}

// the number of arcs at each node below and above it
std::vector<std::array<int, 2>> degrees(const Result& result)
{
  std::vector<std::array<int, 2>> degree(result.nodes.size(), {{0, 0}});
  for (const Result::Arc& arc : result.arcs)
  {
    ++degree[arc.lower][1];
    ++degree[arc.upper][0];
  }
  return degree;
}

void expect_simple_saddles(const Result& result)
{
  const auto degree = degrees(result);
  for (std::size_t i = 0; i < degree.size(); ++i)
  {
    const Result::Node& node = result.nodes[i];
    EXPECT_EQ(node.genus, 0u);
    EXPECT_EQ(node.multiplicity, node.kind == Kind::SADDLE ? 1u : 0u);
    EXPECT_EQ(degree[i][0] + degree[i][1], node.kind == Kind::SADDLE ? 3 : 1);
    EXPECT_EQ(degree[i][0] == 0, node.kind == Kind::MINIMUM);
    EXPECT_EQ(degree[i][1] == 0, node.kind == Kind::MAXIMUM);
  }
}

TEST(Reeb_graph_of_function, with_unfolded_saddles_has_as_many_cycles_as_the_genus)
{
  for_each_function(400, [&](const Surface& surface, const Values& values) {
    const Result result = reeb_graph(surface.mesh, values);
    EXPECT_EQ(result.number_of_cycles(), surface.genus);
    expect_simple_saddles(result);
    // without the arcs inside vertices it is the other one
    const Result folded = reeb_graph(surface.mesh, values, smf_np::unfold_saddles(false));
    std::vector<std::array<std::size_t, 2>> ends, folded_ends;
    for (std::size_t a = 0; a < result.arcs.size(); ++a)
      if (result.ends(a)[0] != result.ends(a)[1])
        ends.push_back(result.ends(a));
    for (std::size_t a = 0; a < folded.arcs.size(); ++a)
      folded_ends.push_back(folded.ends(a));
    EXPECT_EQ(sorted(ends), sorted(folded_ends));
    for (std::size_t v = 0; v < values.size(); ++v)
      EXPECT_EQ(result.ends(result.arc_of_vertex[v]), folded.ends(folded.arc_of_vertex[v]));
  });
}

TEST(Reeb_graph_of_function, of_shared_meshes_has_as_many_cycles_as_the_genus)
{
  const std::string shared = SMF_SHARED_DIR;
  const auto files = smf_test::all_shared_meshes(shared.empty() ? shared : shared + "/meshes");
  if (files.empty())
    GTEST_SKIP() << "there are no shared meshes";
  for (const std::string& file : files)
  {
    SCOPED_TRACE(file);
    Mesh mesh;
    smf::read_triangle_mesh(file, mesh);
    const std::size_t genus = smf_test::genus(mesh);
    smf_test::Random random(3);
    for (const int axis : {0, 1, 2, 3})
    {
      Values values;
      for (const auto v : vertices(mesh))
        values.push_back(axis < 3 ? mesh.point(v)[axis] : random.between(0, 1));
      const Result result = reeb_graph(mesh, values);
      EXPECT_EQ(result.number_of_cycles(), genus);
      expect_simple_saddles(result);
    }
  }
}

// ===  Known graphs

TEST(Reeb_graph_of_function, of_the_height_of_a_lying_torus)
{
  const std::size_t m = 24, n = 12;
  const Mesh mesh = smf_test::torus(m, n, 3, 1);
  Values values;
  for (const auto v : vertices(mesh))
    values.push_back(mesh.point(v).x());
  const Result result = reeb_graph(mesh, values);
  ASSERT_EQ(result.nodes.size(), 4u);
  EXPECT_EQ(result.nodes[0].kind, Kind::MINIMUM);
  EXPECT_EQ(result.nodes[1].kind, Kind::SADDLE);
  EXPECT_EQ(result.nodes[2].kind, Kind::SADDLE);
  EXPECT_EQ(result.nodes[3].kind, Kind::MAXIMUM);
  ASSERT_EQ(result.arcs.size(), 4u);
  std::size_t number_of_vertices = 4;
  for (const Result::Arc& arc : result.arcs)
  {
    EXPECT_EQ(arc.upper, arc.lower == 0 ? 1u : arc.lower == 1 ? 2u : 3u);
    number_of_vertices += arc.number_of_vertices;
  }
  EXPECT_EQ(number_of_vertices, m * n);
}

// A torus of seven vertices, all adjacent to each other: every order of the vertices has just one
// minimum and one maximum.
TEST(Reeb_graph_of_function, of_a_torus_with_a_saddle_that_hides_the_handle)
{
  Triangle_soup soup;
  for (std::size_t i = 0; i < 7; ++i)
  {
    soup.points.push_back({std::cos(double(i)), std::sin(double(i)), double(i * i)});
    soup.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    soup.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  const Mesh mesh = smf_test::to_mesh(soup);
  bool has_hidden_handle = false;
  std::vector<double> values = {0, 1, 2, 3, 4, 5, 6};
  do
  {
    EXPECT_EQ(reeb_graph(mesh, values).number_of_cycles(), 1u);
    const Result folded = reeb_graph(mesh, values, smf_np::unfold_saddles(false));
    if (folded.nodes.size() == 3)
    {
      EXPECT_EQ(folded.nodes[1].multiplicity, 2u);
      EXPECT_EQ(folded.nodes[1].genus, 1u);
      EXPECT_EQ(folded.arcs.size(), 2u);
      has_hidden_handle = true;
    }
    else
      EXPECT_EQ(folded.number_of_cycles(), 1u);
  } while (std::next_permutation(values.begin() + 1, values.end()));
  EXPECT_TRUE(has_hidden_handle);
}

// a double pyramid over a polygon with 2m corners, alternately high and low
TEST(Reeb_graph_of_function, of_a_saddle_of_high_multiplicity)
{
  const std::size_t m = 50;
  Triangle_soup soup;
  for (std::size_t i = 0; i < 2 * m; ++i)
  {
    const double angle = 3.14159265358979 * static_cast<double>(i) / static_cast<double>(m);
    soup.points.push_back({std::cos(angle), std::sin(angle), 0});
    soup.triangles.push_back({i, (i + 1) % (2 * m), 2 * m});
    soup.triangles.push_back({(i + 1) % (2 * m), i, 2 * m + 1});
  }
  soup.points.push_back({0, 0, 1});
  soup.points.push_back({0, 0, -1});
  const Mesh mesh = smf_test::to_mesh(soup);
  Values values;
  for (std::size_t i = 0; i < 2 * m; ++i)
    values.push_back(i % 2 == 0 ? 1 : -1);
  values.push_back(0);
  values.push_back(-2);
  const Result result = reeb_graph(mesh, values, smf_np::unfold_saddles(false));
  ASSERT_EQ(result.nodes.size(), m + 2); // all low corners are regular
  EXPECT_EQ(result.nodes[1].kind, Kind::SADDLE);
  EXPECT_EQ(result.nodes[1].multiplicity, m - 1);
  EXPECT_EQ(reeb_graph(mesh, values).nodes.size(), m + 1 + m - 1);
}

// ===  Order of vertices

using Description = std::vector<std::vector<double>>;

// what does not depend on numbers
Description description(const Result& result, const Values& values)
{
  Description lines;
  for (const Result::Node& node : result.nodes)
    lines.push_back({values[node.vertex], static_cast<double>(node.kind),
                     static_cast<double>(node.multiplicity), static_cast<double>(node.genus)});
  for (std::size_t a = 0; a < result.arcs.size(); ++a)
    lines.push_back({static_cast<double>(result.arcs[a].lower),
                     static_cast<double>(result.arcs[a].upper),
                     static_cast<double>(result.arcs[a].number_of_vertices)});
  for (std::size_t v = 0; v < values.size(); ++v)
    lines.push_back({values[v], static_cast<double>(result.arcs[result.arc_of_vertex[v]].lower),
                     static_cast<double>(result.arcs[result.arc_of_vertex[v]].upper), 0, 0});
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(Reeb_graph_of_function, does_not_depend_on_the_order_of_vertices_if_there_are_no_ties)
{
  smf_test::Random random(8);
  for (const Surface& surface : surfaces())
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
      const Values values = random_function(surface, 0, random);
      const std::vector<std::size_t> labels = smf_test::new_labels(values.size(), seed);
      Values new_values(values.size());
      for (std::size_t v = 0; v < values.size(); ++v)
        new_values[labels[v]] = values[v];
      const Mesh mesh = smf_test::relabelled(surface.mesh, seed);
      for (const double persistence : {0., 0.3})
      {
        const auto np = smf_np::persistence(persistence);
        EXPECT_EQ(description(reeb_graph(mesh, new_values, np), new_values),
                  description(reeb_graph(surface.mesh, values, np), values));
      }
    }
}

// ===  Simplification

struct Leaf
{
  double span;
  std::size_t arc, extremum, saddle;
};

// the shortest leaf that can be pruned, or one of infinite span
Leaf shortest_leaf(const Result& graph, const Values& values)
{
  Leaf best = {std::numeric_limits<double>::infinity(), 0, 0, 0};
  const auto key = [&](double span, std::size_t extremum) {
    const std::size_t v = graph.nodes[extremum].vertex;
    return std::make_tuple(span, values[v], v);
  };
  const auto degree = degrees(graph);
  for (std::size_t a = 0; a < graph.arcs.size(); ++a)
    for (const bool is_minimum : {true, false})
    {
      const auto [low, high, size] = graph.arcs[a];
      const std::size_t extremum = is_minimum ? low : high, saddle = is_minimum ? high : low;
      const double span = values[graph.nodes[high].vertex] - values[graph.nodes[low].vertex];
      if (graph.nodes[extremum].kind != Kind::SADDLE && degree[saddle][is_minimum ? 0 : 1] == 2 &&
          key(span, extremum) < key(best.span, best.extremum))
        best = {span, a, extremum, saddle};
    }
  return best;
}

// Nodes that are gone have multiplicity 99, and arcs that are gone go from such a node to itself.
Result pruned(Result graph, const Values& values, double persistence)
{
  for (;;)
  {
    const Leaf leaf = shortest_leaf(graph, values);
    if (!(leaf.span <= persistence))
      return graph;
    std::size_t low = leaf.arc, high = leaf.arc;
    for (std::size_t a = 0; a < graph.arcs.size(); ++a)
      if (a != leaf.arc && graph.arcs[a].upper == leaf.saddle)
        low = a;
      else if (a != leaf.arc && graph.arcs[a].lower == leaf.saddle)
        high = a;
    EXPECT_TRUE(low != leaf.arc && high != leaf.arc);
    graph.arcs[low].upper = graph.arcs[high].upper;
    for (std::size_t& a : graph.arc_of_vertex)
      a = a == leaf.arc || a == high ? low : a;
    for (const std::size_t a : {leaf.arc, high})
      graph.arcs[a].lower = graph.arcs[a].upper = leaf.saddle;
    for (const std::size_t node : {leaf.extremum, leaf.saddle})
    {
      graph.nodes[node].kind = Kind::SADDLE;
      graph.nodes[node].multiplicity = 99;
    }
  }
}

// Arcs correspond to each other: the same vertices lie on them, and their ends are the same.
void expect_equal_arcs(const Result& result, const Result& expected)
{
  std::set<std::size_t> arcs, expected_arcs;
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t v = 0; v < result.arc_of_vertex.size(); ++v)
  {
    const std::size_t a = result.arc_of_vertex[v], b = expected.arc_of_vertex[v];
    EXPECT_EQ(result.ends(a), expected.ends(b));
    arcs.insert(a);
    expected_arcs.insert(b);
    pairs.emplace(a, b);
  }
  EXPECT_EQ(pairs.size(), arcs.size());
  EXPECT_EQ(pairs.size(), expected_arcs.size());
}

TEST(Persistence, prunes_the_shortest_leaf_again_and_again)
{
  smf_test::Random random(2);
  for_each_function(60, [&](const Surface& surface, const Values& values) {
    const double persistence = random.index(4) == 0 ? 0 : random.between(0, 2);
    const Result result = reeb_graph(surface.mesh, values, smf_np::persistence(persistence));
    EXPECT_EQ(result.number_of_cycles(), surface.genus);
    expect_simple_saddles(result);
    const Result expected = pruned(reeb_graph(surface.mesh, values), values, persistence);
    std::vector<std::size_t> vertices, expected_vertices;
    for (const Result::Node& node : result.nodes)
      vertices.push_back(node.vertex);
    for (const Result::Node& node : expected.nodes)
      if (node.multiplicity != 99)
        expected_vertices.push_back(node.vertex);
    EXPECT_EQ(vertices, expected_vertices);
    expect_equal_arcs(result, expected);
    std::size_t count = std::set<std::size_t>(vertices.begin(), vertices.end()).size();
    for (const Result::Arc& arc : result.arcs)
      count += arc.number_of_vertices;
    EXPECT_EQ(count, values.size()) << "every vertex is on an arc or at a node";
  });
}

void expect_contours_around_nodes(const Result& folded)
{
  const auto degree = degrees(folded);
  for (std::size_t i = 0; i < degree.size(); ++i)
  {
    const Result::Node& node = folded.nodes[i];
    const auto contours = static_cast<std::size_t>(degree[i][0] + degree[i][1]);
    EXPECT_EQ(2 * node.genus + contours, node.kind == Kind::SADDLE ? 2 + node.multiplicity : 1);
  }
}

TEST(Persistence, folded_graphs_keep_cycles_and_vertices)
{
  smf_test::Random random(2);
  bool has_vertices_inside_saddles = false;
  for_each_function(100, [&](const Surface& surface, const Values& values) {
    const auto np = smf_np::persistence(random.between(0, 2));
    const Result unfolded = reeb_graph(surface.mesh, values, np);
    const Result result =
      reeb_graph(surface.mesh, values, smf_np::combine(np, smf_np::unfold_saddles(false)));
    expect_contours_around_nodes(result);
    std::size_t genus = result.number_of_cycles();
    for (const Result::Node& node : result.nodes)
      genus += node.genus;
    EXPECT_EQ(genus, surface.genus);
    std::size_t count = result.nodes.size();
    for (const Result::Arc& arc : result.arcs)
      count += arc.number_of_vertices;
    EXPECT_EQ(count, values.size());
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      const auto ends = result.ends(result.arc_of_vertex[v]);
      const auto unfolded_ends = unfolded.ends(unfolded.arc_of_vertex[v]);
      const bool is_inside_saddle = unfolded_ends[0] == unfolded_ends[1];
      has_vertices_inside_saddles = has_vertices_inside_saddles || is_inside_saddle;
      EXPECT_TRUE(is_inside_saddle ? ends[1] == unfolded_ends[1] : ends == unfolded_ends);
    }
  });
  EXPECT_TRUE(has_vertices_inside_saddles);
}

TEST(Persistence, a_large_one_leaves_an_arc_of_a_sphere)
{
  const Mesh mesh = smf_test::icosphere(3);
  smf_test::Random random(1);
  Values values;
  for (std::size_t v = 0; v < num_vertices(mesh); ++v)
    values.push_back(random.between(0, 1));
  EXPECT_GT(reeb_graph(mesh, values).nodes.size(), 100u);
  const Result result = reeb_graph(mesh, values, smf_np::persistence(1));
  ASSERT_EQ(result.arcs.size(), 1u);
  EXPECT_EQ(result.arcs[0].number_of_vertices, values.size() - 2);
}

TEST(Persistence, of_zero_removes_what_only_ties_make)
{
  const Mesh mesh = smf_test::icosphere(3);
  const Values constant(num_vertices(mesh), 1.5);
  EXPECT_GT(reeb_graph(mesh, constant).arcs.size(), 1u);
  EXPECT_EQ(reeb_graph(mesh, constant, smf_np::persistence(0)).arcs.size(), 1u);
  EXPECT_EQ(reeb_graph(mesh, constant, smf_np::persistence(-0.)).arcs.size(), 1u);
}

// ===  Models

template <class TriangleMesh>
class Reeb_graph_of_function_models : public ::testing::Test
{};

using Models = ::testing::Types<smf_test::Surface_mesh_model<smf_test::Kernel>,
                                smf_test::Polyhedron_model<smf_test::Kernel>,
                                smf_test::Linear_cell_complex_model<smf_test::Kernel>>;
TYPED_TEST_SUITE(Reeb_graph_of_function_models, Models);

TYPED_TEST(Reeb_graph_of_function_models, give_equal_results)
{
  smf_test::Random random(4);
  for (const Surface& surface : surfaces())
  {
    const TypeParam mesh = smf_test::to_mesh<TypeParam>(surface.soup);
    const Values values = random_function(surface, 1, random);
    EXPECT_EQ(description(reeb_graph(mesh, values), values),
              description(reeb_graph(surface.mesh, values), values));
  }
}

TEST(Reeb_graph_of_function, of_a_mesh_with_removed_elements)
{
  Mesh mesh = smf_test::tetrahedron();
  const auto second = smf_test::torus(7, 5, 3, 1);
  mesh += second;
  const auto first_faces =
    std::vector<Mesh::Face_index>(faces(mesh).begin(), faces(mesh).begin() + 4);
  for (const auto f : first_faces)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  Values values;
  for (const auto v : vertices(second))
    values.push_back(second.point(v).x());
  EXPECT_EQ(description(reeb_graph(mesh, values), values),
            description(reeb_graph(second, values), values));
}

// ===  Other graphs, other values

TEST(Reeb_graph_of_function, goes_to_property_maps)
{
  using Graph = boost::adjacency_list<boost::listS, boost::vecS, boost::bidirectionalS>;
  const Mesh mesh = smf_test::torus(7, 5, 3, 1);
  std::map<Mesh::Vertex_index, int> function;
  for (const auto v : vertices(mesh))
    function[v] = static_cast<int>(v) % 4;
  Graph graph(3); // is appended to
  std::map<Graph::vertex_descriptor, smf::Scalar_reeb_node<Mesh>> nodes;
  std::map<Graph::edge_descriptor, smf::Scalar_reeb_arc> arcs;
  smf::reeb_graph_of_function(
    mesh, as_map(function), graph,
    smf_np::combine(smf_np::node_map(as_map(nodes)), smf_np::arc_map(as_map(arcs))));
  EXPECT_EQ(num_vertices(graph), nodes.size() + 3);
  EXPECT_EQ(num_edges(graph), arcs.size());
  EXPECT_EQ(arcs.size(), nodes.size());
  for (const auto& [arc, properties] : arcs)
  {
    EXPECT_EQ(properties.lower, nodes.at(source(arc, graph)).value);
    EXPECT_EQ(properties.upper, nodes.at(target(arc, graph)).value);
    EXPECT_LE(properties.lower, properties.upper);
  }
}

TEST(Reeb_graph_of_function, of_extreme_values)
{
  const Mesh mesh = smf_test::torus(7, 5, 3, 1);
  Values values;
  for (const auto v : vertices(mesh))
    values.push_back(mesh.point(v).x() / 4);
  const Description expected = description(reeb_graph(mesh, values), values);
  for (const double scale : {5e-300, 1.7e308})
  {
    Values scaled = values;
    for (double& value : scaled)
      value *= scale;
    Description found = description(reeb_graph(mesh, scaled), scaled);
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_EQ(reeb_graph(mesh, scaled, smf_np::persistence(1.)).number_of_cycles(), 1u);
  }
}

// ===  Refusals

template <class Exception, class Run>
smf::Problem refusal(const Run& run)
{
  try
  {
    run();
    ADD_FAILURE() << "it is accepted";
  }
  catch (const Exception& exception)
  {
    return exception.problem();
  }
  return {};
}

TEST(Reeb_graph_of_function, refuses_values_that_are_not_finite)
{
  const Mesh mesh = smf_test::icosphere(1);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
  {
    Values values(num_vertices(mesh), 1);
    values[17] = values[20] = bad;
    const smf::Problem problem =
      refusal<smf::Invalid_parameter_exception>([&] { reeb_graph(mesh, values); });
    EXPECT_EQ(problem.kind, smf::Problem_kind::NOT_FINITE);
    EXPECT_EQ(problem.vertices, std::vector<std::size_t>{17});
    EXPECT_NE(problem.message.find("vertex 17"), std::string::npos) << problem.message;
  }
}

TEST(Reeb_graph_of_function, refuses_a_persistence_that_is_no_length)
{
  const Mesh mesh = smf_test::icosphere(1);
  const Values values(num_vertices(mesh), 1);
  for (const double bad : {-1e-300, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(refusal<smf::Invalid_parameter_exception>([&] {
                reeb_graph(mesh, values, smf_np::persistence(bad));
              }).kind,
              smf::Problem_kind::INVALID_PARAMETER);
}

void expect_refusal(const Mesh& mesh, smf::Problem_kind kind)
{
  smf::Scalar_reeb_graph<Mesh> graph;
  const CGAL::Constant_property_map<Mesh::Vertex_index, double> constant(1);
  EXPECT_EQ(refusal<smf::Invalid_mesh_exception>([&] {
              smf::reeb_graph_of_function(mesh, constant, graph);
            }).kind,
            kind);
  EXPECT_EQ(num_vertices(graph), 0u) << "nothing has been appended";
}

Mesh two_triangles_back_to_back()
{
  Mesh mesh;
  const auto a = mesh.add_vertex(Mesh::Point(0, 0, 0)), b = mesh.add_vertex(Mesh::Point(1, 0, 0)),
             c = mesh.add_vertex(Mesh::Point(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, b);
  return mesh;
}

TEST(Reeb_graph_of_function, refuses_what_is_no_closed_connected_triangle_mesh)
{
  using Problem = smf::Problem_kind;
  expect_refusal(Mesh(), Problem::EMPTY_MESH);
  Mesh open = smf_test::icosphere(1);
  CGAL::Euler::remove_face(halfedge(*faces(open).begin(), open), open);
  expect_refusal(open, Problem::NOT_CLOSED);
  Mesh two = smf_test::tetrahedron();
  two += smf_test::octahedron();
  expect_refusal(two, Problem::NOT_CONNECTED);
  Mesh isolated = smf_test::tetrahedron();
  isolated.add_vertex(Mesh::Point(5, 5, 0));
  expect_refusal(isolated, Problem::ISOLATED_VERTEX);
  Mesh quads = smf_test::tetrahedron();
  CGAL::Euler::join_face(halfedge(*edges(quads).begin(), quads), quads);
  expect_refusal(quads, Problem::NOT_TRIANGLE_MESH);
  expect_refusal(two_triangles_back_to_back(), Problem::NOT_MANIFOLD);
}

// a tetrahedron and an octahedron with a common vertex
Mesh two_umbrellas()
{
  Mesh mesh = smf_test::tetrahedron();
  mesh += smf_test::octahedron();
  const auto first = vertex(0), second = vertex(4);
  const auto spokes = CGAL::halfedges_around_target(second, mesh);
  for (const auto h : std::vector<Mesh::Halfedge_index>(spokes.begin(), spokes.end()))
    mesh.set_target(h, first);
  mesh.remove_vertex(second);
  return mesh;
}

TEST(Reeb_graph_of_function, refuses_a_vertex_with_two_umbrellas)
{
  expect_refusal(two_umbrellas(), smf::Problem_kind::NOT_MANIFOLD);
}

TEST(Reeb_graph_of_function, refuses_a_slit)
{
  Mesh mesh = smf_test::octahedron();
  const auto side = *halfedges(mesh).begin(), other_side = mesh.add_edge();
  const auto back = opposite(other_side, mesh), before = prev(side, mesh),
             behind = next(side, mesh);
  mesh.set_target(other_side, target(side, mesh));
  mesh.set_target(back, source(side, mesh));
  mesh.set_next(before, other_side);
  mesh.set_next(other_side, behind);
  mesh.set_face(other_side, face(side, mesh));
  mesh.set_halfedge(face(side, mesh), other_side);
  mesh.set_next(side, back); // around the slit
  mesh.set_next(back, side);
  mesh.set_face(side, Mesh::null_face());
  ASSERT_TRUE(mesh.is_valid());
  expect_refusal(mesh, smf::Problem_kind::NOT_CLOSED);
}

TEST(Reeb_graph_of_function, does_not_look_at_the_positions_of_vertices)
{
  Mesh mesh = smf_test::torus(7, 5, 3, 1);
  Values values;
  for (const auto v : vertices(mesh))
    values.push_back(mesh.point(v).x());
  const Description expected = description(reeb_graph(mesh, values), values);
  for (const auto v : vertices(mesh))
    mesh.point(v) = CGAL::ORIGIN;
  EXPECT_EQ(description(reeb_graph(mesh, values), values), expected);
}

// ===  Flat surfaces

using Flat_triangles = std::vector<smf::internal::Triangle>;

Flat_triangles flat_triangles(const Triangle_soup& soup)
{
  Flat_triangles result;
  for (const auto& [a, b, c] : soup.triangles)
    result.push_back({static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  return result;
}

void expect_flat_surface(const Mesh& mesh, const Triangle_soup& soup)
{
  const smf::internal::Mesh_index<Mesh> index(mesh);
  const smf::internal::Flat_mesh flat = smf::internal::flat_surface(index);
  const std::vector<smf::internal::Point> origins(soup.points.size(), {{0, 0, 0}});
  const smf::internal::Flat_mesh expected(origins, flat_triangles(soup));
  EXPECT_EQ(flat.points(), origins);
  EXPECT_EQ(flat.number_of_faces(), expected.number_of_faces());
  ASSERT_EQ(flat.number_of_halfedges(), expected.number_of_halfedges());
  for (int h = 0; h < flat.number_of_halfedges(); ++h)
  {
    EXPECT_EQ(flat.source(h), expected.source(h));
    EXPECT_EQ(flat.target(h), expected.target(h));
    EXPECT_EQ(flat.next(h), expected.next(h));
    EXPECT_EQ(flat.face(h), expected.face(h));
  }
}

TEST(Flat_surface, is_the_connectivity_of_the_mesh)
{
  for (const Surface& surface : surfaces())
    expect_flat_surface(surface.mesh, surface.soup);
  Mesh mesh = smf_test::tetrahedron(); // is removed again, but leaves its numbers
  mesh += smf_test::to_mesh(soups::torus(7, 5, 3, 1));
  for (int f = 0; f < 4; ++f)
    CGAL::Euler::remove_face(halfedge(Mesh::Face_index(f), mesh), mesh);
  expect_flat_surface(mesh, soups::torus(7, 5, 3, 1));
}

TEST(Flat_surface, edges_are_closed_with_one_face_on_each_side)
{
  using smf::internal::are_edges_closed;
  const Flat_triangles closed = flat_triangles(soups::octahedron());
  EXPECT_TRUE(are_edges_closed(6, closed));
  for (std::size_t f = 0; f < closed.size(); ++f)
  {
    Flat_triangles hole = closed, reversed = closed, twice = closed;
    hole.erase(hole.begin() + static_cast<std::ptrdiff_t>(f));
    std::swap(reversed[f][0], reversed[f][1]);
    twice.push_back(closed[f]);
    for (const Flat_triangles& triangles : {hole, reversed, twice})
      EXPECT_FALSE(are_edges_closed(6, triangles)) << f;
  }
  // two tetrahedra with the common edge 0, 1: two faces on each side
  EXPECT_FALSE(are_edges_closed(
    6, {{0, 1, 2}, {1, 0, 3}, {1, 3, 2}, {0, 2, 3}, {0, 1, 4}, {1, 0, 5}, {1, 5, 4}, {0, 4, 5}}));
  // two faces back to back have closed edges
  EXPECT_TRUE(are_edges_closed(3, {{0, 1, 2}, {0, 2, 1}}));
}

bool has_manifold_vertices(const Mesh& mesh)
{
  const smf::internal::Mesh_index<Mesh> index(mesh);
  std::vector<smf::Problem> problems;
  const Triangle_soup soup = index.soup(smf::internal::Origin_map(), problems);
  return smf::internal::are_vertices_manifold(index, static_cast<int>(soup.points.size()),
                                              flat_triangles(soup));
}

TEST(Flat_surface, vertices_are_manifold_with_one_umbrella_of_three_faces)
{
  EXPECT_TRUE(has_manifold_vertices(smf_test::tetrahedron()));
  Mesh two = smf_test::tetrahedron();
  two += smf_test::octahedron();
  EXPECT_TRUE(has_manifold_vertices(two));
  EXPECT_FALSE(has_manifold_vertices(two_umbrellas()));
  EXPECT_FALSE(has_manifold_vertices(two_triangles_back_to_back()));
  two.add_vertex(Mesh::Point(5, 5, 0)); // isolated
  EXPECT_FALSE(has_manifold_vertices(two));
}

} // namespace
