// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_GENERATORS_OPENINGS_H
#define SMF_GENERATORS_OPENINGS_H

#include "generators/Random.h"
#include "generators/meshes.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

// Surfaces with openings, cut into closed ones.

namespace smf_test {

namespace soups {

// without vertices that no face uses; the others keep their order
inline Triangle_soup without_isolated_vertices(const Triangle_soup& soup)
{
  std::vector<bool> is_used(soup.points.size(), false);
  for (const Triangle& triangle : soup.triangles)
    for (const std::size_t v : triangle)
      is_used[v] = true;
  std::vector<std::size_t> number(soup.points.size(), 0);
  Triangle_soup result;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (is_used[v])
    {
      number[v] = result.points.size();
      result.points.push_back(soup.points[v]);
    }
  for (const auto& [a, b, c] : soup.triangles)
    result.triangles.push_back({number[a], number[b], number[c]});
  return result;
}

// The faces for which the function returns true.
template <class Function>
Triangle_soup with_faces(const Triangle_soup& soup, const Function& is_kept)
{
  Triangle_soup result;
  result.points = soup.points;
  for (const Triangle& triangle : soup.triangles)
    if (is_kept(triangle))
      result.triangles.push_back(triangle);
  return without_isolated_vertices(result);
}

// The part of a soup on one side of a plane x_i = level: the faces whose corners all lie there.
inline Triangle_soup part_below(const Triangle_soup& soup, std::size_t axis, double level)
{
  return with_faces(soup, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::size_t v) { return soup.points[v][axis] <= level; });
  });
}

// Cuts up to `number` openings, some of a face and some of many, near each other too; the result is
// a connected manifold.
inline Triangle_soup with_random_openings(Triangle_soup soup, std::size_t number, Random& random)
{
  namespace SMF = CGAL::Surface_mesh_foliation;
  for (std::size_t attempt = 0; attempt < 4 * number && number > 0; ++attempt)
  {
    const std::size_t seed = random.index(soup.triangles.size());
    const std::size_t size =
      random.index(3) == 0 ? 1 : 1 + random.index(1 + soup.triangles.size() / 6);
    // faces around the seed, in rounds: those that share a vertex with one before
    std::vector<bool> is_cut(soup.triangles.size(), false), is_near(soup.points.size(), false);
    is_cut[seed] = true;
    for (std::size_t count = 1; count < size;)
    {
      for (std::size_t f = 0; f < is_cut.size(); ++f)
        if (is_cut[f])
          for (const std::size_t v : soup.triangles[f])
            is_near[v] = true;
      const std::size_t before = count;
      for (std::size_t f = 0; f < is_cut.size() && count < size; ++f)
        if (!is_cut[f] && std::any_of(soup.triangles[f].begin(), soup.triangles[f].end(),
                                      [&](std::size_t v) { return is_near[v]; }))
        {
          is_cut[f] = true;
          ++count;
        }
      if (count == before)
        break;
    }
    Triangle_soup cut;
    cut.points = soup.points;
    for (std::size_t f = 0; f < is_cut.size(); ++f)
      if (!is_cut[f])
        cut.triangles.push_back(soup.triangles[f]);
    cut = without_isolated_vertices(cut);
    if (cut.triangles.size() < 4 ||
        !SMF::check_triangle_soup(cut, SMF::parameters::allow_openings(true)).empty())
      continue;
    soup = std::move(cut);
    --number;
  }
  return soup;
}

} // namespace soups

// the mesh of a soup that may have openings
template <class TriangleMesh = Mesh>
TriangleMesh to_open_mesh(const Triangle_soup& soup)
{
  namespace SMF = CGAL::Surface_mesh_foliation;
  TriangleMesh mesh;
  SMF::triangle_soup_to_triangle_mesh(soup, mesh, SMF::parameters::allow_openings(true));
  return mesh;
}

// a border halfedge of each opening
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> border_halfedges(
  const TriangleMesh& mesh)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> result, seen;
  for (const auto h : halfedges(mesh))
  {
    if (!is_border(h, mesh) || std::find(seen.begin(), seen.end(), h) != seen.end())
      continue;
    result.push_back(h);
    auto g = h;
    do
    {
      seen.push_back(g);
      g = next(g, mesh);
    } while (g != h);
  }
  return result;
}

} // namespace smf_test

#endif // SMF_GENERATORS_OPENINGS_H
