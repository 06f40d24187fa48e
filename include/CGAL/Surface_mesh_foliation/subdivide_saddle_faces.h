// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_SUBDIVIDE_SADDLE_FACES_H
#define CGAL_SURFACE_MESH_FOLIATION_SUBDIVIDE_SADDLE_FACES_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/Tripod.h>
#include <CGAL/Surface_mesh_foliation/internal/Leaves/Refined_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Triangle_soup.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/build_triangle_mesh.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// The mesh with tripods split at their centers, and the foliation value of each side of a face.
class Split_saddles
{
public:
  Split_saddles(const Foliation_state& state, const Refined_mesh& refined) : m_state(state)
  {
    const Flat_mesh& mesh = state.mesh();
    m_soup.points = mesh.points();
    m_soup.points.resize(mesh.number_of_input_vertices());
    m_soup.points.insert(m_soup.points.end(), refined.points.begin() + refined.first_center,
                         refined.points.end());
    int center = mesh.number_of_input_vertices();
    for (int f = 0; f < mesh.number_of_input_faces(); ++f)
      if (Tripod(state, f).is_singular())
        split(f, center++);
      else
        add_whole(f);
  }

  const Triangle_soup& soup() const { return m_soup; }
  // by 3 * face + side
  const std::vector<double>& values() const { return m_values; }

private:
  void add(const Triangle& vertices, const std::array<double, 3>& values)
  {
    m_soup.triangles.push_back({static_cast<std::size_t>(vertices[0]),
                                static_cast<std::size_t>(vertices[1]),
                                static_cast<std::size_t>(vertices[2])});
    m_values.insert(m_values.end(), values.begin(), values.end());
  }

  void add_whole(int f)
  {
    const std::array<int, 3> h = m_state.mesh().halfedges(f);
    const Flat_mesh& mesh = m_state.mesh();
    add({mesh.source(h[0]), mesh.source(h[1]), mesh.source(h[2])},
        {length_of_edge(m_state, edge_of(h[0])), length_of_edge(m_state, edge_of(h[1])),
         length_of_edge(m_state, edge_of(h[2]))});
  }

  void split(int f, int center)
  {
    const Tripod tripod(m_state, f);
    for (int i : {0, 1, 2})
    {
      const int j = (i + 1) % 3;
      add({tripod.corner(i), tripod.corner(j), center},
          {length_of_edge(m_state, edge_of(tripod.out(i))), tripod.length_of_leg(j),
           tripod.length_of_leg(i)});
    }
  }

  const Foliation_state& m_state;
  Triangle_soup m_soup;
  std::vector<double> m_values;
};

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

appends to `output` a copy of the mesh in which every face that is a tripod saddle is split into
three at its center, so that every singularity is a vertex [Section 5.2.1]. The input mesh is not
changed. The first vertices appended are those of the input mesh, in its order; then comes the
center of each face that `singularities()` reports, in the order of faces.

The new edges get foliation values, too: the value of an edge from the center to a corner is that of
the leaves that cut off the corner. So every face of `output` is regular: the value of one of its
edges is the sum of those of the other two, up to rounding. Which faces are split is decided without
numerical comparisons.

\tparam TriangleMesh see `Loop_system`
\tparam OutputMesh a model of `MutableFaceGraph` in which a new element is the last to be iterated
\param foliation the foliation
\param output the mesh to append to
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of `output`}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<OutputMesh>::%vertex_descriptor` as key type and a point type
      constructible from three `double` as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
  \cgalParamNEnd
  \cgalParamNBegin{edge_value_map}
    \cgalParamDescription{a property map to which the foliation value of each edge of `output` is
      written}
    \cgalParamType{a class model of `WritablePropertyMap` with
      `boost::graph_traits<OutputMesh>::%edge_descriptor` as key type and `double` as value type}
    \cgalParamDefault{nothing is written}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the number of faces that were split

Time and memory are linear in the size of the mesh.
*/
template <class TriangleMesh,
          class OutputMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t subdivide_saddle_faces(const Measured_foliation<TriangleMesh>& foliation,
                                   OutputMesh& output,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::edge_value_map_t>(np);
  using Edge = typename boost::graph_traits<OutputMesh>::edge_descriptor;
  const auto vertex_point_map = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                 get_property_map(CGAL::vertex_point, output));
  const auto edge_value_map = choose_parameter(get_parameter(np, internal_np::edge_value_map),
                                               CGAL::Constant_property_map<Edge, double>());

  const internal::Split_saddles split(foliation.state(), foliation.extraction().refined_mesh);
  const auto faces = internal::build_triangle_mesh(split.soup(), output, vertex_point_map);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    auto h = halfedge(faces[f], output);
    for (std::size_t i : {0, 1, 2})
    {
      put(edge_value_map, edge(h, output), split.values()[3 * f + i]);
      h = next(h, output);
    }
  }
  return split.soup().points.size() -
         static_cast<std::size_t>(foliation.state().mesh().number_of_input_vertices());
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_SUBDIVIDE_SADDLE_FACES_H
