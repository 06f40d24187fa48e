// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PYTHON_MEMORY_H
#define SMF_PYTHON_MEMORY_H

namespace smf_python {

// Lets the C library keep memory from one run of the solver to the next, up to 256 MB, instead of
// handing it back to the system and getting it anew, page by page, which takes some 5% of a run. A
// program in C++ mostly has something at the end of its heap that keeps it; Python frees results
// wholly. Whoever sets the thresholds by the environment of the process is not overruled.
void keep_memory();

} // namespace smf_python

#endif // SMF_PYTHON_MEMORY_H
