// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_SUMMARIZER_H
#define SMF_TEST_SUMMARIZER_H

#include "example_systems.h"
#include "summary.h"
#include "temporary_folder.h"

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace smf_test {

// Calls every public function with a mesh, once; points are asked for through `np`.
template <class TriangleMesh, class NamedParameters>
class Summarizer
{
  using Traits = boost::graph_traits<TriangleMesh>;
  using Vertex = typename Traits::vertex_descriptor;
  using Halfedge = typename Traits::halfedge_descriptor;
  using Loop = SMF::Loop<TriangleMesh>;
  using Point = typename SMF::Loop_system<TriangleMesh>::Point;

public:
  Summarizer(const TriangleMesh& mesh, const NamedParameters& np)
    : m_mesh(mesh),
      m_np(np),
      m_position(get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh)),
      m_face_position(get(CGAL::dynamic_face_property_t<std::size_t>(), mesh)),
      m_vertices(vertex_list(mesh))
  {
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      put(m_position, m_vertices[i], i);
    std::size_t i = 0;
    for (const auto f : faces(mesh))
      put(m_face_position, f, i++);
  }

  // `output` is an empty mesh
  template <class OutputMesh>
  Summary operator()(const std::vector<Item>& items, OutputMesh& output)
  {
    add_loops();
    const auto input = poles_and_loops(items, m_mesh, m_np);
    EXPECT_TRUE(SMF::validate(m_mesh, input, m_np).empty());
    const SMF::Loop_system<TriangleMesh> system(m_mesh, input, m_np);
    add_system(system);
    add_weights(system);
    const SMF::Measured_foliation<TriangleMesh> foliation = SMF::harmonic_foliation(system);
    add_foliation(foliation);
    add_leaves(foliation);
    add_split_faces(foliation);
    add_components(foliation, output);
    add_coordinates(foliation);
    add_graph(foliation, input);
    add_files(foliation);
    return m_summary;
  }

private:
  void add_number(const std::string& key, double number)
  {
    m_summary.numbers[key].push_back(number);
  }
  double position(Vertex v) const { return static_cast<double>(get(m_position, v)); }

  void add_loop(const std::string& key, const Loop& loop)
  {
    for (const auto& crossing : loop)
    {
      add_number(key, position(source(crossing.halfedge, m_mesh)));
      add_number(key, position(target(crossing.halfedge, m_mesh)));
      add_number(key, crossing.position);
    }
  }

  // a plane through the middle of the mesh
  std::array<double, 4> plane() const
  {
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto points = choose_parameter(get_parameter(m_np, CGAL::internal_np::vertex_point),
                                         CGAL::get_const_property_map(CGAL::vertex_point, m_mesh));
    std::array<double, 4> result = {1, 2, 3, 0};
    for (const Vertex v : m_vertices)
    {
      const auto& p = get(points, v);
      result[3] -= CGAL::to_double(p.x()) + 2 * CGAL::to_double(p.y()) + 3 * CGAL::to_double(p.z());
    }
    result[3] /= static_cast<double>(m_vertices.size());
    return result;
  }

  void add_loops()
  {
    auto height = get(CGAL::dynamic_vertex_property_t<double>(), m_mesh);
    for (std::size_t i = 0; i < m_vertices.size(); ++i)
      put(height, m_vertices[i], static_cast<double>(i * i % 17));
    std::vector<Loop> loops;
    SMF::isoline_loops(m_mesh, height, 7.5, std::back_inserter(loops));
    SMF::plane_section_loops(m_mesh, plane(), std::back_inserter(loops), m_np);
    SMF::loops_around_vertices(std::vector<Vertex>{m_vertices[0]}, m_mesh,
                               std::back_inserter(loops));
    loops.push_back(SMF::pole_loop(m_vertices[1], m_mesh));
    for (const Loop& loop : loops)
    {
      add_number("sizes of loops", static_cast<double>(loop.size()));
      add_loop("loops", loop);
    }
  }

  void add_system(const SMF::Loop_system<TriangleMesh>& system)
  {
    add_number("system", static_cast<double>(system.genus()));
    for (std::size_t a = 0; a < system.number_of_arcs(); ++a)
    {
      add_number("ends", static_cast<double>(system.node(a, 0)));
      add_number("ends", static_cast<double>(system.node(a, 1)));
      add_number("heights", system.height(a));
      add_loop("loops of arcs", system.loop(a));
    }
    for (std::size_t p = 0; p < system.number_of_poles(); ++p)
      for (const Vertex v : system.pole_vertices(p))
        add_number("poles", position(v));
  }

  // values of edges in an order that does not depend on the model
  template <class Map>
  void add_edges(const std::string& key, Map map)
  {
    std::map<std::array<double, 2>, double> values;
    for (const auto e : edges(m_mesh))
    {
      const double u = position(source(e, m_mesh)), v = position(target(e, m_mesh));
      values[{(std::min)(u, v), (std::max)(u, v)}] = get(map, e);
    }
    for (const auto& entry : values)
      add_number(key, entry.second);
  }

  void add_weights(const SMF::Loop_system<TriangleMesh>& system)
  {
    auto weight = get(CGAL::dynamic_edge_property_t<double>(), m_mesh);
    SMF::edge_weights(system, SMF::Cotangent_weights(), weight);
    add_edges("cotangent weights", weight);
    SMF::edge_weights(system, SMF::Mean_value_weights(), weight);
    add_edges("mean value weights", weight);
    const auto foliation = SMF::harmonic_foliation(system, SMF::parameters::weights(weight));
    add_number("energy with given weights", foliation.statistics().energy);
  }

  void add_foliation(const SMF::Measured_foliation<TriangleMesh>& foliation)
  {
    const SMF::Foliation_statistics& statistics = foliation.statistics();
    EXPECT_TRUE(statistics.has_converged && statistics.is_certified);
    add_number("statistics", statistics.energy);
    add_number("statistics", statistics.optimality);
    add_number("statistics", static_cast<double>(statistics.number_of_iterations));
    for (const Vertex v : m_vertices)
    {
      add_number("cells", foliation.cell(v).is_arc ? 1 : 0);
      add_number("cells", static_cast<double>(foliation.cell(v).index));
      add_number("parameters", foliation.parameter(v));
    }
    auto value = get(CGAL::dynamic_edge_property_t<double>(), m_mesh);
    SMF::edge_values(foliation, value);
    add_edges("edge values", value);
    std::map<std::array<double, 2>, std::vector<double>> paths;
    for (const auto e : edges(m_mesh))
    {
      EXPECT_EQ(foliation.edge_value(e), get(value, e));
      for (const Halfedge h : {halfedge(e, m_mesh), opposite(halfedge(e, m_mesh), m_mesh)})
        for (const auto& passage : foliation.path(h))
          paths[{position(source(h, m_mesh)), position(target(h, m_mesh))}].push_back(
            static_cast<double>(2 * passage.arc) + passage.end);
    }
    for (const auto& entry : paths)
      for (const double passage : entry.second)
        add_number("paths", passage);
  }

  void add_leaves(const SMF::Measured_foliation<TriangleMesh>& foliation)
  {
    std::vector<SMF::Singularity<TriangleMesh>> singularities;
    SMF::singularities(foliation, std::back_inserter(singularities));
    for (const auto& singularity : singularities)
    {
      add_number("singularities", singularity.index);
      add_number("singularities", singularity.order);
      add_number("singularities", singularity.is_face
                                    ? static_cast<double>(get(m_face_position, singularity.face))
                                    : position(singularity.vertex));
    }
    std::vector<SMF::Critical_polyline<Point>> polylines;
    SMF::critical_leaves(foliation, std::back_inserter(polylines));
    for (const auto& polyline : polylines)
    {
      add_number("nodes of polylines", static_cast<double>(polyline.node));
      for (const Point& p : polyline.points)
        m_summary.add("critical leaves", p);
    }
    for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
      for (const Point& p : SMF::leaf(foliation, a, foliation.system().height(a) / 3))
        m_summary.add("leaves", p);
    const SMF::Leaf_tracer<TriangleMesh> tracer(foliation);
    std::vector<SMF::Leaf<Point>> leaves;
    for (std::size_t a = 0; a < foliation.system().number_of_arcs(); ++a)
      tracer.evenly_spaced_leaves(a, 2, std::back_inserter(leaves));
    for (const auto f : faces(m_mesh))
      if (const auto leaf = tracer.leaf_through(f, {0.3, 0.3, 0.4}); leaf && leaves.size() < 20)
        leaves.push_back(*leaf);
    if (const auto leaf = tracer.leaf_through(m_vertices[2]))
      leaves.push_back(*leaf);
    for (const auto& leaf : leaves)
    {
      add_number("traced leaves", static_cast<double>(leaf.arc));
      add_number("traced leaves", leaf.level);
      add_number("traced leaves", leaf.length);
      m_summary.add("traced leaves", leaf.centroid);
    }
    std::vector<SMF::Complex_saddle_leaf> complex_leaves;
    SMF::complex_saddle_leaves(foliation, std::back_inserter(complex_leaves));
    for (const auto& leaf : complex_leaves)
      add_number("complex leaves", static_cast<double>(leaf.node * 1000 + leaf.order));
  }

  void add_split_faces(const SMF::Measured_foliation<TriangleMesh>& foliation)
  {
    Mesh output;
    const auto value = get(CGAL::dynamic_edge_property_t<double>(), output);
    add_number("split faces", static_cast<double>(SMF::subdivide_saddle_faces(
                                foliation, output,
                                SMF::parameters::combine(SMF::parameters::edge_value_map(value),
                                                         CGAL::parameters::vertex_point_map(
                                                           get(CGAL::vertex_point, output))))));
    for (const auto v : vertices(output))
      m_summary.add("split faces", get(get(CGAL::vertex_point, output), v));
    for (const auto f : faces(output))
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, output), output))
        add_number("split faces", get(value, edge(h, output)));
  }

  void add_coordinates(const SMF::Measured_foliation<TriangleMesh>& foliation)
  {
    const SMF::Component_coordinates<TriangleMesh> coordinates(foliation);
    Mesh output;
    const auto uv = get(CGAL::dynamic_halfedge_property_t<std::array<double, 2>>(), output);
    coordinates.uv_mesh(output, uv);
    for (const auto f : faces(output))
      for (const auto h : CGAL::halfedges_around_face(halfedge(f, output), output))
        if (!std::isnan(get(uv, h)[0])) // in faces at nodes
          m_summary.numbers["coordinates"].insert(m_summary.numbers["coordinates"].end(),
                                                  get(uv, h).begin(), get(uv, h).end());
  }

  template <class OutputMesh>
  void add_components(const SMF::Measured_foliation<TriangleMesh>& foliation, OutputMesh& output)
  {
    const auto component = get(CGAL::dynamic_face_property_t<std::size_t>(), output);
    const auto is_critical = get(CGAL::dynamic_edge_property_t<bool>(), output);
    SMF::surface_components(foliation, output,
                            SMF::parameters::combine(
                              SMF::parameters::face_component_map(component),
                              CGAL::parameters::edge_is_constrained_map(is_critical),
                              CGAL::parameters::vertex_point_map(get(CGAL::vertex_point, output))));
    EXPECT_TRUE(CGAL::is_closed(output));
    const auto segment = get(CGAL::dynamic_face_property_t<std::size_t>(), m_mesh);
    SMF::face_segmentation(foliation, segment);
    for (const auto f : faces(m_mesh))
      add_number("segments", static_cast<double>(get(segment, f)));
    for (const auto v : vertices(output))
      m_summary.add("cut mesh", get(get(CGAL::vertex_point, output), v));
    for (const auto f : faces(output))
      add_number("components", static_cast<double>(get(component, f)));
    double critical_edges = 0;
    for (const auto e : edges(output))
      critical_edges += get(is_critical, e);
    add_number("critical edges", critical_edges);
  }

  void add_graph(const SMF::Measured_foliation<TriangleMesh>& foliation,
                 const SMF::Poles_and_loops<TriangleMesh>& input)
  {
    SMF::Reeb_graph<Point> by_stages, by_one_call;
    SMF::reeb_graph(foliation, by_stages);
    SMF::foliation_reeb_graph(m_mesh, input, by_one_call, m_np);
    for (const auto* graph : {&by_stages, &by_one_call})
    {
      for (const auto v : boost::make_iterator_range(vertices(*graph)))
        m_summary.add("nodes", (*graph)[v].point);
      for (const auto& e : boost::make_iterator_range(edges(*graph)))
      {
        add_number("flux", (*graph)[e].flux);
        add_number("area", (*graph)[e].area);
        for (const Point& p : (*graph)[e].polyline)
          m_summary.add("arcs", p);
      }
    }
    const auto matching = SMF::match_reeb_graphs(by_stages, by_one_call);
    ASSERT_TRUE(matching);
    EXPECT_EQ(matching->distance, 0);
    add_skeleton(foliation);
  }

  void add_skeleton(const SMF::Measured_foliation<TriangleMesh>& foliation)
  {
    const auto embedding =
      SMF::reeb_graph_embedding(foliation, SMF::parameters::number_of_smoothing_steps(2));
    const auto sample = get(CGAL::dynamic_vertex_property_t<std::size_t>(), m_mesh);
    SMF::vertex_samples(foliation, embedding, sample);
    for (const Vertex v : m_vertices)
      add_number("samples of vertices", static_cast<double>(get(sample, v)));
    SMF::Curve_skeleton<TriangleMesh> skeleton;
    SMF::curve_skeleton(foliation, embedding, skeleton);
    for (const auto p : boost::make_iterator_range(vertices(skeleton)))
    {
      m_summary.add("skeleton", skeleton[p].point);
      add_number("radii", skeleton[p].radius);
      for (const Vertex v : skeleton[p].vertices)
        add_number("vertices of skeleton", position(v));
    }
  }

  void add_files(const SMF::Measured_foliation<TriangleMesh>& foliation)
  {
    const Temporary_folder folder;
    const auto embedding =
      SMF::reeb_graph_embedding(foliation, SMF::parameters::number_of_samples(3));
    SMF::Reeb_graph<Point> graph;
    SMF::reeb_graph(foliation, graph, embedding);
    SMF::write_components_ply(folder.file_name("components.ply"), foliation);
    SMF::write_foliation_ply(folder.file_name("foliation.ply"), foliation);
    const SMF::Component_coordinates<TriangleMesh> coordinates(foliation);
    SMF::write_component_coordinates_obj(folder.file_name("coordinates.obj"), coordinates);
    SMF::write_component_coordinates_ply(folder.file_name("coordinates.ply"), coordinates);
    SMF::write_leaves_ply(folder.file_name("leaves.ply"), foliation, embedding);
    SMF::write_skeleton_ply(folder.file_name("skeleton.ply"), graph);
    SMF::write_reeb_graph_dot(folder.file_name("graph.dot"), graph);
    SMF::write_reeb_graph_graphml(folder.file_name("graph.graphml"), graph);
    SMF::write_components_vtp(folder.file_name("components.vtp"), foliation);
    SMF::write_foliation_vtp(folder.file_name("foliation.vtp"), foliation);
    SMF::write_leaves_vtp(folder.file_name("leaves.vtp"), foliation, embedding);
    SMF::write_skeleton_vtp(folder.file_name("skeleton.vtp"), graph);
    SMF::write_singularities_vtp(folder.file_name("singularities.vtp"), foliation);
    for (const char* name :
         {"components.ply", "foliation.ply", "coordinates.obj", "coordinates.ply", "leaves.ply",
          "skeleton.ply", "graph.dot", "graph.graphml", "components.vtp", "foliation.vtp",
          "leaves.vtp", "skeleton.vtp", "singularities.vtp"})
    {
      std::ostringstream text;
      text << std::ifstream(folder.file_name(name)).rdbuf();
      EXPECT_FALSE(text.str().empty()) << name;
      m_summary.files[name] = text.str();
    }
    SMF::Poles_and_loops<TriangleMesh> read;
    const std::string line = "plane 1 2 3 " + std::to_string(plane()[3]) + " 5\n";
    SMF::read_loops(folder.write("loops", "separate 0\n" + line), m_mesh, read, m_np);
    for (const auto& entry : read.entries())
      add_loop("loops from a file", entry.loop);
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  typename boost::property_map<TriangleMesh,
                               CGAL::dynamic_vertex_property_t<std::size_t>>::const_type m_position;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<std::size_t>>::const_type
    m_face_position;
  std::vector<Vertex> m_vertices;
  Summary m_summary;
};

} // namespace smf_test

#endif // SMF_TEST_SUMMARIZER_H
