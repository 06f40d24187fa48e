// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_PARTS_H
#define CGAL_SURFACE_MESH_FOLIATION_PARTS_H

#include <CGAL/Surface_mesh_foliation/Loop.h>
#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/Loop_system.h>
#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph_embedding.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Sum.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/points.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>
#include <CGAL/Surface_mesh_foliation/reeb_graph.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/// \ingroup PkgSurfaceMeshFoliationParts
/// is a connected component of a mesh: a view of its faces. The descriptors of its elements are
/// those of the mesh, so a property map of the mesh is also one of each part.
template <class TriangleMesh>
using Mesh_part = CGAL::Face_filtered_graph<TriangleMesh>;

namespace internal {

template <class TriangleMesh, class VertexPointMap>
double area_of_mesh_face(const TriangleMesh& mesh,
                         typename boost::graph_traits<TriangleMesh>::face_descriptor face,
                         VertexPointMap map)
{
  const auto h = halfedge(face, mesh);
  const Point p = coordinates(get(map, source(h, mesh)));
  const Eigen::Vector3d a = difference(coordinates(get(map, target(h, mesh))), p);
  const Eigen::Vector3d b = difference(coordinates(get(map, target(next(h, mesh), mesh))), p);
  return norm(a.cross(b)) / 2;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationParts

returns the connected components of a mesh, from the largest area to the smallest; of equal ones,
that whose first face comes first.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` for which
  `CGAL::dynamic_face_property_t` maps exist
\param mesh the mesh, which must outlive the parts
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `mesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with
      `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a `Point_3` as value
      type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_parts}
    \cgalParamDescription{the largest number of parts that are returned}
    \cgalParamType{an integer, positive}
    \cgalParamDefault{all}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws Invalid_parameter_exception if the number of parts is not positive

The time is \f$O(k n)\f$ for \f$k\f$ parts that are returned and \f$n\f$ faces, and each part takes
about nine bits for each vertex of the mesh.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Mesh_part<TriangleMesh>> mesh_parts(
  const TriangleMesh& mesh, const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::number_of_parts_t>(np);
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_const_property_map(CGAL::vertex_point, mesh));
  const int limit = internal::user_count(choose_parameter(
    get_parameter(np, internal_np::number_of_parts), (std::numeric_limits<int>::max)()));
  internal::require_parameter(limit > 0, "the number of parts is not positive");

  const auto part_of_face = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const std::size_t number = Polygon_mesh_processing::connected_components(mesh, part_of_face);
  std::vector<std::vector<face_descriptor>> faces_of_part(number);
  std::vector<internal::Sum> area(number);
  for (const face_descriptor f : faces(mesh))
  {
    const std::size_t part = get(part_of_face, f);
    faces_of_part[part].push_back(f);
    area[part].add(internal::area_of_mesh_face(mesh, f, vertex_point_map));
  }
  std::vector<std::size_t> order(number);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return area[i].value() > area[j].value(); });
  order.resize((std::min)(number, static_cast<std::size_t>(limit)));
  std::vector<Mesh_part<TriangleMesh>> result;
  result.reserve(order.size());
  for (const std::size_t part : order)
    result.emplace_back(mesh, faces_of_part[part]);
  return result;
}

namespace internal {

template <class TriangleMesh>
bool lies_on_part(const Mesh_part<TriangleMesh>& part,
                  const typename Poles_and_loops<TriangleMesh>::Entry& entry)
{
  if (!entry.pole.empty())
    return part.is_in_cc(entry.pole[0]);
  if (entry.border != boost::graph_traits<TriangleMesh>::null_halfedge())
    return part.is_in_cc(entry.border);
  return !entry.loop.empty() && part.is_in_cc(entry.loop[0].halfedge);
}

template <class TriangleMesh>
void add_entry(const typename Poles_and_loops<TriangleMesh>::Entry& entry,
               Poles_and_loops<Mesh_part<TriangleMesh>>& result)
{
  Loop<Mesh_part<TriangleMesh>> loop;
  for (const Crossing<TriangleMesh>& crossing : entry.loop)
    loop.push_back({crossing.halfedge, crossing.position});
  if (!entry.pole.empty())
    result.add_line_pole(entry.pole, std::move(loop), entry.height);
  else if (entry.border != boost::graph_traits<TriangleMesh>::null_halfedge())
    result.add_border_pole(entry.border, std::move(loop), entry.height);
  else
    result.add_loop(std::move(loop), entry.height);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationParts

distributes poles and loops of a mesh to its parts: each goes to the part that its first vertex, its
opening or its first crossing belongs to, and their order remains.

\param parts parts of a mesh, from `mesh_parts()`
\param input poles and loops on the mesh

\returns the poles and loops of each part

\throws Invalid_loops_exception if one lies on no part

The time is linear in the number of parts times the number of poles and loops, and in the lengths of
these.
*/
template <class TriangleMesh>
std::vector<Poles_and_loops<Mesh_part<TriangleMesh>>> poles_and_loops_of_parts(
  const std::vector<Mesh_part<TriangleMesh>>& parts, const Poles_and_loops<TriangleMesh>& input)
{
  std::vector<Poles_and_loops<Mesh_part<TriangleMesh>>> result(parts.size());
  for (std::size_t a = 0; a < input.size(); ++a)
  {
    const auto& entry = input.entries()[a];
    const auto part = std::find_if(parts.begin(), parts.end(), [&](const auto& candidate) {
      return internal::lies_on_part<TriangleMesh>(candidate, entry);
    });
    if (part == parts.end())
      throw Invalid_loops_exception(
        internal::problem(entry.is_pole_loop() ? Problem_kind::INVALID_POLE
                                               : Problem_kind::INVALID_LOOP,
                          "loop ", a, " lies on none of the ", parts.size(), " parts of the mesh")
          .loops({a}));
    internal::add_entry<TriangleMesh>(entry, result[part - parts.begin()]);
  }
  return result;
}

/*!
\ingroup PkgSurfaceMeshFoliationParts

counts what the Reeb graph of several parts has so far.
*/
struct Part_numbers
{
  std::size_t parts = 0, nodes = 0, loops = 0, poles = 0;
};

namespace internal {

template <class Point>
void add_numbers(const Part_numbers& numbers, Reeb_node<Point>& node)
{
  node.part = numbers.parts;
  node.id += numbers.nodes;
  if (node.pole >= 0)
    node.pole += static_cast<int>(numbers.poles);
}

template <class Point>
void add_numbers(const Part_numbers& numbers, Reeb_arc<Point>& arc)
{
  arc.part = numbers.parts;
  arc.loop += numbers.loops;
}

// A map for nodes or arcs that numbers them on from those of other parts.
template <class Map>
struct Numbered_map
{
  Map map;
  Part_numbers numbers;

  template <class Key, class Value>
  friend void put(const Numbered_map& numbered, const Key& key, Value value)
  {
    add_numbers(numbered.numbers, value);
    put(numbered.map, key, value);
  }
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationParts

appends the Reeb graph of one part of a mesh to the graph of its parts, like `reeb_graph()`, but
with numbers that no other part has: nodes, loops and poles are numbered on, and nodes and arcs know
their part.

\param foliation the foliation of the part
\param graph the graph to append to
\param embedding its embedding, from `reeb_graph_embedding()`
\param numbers what the graph has so far; increased by what the part has
\param np an optional sequence of named parameters: `node_map` and `arc_map` as for `reeb_graph()`

\returns the vertex descriptors of the nodes, by their number in the loop system of the part
*/
template <class TriangleMesh,
          class Point,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<typename boost::graph_traits<Graph>::vertex_descriptor> reeb_graph_of_part(
  const Measured_foliation<TriangleMesh>& foliation,
  Graph& graph,
  const Reeb_graph_embedding<Point>& embedding,
  Part_numbers& numbers,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using Node = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Arc = typename boost::graph_traits<Graph>::edge_descriptor;
  internal::check_parameters<internal::Graph_map_parameters>(np);
  const auto node_map =
    choose_parameter(get_parameter(np, internal_np::node_map),
                     internal::Bundle_map<Graph, Node, Reeb_node<Point>>{&graph});
  const auto arc_map = choose_parameter(get_parameter(np, internal_np::arc_map),
                                        internal::Bundle_map<Graph, Arc, Reeb_arc<Point>>{&graph});
  const auto result = reeb_graph(
    foliation, graph, embedding,
    parameters::node_map(
      internal::Numbered_map<std::decay_t<decltype(node_map)>>{node_map, numbers})
      .arc_map(internal::Numbered_map<std::decay_t<decltype(arc_map)>>{arc_map, numbers}));
  const auto& system = foliation.system();
  ++numbers.parts;
  numbers.nodes += system.number_of_nodes();
  numbers.loops += system.number_of_arcs() + system.merged_loops().size();
  numbers.poles += system.number_of_poles();
  return result;
}

/*!
\ingroup PkgSurfaceMeshFoliationParts

computes one Reeb graph for all parts of a mesh: `foliation_reeb_graph()` for each of them, with
numbers of nodes, loops and poles that go on from part to part.

\tparam ConcurrencyTag see `harmonic_foliation()`
\param parts the parts of a mesh, from `mesh_parts()`, which must outlive the result
\param input the poles and loops of each part: those that `poles_and_loops_of_parts()` returns, to
  which others may have been added, for example by `add_missing_poles()`
\param graph the graph to append to, see `reeb_graph()`
\param np an optional sequence of named parameters: those of `foliation_reeb_graph()`

\returns the foliation of each part

\throws whatever `foliation_reeb_graph()` throws; the graph then has the parts before the one at
  fault. Vertices and faces are those of that part, in its order.
*/
template <class ConcurrencyTag = CGAL::Sequential_tag,
          class TriangleMesh,
          class Graph,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Measured_foliation<Mesh_part<TriangleMesh>>> foliation_reeb_graph_of_parts(
  const std::vector<Mesh_part<TriangleMesh>>& parts,
  const std::vector<Poles_and_loops<Mesh_part<TriangleMesh>>>& input,
  Graph& graph,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using Part = Mesh_part<TriangleMesh>;
  internal::check_parameters<CGAL::internal_np::vertex_point_t,
                             internal::Harmonic_foliation_parameters,
                             internal::Reeb_graph_parameters>(np);
  internal::require_parameter(parts.size() == input.size(),
                              internal::text("there are poles and loops of ", input.size(),
                                             " parts, but ", parts.size(), " parts"));
  Part_numbers numbers;
  std::vector<Measured_foliation<Part>> result;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const Loop_system<Part> system(parts[i], input[i],
                                   internal::select<CGAL::internal_np::vertex_point_t>(np));
    result.push_back(harmonic_foliation<ConcurrencyTag>(
      system, internal::select<internal::Harmonic_foliation_parameters>(np)));
    reeb_graph_of_part(
      result.back(), graph,
      reeb_graph_embedding(result.back(), internal::select<internal::Embedding_parameters>(np)),
      numbers, internal::select<internal::Graph_map_parameters>(np));
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_PARTS_H
