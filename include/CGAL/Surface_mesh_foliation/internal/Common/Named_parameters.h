// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_NAMED_PARAMETERS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

// The named parameters of the package, each by its name. This is the only list: the tags, the
// functions in `parameters` and the member functions of `Named_parameters` are generated from it. A
// new parameter is one more line.
#define CGAL_SURFACE_MESH_FOLIATION_OWN_PARAMETERS(PARAMETER) \
  PARAMETER(weights)                                          \
  PARAMETER(allow_any_weights)                                \
  PARAMETER(allow_openings)                                   \
  PARAMETER(allow_parts)                                      \
  PARAMETER(tolerance)                                        \
  PARAMETER(number_of_samples)                                \
  PARAMETER(use_uniform_levels)                               \
  PARAMETER(max_chord_deviation)                              \
  PARAMETER(number_of_smoothing_steps)                        \
  PARAMETER(use_pole_labels)                                  \
  PARAMETER(over_relaxation)                                  \
  PARAMETER(use_literal_moves)                                \
  PARAMETER(stage_critical_moves)                             \
  PARAMETER(spread_by_rings)                                  \
  PARAMETER(edge_value_map)                                   \
  PARAMETER(node_map)                                         \
  PARAMETER(arc_map)                                          \
  PARAMETER(face_component_map)                               \
  PARAMETER(surface_point_map)                                \
  PARAMETER(persistence)                                      \
  PARAMETER(min_significance)                                 \
  PARAMETER(significance_output_iterator)                     \
  PARAMETER(unfold_saddles)                                   \
  PARAMETER(vertex_to_arc_map)                                \
  PARAMETER(pole_detector)                                    \
  PARAMETER(number_of_poles)                                  \
  PARAMETER(diffusion_time)                                   \
  PARAMETER(number_of_eigenpairs)                             \
  PARAMETER(decimation_threshold)                             \
  PARAMETER(blade_width)                                      \
  PARAMETER(blade_flatness)                                   \
  PARAMETER(least_line_length)                                \
  PARAMETER(vertex_scalar_map)                                \
  PARAMETER(use_poles_as_punctures)                           \
  PARAMETER(min_loop_length)                                  \
  PARAMETER(min_relative_loop_length)                         \
  PARAMETER(min_modulus)                                      \
  PARAMETER(show_handles)                                     \
  PARAMETER(number_of_proxy_vertices)                         \
  PARAMETER(canonical_loop_output_iterator)                   \
  PARAMETER(max_leaf_length)                                  \
  PARAMETER(max_opening_length)                               \
  PARAMETER(filled_face_map)                                  \
  PARAMETER(numbered_vertices)                                \
  PARAMETER(number_of_parts)

// The parameters of CGAL that functions of the package take, each by its name and its tag there.
#define CGAL_SURFACE_MESH_FOLIATION_CGAL_PARAMETERS(PARAMETER) \
  PARAMETER(vertex_point_map, vertex_point_t)                  \
  PARAMETER(edge_is_constrained_map, edge_is_constrained_t)    \
  PARAMETER(number_of_iterations, number_of_iterations_t)      \
  PARAMETER(sparse_linear_solver, sparse_linear_solver_t)      \
  PARAMETER(visitor, visitor_t)

namespace CGAL {
namespace Surface_mesh_foliation {

// the tags of the named parameters of the package
namespace internal_np {

#define CGAL_SURFACE_MESH_FOLIATION_TAG(NAME) enum NAME##_t{NAME};
CGAL_SURFACE_MESH_FOLIATION_OWN_PARAMETERS(CGAL_SURFACE_MESH_FOLIATION_TAG)
#undef CGAL_SURFACE_MESH_FOLIATION_TAG

} // namespace internal_np

/*!
\ingroup PkgSurfaceMeshFoliationParameters
\smfHeader{Common/Named_parameters.h,named_parameters.h}

is a sequence of named parameters that can be continued: it has a member function for each parameter
of this package, and for those of \cgal that functions of this package take, which returns the
sequence with that parameter added. Of two parameters with the same name, the later one counts.

The functions in `parameters` create sequences. A sequence of this class is also one of \cgal's, so
\cgal's functions accept it.

\tparam T the type of the value of the last parameter
\tparam Tag the tag of the last parameter
\tparam Base the \cgal sequence that precedes it
*/
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
class Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base>
{
public:
  /// the sequence as one of \cgal's
  using Sequence = CGAL::Named_function_parameters<T, Tag, Base>;

#ifndef DOXYGEN_RUNNING
  using Sequence::Sequence;
  explicit Named_parameters(const Sequence& sequence) : Sequence(sequence) {}

  // (The result derives from `Sequence`, not from this class, whose member functions it would
  // inherit: those would continue from the middle.)
#define CGAL_SURFACE_MESH_FOLIATION_CONTINUATION(NAME, TAG)             \
  template <class Value>                                                \
  Named_parameters<Value, TAG, Sequence> NAME(const Value& value) const \
  {                                                                     \
    return Named_parameters<Value, TAG, Sequence>(value, *this);        \
  }
#define CGAL_SURFACE_MESH_FOLIATION_OWN(NAME) \
  CGAL_SURFACE_MESH_FOLIATION_CONTINUATION(NAME, internal_np::NAME##_t)
#define CGAL_SURFACE_MESH_FOLIATION_CGALS(NAME, TAG) \
  CGAL_SURFACE_MESH_FOLIATION_CONTINUATION(NAME, CGAL::internal_np::TAG)
  CGAL_SURFACE_MESH_FOLIATION_OWN_PARAMETERS(CGAL_SURFACE_MESH_FOLIATION_OWN)
  CGAL_SURFACE_MESH_FOLIATION_CGAL_PARAMETERS(CGAL_SURFACE_MESH_FOLIATION_CGALS)
#undef CGAL_SURFACE_MESH_FOLIATION_CGALS
#undef CGAL_SURFACE_MESH_FOLIATION_OWN
#undef CGAL_SURFACE_MESH_FOLIATION_CONTINUATION
#endif
};

namespace internal {

// a sequence as one of CGAL's
template <class T, class Tag, class Base>
const CGAL::Named_function_parameters<T, Tag, Base>& sequence(
  const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return np;
}
template <class T, class Tag, class Base>
const CGAL::Named_function_parameters<T, Tag, Base>& sequence(
  const Named_parameters<T, Tag, Base>& np)
{
  return np;
}

// a sequence as one that can be continued
template <class T, class Tag, class Base>
Named_parameters<T, Tag, Base> continuable(const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  return Named_parameters<T, Tag, Base>(np);
}

// the parameters of `first` followed by those of `np`
template <class First, class T, class Tag, class Base>
auto joined(const First& first, const CGAL::Named_function_parameters<T, Tag, Base>& np)
{
  if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>)
    return CGAL::Named_function_parameters<T, Tag, First>(np.v, first);
  else
  {
    const auto rest = joined(first, static_cast<const Base&>(np));
    return CGAL::Named_function_parameters<T, Tag, std::decay_t<decltype(rest)>>(np.v, rest);
  }
}

} // namespace internal

// CGAL's functions of these names deduce the last parameter from the base classes. Compilers
// without the resolution of C++ core issue 2303 find several of these.
template <class T, class Tag, class Base, class Query>
decltype(auto) get_parameter(const Named_parameters<T, Tag, Base>& np, Query query)
{
  return CGAL::parameters::get_parameter(internal::sequence(np), query);
}
template <class T, class Tag, class Base, class Query>
decltype(auto) get_parameter_reference(const Named_parameters<T, Tag, Base>& np, Query query)
{
  return CGAL::parameters::get_parameter_reference(internal::sequence(np), query);
}

/*!
\ingroup PkgSurfaceMeshFoliationParameters

contains the named parameters of this package, a function for each, and those of \cgal that
functions of this package take. They are used like those of \cgal, and chained in any order, as in
`parameters::tolerance(1e-9).vertex_point_map(vpm).number_of_samples(20)`.

A chain that comes from `CGAL::parameters` may also be passed to a function, but it cannot be
continued with parameters of this package: `parameters::combine()` adds those.

A function rejects, at compile time, any named parameter that it does not know.
*/
namespace parameters {

#ifndef DOXYGEN_RUNNING
#define CGAL_SURFACE_MESH_FOLIATION_MAKER(NAME, TAG) \
  template <class T>                                 \
  Named_parameters<T, TAG> NAME(const T& value)      \
  {                                                  \
    return Named_parameters<T, TAG>(value);          \
  }
#define CGAL_SURFACE_MESH_FOLIATION_OWN(NAME) \
  CGAL_SURFACE_MESH_FOLIATION_MAKER(NAME, internal_np::NAME##_t)
#define CGAL_SURFACE_MESH_FOLIATION_CGALS(NAME, TAG) \
  CGAL_SURFACE_MESH_FOLIATION_MAKER(NAME, CGAL::internal_np::TAG)
CGAL_SURFACE_MESH_FOLIATION_OWN_PARAMETERS(CGAL_SURFACE_MESH_FOLIATION_OWN)
CGAL_SURFACE_MESH_FOLIATION_CGAL_PARAMETERS(CGAL_SURFACE_MESH_FOLIATION_CGALS)
#undef CGAL_SURFACE_MESH_FOLIATION_CGALS
#undef CGAL_SURFACE_MESH_FOLIATION_OWN
#undef CGAL_SURFACE_MESH_FOLIATION_MAKER
#endif

/// returns the named parameters `np`, of this package or \cgal's, as a sequence that can be
/// continued.
template <class NamedParameters>
auto combine(const NamedParameters& np)
{
  return internal::continuable(internal::sequence(np));
}

/// returns the named parameters `first`, `second` and `others`, each one parameter or several, of
/// this package or \cgal's, as one sequence in this order.
template <class First, class Second, class... Others>
auto combine(const First& first, const Second& second, const Others&... others)
{
  return combine(internal::joined(internal::sequence(first), internal::sequence(second)),
                 others...);
}

} // namespace parameters

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_NAMED_PARAMETERS_H
