// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_LOOP_SYSTEM_H
#define CGAL_SURFACE_MESH_FOLIATION_LOOP_SYSTEM_H

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/Flat_loop_system.h>
#include <CGAL/Surface_mesh_foliation/internal/Loops/to_loop.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Border_poles.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Mesh_index.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// A mesh that was checked. Systems on one mesh may share it.
template <class TriangleMesh>
struct Indexed_mesh
{
  explicit Indexed_mesh(const TriangleMesh& mesh) : index(mesh) {}
  Indexed_mesh(Mesh_index<TriangleMesh> mesh_index, Capped_mesh capped_mesh)
    : index(std::move(mesh_index)), capped(std::move(capped_mesh))
  {}
  Mesh_index<TriangleMesh> index;
  Capped_mesh capped;
};

template <class TriangleMesh>
using Shared_mesh = std::shared_ptr<const Indexed_mesh<TriangleMesh>>;

template <class TriangleMesh>
struct Loop_system_data
{
  explicit Loop_system_data(Shared_mesh<TriangleMesh> shared)
    : indexed_mesh(std::move(shared)), mesh_index(indexed_mesh->index)
  {
    flat.mesh = indexed_mesh->capped.mesh;
  }
  Loop_system_data(const Loop_system_data&) = delete;
  Loop_system_data& operator=(const Loop_system_data&) = delete;

  const Shared_mesh<TriangleMesh> indexed_mesh;
  const Mesh_index<TriangleMesh>& mesh_index;
  Flat_loop_system flat;
};

// Checks a mesh as documented for `Loop_system`, and returns the first problems found; if there is
// none, `result` is the mesh.
template <class TriangleMesh, class NamedParameters>
std::vector<Problem> build_indexed_mesh(const TriangleMesh& mesh,
                                        const NamedParameters& np,
                                        Shared_mesh<TriangleMesh>& result)
{
  const auto indexed = std::make_shared<Indexed_mesh<TriangleMesh>>(mesh);
  std::vector<Problem> problems = build_flat_mesh(np, indexed->index, indexed->capped);
  if (!problems.empty())
    return problems;
  indexed->index.number_halfedges(indexed->capped.mesh);
  result = indexed;
  return problems;
}

template <class TriangleMesh>
void read_poles_and_loops(const Poles_and_loops<TriangleMesh>& input,
                          Loop_system_data<TriangleMesh>& data,
                          Problems& problems)
{
  const Mesh_index<TriangleMesh>& mesh_index = data.mesh_index;
  Border_poles<TriangleMesh> border_poles(mesh_index, data.indexed_mesh->capped);
  for (const auto& entry : input.entries())
  {
    Flat_loop loop;
    loop.height = entry.height;
    for (const Crossing<TriangleMesh>& crossing : entry.loop)
      loop.crossings.push_back({mesh_index.index(crossing.halfedge), crossing.position});
    if (entry.is_pole_loop())
    {
      loop.pole = static_cast<int>(data.flat.poles.size());
      loop.is_tight = entry.loop.empty();
      Pole pole;
      if (entry.pole.empty())
        pole = border_poles(entry.border, loop.pole, problems);
      for (const auto v : entry.pole)
        pole.push_back(mesh_index.find(v));
      data.flat.poles.push_back(std::move(pole));
    }
    data.flat.loops.push_back(std::move(loop));
  }
  border_poles.check_all(problems);
}

// Checks poles and loops and returns the first problems found; none if `data` is complete.
template <class TriangleMesh>
std::vector<Problem> build_loop_system(const Poles_and_loops<TriangleMesh>& input,
                                       Loop_system_data<TriangleMesh>& data)
{
  std::vector<Problem> problems;
  read_poles_and_loops(input, data, problems);
  if (problems.empty())
    complete(data.flat, problems);
  return problems;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationLoops

is a checked system of poles and loops on a mesh, together with its dual graph: the Reeb graph of
every foliation in its class [Section 4.1 of the paper], known before any foliation is computed. The
graph has a node for each region that remains when the mesh is cut along the loops, and an arc for
each loop.

Arcs are numbered like the loops. Nodes are numbered from 0, the nodes of poles first, in the order
of the poles. End 0 of an arc lies to the left of its loop, end 1 to the right; a pole loop made by
the package has its pole to the left.

On a sphere with two poles, the two pole loops are homotopic; they are merged into one arc whose
height is the sum of their heights (see `merged_loops()`).

Copies share their contents. The mesh must outlive the system and keep its connectivity.

\tparam TriangleMesh a model of `FaceListGraph` and `VertexListGraph` for which
  `CGAL::dynamic_vertex_property_t` and `CGAL::dynamic_halfedge_property_t` maps exist, as for all
  models in \cgal
*/
template <class TriangleMesh>
class Loop_system
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the point type of the mesh's own `CGAL::vertex_point_t` map. Coordinates may come from another
  /// map, but the points that the package returns have this type.
  using Point = typename boost::property_traits<
    typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::const_type>::value_type;

  /*!
  checks the mesh, the poles and the loops, and builds the dual graph, in time
  \f$O(n \log n)\f$ for \f$n\f$ faces and crossings, and
  \f$O(n)\f$ for each vertex of a pole.

  The mesh must have a vertex and a face, and be connected, oriented, manifold, triangular, closed
  except for openings that are poles (`Poles_and_loops::add_border_pole()`),
  without two edges between the same vertices, without isolated vertices and without degenerate
  faces; its coordinates must be finite. Coordinates are converted to `double`. Loops must be
  simple, disjoint, essential and pairwise not homotopic in the mesh minus its poles; heights must
  be finite, and at least 1e-300.

  \param mesh the mesh
  \param input the poles and loops
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones
    listed
    below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map associating points to the vertices of `mesh`}
      \cgalParamType{a class model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a point type with
        `x()`, `y()` and `z()` as value type}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \throws Invalid_mesh_exception, Invalid_loops_exception for the first problem that `validate()`
    finds
  */
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  Loop_system(const TriangleMesh& mesh,
              const Poles_and_loops<TriangleMesh>& input,
              const NamedParameters& np = CGAL::parameters::default_values())
  {
    internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
    internal::Shared_mesh<TriangleMesh> indexed;
    const std::vector<Problem> problems = internal::build_indexed_mesh(mesh, np, indexed);
    if (!problems.empty())
      throw Invalid_mesh_exception(problems[0]);
    build(std::move(indexed), input);
  }

  /*!
  checks other poles and loops on the mesh of another system, and builds their dual graph. The mesh
  is neither read nor checked again, which is most of the work of the other constructor; its points
  are those that `other` was made with. The systems share what both know about the mesh.

  \throws Invalid_mesh_exception if the mesh has openings that are no longer poles
  \throws Invalid_loops_exception for the first problem with the poles and loops
  */
  Loop_system(const Loop_system& other, const Poles_and_loops<TriangleMesh>& input)
  {
    build(other.m_data->indexed_mesh, input);
  }

  /// \cond SKIP_IN_MANUAL
  // Precondition: the data are complete.
  explicit Loop_system(std::shared_ptr<internal::Loop_system_data<TriangleMesh>> data)
    : m_data(std::move(data))
  {}
  /// \endcond

  /// returns the mesh.
  const TriangleMesh& mesh() const { return m_data->mesh_index.mesh(); }

  /// returns the genus of the mesh.
  std::size_t genus() const { return m_data->flat.mesh.genus(); }

  /// \name Dual graph
  /// @{

  /// returns the number of arcs.
  std::size_t number_of_arcs() const { return m_data->flat.loops.size(); }

  /// returns the height of an arc: the transverse measure of its leaves.
  double height(std::size_t arc) const { return m_data->flat.loops[arc].height; }

  /// returns the number of nodes.
  std::size_t number_of_nodes() const { return m_data->flat.nodes.size(); }

  /// returns the node at an end, 0 or 1, of an arc.
  std::size_t node(std::size_t arc, int end) const
  {
    return m_data->flat.node_of_end(static_cast<int>(arc), end);
  }

  /// returns the genus of the region of a node.
  std::size_t genus(std::size_t node) const { return m_data->flat.nodes[node].genus; }

  /// returns the number of arc ends at a node.
  std::size_t degree(std::size_t node) const { return m_data->flat.nodes[node].degree; }

  /// returns the number of the pole that a node stands for, or -1. Poles are numbered in the order
  /// of addition.
  int pole(std::size_t node) const { return m_data->flat.nodes[node].pole; }

  /// @}
  /// \name Poles and loops
  /// @{

  /// returns the number of poles.
  std::size_t number_of_poles() const { return m_data->flat.poles.size(); }

  /// tells whether a pole is an opening of the mesh.
  bool is_border_pole(std::size_t pole) const { return m_data->flat.poles[pole].is_cap(); }

  /// returns the vertices of a pole: those of the border, in order, if it is an opening.
  std::vector<vertex_descriptor> pole_vertices(std::size_t pole) const
  {
    std::vector<vertex_descriptor> result;
    for (int v : m_data->flat.poles[pole])
      if (m_data->mesh_index.has_vertex(v))
        result.push_back(m_data->mesh_index.vertex(v));
    return result;
  }

  /// returns the loop of an arc.
  Loop<TriangleMesh> loop(std::size_t arc) const
  {
    return internal::to_loop(m_data->flat.loops[arc], m_data->mesh_index);
  }

  /// returns the ids of the loops that have no arc of their own: on a sphere with two poles loop 1,
  /// which shares arc 0; none otherwise.
  std::vector<std::size_t> merged_loops() const
  {
    return std::vector<std::size_t>(m_data->flat.merged_loops.begin(),
                                    m_data->flat.merged_loops.end());
  }

  /// @}
  /// \cond SKIP_IN_MANUAL
  const internal::Loop_system_data<TriangleMesh>& data() const { return *m_data; }
  /// \endcond

private:
  void build(internal::Shared_mesh<TriangleMesh> indexed,
             const Poles_and_loops<TriangleMesh>& input)
  {
    m_data = std::make_shared<internal::Loop_system_data<TriangleMesh>>(std::move(indexed));
    const std::vector<Problem> problems = internal::build_loop_system(input, *m_data);
    if (problems.empty())
      return;
    if (internal::is_about_mesh(problems[0].kind))
      throw Invalid_mesh_exception(problems[0]);
    throw Invalid_loops_exception(problems[0]);
  }

  std::shared_ptr<internal::Loop_system_data<TriangleMesh>> m_data;
};

/*!
\ingroup PkgSurfaceMeshFoliationLoops

checks a mesh, poles and loops like the constructor of `Loop_system`, and returns what it finds
instead of throwing. The checks depend on one another and stop at the first stage that fails: mesh;
heights and poles; curves; disjointness; homotopy.

\param mesh the mesh
\param input the poles and loops
\param np an optional sequence of named parameters: `vertex_point_map` as for `Loop_system`

\returns the problems, empty if `Loop_system` accepts the input
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Problem> validate(const TriangleMesh& mesh,
                              const Poles_and_loops<TriangleMesh>& input,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  internal::Shared_mesh<TriangleMesh> indexed;
  std::vector<Problem> problems = internal::build_indexed_mesh(mesh, np, indexed);
  if (!problems.empty())
    return problems;
  internal::Loop_system_data<TriangleMesh> data(std::move(indexed));
  return internal::build_loop_system(input, data);
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_LOOP_SYSTEM_H
