// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Cyclic sequences do what vectors do, however often they are changed, cut and joined.

#include <CGAL/Surface_mesh_foliation/internal/Scalar_reeb_graph/Cyclic_sequences.h>

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_cyclic_sequences {

using namespace smf_test;
using namespace CGAL::Surface_mesh_foliation::internal;

namespace {

using Ints = std::vector<int>;

// Cyclic sequences as vectors, which are open where those are. Each operation is done with both.
class Sequences_and_vectors
{
public:
  explicit Sequences_and_vectors(std::uint64_t seed) : m_random(seed) {}

  void do_random_operation()
  {
    const std::size_t choice = m_vectors.empty() ? 0 : m_random.index(9);
    if (choice == 0)
      make();
    else if (choice <= 3)
      insert_after();
    else if (choice == 4)
      erase();
    else if (choice == 5)
      cut_at();
    else if (choice == 6)
      split_at();
    else if (choice == 7)
      join();
    else
      set_label();
  }

  // Only of a copy, so that trees keep shapes that no check has tidied up.
  void check() const
  {
    Cyclic_sequences sequences = m_sequences;
    for (std::size_t k = 0; k < m_vectors.size(); ++k)
    {
      const Labeled& v = m_vectors[k];
      for (int x : v.items)
        EXPECT_EQ(v.past.count(sequences.former_label(x)), 1u);
      for (int x : v.items)
      {
        EXPECT_EQ(sequences.label(x), v.label);
        EXPECT_EQ(sequences.is_alone(x), v.items.size() == 1);
        EXPECT_TRUE(sequences.are_in_one_sequence(x, v.items.front()));
        EXPECT_TRUE(k == 0 || !sequences.are_in_one_sequence(x, m_vectors[k - 1].items.back()));
      }
      check_order(sequences, v.items);
    }
  }

  std::size_t longest() const { return m_longest; }

private:
  struct Labeled
  {
    Ints items;
    int label;
    std::set<int> past; // labels, also of what has been joined
  };

  static void check_order(Cyclic_sequences& sequences, const Ints& items)
  {
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const bool is_last = i + 1 == items.size();
      EXPECT_TRUE(is_last || sequences.are_in_one_sequence(items[i], items[i + 1]));
      const auto [before, behind] = sequences.split_at(items[i]);
      EXPECT_EQ(before, Cyclic_sequences::none);
      EXPECT_EQ(behind == Cyclic_sequences::none, is_last);
    }
  }

  std::size_t random_vector() { return m_random.index(m_vectors.size()); }

  // adds a vector if there are items, which are those of the root
  void add(Ints items, int root, std::set<int> past)
  {
    ASSERT_EQ(root == Cyclic_sequences::none, items.empty());
    if (items.empty())
      return;
    m_sequences.set_label(root, ++m_label);
    past.insert(m_label);
    m_longest = std::max(m_longest, items.size());
    m_vectors.push_back({std::move(items), m_label, std::move(past)});
  }

  Labeled take(std::size_t k)
  {
    Labeled result = std::move(m_vectors[k]);
    m_vectors.erase(m_vectors.begin() + static_cast<std::ptrdiff_t>(k));
    return result;
  }

  // an item is new, and those that were freed are used first
  void count_item(int x)
  {
    for (const Labeled& v : m_vectors)
      EXPECT_EQ(std::count(v.items.begin(), v.items.end(), x), 0);
    m_largest_number_of_items = std::max(m_largest_number_of_items, ++m_number_of_items);
    EXPECT_LT(x, m_largest_number_of_items);
  }

  void make()
  {
    const int x = m_sequences.make(++m_label);
    count_item(x);
    m_vectors.push_back({{x}, m_label, {m_label}});
  }

  void insert_after()
  {
    Labeled& v = m_vectors[random_vector()];
    const std::size_t i = m_random.index(v.items.size());
    const int y = m_sequences.insert_after(v.items[i]);
    count_item(y);
    v.items.insert(v.items.begin() + static_cast<std::ptrdiff_t>(i) + 1, y);
    m_longest = std::max(m_longest, v.items.size());
  }

  // those behind the i-th item, and those before it
  static Ints others(const Ints& items, std::size_t i)
  {
    const auto x = items.begin() + static_cast<std::ptrdiff_t>(i);
    Ints result(x + 1, items.end());
    result.insert(result.end(), items.begin(), x);
    return result;
  }

  void erase()
  {
    const std::size_t k = random_vector();
    Labeled& v = m_vectors[k];
    const std::size_t i = m_random.index(v.items.size());
    m_sequences.erase(v.items[i]);
    --m_number_of_items;
    v.items = others(v.items, i);
    if (v.items.empty())
      take(k);
  }

  void cut_at()
  {
    const Labeled v = take(random_vector());
    const std::size_t i = m_random.index(v.items.size());
    const int x = v.items[i];
    add(others(v.items, i), m_sequences.cut_at(x), v.past);
    if (m_random.index(2) == 0)
      m_vectors.push_back({{x}, v.label, v.past}); // keeps its label
    else
    {
      m_sequences.free(x);
      --m_number_of_items;
    }
  }

  void split_at()
  {
    const Labeled v = take(random_vector());
    const std::size_t i = m_random.index(v.items.size());
    const auto x = v.items.begin() + static_cast<std::ptrdiff_t>(i);
    const auto [before, behind] = m_sequences.split_at(*x);
    add(Ints(v.items.begin(), x), before, v.past);
    m_vectors.push_back({{*x}, v.label, v.past});
    add(Ints(x + 1, v.items.end()), behind, v.past);
  }

  // joins up to four sequences, and labels only the last result
  void join()
  {
    int root = Cyclic_sequences::none;
    Ints items;
    std::set<int> past;
    const std::size_t number = std::min(m_vectors.size(), 1 + m_random.index(4));
    for (std::size_t i = 0; i < number; ++i)
    {
      const Labeled v = take(random_vector());
      const int x = v.items[m_random.index(v.items.size())];
      EXPECT_EQ(m_sequences.label(x), v.label);
      root = m_sequences.join(root, x); // x is a root now
      root = m_sequences.join(root, Cyclic_sequences::none);
      items.insert(items.end(), v.items.begin(), v.items.end());
      past.insert(v.past.begin(), v.past.end());
    }
    add(std::move(items), root, std::move(past));
  }

  void set_label()
  {
    Labeled& v = m_vectors[random_vector()];
    v.label = ++m_label;
    v.past.insert(m_label);
    m_sequences.set_label(v.items[m_random.index(v.items.size())], m_label);
  }

  Random m_random;
  Cyclic_sequences m_sequences;
  std::vector<Labeled> m_vectors;
  int m_label = 0, m_number_of_items = 0, m_largest_number_of_items = 0;
  std::size_t m_longest = 0;
};

TEST(Cyclic_sequences, are_like_vectors)
{
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 100 && !HasFailure(); ++seed)
  {
    Sequences_and_vectors both(seed);
    for (int step = 0; step < 200 && !HasFailure(); ++step)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      both.do_random_operation();
      both.check();
    }
    longest = std::max(longest, both.longest());
  }
  EXPECT_GT(longest, 30u) << "the test has the cases that it is meant to have";
}

TEST(Cyclic_sequences, of_one_item)
{
  Cyclic_sequences s;
  const int x = s.make(5);
  EXPECT_TRUE(s.is_alone(x));
  EXPECT_TRUE(s.are_in_one_sequence(x, x));
  EXPECT_EQ(s.cut_at(x), Cyclic_sequences::none);
  EXPECT_EQ(s.split_at(x), std::make_pair(Cyclic_sequences::none, Cyclic_sequences::none));
  EXPECT_EQ(s.join(Cyclic_sequences::none, Cyclic_sequences::none), Cyclic_sequences::none);
  EXPECT_EQ(s.label(x), 5);
  s.erase(x);
  EXPECT_EQ(s.make(6), x) << "it is used again";
  EXPECT_EQ(s.label(x), 6);
}

} // namespace

} // namespace test_cyclic_sequences
