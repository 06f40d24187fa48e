// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_SURFACE_GROUP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_SURFACE_GROUP_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A word in generators 1, 2, ... and their inverses -1, -2, ... (Words of letters are something
// else: see the glossary in ARCHITECTURE.md.)
using Group_word = std::vector<int>;

inline Group_word inverse(const Group_word& word)
{
  Group_word result(word.rbegin(), word.rend());
  for (int& letter : result)
    letter = -letter;
  return result;
}

// appends `factor` to `word` and cancels what cancels freely
inline void multiply(Group_word& word, const Group_word& factor)
{
  for (int letter : factor)
    if (!word.empty() && word.back() == -letter)
      word.pop_back();
    else
      word.push_back(letter);
}

inline Group_word cyclically_reduced(const Group_word& word)
{
  std::size_t first = 0, last = word.size();
  for (; last - first >= 2 && word[first] == -word[last - 1]; ++first)
    --last;
  return Group_word(word.begin() + first, word.begin() + last);
}

// The fundamental group of the surface minus its poles. With a pole it is free. Without poles, it
// has one relator of length 4g, in which every generator occurs once with each sign; for g >= 2 two
// different places of the relator share subwords of length 1 only (the relator is the star of a
// vertex of degree 4g in a map with one vertex and one face, where a longer one would mean a vertex
// of degree 2), so small cancellation C'(1/6) holds and Dehn's algorithm decides exactly which
// words are trivial. For g = 1 the group is abelian.
class Surface_group
{
public:
  Surface_group() = default;

  // the free group of the given rank
  explicit Surface_group(int rank) : m_rank(rank) {}

  // the group of a closed surface
  Surface_group(int rank, const Group_word& relator) : m_rank(rank)
  {
    const Group_word r = cyclically_reduced(relator);
    CGAL_assertion(static_cast<int>(r.size()) == 2 * rank);
    m_is_abelian = rank == 2;
    m_half_relator = r.size() / 2;
    const Group_word inverted = inverse(r);
    m_successor[0].assign(2 * rank + 1, 0);
    m_successor[1].assign(2 * rank + 1, 0);
    for (std::size_t i = 0; i < r.size(); ++i)
    {
      m_successor[0][r[i] + rank] = r[(i + 1) % r.size()];
      m_successor[1][inverted[i] + rank] = inverted[(i + 1) % r.size()];
    }
  }

  int rank() const { return m_rank; }
  bool is_free() const { return m_half_relator == 0; }
  bool is_abelian() const { return m_is_abelian; }

  // The product of two reduced words, reduced. In the free and in the abelian case a reduced word
  // is a normal form.
  Group_word product(Group_word a, const Group_word& b) const
  {
    multiply(a, b);
    if (m_is_abelian)
      sort(a);
    else if (!is_free())
      while (shorten(a))
      {}
    return a;
  }

  bool are_equal(const Group_word& a, const Group_word& b) const
  {
    return a == b || (!is_free() && product(inverse(a), b).empty());
  }

private:
  static void sort(Group_word& word)
  {
    std::array<int, 3> exponent = {0, 0, 0};
    for (int letter : word)
      exponent[std::abs(letter)] += letter > 0 ? 1 : -1;
    word.clear();
    for (int x : {1, 2})
      word.insert(word.end(), std::abs(exponent[x]), exponent[x] > 0 ? x : -x);
  }

  // One step of Dehn's algorithm: replaces a subword that is more than half of the relator by the
  // inverse of the rest, which is shorter.
  bool shorten(Group_word& word) const
  {
    for (const std::vector<int>& successor : m_successor)
      for (std::size_t first = 0; first < word.size();)
      {
        std::size_t last = first + 1;
        while (last < word.size() && last - first < 2 * m_half_relator &&
               word[last] == successor[word[last - 1] + m_rank])
          ++last;
        if (last - first > m_half_relator)
        {
          replace_by_rest(word, first, last, successor);
          return true;
        }
        first = last;
      }
    return false;
  }

  void replace_by_rest(Group_word& word,
                       std::size_t first,
                       std::size_t last,
                       const std::vector<int>& successor) const
  {
    Group_word rest;
    for (int letter = word[last - 1]; rest.size() < 2 * m_half_relator - (last - first);)
      rest.push_back(letter = successor[letter + m_rank]);
    Group_word result(word.begin(), word.begin() + first);
    multiply(result, inverse(rest));
    multiply(result, Group_word(word.begin() + last, word.end()));
    word = std::move(result);
  }

  int m_rank = 0;
  bool m_is_abelian = false;
  std::size_t m_half_relator = 0;
  std::array<std::vector<int>, 2>
    m_successor; // in the relator and in its inverse, by letter + rank
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_HOMOTOPY_SURFACE_GROUP_H
