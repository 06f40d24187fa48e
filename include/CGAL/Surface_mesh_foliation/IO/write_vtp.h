// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_VTP_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_VTP_H

#include <CGAL/Surface_mesh_foliation/IO/write_foliation.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Kept_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/Vtp_document.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/component_labels.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/singular_points.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/soup_of_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/leaves.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Files in VTK's XML format for PolyData, which ParaView and VTK itself can read; VTK is not
// needed.

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

inline void add_points(const std::vector<Point>& points, Vtp_document& document)
{
  for (const Point& p : points)
    document.add_point(p);
}

// The data of the points and cells of an embedded Reeb graph.
template <class PointType>
class Skeleton_arrays
{
public:
  template <class Reader>
  explicit Skeleton_arrays(const Reader& reader)
  {
    for (const auto v : reader.nodes())
      add_node(reader.node(v));
    for (const auto& e : reader.arcs())
      add_arc(reader.source_of(e), reader.target_of(e), reader.arc(e));
    m_document.add_point_array("node", m_node);
    m_document.add_point_array("kind", m_kind);
    m_document.add_point_array("pole", m_pole);
    m_document.add_point_array("genus", m_genus);
    m_document.add_point_array("arc", m_arc);
    m_document.add_point_array("radius", m_radius);
    m_document.add_cell_array("node", m_node_of_cell);
    m_document.add_cell_array("arc", m_arc_of_cell);
    m_document.add_cell_array("height", m_height);
    m_document.add_cell_array("flux", m_flux);
    m_document.add_cell_array("length", m_length);
    m_document.add_cell_array("area", m_area);
    m_document.add_cell_array("part", m_part);
  }

  const Vtp_document& document() const { return m_document; }

private:
  void add_point(const PointType& p, const Reeb_node<PointType>* node, int arc, double radius)
  {
    m_document.add_point(p);
    m_node.push_back(node ? static_cast<int>(node->id) : -1);
    m_kind.push_back(node ? static_cast<int>(node->kind) : -1);
    m_pole.push_back(node ? node->pole : -1);
    m_genus.push_back(node ? static_cast<int>(node->genus) : 0);
    m_arc.push_back(arc);
    m_radius.push_back(radius);
  }

  void add_cell(int node, const Reeb_arc<PointType>* arc, std::size_t part)
  {
    m_node_of_cell.push_back(node);
    m_arc_of_cell.push_back(arc ? static_cast<int>(arc->loop) : -1);
    m_height.push_back(arc ? arc->height : 0);
    m_flux.push_back(arc ? arc->flux : 0);
    m_length.push_back(arc ? Surface_mesh_foliation::length(arc->polyline) : 0);
    m_area.push_back(arc ? arc->area : 0);
    m_part.push_back(static_cast<int>(part));
  }

  void add_node(const Reeb_node<PointType>& node)
  {
    m_document.add_vertex(m_document.number_of_points());
    add_point(node.point, &node, -1, node.radius);
    add_cell(static_cast<int>(node.id), nullptr, node.part);
  }

  // the ends of the polyline are points of nodes
  void add_arc(std::size_t first, std::size_t last, const Reeb_arc<PointType>& arc)
  {
    std::vector<std::size_t> line = {first};
    for (std::size_t i = 1; i + 1 < arc.polyline.size(); ++i)
    {
      line.push_back(m_document.number_of_points());
      add_point(arc.polyline[i], nullptr, static_cast<int>(arc.loop),
                i < arc.radii.size() ? arc.radii[i] : 0);
    }
    line.push_back(last);
    m_document.add_line(line);
    add_cell(-1, &arc, arc.part);
  }

  Vtp_document m_document;
  std::vector<int> m_node, m_kind, m_pole, m_genus, m_arc, m_node_of_cell, m_arc_of_cell, m_part;
  std::vector<double> m_radius, m_height, m_flux, m_length, m_area;
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the input mesh in VTK's XML format (.vtp), its vertices and faces in their original order:
point arrays `arc` and `node`, one of which is -1, and `t`, the parameter in the arc (0 at a node);
cell array `component`, as computed by `face_segmentation()`.

\param file_name the name of the file
\param foliation the foliation
\param np an optional sequence of named parameters: `filled_face_map`, a readable property map of
  `fill_openings()`; faces for which it is `true` are not written, nor vertices that only these use

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_foliation_vtp(const std::string& file_name,
                         const Measured_foliation<TriangleMesh>& foliation,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Foliation_state& state = foliation.state();
  internal::Vtp_document document;
  const internal::Kept_soup kept(internal::soup_of(state.mesh()),
                                 internal::is_written(foliation, np));
  internal::add_points(kept.soup.points, document);
  std::vector<int> arc, node;
  std::vector<double> t;
  for (const int v : kept.vertices)
  {
    arc.push_back(state.is_at_node(v) ? -1 : state.arc(v));
    node.push_back(state.is_at_node(v) ? state.node(v) : -1);
    t.push_back(state.is_at_node(v) ? 0 : state.parameter(v));
  }
  for (const auto& triangle : kept.soup.triangles)
    document.add_polygon({triangle[0], triangle[1], triangle[2]});
  document.add_point_array("arc", arc);
  document.add_point_array("node", node);
  document.add_point_array("t", t);
  document.add_cell_array(
    "component",
    internal::Kept_soup::select(internal::components_of_origins(foliation.extraction().refined_mesh,
                                                                foliation.extraction().leaf_graph),
                                kept.faces));
  internal::write_vtp(file_name, document);
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the mesh cut into its surface components in VTK's XML format (.vtp), with vertices and faces
in the order in which `surface_components()` appends them: point array `node`, the node whose
critical leaf a vertex lies on, or -1; cell arrays `component` and `face`, the position in the input
mesh of the face that a face is a part of.

\param file_name the name of the file
\param foliation the foliation
\param np an optional sequence of named parameters: `filled_face_map`, a readable property map of
  `fill_openings()`; faces for which it is `true` are not written, nor vertices that only these use

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_components_vtp(const std::string& file_name,
                          const Measured_foliation<TriangleMesh>& foliation,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  const internal::Refined_mesh& refined = foliation.extraction().refined_mesh;
  internal::Vtp_document document;
  const internal::Kept_soup kept = internal::kept_components(foliation, np);
  internal::add_points(kept.soup.points, document);
  for (const auto& triangle : kept.soup.triangles)
    document.add_polygon({triangle[0], triangle[1], triangle[2]});
  std::vector<int> origin, node;
  for (const int f : kept.faces)
    origin.push_back(refined.faces[f].origin);
  for (int v = 0; v < static_cast<int>(refined.node.size()); ++v)
    if (!refined.is_cap_vertex(v))
      node.push_back(refined.node[v]);
  node = internal::Kept_soup::select(node, kept.vertices);
  const std::vector<int> component = internal::Kept_soup::select(
    internal::component_labels(refined, foliation.extraction().leaf_graph), kept.faces);
  document.add_point_array("node", node);
  document.add_cell_array("component", component);
  document.add_cell_array("face", origin);
  internal::write_vtp(file_name, document);
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes leaves in VTK's XML format (.vtp), as polylines with the cell arrays `arc`, `node` and
`level`: the critical leaves, with `arc` = -1 and `level` = 0, and some regular leaves of each arc,
with `node` = -1. A pole that is a vertex becomes a vertex cell. A closed leaf repeats its first
point at the end.

\param file_name the name of the file
\param foliation the foliation
\param embedding the embedding whose sampled levels are the regular leaves that are written

\throws Invalid_file_exception if the file cannot be written

The time is linear in the sizes of the mesh and of the regular leaves.
*/
template <class TriangleMesh>
void write_leaves_vtp(
  const std::string& file_name,
  const Measured_foliation<TriangleMesh>& foliation,
  const Reeb_graph_embedding<typename Loop_system<TriangleMesh>::Point>& embedding)
{
  const auto leaves = internal::all_leaves(foliation, embedding.levels);
  internal::Vtp_document document;
  std::vector<int> arc, node;
  std::vector<double> level;
  for (const bool is_line : {false, true}) // vertices are the first cells
    for (const auto& leaf : leaves)
    {
      if ((leaf.points.size() > 1) != is_line)
        continue;
      std::vector<std::size_t> line;
      for (const auto& p : leaf.points)
      {
        line.push_back(document.number_of_points());
        document.add_point(p);
      }
      is_line ? document.add_line(line) : document.add_vertex(line[0]);
      arc.push_back(leaf.arc);
      node.push_back(leaf.node);
      level.push_back(leaf.level);
    }
  document.add_cell_array("arc", arc);
  document.add_cell_array("node", node);
  document.add_cell_array("level", level);
  internal::write_vtp(file_name, document);
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes an embedded Reeb graph in VTK's XML format (.vtp): a vertex cell for each node, then a
polyline for each arc. The point array `radius` has the radii of leaves. Further point arrays are,
for nodes, `node`, the id, `kind` (0, 1, 2 or 3: pole, saddle, regular or boundary), `pole` (or -1)
and `genus`, and for samples, which have -1 in `node`, `arc`, the loop id. Cell arrays are `node`
and `arc`, one of which is -1, `part`, and for arcs `height`, `flux`, `length` and `area`.

\tparam Graph a model of `boost::VertexListGraph` and `boost::EdgeListGraph` whose vertex
  descriptors can be compared by `<`, such as `Reeb_graph<Point>` or a graph whose bundled
  properties derive from those of that type
\param file_name the name of the file
\param graph the graph
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{node_map}
    \cgalParamDescription{a property map with the properties of the nodes}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%vertex_descriptor` as key type and `Reeb_node<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_node<Point>`}
  \cgalParamNEnd
  \cgalParamNBegin{arc_map}
    \cgalParamDescription{a property map with the properties of the arcs}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<Graph>::%edge_descriptor` as key type and `Reeb_arc<Point>`, or a type
      derived from it, as value type}
    \cgalParamDefault{the bundled properties, which must be or derive from `Reeb_arc<Point>`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_file_exception if the file cannot be written
*/
template <class Graph, class NamedParameters = CGAL::parameters::Default_named_parameters>
void write_skeleton_vtp(const std::string& file_name,
                        const Graph& graph,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::node_map_t, internal_np::arc_map_t>(np);
  const auto reader = internal::reeb_graph_reader(graph, np);
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Point = std::decay_t<decltype(reader.node(std::declval<Node>()).point)>;
  const internal::Skeleton_arrays<Point> arrays(reader);
  internal::write_vtp(file_name, arrays.document());
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes the singularities in VTK's XML format (.vtp) as vertex cells, in the order of
`singularities()`: point arrays `index`, `node` and `is_face`. A singular face is marked at its
inner point where three leaves meet.

\param file_name the name of the file
\param foliation the foliation

\throws Invalid_file_exception if the file cannot be written
*/
template <class TriangleMesh>
void write_singularities_vtp(const std::string& file_name,
                             const Measured_foliation<TriangleMesh>& foliation)
{
  const internal::Extraction& extraction = foliation.extraction();
  internal::Vtp_document document;
  internal::add_points(internal::singular_points(extraction), document);
  std::vector<int> index, node, is_face;
  for (const internal::Singular_place& place : extraction.singular_places)
  {
    document.add_vertex(index.size());
    index.push_back(place.index);
    node.push_back(place.node);
    is_face.push_back(place.is_face);
  }
  document.add_point_array("index", index);
  document.add_point_array("node", node);
  document.add_point_array("is_face", is_face);
  internal::write_vtp(file_name, document);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_VTP_H
