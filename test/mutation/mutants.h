// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_MUTATION_MUTANTS_H
#define SMF_MUTATION_MUTANTS_H

#include <cstdlib>

// What weave.py puts in the place of operators, numbers, conditions and statements. Each does what
// stood there, unless the mutant that the environment variable SMF_MUTANT names is its own: an
// operator has one or two mutants, `id` and `id + 1`.

namespace smf_mutation {

inline int number_from_environment()
{
  const char* text = std::getenv("SMF_MUTANT");
  return text != nullptr ? std::atoi(text) : 0;
}

inline const int active = number_from_environment(); // 0: none

inline bool is_active(int id)
{
  return id == active;
}

// whether a statement stays
inline bool keep(int id)
{
  return !is_active(id);
}

template <class Condition>
bool flip(int id, const Condition& condition)
{
  return static_cast<bool>(condition) != is_active(id);
}

template <class Number>
Number whole(int id, Number number)
{
  return is_active(id) ? number + 1 : is_active(id + 1) ? number - 1 : number;
}

template <class Number>
Number real(int id, Number number)
{
  return is_active(id) ? number + 1 : is_active(id + 1) ? 0 : number;
}

template <class Number>
auto minus(int id, Number number)
{
  return is_active(id) ? +number : -number;
}

#define SMF_MUTATION_RELATION(name, op, mutant, negated)                          \
  template <class A, class B>                                                     \
  bool name(int id, const A& a, const B& b)                                       \
  {                                                                               \
    return is_active(id) ? a mutant b : is_active(id + 1) ? a negated b : a op b; \
  }

#define SMF_MUTATION_BINARY(name, op, mutant)   \
  template <class A, class B>                   \
  auto name(int id, const A& a, const B& b)     \
  {                                             \
    return is_active(id) ? a mutant b : a op b; \
  }

#define SMF_MUTATION_ASSIGNMENT(name, op, mutant) \
  template <class A, class B>                     \
  A& name(int id, A& a, const B& b)               \
  {                                               \
    return is_active(id) ? a mutant b : a op b;   \
  }

#define SMF_MUTATION_STEP(name, before, after, mutant_before, mutant_after) \
  template <class A>                                                        \
  decltype(auto) name(int id, A& a)                                         \
  {                                                                         \
    return is_active(id) ? mutant_before a mutant_after : before a after;   \
  }

SMF_MUTATION_RELATION(less, <, <=, >=)
SMF_MUTATION_RELATION(less_equal, <=, <, >)
SMF_MUTATION_RELATION(greater, >, >=, <=)
SMF_MUTATION_RELATION(greater_equal, >=, >, <)
SMF_MUTATION_BINARY(equal, ==, !=)
SMF_MUTATION_BINARY(not_equal, !=, ==)
SMF_MUTATION_BINARY(plus, +, -)
SMF_MUTATION_BINARY(difference, -, +)
SMF_MUTATION_BINARY(times, *, /)
SMF_MUTATION_BINARY(divided_by, /, *)
SMF_MUTATION_BINARY(modulo, %, *)
SMF_MUTATION_ASSIGNMENT(add, +=, -=)
SMF_MUTATION_ASSIGNMENT(subtract, -=, +=)
SMF_MUTATION_ASSIGNMENT(multiply_by, *=, /=)
SMF_MUTATION_ASSIGNMENT(divide_by, /=, *=)
SMF_MUTATION_STEP(next, ++, , --, )
SMF_MUTATION_STEP(previous, --, , ++, )
SMF_MUTATION_STEP(next_after, , ++, , --)
SMF_MUTATION_STEP(previous_after, , --, , ++)

#undef SMF_MUTATION_RELATION
#undef SMF_MUTATION_BINARY
#undef SMF_MUTATION_ASSIGNMENT
#undef SMF_MUTATION_STEP

} // namespace smf_mutation

#endif // SMF_MUTATION_MUTANTS_H
