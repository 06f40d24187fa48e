// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/vertex_areas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The loops of a surface in the order of their moduli, found on a proxy. Around a thin tube or
// handle the proxy may have a few edges only, too few for its modulus; then moduli are measured on
// a proxy that is finer there. So are those of candidates that were not chosen, and of loops
// elsewhere, whose annuli may reach there: with a few edges around two handles, they can be off by
// a factor of two.
class Loops_on_proxy
{
public:
  // Precondition: on the proxy, poles are apart.
  // least_modulus: see Flat_loop_hierarchy. The loops above it are the same as with 0.
  Loops_on_proxy(const Flat_mesh& fine,
                 const std::vector<Pole>& poles,
                 std::shared_ptr<const Proxy> proxy,
                 const Poll& poll = poll_nobody,
                 double least_modulus = 0)
    : m_proxy(std::move(proxy)),
      m_hierarchy(
        m_proxy->mesh(),
        m_proxy->lengths(),
        m_proxy->poles(),
        poll,
        (std::min)(least_modulus, least_refined + Flat_loop_hierarchy::accuracy_of_bounds))
  {
    if (m_proxy->mesh().number_of_vertices() == fine.number_of_vertices())
      return;
    std::vector<Loop_class> loops = m_hierarchy.contenders();
    loops.erase(std::remove_if(loops.begin(), loops.end(),
                               [](const Loop_class& found) {
                                 return found.is_separating && found.modulus < least_refined;
                               }),
                loops.end());
    if (std::none_of(loops.begin(), loops.end(), is_thin))
      return;
    measure(fine, poles, loops, poll);
    m_hierarchy.choose_again(loops);
  }

  const Proxy& proxy() const { return *m_proxy; }
  const Flat_loop_hierarchy& hierarchy() const { return m_hierarchy; }

private:
  // A loop around a ring of k vertices crosses about 2k edges. On tori of revolution that were
  // collapsed to 5,000 vertices, moduli are too large by 0.7% with 16 around, by 2% with 10; where
  // tubes taper, fewer than around the loop are around elsewhere in its annulus.
  static constexpr double enough_crossings = 64;
  // Separating loops that are clearly below the usual bound, 0.6, are not looked at so closely.
  static constexpr double least_refined = 0.57;
  // of the number of vertices; more would take too much time where there are many thin handles
  static constexpr double most_growth = 3;

  static bool is_thin(const Loop_class& found)
  {
    return static_cast<double>(found.loop.crossings.size()) < enough_crossings;
  }

  void measure(const Flat_mesh& fine,
               const std::vector<Pole>& poles,
               std::vector<Loop_class>& classes,
               const Poll& poll) const
  {
    const std::vector<double> fineness = fineness_for(classes);
    std::vector<double> of_fine_mesh(fine.number_of_vertices());
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      of_fine_mesh[v] = fineness[m_proxy->clusters()[v]];
    std::vector<Flat_loop> loops(classes.size());
    std::transform(classes.begin(), classes.end(), loops.begin(),
                   [this](const Loop_class& found) { return m_proxy->on_fine_mesh(found.loop); });
    // What is kept for the loops comes in addition, lest the rest gets coarser.
    const std::vector<bool> is_kept = vertices_beside_loops(fine, loops);
    const auto number_kept = std::count(is_kept.begin(), is_kept.end(), true);
    const Proxy finer(
      fine, poles, loops,
      static_cast<int>(std::ceil(number_of_vertices(fineness)) + static_cast<double>(number_kept)),
      std::move(of_fine_mesh));
    Class_moduli moduli(finer.mesh(), finer.lengths(), finer.poles(), poll);
    for (std::size_t i = 0; i < classes.size(); ++i)
      classes[i].modulus = moduli.of_loop(finer.on_proxy(loops[i])).modulus;
  }

  // By vertex of the proxy, how many times finer it should be there. What a thin loop needs it gets
  // where its annulus may reach, whose height is its length times its modulus, and less and less up
  // to twice as far.
  std::vector<double> fineness_for(const std::vector<Loop_class>& classes) const
  {
    std::vector<double> result(m_proxy->mesh().number_of_vertices(), 1);
    for (const Loop_class& found : classes)
    {
      if (!is_thin(found))
        continue;
      const auto crossings = static_cast<double>(found.loop.crossings.size());
      const double wanted = enough_crossings / crossings;
      for_each_near(found.loop, crossings * (0.5 + found.modulus), [&](int v, double share) {
        result[v] = (std::max)(result[v], 1 + (wanted - 1) * (std::min)(1., 2 * (1 - share)));
      });
    }
    return result;
  }

  double number_of_vertices(const std::vector<double>& fineness) const
  {
    const std::vector<double> areas = vertex_areas(m_proxy->mesh()); // as shares
    double growth = 0;
    for (std::size_t v = 0; v < areas.size(); ++v)
      growth += areas[v] * fineness[v] * fineness[v];
    return (std::min)(growth, most_growth) * m_proxy->mesh().number_of_vertices();
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

  const std::shared_ptr<const Proxy> m_proxy;
  Flat_loop_hierarchy m_hierarchy;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H
