#include "include/each_foliation.h"
#include "include/example_systems.h"
#include "include/polylines.h"

#include <CGAL/Surface_mesh_foliation/components.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/singularities.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace {

using smf_test::distance;
using smf_test::Each_foliation;
using smf_test::Example;
using smf_test::Item;
using smf_test::length;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace smf = CGAL::Surface_mesh_foliation;
namespace soups = smf_test::soups;

using Point = Mesh::Point;
using Polyline = std::vector<Point>;
using Foliation = smf::Measured_foliation<Mesh>;
using Critical_polyline = smf::Critical_polyline<Point>;
using Singularity = smf::Singularity<Mesh>;

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_foliation,
                         ::testing::ValuesIn(smf_test::all_example_systems()),
                         smf_test::name_of_example);

// ===  Singularities

TEST_P(Each_foliation, indices_add_up)
{
  std::vector<Singularity> singularities;
  smf::singularities(foliation, std::back_inserter(singularities));
  std::vector<int> sum(system.number_of_nodes(), 0);
  int total = 0;
  for (const Singularity& singularity : singularities)
  {
    ASSERT_LT(singularity.node, system.number_of_nodes());
    sum[singularity.node] += singularity.index;
    total += singularity.index;
  }
  for (std::size_t r = 0; r < system.number_of_nodes(); ++r)
    EXPECT_EQ(sum[r],
              2 * (2 - 2 * static_cast<int>(system.genus(r)) - static_cast<int>(system.degree(r))))
      << "node " << r;
  EXPECT_EQ(total, 4 - 4 * static_cast<int>(system.genus()));
}

TEST_P(Each_foliation, kinds_of_singularities)
{
  std::vector<Singularity> singularities;
  smf::singularities(foliation, std::back_inserter(singularities));
  std::map<Mesh::Vertex_index, int> expected; // positive indices: poles and nothing else
  for (std::size_t p = 0; p < system.number_of_poles(); ++p)
  {
    const auto vertices = system.pole_vertices(p);
    ++expected[vertices.front()];
    ++expected[vertices.back()];
  }
  std::map<Mesh::Vertex_index, int> positive;
  std::set<Mesh::Vertex_index> singular_vertices;
  std::set<Mesh::Face_index> singular_faces;
  for (const Singularity& singularity : singularities)
  {
    EXPECT_NE(singularity.index, 0);
    if (singularity.is_face)
    {
      EXPECT_EQ(singularity.index, -1);
      EXPECT_EQ(singularity.vertex, Mesh::null_vertex());
      EXPECT_TRUE(singular_faces.insert(singularity.face).second) << "twice";
      continue;
    }
    EXPECT_EQ(singularity.face, Mesh::null_face());
    EXPECT_TRUE(singular_vertices.insert(singularity.vertex).second) << "twice";
    EXPECT_FALSE(foliation.cell(singularity.vertex).is_arc);
    EXPECT_EQ(foliation.cell(singularity.vertex).index, singularity.node);
    if (singularity.index > 0)
      positive[singularity.vertex] = singularity.index;
  }
  EXPECT_EQ(positive, expected);
}

// ===  Critical leaves

TEST_P(Each_foliation, critical_leaves_are_the_constrained_edges)
{
  std::vector<Critical_polyline> polylines;
  smf::critical_leaves(foliation, std::back_inserter(polylines));
  double total = 0, expected = 0;
  for (const Critical_polyline& polyline : polylines)
    total += length(polyline.points);
  Mesh cut;
  const auto is_critical = cut.add_property_map<Mesh::Edge_index, bool>("e:critical").first;
  smf::surface_components(foliation, cut, CGAL::parameters::edge_is_constrained_map(is_critical));
  for (const auto e : edges(cut))
    if (is_critical[e])
      expected += distance(cut.point(cut.vertex(e, 0)), cut.point(cut.vertex(e, 1)));
  EXPECT_NEAR(total, expected, 1e-12 * expected);
}

TEST_P(Each_foliation, critical_leaves_are_connected)
{
  std::vector<Critical_polyline> polylines;
  smf::critical_leaves(foliation, std::back_inserter(polylines));
  std::map<std::size_t, std::vector<const Critical_polyline*>> of_node;
  for (const Critical_polyline& polyline : polylines)
  {
    ASSERT_LT(polyline.node, system.number_of_nodes());
    ASSERT_GE(polyline.points.size(), 1u);
    of_node[polyline.node].push_back(&polyline);
  }
  ASSERT_EQ(of_node.size(), system.number_of_nodes());
  for (const auto& [node, its_polylines] : of_node)
  {
    std::map<Point, std::size_t> ends; // with a number for each
    for (const Critical_polyline* polyline : its_polylines)
      for (const Point& p : {polyline->points.front(), polyline->points.back()})
        ends.emplace(p, ends.size());
    boost::disjoint_sets_with_storage<> sets(ends.size());
    for (const Critical_polyline* polyline : its_polylines)
      sets.union_set(ends[polyline->points.front()], ends[polyline->points.back()]);
    for (std::size_t i = 1; i < ends.size(); ++i)
      EXPECT_EQ(sets.find_set(i), sets.find_set(0)) << "node " << node;
  }
}

TEST_P(Each_foliation, critical_leaves_of_poles_are_the_poles)
{
  std::vector<Critical_polyline> polylines;
  smf::critical_leaves(foliation, std::back_inserter(polylines));
  for (const Critical_polyline& polyline : polylines)
  {
    const int pole = system.pole(polyline.node);
    if (pole < 0)
    {
      EXPECT_GT(length(polyline.points), 0);
      continue;
    }
    Polyline expected;
    for (const auto v : system.pole_vertices(static_cast<std::size_t>(pole)))
      expected.push_back(mesh.point(v));
    if (expected.front() != polyline.points.front())
      std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(polyline.points, expected);
  }
}

TEST(Critical_leaves, without_singularity_is_one_closed_polyline)
{
  const Solved_example<> example(
    {"", soups::torus(14, 9, 3, 1), {{Item::CYCLE, smf_test::meridian(3, 9), 2.5}}});
  std::vector<Singularity> singularities;
  smf::singularities(example.foliation, std::back_inserter(singularities));
  EXPECT_TRUE(singularities.empty());
  std::vector<Critical_polyline> polylines;
  smf::critical_leaves(example.foliation, std::back_inserter(polylines));
  ASSERT_EQ(polylines.size(), 1u);
  EXPECT_EQ(polylines[0].points.front(), polylines[0].points.back());
  EXPECT_NEAR(length(polylines[0].points), 6.28, 0.5); // once around the tube
}

} // namespace
