// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_CHECK_PARAMETERS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_CHECK_PARAMETERS_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

namespace CGAL {
namespace Surface_mesh_foliation {

namespace internal {

// The parameters that a function knows, by their tags. A function has one list, against which it
// checks its parameters and by which it selects those that it passes on.
template <class... Tags>
struct Parameter_list
{};

template <class... Tags, class... Others>
Parameter_list<Tags..., Others...> operator+(Parameter_list<Tags...>, Parameter_list<Others...>);

template <class Tag>
struct As_parameter_list
{
  using type = Parameter_list<Tag>;
};
template <class... Tags>
struct As_parameter_list<Parameter_list<Tags...>>
{
  using type = Parameter_list<Tags...>;
};

// one list of tags and lists
template <class... Parts>
using Joined_parameters =
  decltype((Parameter_list<>() + ... + typename As_parameter_list<Parts>::type()));

// Whether every parameter of the sequence has one of the given tags.
template <class NamedParameters, class... Tags>
struct Are_parameters_known;

template <class... Tags>
struct Are_parameters_known<CGAL::internal_np::No_property, Tags...> : std::true_type
{};

template <class T, class Tag, class Base, class... Tags>
struct Are_parameters_known<CGAL::Named_function_parameters<T, Tag, Base>, Tags...>
  : std::bool_constant<(std::is_same_v<Tag, CGAL::internal_np::all_default_t> || ... ||
                        std::is_same_v<Tag, Tags>)&&Are_parameters_known<Base, Tags...>::value>
{};

template <class T, class Tag, class Base, class... Tags>
struct Are_parameters_known<Named_parameters<T, Tag, Base>, Tags...>
  : Are_parameters_known<CGAL::Named_function_parameters<T, Tag, Base>, Tags...>
{};

template <class NamedParameters, class... Tags>
constexpr bool are_parameters_known(Parameter_list<Tags...>)
{
  return Are_parameters_known<NamedParameters, Tags...>::value;
}

// The parameters of a sequence that have one of the given tags, as a sequence. It ends with CGAL's
// default, a parameter that every function knows.
template <class List>
struct Selection;

template <class... Tags>
struct Selection<Parameter_list<Tags...>>
{
  template <class T, class Tag, class Base>
  static auto of(const CGAL::Named_function_parameters<T, Tag, Base>& np)
  {
    const auto rest = of_rest<Base>(np);
    if constexpr ((std::is_same_v<Tag, Tags> || ...))
      return CGAL::Named_function_parameters<T, Tag, std::decay_t<decltype(rest)>>(np.v, rest);
    else
      return rest;
  }

private:
  template <class Base, class NamedParameters>
  static auto of_rest(const NamedParameters& np)
  {
    if constexpr (std::is_same_v<Base, CGAL::internal_np::No_property>)
      return CGAL::parameters::default_values();
    else
      return of(static_cast<const Base&>(np));
  }
};

// `Parts` are tags and lists of them
template <class... Parts, class NamedParameters>
auto select(const NamedParameters& np)
{
  return Selection<Joined_parameters<Parts...>>::of(sequence(np));
}

// Misspelled and misplaced parameters are worse than none, so they are errors. `Parts` are tags and
// lists of them.
template <class... Parts, class NamedParameters>
constexpr void check_parameters(const NamedParameters&)
{
  static_assert(
    are_parameters_known<NamedParameters>(Joined_parameters<Parts...>()),
    "this function of Surface_mesh_foliation does not know one of the named parameters");
}

} // namespace internal

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_CHECK_PARAMETERS_H
