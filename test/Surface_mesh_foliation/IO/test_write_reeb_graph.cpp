// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Boost.Graph's writer comes first: users include it, too, and it must not spoil our headers.
#include <boost/graph/graphviz.hpp>

#include "include/example_systems.h"
#include "include/temporary_folder.h"

#include <CGAL/Surface_mesh_foliation/IO/write_reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/IO/write_vtp.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_write_reeb_graph {

// Graphs that are written can be read again, and say what the graph says.

namespace {

using smf_test::Example;
using smf_test::Mesh;
using smf_test::Solved_example;
namespace SMF = CGAL::Surface_mesh_foliation;

using Point = Mesh::Point;
using Graph = SMF::Reeb_graph<Point>;

class Written_graph_of_example : public ::testing::TestWithParam<Example>
{
protected:
  Written_graph_of_example() : example(GetParam()) { SMF::reeb_graph(example.foliation, graph); }

  std::string file(const std::string& name) const { return folder.file_name(name); }

  smf_test::Temporary_folder folder;
  Solved_example<> example;
  Graph graph;
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Written_graph_of_example,
                         ::testing::ValuesIn(smf_test::example_systems()),
                         smf_test::name_of_example);

// ===  GraphML

using Tree = boost::property_tree::ptree;

// the data of a node or edge by the names of the attributes
std::map<std::string, std::string> data_of(const Tree& element,
                                           const std::map<std::string, std::string>& name_of_key)
{
  std::map<std::string, std::string> result;
  for (const auto& [tag, data] : element)
    if (tag == "data")
    {
      const auto name = name_of_key.find(data.get<std::string>("<xmlattr>.key"));
      if (name == name_of_key.end())
        ADD_FAILURE() << "undeclared key";
      else
        result[name->second] = data.data();
    }
  return result;
}

double number(const std::string& text)
{
  char* end = nullptr;
  const double result = std::strtod(text.c_str(), &end);
  EXPECT_TRUE(!text.empty() && *end == '\0') << text;
  return result;
}

TEST_P(Written_graph_of_example, graphml)
{
  SMF::write_reeb_graph_graphml(file("graph.graphml"), graph);
  Tree tree;
  ASSERT_NO_THROW(boost::property_tree::read_xml(file("graph.graphml"), tree)) << "well-formed";
  const Tree& graphml = tree.get_child("graphml");
  EXPECT_EQ(graphml.get<std::string>("<xmlattr>.xmlns"), "http://graphml.graphdrawing.org/xmlns");
  std::map<std::string, std::string> keys; // attribute names, by key
  for (const auto& [tag, key] : graphml)
    if (tag == "key")
    {
      EXPECT_TRUE(keys
                    .emplace(key.get<std::string>("<xmlattr>.id"),
                             key.get<std::string>(Tree::path_type("<xmlattr>/attr.name", '/')))
                    .second);
    }
  const Tree& body = graphml.get_child("graph");
  EXPECT_EQ(body.get<std::string>("<xmlattr>.edgedefault"), "undirected");
  std::map<std::string, std::size_t> node_of_id;
  std::size_t arcs = 0;
  auto e = edges(graph).first;
  for (const auto& [tag, element] : body)
    if (tag == "node")
    {
      const std::size_t v = node_of_id.size();
      node_of_id[element.get<std::string>("<xmlattr>.id")] = v;
      auto data = data_of(element, keys);
      EXPECT_EQ(number(data["id"]), v);
      EXPECT_EQ(data["kind"], SMF::name(graph[v].kind));
      EXPECT_EQ(number(data["genus"]), graph[v].genus);
      EXPECT_EQ(number(data["pole"]), graph[v].pole);
      EXPECT_EQ(number(data["x"]), graph[v].point.x());
      EXPECT_EQ(number(data["y"]), graph[v].point.y());
      EXPECT_EQ(number(data["z"]), graph[v].point.z());
    }
    else if (tag == "edge")
    {
      EXPECT_EQ(node_of_id.at(element.get<std::string>("<xmlattr>.source")), source(*e, graph));
      EXPECT_EQ(node_of_id.at(element.get<std::string>("<xmlattr>.target")), target(*e, graph));
      auto data = data_of(element, keys);
      EXPECT_EQ(number(data["loop"]), graph[*e].loop);
      EXPECT_EQ(number(data["height"]), graph[*e].height);
      EXPECT_EQ(number(data["flux"]), graph[*e].flux);
      EXPECT_EQ(number(data["length"]), SMF::length(graph[*e].polyline));
      EXPECT_EQ(data["component"], SMF::name(graph[*e].component));
      EXPECT_EQ(number(data["area"]), graph[*e].area);
      ++e;
      ++arcs;
    }
  EXPECT_EQ(node_of_id.size(), num_vertices(graph));
  EXPECT_EQ(arcs, num_edges(graph));
}

// ===  DOT

TEST_P(Written_graph_of_example, dot)
{
  SMF::write_reeb_graph_dot(file("graph.dot"), graph);
  std::istringstream input(smf_test::file_text(file("graph.dot")));
  std::string line;
  std::getline(input, line);
  EXPECT_EQ(line, "graph G {");
  std::size_t nodes = 0, arcs = 0;
  auto e = edges(graph).first;
  while (std::getline(input, line) && line != "}")
  {
    EXPECT_EQ(line.substr(line.size() - 2), "];") << line;
    if (line.find("--") == std::string::npos)
    {
      EXPECT_EQ(line.rfind(std::to_string(nodes) + "[label=\"" + SMF::name(graph[nodes].kind), 0),
                0u);
      EXPECT_EQ(line.find("circle") != std::string::npos, graph[nodes].pole >= 0) << line;
      EXPECT_EQ(line.find("genus") != std::string::npos, graph[nodes].genus > 0) << line;
      ++nodes;
      continue;
    }
    const std::string begin = std::to_string(source(*e, graph)) + "--" +
                              std::to_string(target(*e, graph)) + " [label=\"" +
                              std::to_string(graph[*e].loop) + "\", height=\"";
    EXPECT_EQ(line.substr(0, begin.size()), begin);
    EXPECT_EQ(std::strtod(line.c_str() + begin.size(), nullptr), graph[*e].height) << line;
    ++e;
    ++arcs;
  }
  EXPECT_EQ(line, "}");
  EXPECT_EQ(nodes, num_vertices(graph));
  EXPECT_EQ(arcs, num_edges(graph));
}

// what Boost.Graph's writer makes of it
template <class Graph>
std::string dot_by_boost(const Graph& graph)
{
  std::map<typename boost::graph_traits<Graph>::vertex_descriptor, std::size_t> number;
  for (const auto v : boost::make_iterator_range(vertices(graph)))
    number.emplace(v, number.size());
  std::ostringstream output;
  output.precision(17);
  boost::write_graphviz(
    output, graph,
    [&](std::ostream& o, const auto& v) {
      const auto& node = graph[v];
      o << "[label=\"" << SMF::name(node.kind) << ' '
        << (node.pole >= 0 ? static_cast<std::size_t>(node.pole) : node.id);
      if (node.genus > 0)
        o << "\\ngenus " << node.genus;
      o << "\", shape="
        << (node.kind == SMF::Node_kind::POLE       ? "circle"
            : node.kind == SMF::Node_kind::BOUNDARY ? "doublecircle"
                                                    : "box")
        << "]";
    },
    [&](std::ostream& o, const auto& e) {
      o << "[label=\"" << graph[e].loop << "\", height=\"" << graph[e].height << "\"]";
    },
    boost::default_writer(), boost::make_assoc_property_map(number));
  return output.str();
}

TEST_P(Written_graph_of_example, dot_as_boost_writes_it)
{
  SMF::write_reeb_graph_dot(file("graph.dot"), graph);
  EXPECT_EQ(smf_test::file_text(file("graph.dot")), dot_by_boost(graph));
}

// ===  Other graphs than Reeb_graph

struct Derived_node : SMF::Reeb_node<Point>
{
  std::string label = "mine";
};

struct Derived_arc : SMF::Reeb_arc<Point>
{
  int weight = 17;
};

template <class Vertices, class Directed, class... Bundles>
using List = boost::adjacency_list<boost::listS, Vertices, Directed, Bundles...>;

class Each_graph : public Written_graph_of_example
{
protected:
  // what the other graph's files must be, and are
  template <class Other_graph, class NamedParameters, class ArcParameter>
  void expect_same_files(const Other_graph& other,
                         const NamedParameters& np,
                         const ArcParameter& arc_map) const
  {
    const auto expect_same = [&](const std::string& name) {
      const std::string expected = smf_test::file_text(file("expected." + name));
      EXPECT_FALSE(expected.empty());
      EXPECT_EQ(smf_test::file_text(file("other." + name)), expected);
    };
    SMF::write_reeb_graph_graphml(file("expected.graphml"), graph);
    SMF::write_reeb_graph_graphml(file("other.graphml"), other, np);
    expect_same("graphml");
    SMF::write_reeb_graph_dot(file("expected.dot"), graph);
    SMF::write_reeb_graph_dot(file("other.dot"), other, np);
    expect_same("dot");
    SMF::write_skeleton_vtp(file("expected.vtp"), graph);
    SMF::write_skeleton_vtp(file("other.vtp"), other, np);
    expect_same("vtp");
    SMF::write_skeleton_ply(file("expected.ply"), graph);
    SMF::write_skeleton_ply(file("other.ply"), other, arc_map);
    expect_same("ply");
  }
};

INSTANTIATE_TEST_SUITE_P(Examples,
                         Each_graph,
                         ::testing::ValuesIn(smf_test::example_systems()),
                         smf_test::name_of_example);

TEST_P(Each_graph, with_derived_bundles)
{
  List<boost::vecS, boost::undirectedS, Derived_node, Derived_arc> other;
  SMF::reeb_graph(example.foliation, other);
  const auto none = CGAL::parameters::default_values();
  expect_same_files(other, none, none);
}

TEST_P(Each_graph, with_maps)
{
  using Other = List<boost::listS, boost::undirectedS, std::string, boost::no_property>;
  using Vertex = boost::graph_traits<Other>::vertex_descriptor;
  using Edge = boost::graph_traits<Other>::edge_descriptor;
  std::map<Vertex, Derived_node> nodes;
  std::vector<Edge> arcs;
  Other other;
  const auto descriptors = SMF::reeb_graph(example.foliation, other);
  for (std::size_t r = 0; r < descriptors.size(); ++r)
    static_cast<SMF::Reeb_node<Point>&>(nodes[descriptors[r]]) = graph[r];
  for (const auto& e : boost::make_iterator_range(edges(other)))
    arcs.push_back(e);
  // arcs by value: what the map gives does not outlive the call
  const auto arc_of = [&](const Edge& e) {
    auto own = edges(graph).first;
    for (const Edge& other_arc : arcs)
    {
      if (other_arc.get_property() == e.get_property())
        break;
      ++own;
    }
    return SMF::Reeb_arc<Point>(graph[*own]);
  };
  const auto arc_map = SMF::parameters::arc_map(boost::make_function_property_map<Edge>(arc_of));
  expect_same_files(other,
                    SMF::parameters::combine(
                      SMF::parameters::node_map(boost::make_assoc_property_map(nodes)), arc_map),
                    arc_map);
}

TEST_P(Each_graph, that_is_directed)
{
  List<boost::listS, boost::bidirectionalS, Derived_node, Derived_arc> other;
  SMF::reeb_graph(example.foliation, other);
  SMF::write_reeb_graph_dot(file("directed.dot"), other);
  const std::string dot = smf_test::file_text(file("directed.dot"));
  EXPECT_EQ(dot, dot_by_boost(other));
  EXPECT_EQ(dot.rfind("digraph G {", 0), 0u);
  std::size_t arrows = 0;
  for (std::size_t i = dot.find("->"); i != std::string::npos; i = dot.find("->", i + 1))
    ++arrows;
  EXPECT_EQ(arrows, num_edges(graph));
  SMF::write_reeb_graph_graphml(file("directed.graphml"), other);
  EXPECT_NE(smf_test::file_text(file("directed.graphml")).find("edgedefault=\"directed\""),
            std::string::npos);
}

// ===  Names and lengths

TEST(Names, of_kinds)
{
  EXPECT_EQ(SMF::name(SMF::Node_kind::POLE), "pole");
  EXPECT_EQ(SMF::name(SMF::Node_kind::SADDLE), "saddle");
  EXPECT_EQ(SMF::name(SMF::Node_kind::REGULAR), "regular");
  EXPECT_EQ(SMF::name(SMF::Node_kind::BOUNDARY), "boundary");
  EXPECT_EQ(SMF::name(SMF::Component_kind::DISK), "disk");
  EXPECT_EQ(SMF::name(SMF::Component_kind::CYLINDER), "cylinder");
  EXPECT_EQ(SMF::name(SMF::Component_kind::SPHERE), "sphere");
}

TEST(Length, of_polylines)
{
  EXPECT_EQ(SMF::length(std::vector<Point>()), 0);
  EXPECT_EQ(SMF::length(std::vector<Point>{{1, 2, 3}}), 0);
  EXPECT_EQ(SMF::length(std::vector<Point>{{0, 0, 0}, {3, 4, 0}, {3, 4, -2}}), 7);
}

} // namespace

} // namespace test_write_reeb_graph
