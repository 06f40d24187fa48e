// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_IO_READ_WITH_ASSIMP_H
#define CGAL_SURFACE_MESH_FOLIATION_IO_READ_WITH_ASSIMP_H

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cstddef>
#include <string>
#include <vector>

/// \file
/// This header needs the library Assimp, and is not included by `Surface_mesh_foliation.h`.

namespace CGAL {
namespace Surface_mesh_foliation {

/*!
\ingroup PkgSurfaceMeshFoliationIO

reads the vertices and faces of a polygon mesh from a file with the library Assimp, which knows
glTF (`.gltf`, `.glb`) and many other formats.

All meshes of the scene are one mesh, placed as the scene places them, one after the other. Points
and lines are skipped. Coordinates have the precision of `float`. Many of these formats give
vertices several normals or texture coordinates by making copies of them; `repair_polygon_soup()`
joins them.

\param file_name the name of the file

\returns the vertices and faces

\throws Invalid_file_exception if Assimp cannot read the file

\sa `read_polygon_soup()`
*/
inline Polygon_soup read_polygon_soup_with_assimp(const std::string& file_name)
{
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(file_name, aiProcess_PreTransformVertices);
  if (scene == nullptr || (scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0)
  {
    std::string reason = importer.GetErrorString();
    for (char& c : reason)
      c = c == '\n' ? ' ' : c;
    internal::throw_file_problem(file_name, ": Assimp cannot read it: ", reason);
  }
  Polygon_soup result;
  for (unsigned int m = 0; m < scene->mNumMeshes; ++m)
  {
    const aiMesh& mesh = *scene->mMeshes[m];
    const std::size_t first = result.points.size();
    for (unsigned int v = 0; v < mesh.mNumVertices; ++v)
      result.points.push_back({mesh.mVertices[v].x, mesh.mVertices[v].y, mesh.mVertices[v].z});
    for (unsigned int f = 0; f < mesh.mNumFaces; ++f)
    {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices < 3)
        continue;
      result.polygons.emplace_back();
      for (unsigned int i = 0; i < face.mNumIndices; ++i)
        result.polygons.back().push_back(first + face.mIndices[i]);
    }
  }
  return result;
}

} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_IO_READ_WITH_ASSIMP_H
