// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_REFUSED_FILES_H
#define SMF_TEST_REFUSED_FILES_H

#include "generators/meshes.h"

#include <CGAL/Surface_mesh_foliation/IO/read_triangle_mesh.h>

#include <gtest/gtest.h>

#include <string>

namespace smf_test {

// the exception class that belongs to the kind, a message of one line that names the file
inline void expect_refused(const std::string& file_name,
                           CGAL::Surface_mesh_foliation::Problem_kind kind,
                           const std::string& message_part)
{
  namespace SMF = CGAL::Surface_mesh_foliation;
  Mesh mesh;
  try
  {
    SMF::read_triangle_mesh(file_name, mesh);
    ADD_FAILURE() << file_name << " was accepted";
  }
  catch (const SMF::Foliation_exception& exception)
  {
    const std::string message = exception.what();
    EXPECT_EQ(exception.problem().kind, kind) << message;
    EXPECT_EQ(exception.problem().message, message);
    EXPECT_EQ(message.rfind(file_name + ":", 0), 0u) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find(message_part), std::string::npos) << message;
    const bool is_file_exception =
      dynamic_cast<const SMF::Invalid_file_exception*>(&exception) != nullptr;
    EXPECT_EQ(is_file_exception, kind == SMF::Problem_kind::FILE) << message;
    if (kind != SMF::Problem_kind::FILE)
    {
      EXPECT_NE(dynamic_cast<const SMF::Invalid_mesh_exception*>(&exception), nullptr);
    }
  }
  EXPECT_EQ(num_vertices(mesh), 0u);
}

} // namespace smf_test

#endif // SMF_TEST_REFUSED_FILES_H
