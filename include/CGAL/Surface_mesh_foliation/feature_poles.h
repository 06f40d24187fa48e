// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_FEATURE_POLES_H
#define CGAL_SURFACE_MESH_FOLIATION_FEATURE_POLES_H

#include <CGAL/Surface_mesh_foliation/Foliation_visitor.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Pole_significance.h>
#include <CGAL/Surface_mesh_foliation/internal/Canonical_loops/Proxy.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/Poll.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Average_geodesic_distances.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/Persistent_maxima.h>
#include <CGAL/Surface_mesh_foliation/internal/Features/tip_near_cluster.h>
#include <CGAL/Surface_mesh_foliation/internal/Mesh/checked_flat_mesh.h>
#include <CGAL/Surface_mesh_foliation/internal/Solver/solver_visitor.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/require_parameter.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/user_count.h>
#include <CGAL/Surface_mesh_foliation/named_parameters.h>

#include <CGAL/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <type_traits>
#include <vector>

#if __has_include(<Spectra/SymEigsSolver.h>)
#include <CGAL/Surface_mesh_foliation/internal/Features/heat_kernel_signature.h>
#define CGAL_SURFACE_MESH_FOLIATION_HAS_SPECTRA
#endif

/// \file
/// finds poles. The heat kernel signature needs Spectra, a library for eigenvalues, so
/// `CGAL/Surface_mesh_foliation.h` does not include it.

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

selects poles where heat stays longest: the maxima of the heat kernel signature
\cgalCite{sog-cpimsd-09},
\f$ h_t(x) = \sum_i e^{-\lambda_i t} \phi_i(x)^2 \f$, with the smallest eigenvalues
\f$ \lambda_i \f$ of the Laplace-Beltrami operator and their eigenfunctions \f$ \phi_i \f$. At a
large time \f$ t \f$ it does not see details smaller than about \f$ \sqrt t \f$. Poles do not move
when the shape bends.
*/
struct Heat_kernel_signature
{};

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

selects poles far from everything else: the maxima of the average geodesic distance to all other
points of the surface \cgalCite{hskk-tmfast-01}. The average is over samples, each of which is the
vertex farthest from the previous ones. It needs no eigenfunctions, hence no other library.
*/
struct Average_geodesic_distance
{};

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

is the least significance of a pole unless another one is asked for; see `detect_feature_poles()`.
*/
constexpr double default_min_significance = 0.2;

namespace internal {

struct Feature_pole_options
{
  double number_of_poles = std::numeric_limits<double>::infinity();
  double persistence = 0;
  double min_significance = 0;
  double diffusion_time = 0.05;
  int number_of_eigenpairs = 60;
  int number_of_samples = 16;
  int decimation_threshold = 3500;
  bool tells_significance = false;
};

inline double default_persistence(Heat_kernel_signature)
{
  return 1.14;
}

inline double default_persistence(Average_geodesic_distance)
{
  return 1.03;
}

#ifdef CGAL_SURFACE_MESH_FOLIATION_HAS_SPECTRA
inline std::vector<double> pole_function(const Flat_mesh& mesh,
                                         const Feature_pole_options& options,
                                         Heat_kernel_signature,
                                         const Poll&)
{
  return heat_kernel_signature(mesh, options.diffusion_time, options.number_of_eigenpairs);
}
#else
template <class Detector>
std::vector<double> pole_function(const Flat_mesh&,
                                  const Feature_pole_options&,
                                  Detector,
                                  const Poll&)
{
  static_assert(!std::is_same_v<Detector, Heat_kernel_signature>,
                "the heat kernel signature needs Spectra, which is not found");
  return {};
}
#endif

inline std::vector<double> pole_function(const Flat_mesh& mesh,
                                         const Feature_pole_options& options,
                                         Average_geodesic_distance,
                                         const Poll& poll)
{
  return Average_geodesic_distances(mesh, options.number_of_samples, poll).average();
}

struct Feature_pole
{
  int vertex;
  double significance; // a NaN unless asked for
};

// Of the persistent maxima of the function, the most persistent first, those that are significant
// beside all before them. Openings are ends already: they are higher than every maximum, so that a
// maximum beside one does not persist.
template <class Detector>
std::vector<Feature_pole> feature_poles_of_proxy(const Proxy& proxy,
                                                 const Feature_pole_options& options,
                                                 Detector detector,
                                                 const Poll& poll)
{
  std::vector<double> function = pole_function(proxy.mesh(), options, detector, poll);
  std::vector<bool> is_end(function.size(), false);
  for (const Pole& end : proxy.poles())
    for (int v : end)
    {
      is_end[v] = true;
      function[v] = (std::numeric_limits<double>::max)();
    }
  const Persistent_maxima maxima(proxy.mesh(), function);
  Pole_significance significance_of(proxy.mesh(), proxy.poles(), poll);
  std::vector<Feature_pole> result;
  std::vector<int> vertices;
  for (const Maximum& maximum : maxima.maxima())
  {
    if (is_end[maximum.vertex])
      continue;
    if (maximum.persistence < options.persistence ||
        static_cast<double>(result.size()) >= options.number_of_poles)
      break;
    poll();
    if (!significance_of.is_at_least(options.min_significance, maximum.vertex, vertices))
      continue;
    result.push_back({maximum.vertex, options.tells_significance
                                        ? significance_of(maximum.vertex, vertices)
                                        : std::numeric_limits<double>::quiet_NaN()});
    vertices.push_back(maximum.vertex);
  }
  return result;
}

inline std::vector<Pole> caps_of(const Capped_mesh& capped)
{
  std::vector<Pole> result;
  for (std::size_t i = 0; i < capped.openings.size(); ++i)
    result.push_back(capped.cap(static_cast<int>(i)));
  return result;
}

// vertices of a mesh, from those of a proxy of it that has its caps as poles
inline std::vector<Feature_pole> on_finer_mesh(const Flat_mesh& fine,
                                               const Proxy& proxy,
                                               std::vector<Feature_pole> coarse)
{
  if (proxy.mesh().number_of_vertices() == fine.number_of_vertices())
    return coarse;
  const Tip_near_cluster tip_near(fine, proxy.clusters());
  std::vector<Feature_pole> result;
  std::set<int> taken;
  for (const Feature_pole& pole : coarse) // two maxima may share a tip
    for (const int v : {tip_near(pole.vertex), proxy.clusters().representative(pole.vertex)})
      if (taken.insert(v).second)
      {
        result.push_back({v, pole.significance});
        break;
      }
  return result;
}

// Vertices of a mesh, found on a proxy of it that has its caps as poles.
template <class TriangleMesh, class Detector>
std::vector<Feature_pole> feature_poles(const Checked_mesh<TriangleMesh>& checked,
                                        const Feature_pole_options& options,
                                        Detector detector,
                                        const Poll& poll)
{
  const int most = (std::numeric_limits<int>::max)() - checked.flat.number_of_caps();
  const Proxy proxy(checked.flat, caps_of(checked.capped), Proxy::no_loops(),
                    (std::min)(options.decimation_threshold, most) + checked.flat.number_of_caps());
  return on_finer_mesh(checked.flat, proxy, feature_poles_of_proxy(proxy, options, detector, poll));
}

template <class Detector, class NamedParameters>
Feature_pole_options feature_pole_options(const NamedParameters& np, Detector detector)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Feature_pole_options o;
  o.number_of_poles = static_cast<double>(
    choose_parameter(get_parameter(np, internal_np::number_of_poles), o.number_of_poles));
  o.persistence =
    choose_parameter(get_parameter(np, internal_np::persistence), default_persistence(detector));
  o.min_significance =
    choose_parameter(get_parameter(np, internal_np::min_significance), default_min_significance);
  o.diffusion_time =
    choose_parameter(get_parameter(np, internal_np::diffusion_time), o.diffusion_time);
  o.number_of_eigenpairs = user_count(
    choose_parameter(get_parameter(np, internal_np::number_of_eigenpairs), o.number_of_eigenpairs));
  o.number_of_samples = user_count(
    choose_parameter(get_parameter(np, internal_np::number_of_samples), o.number_of_samples));
  o.decimation_threshold = user_count(
    choose_parameter(get_parameter(np, internal_np::decimation_threshold), o.decimation_threshold));
  require_parameter(o.number_of_poles >= 0, "the number of poles is negative");
  require_parameter(o.persistence >= 1, "the persistence of poles, a ratio, is less than 1");
  require_parameter(!std::isnan(o.min_significance), "the least significance is not a number");
  require_parameter(o.diffusion_time > 0 && std::isfinite(o.diffusion_time),
                    "the diffusion time is not positive and finite");
  require_parameter(o.number_of_eigenpairs >= 2, "there are fewer than two eigenpairs");
  require_parameter(o.number_of_samples >= 1, "there is no sample");
  require_parameter(o.decimation_threshold >= 1000,
                    "the decimation threshold is below 1000 vertices");
  return o;
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshFoliationFeatures

finds the ends of limbs and other protrusions, to be used as poles [Section 4.2.1 of the paper], and
outputs their vertices, the most persistent first.

They are local maxima of a function on the surface, by default the average geodesic distance, that
are persistent and significant.

The <em>persistence</em> of a maximum is the ratio of its value to that at the pass over which one
can walk to a higher maximum. (For the highest maximum it is the ratio to the smallest value, or, on
a surface with handles, to that at which the surroundings of the maximum, where values are higher,
close around a handle: a ring without limbs has no pole.) Maxima that no sufficiently low pass
separates count as one, the highest of them.

The <em>significance</em> of a maximum says whether it is the end of a limb, whatever the function.
It is the modulus (\ref SMFModulus) of the annuli around it, outside a disk of a quarter of a
percent of the area, that avoid all more persistent poles, minus that of the flat disk of the same
size as the surface. On a limb of length \f$ l \f$ and circumference \f$ c \f$ it is about \f$ l / c
\f$, less a little on thin limbs, and on the side of a limb, or beside another pole, it is at most
about zero; so the fingers of a hand give one pole if the mesh is a whole body, and five if it is
just the hand. On a surface without handles the first two poles need no significance, since a
foliation needs them.

Except for rounding, the result does not depend on the position, orientation or scale of the mesh,
nor, if the mesh is not larger than `decimation_threshold`, on the order of its vertices; where a
shape is symmetric, rounding may decide. A round sphere has no pole, and any surface may have fewer
than the two that a foliation of a sphere needs.

\tparam TriangleMesh see `Loop_system`
\param mesh a mesh that `Loop_system` accepts
\param out an output iterator for `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
  below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{as for `Loop_system`}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{pole_detector}
    \cgalParamDescription{the function whose maxima are the poles}
    \cgalParamType{`Heat_kernel_signature` or `Average_geodesic_distance`}
    \cgalParamDefault{`Average_geodesic_distance()`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_poles}
    \cgalParamDescription{the largest number of poles; less persistent ones are left out}
    \cgalParamType{a number type, not negative}
    \cgalParamDefault{unlimited}
  \cgalParamNEnd
  \cgalParamNBegin{persistence}
    \cgalParamDescription{the least persistence of a pole}
    \cgalParamType{`double`, at least 1}
    \cgalParamDefault{1.14 for `Heat_kernel_signature`, 1.03 for `Average_geodesic_distance`}
  \cgalParamNEnd
  \cgalParamNBegin{min_significance}
    \cgalParamDescription{the least significance of a pole}
    \cgalParamType{`double`, not a NaN; minus infinity leaves it to persistence}
    \cgalParamDefault{`default_min_significance`, 0.2}
  \cgalParamNEnd
  \cgalParamNBegin{significance_output_iterator}
    \cgalParamDescription{receives the significance of each pole that is output, beside those before
      it; infinity for poles that a foliation needs}
    \cgalParamType{an output iterator for `double`}
    \cgalParamDefault{`CGAL::Emptyset_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{diffusion_time}
    \cgalParamDescription{the time of the heat kernel signature as a multiple of
      \f$ 1 / \lambda_1 \f$. Limbs shorter than about a tenth of the way across the surface are not
      seen at the default value. The time is increased if there are too few eigenfunctions for it.}
    \cgalParamType{`double`, positive and finite}
    \cgalParamDefault{0.05}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_eigenpairs}
    \cgalParamDescription{the number of eigenfunctions}
    \cgalParamType{`int`, at least 2}
    \cgalParamDefault{60}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_samples}
    \cgalParamDescription{the number of samples for the average geodesic distance}
    \cgalParamType{`int`, at least 1}
    \cgalParamDefault{16}
  \cgalParamNEnd
  \cgalParamNBegin{decimation_threshold}
    \cgalParamDescription{the largest number of vertices of a mesh that is examined as it is. The
      poles of a larger one are found on a coarser mesh with this many of its vertices.}
    \cgalParamType{`int`, at least 1000}
    \cgalParamDefault{3500}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{its `go_on()` is called before each step that may take long; if it returns
      `false`, there is no result}
    \cgalParamType{a model of `FoliationVisitor`}
    \cgalParamDefault{`Default_foliation_visitor`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the output iterator

\throws Invalid_mesh_exception if `Loop_system` would
\throws Invalid_parameter_exception if a parameter is out of its range
\throws Solver_exception if the Laplacian cannot be factored or its eigenfunctions do not converge
\throws Stopped_exception if the visitor's `go_on()` returns `false`

The time is \f$O(n \log n)\f$ for the coarser mesh; on it, \f$O(m \log m)\f$ for each sample, or one
sparse Cholesky factorization and about four pairs of triangular solves for each eigenfunction; then
one factorization, and two pairs of triangular solves for each maximum, which bound its
significance; and one foliation for each maximum whose bounds enclose `min_significance`, and for
each pole if significances are asked for.
*/
template <class TriangleMesh,
          class VertexOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
VertexOutputIterator detect_feature_poles(
  const TriangleMesh& mesh,
  VertexOutputIterator out,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  internal::check_parameters<
    CGAL::internal_np::vertex_point_t, internal_np::pole_detector_t, internal_np::number_of_poles_t,
    internal_np::persistence_t, internal_np::min_significance_t,
    internal_np::significance_output_iterator_t, internal_np::diffusion_time_t,
    internal_np::number_of_eigenpairs_t, internal_np::number_of_samples_t,
    internal_np::decimation_threshold_t, CGAL::internal_np::visitor_t>(np);
  const auto detector =
    choose_parameter(get_parameter(np, internal_np::pole_detector), Average_geodesic_distance());
  internal::Feature_pole_options options = internal::feature_pole_options(np, detector);
  const auto checked = internal::Checked_mesh<TriangleMesh>::without_halfedges(mesh, np);
  auto visitor =
    choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_foliation_visitor());
  auto significances = choose_parameter(
    get_parameter(np, internal_np::significance_output_iterator), CGAL::Emptyset_iterator());
  options.tells_significance = !std::is_same_v<decltype(significances), CGAL::Emptyset_iterator>;
  for (const auto& pole : internal::feature_poles(checked, options, detector,
                                                  internal::poll_of(internal::unwrapped(visitor))))
  {
    *out++ = checked.index.vertex(pole.vertex);
    *significances++ = pole.significance;
  }
  return out;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_FEATURE_POLES_H
