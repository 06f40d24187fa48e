// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H

#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Class_moduli.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Flat_loop_hierarchy.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Loop_fineness.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>

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
// handle the proxy may have a few vertices only, too few for its modulus; then moduli are measured
// on a proxy that is finer there. So are those of candidates that were not chosen, and of loops
// elsewhere, whose annuli may reach there: with a few vertices around two handles, moduli can be
// off by a factor of two.
class Loops_on_proxy
{
public:
  // Precondition: on the proxy, poles are apart.
  // least_modulus: see Flat_loop_hierarchy. Loops above it are measured as they are with 0, if the
  // first candidates cut the surface into pairs of pants.
  Loops_on_proxy(const Flat_mesh& fine,
                 const std::vector<Pole>& poles,
                 std::shared_ptr<const Proxy> proxy,
                 const Poll& poll = poll_nobody,
                 double least_modulus = 0)
    : m_proxy(std::move(proxy)),
      m_hierarchy(m_proxy->mesh(),
                  m_proxy->lengths(),
                  m_proxy->poles(),
                  poll,
                  (std::min)(least_modulus, least_without_handles))
  {
    if (m_proxy->mesh().number_of_vertices() == fine.number_of_vertices())
      return;
    const std::vector<std::size_t> positions = contenders();
    Loop_fineness fineness(m_proxy->mesh());
    for (const std::size_t i : positions)
      fineness.add(candidate(i).loop, candidate(i).modulus);
    if (fineness.is_needed())
      m_hierarchy.choose_again(positions,
                               moduli_on_finer_mesh(fine, poles, positions, fineness, poll));
  }

  const Proxy& proxy() const { return *m_proxy; }
  const Flat_loop_hierarchy& hierarchy() const { return m_hierarchy; }

private:
  // Without handles, all loops separate the surface, and no two with moduli above 1/2 cross, so
  // there is nothing to choose. Those below the usual bound, 0.6, by a twentieth or more are not
  // measured again, which would take much time on most shapes.
  static constexpr double least_without_handles = 0.57;

  const Loop_class& candidate(std::size_t i) const { return m_hierarchy.candidates()[i]; }

  bool is_contender(const Loop_class& found) const
  {
    if (m_proxy->mesh().genus() == 0)
      return found.modulus >= least_without_handles;
    return found.is_chosen || found.modulus >= Flat_loop_hierarchy::least_looked_at;
  }

  // the positions of the candidates whose moduli matter
  std::vector<std::size_t> contenders() const
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < m_hierarchy.candidates().size(); ++i)
      if (is_contender(candidate(i)))
        result.push_back(i);
    return result;
  }

  std::vector<double> moduli_on_finer_mesh(const Flat_mesh& fine,
                                           const std::vector<Pole>& poles,
                                           const std::vector<std::size_t>& contenders,
                                           const Loop_fineness& fineness,
                                           const Poll& poll) const
  {
    std::vector<Flat_loop> loops;
    loops.reserve(contenders.size());
    for (const std::size_t i : contenders)
      loops.push_back(m_proxy->on_fine_mesh(candidate(i).loop));
    // What is kept for the loops comes in addition, lest the rest gets coarser.
    const std::vector<bool> is_kept = vertices_beside_loops(fine, loops);
    const double size = fineness.number_of_vertices() +
                        static_cast<double>(std::count(is_kept.begin(), is_kept.end(), true));
    const Proxy finer(fine, poles, loops, static_cast<int>(std::ceil(size)),
                      on_fine_mesh(fine, fineness.fineness()));
    Class_moduli moduli(finer.mesh(), finer.lengths(), finer.poles(), poll);
    std::vector<double> result(loops.size());
    std::transform(loops.begin(), loops.end(), result.begin(), [&](const Flat_loop& loop) {
      return moduli.of_loop(finer.on_proxy(loop)).modulus;
    });
    return result;
  }

  std::vector<double> on_fine_mesh(const Flat_mesh& fine, const std::vector<double>& values) const
  {
    std::vector<double> result(fine.number_of_vertices());
    for (int v = 0; v < fine.number_of_vertices(); ++v)
      result[v] = values[m_proxy->clusters()[v]];
    return result;
  }

  const std::shared_ptr<const Proxy> m_proxy;
  Flat_loop_hierarchy m_hierarchy;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_CANONICAL_LOOPS_LOOPS_ON_PROXY_H
