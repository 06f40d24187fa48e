// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_soup.h"
#include "targets.h"

#include <CGAL/Surface_mesh_foliation/internal/IO/read_ply.h>

void smf_fuzz::read_ply(const std::uint8_t* data, std::size_t size)
{
  read_soup(data, size, SMF::internal::read_ply<Triangle_collector>,
            SMF::internal::read_ply<Polygon_collector>);
}
