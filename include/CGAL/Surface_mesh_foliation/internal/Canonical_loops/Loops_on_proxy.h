// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The loops of a surface in the order of their moduli, found on a proxy. Around a thin handle the
// proxy may have a few edges only, too few for its modulus; then the loops are carried to a proxy
// that is finer there, and their moduli and order are those that they have on it. So are those of
// candidates that were not chosen: a few edges around two handles can be off by a factor of two.
class Loops_on_proxy
{
public:
  // Precondition: on the proxy, poles are apart.
  // least_modulus: see Flat_loop_hierarchy
  Loops_on_proxy(const Flat_mesh& fine,
                 const std::vector<Pole>& poles,
                 std::shared_ptr<const Proxy> proxy,
                 const Poll& poll = poll_nobody,
                 double least_modulus = 0)
    : m_proxy(std::move(proxy))
  {
    carry(poles);
    m_hierarchy.emplace(m_proxy->mesh(), m_proxy->lengths(), m_poles, poll, least_modulus);
    const std::vector<double> fineness = fineness_on_proxy();
    if (!fineness.empty() && m_proxy->mesh().number_of_vertices() < fine.number_of_vertices())
      refine(fine, poles, fineness, poll);
  }

  const Proxy& proxy() const { return *m_proxy; }
  const Flat_loop_hierarchy& hierarchy() const { return *m_hierarchy; }

private:
  // A loop around a ring of k vertices crosses about 2k edges. On tori of revolution that were
  // collapsed to 5,000 vertices, moduli are too large by 0.7% with 16 around, by 2% with 10.
  static constexpr double enough_crossings = 32;
  // of the number of vertices; more would take too much time where there are many thin handles
  static constexpr double most_growth = 3;

  void carry(const std::vector<Pole>& poles)
  {
    m_poles = poles;
    for (Pole& pole : m_poles)
      for (int& v : pole)
        v = m_proxy->clusters()[v];
  }

  // By vertex of the proxy, how many times finer it should be there; empty if it is fine enough
  // everywhere. What a loop needs it gets where its annulus may reach, whose height is its length
  // times its modulus, and less and less up to twice as far.
  std::vector<double> fineness_on_proxy() const
  {
    std::vector<double> result(m_proxy->mesh().number_of_vertices(), 1);
    bool is_fine_enough = true;
    for (const Loop_class& found : m_hierarchy->loops())
    {
      const auto crossings = static_cast<double>(found.loop.crossings.size());
      if (crossings >= enough_crossings || found.is_separating)
        continue;
      is_fine_enough = false;
      const double wanted = enough_crossings / crossings;
      for_each_near(found.loop, crossings * (0.5 + found.modulus), [&](int v, double share) {
        result[v] = (std::max)(result[v], 1 + (wanted - 1) * (std::min)(1., 2 * (1 - share)));
      });
    }
    return is_fine_enough ? std::vector<double>() : result;
  }

  // Calls a function for the vertices that are at most some number of edges away, each with its
  // share of that number.
  template <class Function>
  void for_each_near(const Flat_loop& loop, double number, const Function& function) const
  {
    const Flat_mesh& mesh = m_proxy->mesh();
    std::vector<int> distance(mesh.number_of_vertices(), -1), queue;
    const auto reach = [&](int v, int d) {
      if (distance[v] >= 0)
        return;
      distance[v] = d;
      queue.push_back(v);
    };
    for (const Flat_crossing& crossing : loop.crossings)
    {
      reach(mesh.source(crossing.halfedge), 0);
      reach(mesh.target(crossing.halfedge), 0);
    }
    for (std::size_t i = 0; i < queue.size() && distance[queue[i]] <= number; ++i)
    {
      function(queue[i], distance[queue[i]] / number);
      for (int h : mesh.ring(queue[i]))
        reach(mesh.target(h), distance[queue[i]] + 1);
    }
  }

  void refine(const Flat_mesh& fine,
              const std::vector<Pole>& poles,
              const std::vector<double>& fineness,
              const Poll& poll)
  {
    std::vector<double> of_fine_mesh(fine.number_of_vertices());
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      of_fine_mesh[v] = fineness[m_proxy->clusters()[v]];
    const std::vector<double> areas = vertex_areas(m_proxy->mesh()); // as shares
    double growth = 0;
    for (std::size_t v = 0; v < areas.size(); ++v)
      growth += areas[v] * fineness[v] * fineness[v];
    const double number = (std::min)(growth, most_growth) * m_proxy->mesh().number_of_vertices();
    std::vector<Flat_loop> loops = m_hierarchy->loops_and_rivals();
    const std::size_t number_of_loops = m_hierarchy->loops().size();
    m_hierarchy.reset(); // which refers to the proxy and its poles
    for (Flat_loop& loop : loops)
      loop = m_proxy->on_fine_mesh(loop);
    // What is kept for the loops comes in addition, lest the rest gets coarser.
    const std::vector<bool> is_kept = vertices_beside_loops(fine, loops);
    const auto number_kept = std::count(is_kept.begin(), is_kept.end(), true);
    m_proxy = std::make_shared<const Proxy>(
      fine, poles, loops, static_cast<int>(std::ceil(number) + static_cast<double>(number_kept)),
      std::move(of_fine_mesh));
    carry(poles);
    for (Flat_loop& loop : loops)
      loop = m_proxy->on_proxy(loop);
    m_hierarchy.emplace(m_proxy->mesh(), m_proxy->lengths(), m_poles, std::move(loops),
                        number_of_loops, poll);
  }

  std::shared_ptr<const Proxy> m_proxy;
  std::vector<Pole> m_poles; // on the proxy
  std::optional<Flat_loop_hierarchy> m_hierarchy;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H
