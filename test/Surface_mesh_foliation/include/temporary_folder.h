// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_TEMPORARY_FOLDER_H
#define SMF_TEST_TEMPORARY_FOLDER_H

#include <filesystem>
#include <fstream>
#include <ios>
#include <random>
#include <sstream>
#include <string>

namespace smf_test {

// what a file holds; nothing if it cannot be read
inline std::string file_text(const std::string& file_name)
{
  std::ostringstream text;
  text << std::ifstream(file_name, std::ios::binary).rdbuf();
  return text.str();
}

// a folder that lives as long as the object
class Temporary_folder
{
public:
  // Tests run at the same time, so that the name must be new; the system's random numbers see to
  // it.
  Temporary_folder()
  {
    std::random_device random;
    do
      m_path = std::filesystem::temp_directory_path() / ("smf_test_" + std::to_string(random()));
    while (!std::filesystem::create_directory(m_path));
  }

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  std::string file_name(const std::string& name) const { return (m_path / name).string(); }

  // writes a file and returns its full name
  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(file_name(name), std::ios::binary) << text;
    return file_name(name);
  }

private:
  std::filesystem::path m_path;
};

} // namespace smf_test

#endif // SMF_TEST_TEMPORARY_FOLDER_H
