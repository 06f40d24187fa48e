// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_LIFTS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_LIFTS_H

#include <CGAL/Surface_mesh_foliation/internal/Homotopy/Deck_cocycle.h>

#include <cstdint>
#include <cstdlib>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// The lifts of the loops to the universal cover, numbered as they are met. Letters, words and
// frames: see the glossary in ARCHITECTURE.md.
//
// A loop l is simple and essential, so its centralizer in the deck group is the cyclic group that
// it generates, and the lift g l *is* the group element g l g^-1, its deck translation: two lifts
// of one loop are the same iff their names are equal as group elements. (On a torus without poles
// the group is abelian and conjugation forgets g; there the tree is a line, and a lift is named by
// the integer intersection number of g with l, written as a power of generator 1.)
class Lifts
{
public:
  explicit Lifts(const Deck_cocycle& deck) : m_deck(deck) {}

  // on a torus without poles: the deck translation of its only loop
  void set_torus_loop(const Group_word& translation) { m_torus_loop = exponents(translation); }

  // the number of the lift of loop `arc` with the given name
  int intern(int arc, const Group_word& name)
  {
    if (arc >= static_cast<int>(m_lifts_of_arc.size()))
      m_lifts_of_arc.resize(arc + 1);
    for (int lift : m_lifts_of_arc[arc])
      if (is_torus() ? m_names[lift] == name : m_deck.group().are_equal(m_names[lift], name))
        return lift;
    const int lift = static_cast<int>(m_arcs.size());
    m_arcs.push_back(arc);
    m_names.push_back(name);
    m_lifts_of_arc[arc].push_back(lift);
    return lift;
  }

  int arc(int lift) const { return m_arcs[lift]; }
  const Group_word& name(int lift) const { return m_names[lift]; }

  // the name, in the frame reached by `way`, of the lift whose name at the start is `name`
  Group_word transported(const Group_word& name, const Group_word& way) const
  {
    const Surface_group& group = m_deck.group();
    if (!is_torus())
      return group.product(group.product(inverse(way), name), way);
    const int power = (name.empty() ? 0 : name[0] * static_cast<int>(name.size())) - crossed(way);
    return Group_word(std::abs(power), power > 0 ? 1 : -1);
  }

  // the number of `lift` as seen from the other end of an interned way
  int transport(int lift, int element, bool is_backward)
  {
    if (element == 0)
      return lift;
    const std::uint64_t key =
      ((std::uint64_t(lift) << 32 | std::uint64_t(element)) << 1) | std::uint64_t(is_backward);
    const auto it = m_transported.find(key);
    if (it != m_transported.end())
      return it->second;
    const Group_word& way = m_deck.word(element);
    const int result =
      intern(m_arcs[lift], transported(m_names[lift], is_backward ? inverse(way) : way));
    m_transported.emplace(key, result);
    return result;
  }

private:
  bool is_torus() const { return m_deck.group().is_abelian(); }

  static std::pair<int, int> exponents(const Group_word& word)
  {
    std::pair<int, int> result(0, 0);
    for (int letter : word)
      (std::abs(letter) == 1 ? result.first : result.second) += letter > 0 ? 1 : -1;
    return result;
  }

  // how often `way` crosses the loop of the torus, counted with sign
  int crossed(const Group_word& way) const
  {
    const auto [x, y] = exponents(way);
    return x * m_torus_loop.second - y * m_torus_loop.first;
  }

  const Deck_cocycle& m_deck;
  std::pair<int, int> m_torus_loop{0, 0};
  std::vector<int> m_arcs;                      // by lift
  std::vector<Group_word> m_names;              // by lift
  std::vector<std::vector<int>> m_lifts_of_arc; // by loop
  std::unordered_map<std::uint64_t, int> m_transported;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_LIFTS_H
