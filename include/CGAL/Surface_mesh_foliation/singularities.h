// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_SINGULARITIES_H
#define CGAL_SURFACE_MESH_FOLIATION_SINGULARITIES_H

#include <CGAL/Surface_mesh_foliation/Measured_foliation.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is the kind of a singularity [Sections 3.1, 3.2].
*/
enum class Singularity_kind {
  CENTER_POLE,  ///< index 2: a pole that is a vertex
  THORN_POLE,   ///< index 1: either end of a pole that is a polyline
  TRIPOD,       ///< index -1: three bundles of leaves meet, in a face or at a vertex
  MORSE_SADDLE, ///< index -2: four bundles meet, as at the saddle of a function
  HIGHER_SADDLE ///< index -m for an order m > 2: m + 2 bundles meet
};

/// \ingroup PkgSurfaceMeshFoliationExtraction
/// returns the kind of singularities with an index other than 0.
inline Singularity_kind singularity_kind(int index)
{
  return index > 1     ? Singularity_kind::CENTER_POLE
         : index == 1  ? Singularity_kind::THORN_POLE
         : index == -1 ? Singularity_kind::TRIPOD
         : index == -2 ? Singularity_kind::MORSE_SADDLE
                       : Singularity_kind::HIGHER_SADDLE;
}

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
  int index;             ///< 2 for a center pole, 1 for a thorn pole, -m for a saddle of order m
  std::size_t node;      ///< the node that it belongs to
  Singularity_kind kind; ///< its kind, determined by the index
  int order;             ///< the order m of a saddle, where m + 2 bundles meet; 0 for a pole
};

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

is a critical leaf at which more than three components meet [Section 5.3, Fig. 13].
*/
struct Complex_saddle_leaf
{
  std::size_t node;  ///< the node that the critical leaf stands for
  std::size_t order; ///< the number of components that meet; one with both ends there counts twice
};

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

outputs the singularities of a foliation. A connected set of faces that lie entirely at one node is
one singularity, reported at one of its vertices. So are edges at a node that a critical leaf ends
with, as it may where the weight of an edge exceeds those beside it by more than numbers tell.

The indices at a node add up to twice the Euler characteristic of its region, and only poles have
positive indices. The border of an opening is a leaf without singularities.

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
  const auto& system = foliation.system();
  for (const internal::Singular_place& place : foliation.extraction().singular_places)
  {
    if (place.index > 0 && system.is_border_pole(static_cast<std::size_t>(system.pole(place.node))))
      continue; // the leaves are parallel to the border of an opening
    Singularity<TriangleMesh> result = {place.is_face,
                                        Traits::null_face(),
                                        Traits::null_vertex(),
                                        place.index,
                                        static_cast<std::size_t>(place.node),
                                        singularity_kind(place.index),
                                        (std::max)(-place.index, 0)};
    if (place.is_face)
      result.face = mesh_index.face(place.place);
    else
      result.vertex = mesh_index.vertex(place.place);
    *out++ = result;
  }
  return out;
}

/*!
\ingroup PkgSurfaceMeshFoliationExtraction

outputs the critical leaves at which more than three components meet, in the order of nodes. At a
saddle of a Morse function there are three. Here the loops determine the number; whether the
singularities of such a leaf come together in one saddle of higher order or are several tripods does
not matter.

\param foliation the foliation
\param out an output iterator for `Complex_saddle_leaf`

\returns the output iterator
*/
template <class TriangleMesh, class OutputIterator>
OutputIterator complex_saddle_leaves(const Measured_foliation<TriangleMesh>& foliation,
                                     OutputIterator out)
{
  for (std::size_t r = 0; r < foliation.system().number_of_nodes(); ++r)
    if (foliation.system().degree(r) > 3)
      *out++ = Complex_saddle_leaf{r, static_cast<std::size_t>(foliation.system().degree(r))};
  return out;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_SINGULARITIES_H
