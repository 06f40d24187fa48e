// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_BENCHMARK_PEAK_MEMORY_H
#define SMF_BENCHMARK_PEAK_MEMORY_H

// The memory of the process, in Linux with glibc.

#include <malloc.h>

#include <fstream>
#include <string>

namespace smf_benchmark {

// Whether memory that is freed stays with the process, ready for the next to ask. If not, what is
// free now is given back to the system.
inline void keep_freed_memory(bool is_kept)
{
  constexpr int much = 1 << 30, usual = 128 * 1024;
  mallopt(M_MMAP_THRESHOLD, is_kept ? much : usual);
  mallopt(M_TRIM_THRESHOLD, is_kept ? much : usual);
  mallopt(M_TOP_PAD, is_kept ? much / 16 : usual);
  if (!is_kept)
    malloc_trim(0);
}

// Forgets the largest size of the process so far. Freed memory is not kept.
inline void reset_peak_memory()
{
  keep_freed_memory(false);
  std::ofstream("/proc/self/clear_refs") << 5;
}

inline double peak_megabytes()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:")
    {
      double kilobytes = 0;
      status >> kilobytes;
      return kilobytes / 1024;
    }
  return 0;
}

template <class Run>
double peak_megabytes_of(const Run& run)
{
  reset_peak_memory();
  run();
  return peak_megabytes();
}

} // namespace smf_benchmark

#endif // SMF_BENCHMARK_PEAK_MEMORY_H
