// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CYCLIC_SEQUENCES_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CYCLIC_SEQUENCES_H

#include <CGAL/assertions.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Cyclic sequences of items that are cut and joined, each with a label. A sequence is cut open
// somewhere and kept in the inorder of a splay tree (Sleator and Tarjan, Self-adjusting binary
// search trees, 1985), so any k operations take O((k + items) log items) time.
//
// Invariant: the root of a tree has the label of the sequence. The label of any other item is one
// that the sequence had at some time, or one of those that it was joined or cut from.
class Cyclic_sequences
{
public:
  static constexpr int none = -1;

  // a new sequence of one item
  int make(int label)
  {
    int x = m_first_free;
    if (x == none)
    {
      x = static_cast<int>(m_items.size());
      m_items.emplace_back();
    }
    else
      m_first_free = m_items[x].parent;
    m_items[x] = {none, none, none, label};
    return x;
  }

  // a label that the sequence of the item, or one that it was joined or cut from, once had; in
  // constant time
  int former_label(int x) const { return m_items[x].label; }

  int label(int x)
  {
    splay(x);
    return m_items[x].label;
  }

  void set_label(int x, int label)
  {
    splay(x);
    m_items[x].label = label;
  }

  bool are_in_one_sequence(int x, int y)
  {
    splay(x);
    splay(y);
    return x == y || m_items[x].parent != none;
  }

  bool is_alone(int x)
  {
    splay(x);
    return m_items[x].left == none && m_items[x].right == none;
  }

  // returns a new item after x
  int insert_after(int x)
  {
    splay(x);
    const int y = make(m_items[x].label);
    attach_right(y, std::exchange(m_items[x].right, none));
    attach_left(y, x);
    return y;
  }

  void erase(int x)
  {
    const int label = this->label(x);
    const int rest = cut_at(x);
    if (rest != none)
      m_items[rest].label = label;
    free(x);
  }

  // Makes x a sequence of its own. Returns the root of the others, from the one after x to the one
  // before x; it has no valid label.
  int cut_at(int x)
  {
    splay(x);
    const int before = detach(std::exchange(m_items[x].left, none));
    const int after = detach(std::exchange(m_items[x].right, none));
    return join(after, before);
  }

  // Cuts the tree that contains x into the items before x, x itself, and those after it, given as
  // roots without valid labels.
  std::pair<int, int> split_at(int x)
  {
    splay(x);
    const int before = detach(std::exchange(m_items[x].left, none));
    const int after = detach(std::exchange(m_items[x].right, none));
    return {before, after};
  }

  // the root of the first tree followed by the second; it has no valid label
  int join(int first, int second)
  {
    if (first == none || second == none)
      return first == none ? second : first;
    CGAL_assertion(m_items[first].parent == none && m_items[second].parent == none);
    int last = first;
    while (m_items[last].right != none)
      last = m_items[last].right;
    splay(last);
    attach_right(last, second);
    return last;
  }

  void free(int x)
  {
    m_items[x].parent = m_first_free;
    m_first_free = x;
  }

private:
  struct Item
  {
    int parent, left, right, label;
  };

  int detach(int x)
  {
    if (x != none)
      m_items[x].parent = none;
    return x;
  }

  void attach_left(int x, int child)
  {
    m_items[x].left = child;
    if (child != none)
      m_items[child].parent = x;
  }

  void attach_right(int x, int child)
  {
    m_items[x].right = child;
    if (child != none)
      m_items[child].parent = x;
  }

  void rotate(int x)
  {
    const int p = m_items[x].parent, g = m_items[p].parent;
    if (m_items[p].left == x)
    {
      attach_left(p, m_items[x].right);
      attach_right(x, p);
    }
    else
    {
      attach_right(p, m_items[x].left);
      attach_left(x, p);
    }
    m_items[x].parent = g;
    if (g == none)
      return;
    (m_items[g].left == p ? m_items[g].left : m_items[g].right) = x;
  }

  // makes x the root of its tree
  void splay(int x)
  {
    int label = m_items[x].label;
    while (m_items[x].parent != none)
    {
      const int p = m_items[x].parent, g = m_items[p].parent;
      label = m_items[g == none ? p : g].label; // finally, that of the root
      if (g != none)
        rotate((m_items[g].left == p) == (m_items[p].left == x) ? p : x);
      rotate(x);
    }
    m_items[x].label = label;
  }

  std::vector<Item> m_items;
  int m_first_free = none; // the others by their parents
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SCALAR_REEB_GRAPH_CYCLIC_SEQUENCES_H
