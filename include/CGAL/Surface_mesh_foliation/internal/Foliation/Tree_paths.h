// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TREE_PATHS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TREE_PATHS_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Letter.h>

#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// For every edge of the mesh, the path in the tree T between the images of its endpoints, as the
// word of half-arcs that it passes along the forward halfedge. The word is empty iff both ends lie
// in one cell of T. Words are reduced: no letter equals the next.
//
// Nearly all words have at most two letters and are stored in an array; the others, of any length,
// are in a table. Letters, words and frames: see the glossary in ARCHITECTURE.md.
class Tree_paths
{
public:
  explicit Tree_paths(int number_of_edges = 0) : m_short(number_of_edges) {}

  int size(int e) const { return m_short[e].size; }
  bool is_empty(int e) const { return m_short[e].size == 0; }

  Letter operator()(int e, int i) const
  {
    const Short_word& word = m_short[e];
    return word.size <= 2 ? (i == 0 ? word.first : word.second) : m_long.at(e)[i];
  }

  Letter front(int e) const { return (*this)(e, 0); }
  Letter back(int e) const { return (*this)(e, size(e) - 1); }

  void push_front(int e, Letter letter)
  {
    Short_word& word = m_short[e];
    if (word.size < 2)
    {
      word.second = word.first;
      word.first = letter;
    }
    else
    {
      std::vector<Letter>& letters = lengthen(e);
      letters.insert(letters.begin(), letter);
    }
    ++word.size;
  }

  void push_back(int e, Letter letter)
  {
    Short_word& word = m_short[e];
    if (word.size < 2)
      (word.size == 0 ? word.first : word.second) = letter;
    else
      lengthen(e).push_back(letter);
    ++word.size;
  }

  void pop_front(int e)
  {
    Short_word& word = m_short[e];
    if (word.size <= 2)
      word.first = word.second;
    else
    {
      std::vector<Letter>& letters = m_long.at(e);
      letters.erase(letters.begin());
      shorten(e);
    }
    --word.size;
  }

  void pop_back(int e)
  {
    if (m_short[e].size > 2)
    {
      m_long.at(e).pop_back();
      shorten(e);
    }
    --m_short[e].size;
  }

private:
  struct Short_word
  {
    int size = 0;
    Letter first, second; // the letters of a word that has at most two
  };

  std::vector<Letter>& lengthen(int e)
  {
    const Short_word& word = m_short[e];
    std::vector<Letter>& letters = m_long[e];
    if (letters.empty())
      letters = {word.first, word.second};
    return letters;
  }

  // moves a word that is down to two letters back into the array
  void shorten(int e)
  {
    const auto it = m_long.find(e);
    if (it->second.size() > 2)
      return;
    m_short[e].first = it->second[0];
    m_short[e].second = it->second[1];
    m_long.erase(it);
  }

  std::vector<Short_word> m_short;
  std::unordered_map<int, std::vector<Letter>> m_long;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_TREE_PATHS_H
