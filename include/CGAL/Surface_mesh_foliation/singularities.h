// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_SINGULARITIES_H
#define CGAL_SURFACE_MESH_FOLIATION_SINGULARITIES_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is a singular vertex or face of a measured foliation [Sections 3.1, 3.2].
*/
template <class TriangleMesh>
struct Singularity
{
  bool is_face; ///< whether it is a face: a tripod saddle
  /// the face, if `is_face`
  typename boost::graph_traits<TriangleMesh>::face_descriptor face;
  /// the vertex, if not `is_face`
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex;
  int index;        ///< 2 for a center pole, 1 for a thorn pole, -m for a saddle of order m
  std::size_t node; ///< the node that it belongs to
};

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

puts out the singularities of a foliation. A connected set of faces that lie at one node as a whole
is one singularity, reported at one of its vertices.

The indices at a node add up to twice the Euler characteristic of its region, and only poles have
positive ones.

\param foliation the foliation
\param out an output iterator for `Singularity<TriangleMesh>`

\returns the output iterator
*/
template <class TriangleMesh, class SingularityOutputIterator>
SingularityOutputIterator singularities(const Measured_foliation<TriangleMesh>& foliation,
                                        SingularityOutputIterator out)
{
  using Traits = boost::graph_traits<TriangleMesh>;
  const auto& mesh_index = foliation.system().data().mesh_index;
  for (const internal::Singular_place& place : foliation.certificate().singular_places())
  {
    Singularity<TriangleMesh> result = {place.is_face, Traits::null_face(), Traits::null_vertex(),
                                        place.index, static_cast<std::size_t>(place.node)};
    if (place.is_face)
      result.face = mesh_index.face(place.place);
    else
      result.vertex = mesh_index.vertex(place.place);
    *out++ = result;
  }
  return out;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_SINGULARITIES_H
