// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_FUZZ_MESH_FROM_BYTES_H
#define SMF_FUZZ_MESH_FROM_BYTES_H

#include "generators/genus_soups.h"
#include "generators/meshes.h"
#include "generators/openings.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace smf_fuzz {

namespace SMF = CGAL::Surface_mesh_foliation;
using smf_test::Mesh;
using Triangle_soup = SMF::Triangle_soup;

// A small surface that is changed step by step, as bytes say: by flips, splits and collapses of
// edges, splits of faces, moves of vertices, and handles.
class Changed_mesh
{
public:
  Changed_mesh(Mesh mesh, FuzzedDataProvider& bytes) : m_mesh(std::move(mesh)), m_bytes(bytes) {}

  const Mesh& mesh() const { return m_mesh; }

  void change()
  {
    switch (m_bytes.ConsumeIntegral<std::uint8_t>() % 8)
    {
    case 0:
      add_handle();
      break;
    case 1:
      split_face();
      break;
    case 2:
      split_edge();
      break;
    case 3:
      collapse_edge();
      break;
    case 4:
      move_vertex();
      break;
    default:
      flip_edge();
    }
  }

private:
  using Halfedge = Mesh::Halfedge_index;
  using Vertex = Mesh::Vertex_index;

  std::size_t index(std::size_t size)
  {
    return m_bytes.ConsumeIntegral<std::uint16_t>() % size; // the meshes are small
  }
  Halfedge halfedge()
  {
    return Halfedge(static_cast<Mesh::size_type>(index(num_halfedges(m_mesh))));
  }
  // strictly between 0 and 1, often near the ends
  double share()
  {
    constexpr std::array<double, 8> shares = {1e-12, 1e-6, 0.01, 0.25, 0.5, 0.75, 0.99, 1 - 1e-12};
    return m_bytes.PickValueInArray(shares);
  }
  smf_test::Kernel::Point_3 between(Vertex a, Vertex b, double t) const
  {
    return m_mesh.point(a) + t * (m_mesh.point(b) - m_mesh.point(a));
  }

  void flip_edge()
  {
    const Halfedge h = halfedge();
    if (smf_test::is_flippable(h, m_mesh))
      CGAL::Euler::flip_edge(h, m_mesh);
  }

  void split_face()
  {
    const Halfedge h = halfedge();
    const double s = share(), t = share();
    const auto p = between(source(h, m_mesh), target(h, m_mesh), s);
    const auto q = p + t * (m_mesh.point(target(next(h, m_mesh), m_mesh)) - p);
    m_mesh.point(target(CGAL::Euler::add_center_vertex(h, m_mesh), m_mesh)) = q;
  }

  void split_edge()
  {
    const Halfedge h = halfedge();
    const auto p = between(source(h, m_mesh), target(h, m_mesh), share());
    const Halfedge first = CGAL::Euler::split_edge(h, m_mesh);
    m_mesh.point(target(first, m_mesh)) = p;
    CGAL::Euler::split_face(first, next(h, m_mesh), m_mesh);
    const Halfedge second = opposite(h, m_mesh);
    CGAL::Euler::split_face(second, next(next(second, m_mesh), m_mesh), m_mesh);
  }

  void collapse_edge()
  {
    const Halfedge h = halfedge();
    if (num_vertices(m_mesh) < 5 ||
        !CGAL::Euler::does_satisfy_link_condition(edge(h, m_mesh), m_mesh))
      return;
    CGAL::Euler::collapse_edge(edge(h, m_mesh), m_mesh);
    m_mesh.collect_garbage();
  }

  void move_vertex()
  {
    const Halfedge h = halfedge();
    const auto step = m_bytes.ConsumeIntegralInRange<int>(-4, 4) *
                      (m_mesh.point(source(h, m_mesh)) - m_mesh.point(target(h, m_mesh)));
    const Vertex v = target(next(h, m_mesh), m_mesh);
    m_mesh.point(v) = m_mesh.point(v) + 0.25 * step;
  }

  // if two faces without a common vertex are drawn
  void add_handle()
  {
    Triangle_soup soup = smf_test::to_soup(m_mesh);
    std::size_t a = index(soup.triangles.size()), b = index(soup.triangles.size());
    if (a < b)
      std::swap(a, b);
    const auto first = soup.triangles[a], second = soup.triangles[b];
    if (std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) != first.end())
      return;
    smf_test::soups::add_tube(soup, first, second);
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(a));
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(b));
    if (SMF::check_triangle_soup(soup).empty()) // no face had become degenerate before
      m_mesh = smf_test::to_mesh(soup);
  }

  Mesh m_mesh;
  FuzzedDataProvider& m_bytes;
};

inline Triangle_soup simple_soup(FuzzedDataProvider& bytes)
{
  switch (bytes.ConsumeIntegral<std::uint8_t>() % 6)
  {
  case 0:
    return smf_test::soups::octahedron();
  case 1:
    return smf_test::soups::icosahedron();
  case 2:
    return smf_test::soups::torus(4, 3, 3, 1);
  case 3:
    return smf_test::soups::torus(7, 5, 3, 1);
  case 4:
    return smf_test::soups::icosphere(1);
  default:
    return smf_test::soups::tetrahedron();
  }
}

// Removes a face, or the faces at a vertex, if what is left is a surface.
inline void cut_opening(Triangle_soup& soup, FuzzedDataProvider& bytes)
{
  const bool is_face = bytes.ConsumeBool();
  const auto& triangle =
    soup.triangles[bytes.ConsumeIntegral<std::uint16_t>() % soup.triangles.size()];
  const std::size_t v = triangle[0], w = is_face ? triangle[1] : v, x = is_face ? triangle[2] : v;
  const auto has = [](const auto& t, std::size_t corner) {
    return std::find(t.begin(), t.end(), corner) != t.end();
  };
  Triangle_soup cut = smf_test::soups::with_faces(
    soup, [&](const auto& t) { return !has(t, v) || !has(t, w) || !has(t, x); });
  if (SMF::check_triangle_soup(cut, SMF::parameters::allow_openings(true)).empty())
    soup = std::move(cut);
}

// along the axes
inline void scale(Triangle_soup& soup, const std::array<double, 3>& factors)
{
  for (auto& point : soup.points)
    for (std::size_t i = 0; i < 3; ++i)
      point[i] *= factors[i];
}

// A small surface of any genus, perhaps with openings, flat faces, and large or small coordinates;
// nothing if a face is degenerate.
inline std::optional<Mesh> mesh_from_bytes(FuzzedDataProvider& bytes, std::size_t most_changes)
{
  Changed_mesh changed(smf_test::to_mesh(simple_soup(bytes)), bytes);
  for (auto i = bytes.ConsumeIntegralInRange<std::size_t>(0, most_changes); i > 0; --i)
    changed.change();
  Triangle_soup soup = smf_test::to_soup(changed.mesh());
  constexpr std::array<double, 8> units = {1, 1, 1, 1, 1e-50, 1e50, 1e-150, 1e150};
  constexpr std::array<double, 8> stretches = {1, 1, 1, 1, 1, 1e-3, 1e3, 1e6};
  const double unit = bytes.PickValueInArray(units);
  scale(soup, {unit, unit, unit * bytes.PickValueInArray(stretches)});
  for (auto i = bytes.ConsumeIntegralInRange<int>(0, 7) - 4; i > 0; --i)
    cut_opening(soup, bytes);
  if (!SMF::check_triangle_soup(soup, SMF::parameters::allow_openings(true)).empty())
    return std::nullopt;
  return smf_test::to_open_mesh(soup);
}

} // namespace smf_fuzz

#endif // SMF_FUZZ_MESH_FROM_BYTES_H
