// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_EXECUTOR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_EXECUTOR_H

#include <CGAL/Surface_mesh_foliation/internal/Common/Sum.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#include <algorithm>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Runs loops over the numbers 0, ..., n - 1 block by block, here one block after another. How the
// numbers are divided depends on n alone, so that whatever is computed block by block and combined
// in the order of the blocks is the same, bit for bit, whichever executor runs them.
class Executor
{
public:
  // handles the numbers from `first` to `last` - 1; `block` is the number of their block
  using Body = std::function<void(int block, int first, int last)>;

  static constexpr int default_size = 2048;

  virtual ~Executor() = default;

  virtual void operator()(int n, const Body& body, int size = default_size) const
  {
    for (int block = 0; block < number_of_blocks(n, size); ++block)
      run(n, body, size, block);
  }

  // Runs `main`. A parallel executor also runs `ahead`, alongside it if a thread is free and after
  // it otherwise; this one leaves it to be done on demand. `main` does not depend on `ahead`.
  virtual void run_ahead(const std::function<void()>& /* ahead */,
                         const std::function<void()>& main) const
  {
    main();
  }

  static int number_of_blocks(int n, int size = default_size)
  {
    return n / size + (n % size > 0 ? 1 : 0);
  }

protected:
  static void run(int n, const Body& body, int size, int block)
  {
    const int first = block * size;
    body(block, first, first + (std::min)(size, n - first));
  }
};

#ifdef CGAL_LINKED_WITH_TBB
// While a thread waits, it must not pick up any of the user's own parallel work around this.
class Parallel_executor : public Executor
{
public:
  void operator()(int n, const Body& body, int size = default_size) const override
  {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(0, number_of_blocks(n, size),
                        [&](int block) { run(n, body, size, block); });
    });
  }

  // `main`, which may call a user's visitor, stays in this thread
  void run_ahead(const std::function<void()>& ahead,
                 const std::function<void()>& main) const override
  {
    tbb::this_task_arena::isolate([&] {
      tbb::task_group group;
      group.run(ahead);
      try
      {
        main();
      }
      catch (...)
      {
        give_up(group);
        throw;
      }
      group.wait();
    });
  }

private:
  // What has begun must finish, since it uses data that the caller is about to destroy.
  static void give_up(tbb::task_group& group)
  {
    group.cancel();
    try
    {
      group.wait();
    }
    catch (...)
    {
      // the caller already has an exception
    }
  }
};
#endif

// the executor that a CGAL concurrency tag asks for
template <class ConcurrencyTag>
const Executor& executor_for()
{
  constexpr bool is_parallel = std::is_convertible_v<ConcurrencyTag, CGAL::Parallel_tag>;
#ifdef CGAL_LINKED_WITH_TBB
  static const std::conditional_t<is_parallel, Parallel_executor, Executor> result{};
#else
  static_assert(!is_parallel, "CGAL::Parallel_tag needs TBB: link with CGAL::TBB_support");
  static const Executor result{};
#endif
  return result;
}

// calls body(i) for each i
template <class Body>
void for_each_number(const Executor& executor, int n, const Body& body)
{
  executor(n, [&](int, int first, int last) {
    for (int i = first; i < last; ++i)
      body(i);
  });
}

// the sum of term(i), which loses digits only if terms cancel
template <class Term>
double sum_of_numbers(const Executor& executor, int n, const Term& term)
{
  std::vector<double> sums(Executor::number_of_blocks(n));
  executor(n, [&](int block, int first, int last) {
    Sum sum;
    for (int i = first; i < last; ++i)
      sum.add(term(i));
    sums[block] = sum.value();
  });
  Sum result;
  for (double sum : sums)
    result.add(sum);
  return result.value();
}

// What find(i, list) appends to the list, in the order of i.
template <class T, class Find>
std::vector<T> collected_numbers(const Executor& executor, int n, const Find& find)
{
  std::vector<std::vector<T>> lists(Executor::number_of_blocks(n));
  executor(n, [&](int block, int first, int last) {
    for (int i = first; i < last; ++i)
      find(i, lists[block]);
  });
  std::vector<T> result;
  for (const std::vector<T>& list : lists)
    result.insert(result.end(), list.begin(), list.end());
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_COMMON_EXECUTOR_H
