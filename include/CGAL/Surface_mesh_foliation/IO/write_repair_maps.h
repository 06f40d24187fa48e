// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REPAIR_MAPS_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REPAIR_MAPS_H

#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>
#include <CGAL/Surface_mesh_foliation/repair.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes what has become of the vertices of a polygon soup that was repaired: for each of them a line
with the number of a vertex of the repaired mesh, or -1 if it is gone.

\param file_name the name of the file
\param repaired what `repair_polygon_soup()` has returned

\throws Invalid_file_exception if the file cannot be written

The time is linear in the number of vertices.
*/
inline void write_repaired_vertices(const std::string& file_name, const Repaired_soup& repaired)
{
  internal::write_file(file_name, [&](std::ostream& output) {
    for (const std::size_t v : repaired.vertices)
      output << (v == Repaired_soup::none ? "-1" : std::to_string(v)) << '\n';
  });
}

/*!
\ingroup PkgSurfaceMeshFoliationIO

writes what has become of the faces of a polygon soup that was repaired: for each of them a line
with the numbers of the faces of the repaired mesh that it was cut into, none if it is gone.

\param file_name the name of the file
\param repaired what `repair_polygon_soup()` has returned

\throws Invalid_file_exception if the file cannot be written

The time is linear in the number of faces.
*/
inline void write_repaired_faces(const std::string& file_name, const Repaired_soup& repaired)
{
  internal::write_file(file_name, [&](std::ostream& output) {
    const std::vector<std::size_t>& first = repaired.first_faces;
    for (std::size_t f = 0; f + 1 < first.size(); ++f)
    {
      for (std::size_t g = first[f]; g < first[f + 1]; ++g)
        output << (g == first[f] ? "" : " ") << g;
      output << '\n';
    }
  });
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_WRITE_REPAIR_MAPS_H
