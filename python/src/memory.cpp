// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "memory.h"

#include <cstdlib>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace smf_python {

#ifdef __GLIBC__

namespace {

bool environment_sets_thresholds()
{
  const char* const tunables = std::getenv("GLIBC_TUNABLES");
  return std::getenv("MALLOC_TRIM_THRESHOLD_") || std::getenv("MALLOC_MMAP_THRESHOLD_") ||
         (tunables && std::string(tunables).find("glibc.malloc.") != std::string::npos);
}

} // namespace

void keep_memory()
{
  if (environment_sets_thresholds())
    return;
  // Larger blocks always come from the system; the C library raises its threshold to this value by
  // itself when it sees large blocks, but not once the other one is set.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

#else

void keep_memory() {}

#endif

} // namespace smf_python
