// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_ADD_MISSING_POLES_H
#define CGAL_SURFACE_MESH_FOLIATION_ADD_MISSING_POLES_H

#include <CGAL/Surface_mesh_foliation/Poles_and_loops.h>
#include <CGAL/Surface_mesh_foliation/automatic_loops.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/Geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_farthest_from_centroid.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// of the input; the first of several
inline int vertex_farthest_from(const Flat_mesh& mesh, const std::vector<int>& sources)
{
  const std::vector<double> distance = Geodesic_distances(mesh, sources).distances();
  return static_cast<int>(
    std::max_element(distance.begin(), distance.begin() + mesh.number_of_input_vertices()) -
    distance.begin());
}

// vertices that become poles so that there are two on a surface of genus 0
inline std::vector<int> missing_poles(const Flat_mesh& mesh, const std::vector<Pole>& poles)
{
  std::vector<int> result;
  if (mesh.genus() > 0 || poles.size() >= 2)
    return result;
  std::vector<int> sources;
  for (const Pole& pole : poles)
    sources.insert(sources.end(), pole.begin(), pole.end());
  if (sources.empty())
  {
    sources = {vertex_farthest_from(mesh, {vertex_farthest_from_centroid(mesh)})};
    result = sources;
  }
  const int farthest = vertex_farthest_from(mesh, sources);
  if (std::find(sources.begin(), sources.end(), farthest) == sources.end())
    result.push_back(farthest);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

adds center poles of height 1 to a surface of genus 0 until it has two poles, the least number that
it has a foliation with. A ball, a cube or a pebble has no limbs, so `detect_feature_poles()` may
find fewer.

The second pole is the vertex farthest from the first one along the surface. If there is none, the
first pole is the vertex farthest from the one farthest from the centroid, so that the two poles are
nearly the ends of a diameter.

\param mesh a mesh that `Loop_system` accepts
\param poles_and_loops poles, openings among them, to which poles are added; nothing is added to a
  surface of positive genus, to two poles or more, or if there are other loops
\param np an optional sequence of named parameters: `vertex_point_map` as for `Loop_system`

\returns the number of poles added: 0, 1 or 2. (To a disk all of whose vertices lie on its border,
  nothing can be added.)

\throws Invalid_mesh_exception, Invalid_loops_exception as `propose_loops()` does

The time is \f$O(n \log n)\f$ for \f$n\f$ vertices.
*/
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t add_missing_poles(const TriangleMesh& mesh,
                              Poles_and_loops<TriangleMesh>& poles_and_loops,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  const internal::Checked_mesh<TriangleMesh> checked(mesh, np);
  const std::size_t before = poles_and_loops.size();
  if (checked.flat.genus() > 0 || before >= 2 ||
      (before == 1 && !poles_and_loops.entries()[0].is_pole_loop()))
    return 0;
  const std::vector<internal::Pole> poles =
    internal::poles_to_sweep_from(poles_and_loops, checked.index, checked.capped);
  for (const int v : internal::missing_poles(checked.flat, poles))
    poles_and_loops.add_pole(checked.index.vertex(v));
  return poles_and_loops.size() - before;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_ADD_MISSING_POLES_H
