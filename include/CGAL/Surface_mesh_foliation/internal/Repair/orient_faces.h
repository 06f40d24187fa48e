// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_ORIENT_FACES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_ORIENT_FACES_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Disjoint_sets.h>
#include <CGAL/Surface_mesh_foliation/internal/Repair/Traced_soup.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Follows what CGAL does to a soup. CGAL takes a copy of it.
class Orientation_tracer : public Polygon_mesh_processing::Default_orientation_visitor
{
public:
  Orientation_tracer(Traced_soup& soup, std::vector<bool>& is_reversed)
    : m_soup(&soup), m_is_reversed(&is_reversed)
  {}

  void polygon_orientation_reversed(std::size_t face) const { (*m_is_reversed)[face] = true; }
  // new vertices come one after the other, behind all others
  void duplicated_vertex(std::size_t vertex, std::size_t) const
  {
    m_soup->vertex_origins.push_back(m_soup->vertex_origins[vertex]);
  }

private:
  Traced_soup* m_soup;
  std::vector<bool>* m_is_reversed;
};

// by face, a vertex that stands for its part; faces of a part are joined by vertices.
inline std::vector<std::size_t> parts_of_faces(const Traced_soup& soup)
{
  Disjoint_sets sets(soup.points.size());
  for (const Traced_soup::Face& face : soup.faces)
    for (const std::size_t v : face)
      sets.union_set(face[0], v);
  std::vector<std::size_t> result;
  result.reserve(soup.faces.size());
  for (const Traced_soup::Face& face : soup.faces)
    result.push_back(sets.find_set(face[0]));
  return result;
}

// Turns parts over most of whose faces have been reversed, so that few differ from the input.
inline void turn_to_majority(Traced_soup& soup, std::vector<bool>& is_reversed)
{
  const std::vector<std::size_t> part = parts_of_faces(soup);
  std::vector<long long> surplus(soup.points.size(), 0); // by part: reversed faces less the others
  for (std::size_t f = 0; f < part.size(); ++f)
    surplus[part[f]] += is_reversed[f] ? 1 : -1;
  for (std::size_t f = 0; f < part.size(); ++f)
    if (surplus[part[f]] > 0)
    {
      std::reverse(soup.faces[f].begin(), soup.faces[f].end());
      is_reversed[f] = !is_reversed[f];
    }
}

struct Orientation_counts
{
  std::size_t reversed_faces = 0;
  std::size_t duplicated_vertices = 0;
};

// Orients the faces of a soup of triangles alike, and gives faces that do not fit together vertices
// of their own, so that what remains is a manifold with borders: where more than two faces meet at
// an edge, where two meet that cannot be oriented alike, and at vertices with several umbrellas.
inline Orientation_counts orient_faces(Traced_soup& soup)
{
  const std::size_t number_of_vertices = soup.points.size();
  std::vector<bool> is_reversed(soup.faces.size(), false);
  Polygon_mesh_processing::orient_polygon_soup(
    soup.points, soup.faces, CGAL::parameters::visitor(Orientation_tracer(soup, is_reversed)));
  turn_to_majority(soup, is_reversed);
  return {static_cast<std::size_t>(std::count(is_reversed.begin(), is_reversed.end(), true)),
          soup.points.size() - number_of_vertices};
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_REPAIR_ORIENT_FACES_H
