// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_WRITE_FILE_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_WRITE_FILE_H

#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <locale>
#include <ostream>
#include <random>
#include <string>
#include <system_error>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A file that is written under another name and gets its own when it is complete. Whatever happens
// before, the file that had the name is unchanged, and unless the program is killed, nothing else
// is left. What is no regular file, a device or a pipe, is written directly, and so is a file in a
// folder where none can be made.
class Pending_file
{
public:
  explicit Pending_file(const std::string& name) : m_name(name), m_target(target_of(name))
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(m_target, error);
    if (is_regular_file(status) || status.type() == std::filesystem::file_type::not_found)
      open_aside(status);
    if (m_aside.empty())
      open(m_target);
    if (!m_stream)
      refuse("opened");
    m_stream.imbue(std::locale::classic());
    errno = 0;
  }

  ~Pending_file()
  {
    if (m_aside.empty())
      return;
    m_stream.close();
    std::error_code error;
    std::filesystem::remove(m_aside, error);
  }

  Pending_file(const Pending_file&) = delete;
  Pending_file& operator=(const Pending_file&) = delete;

  std::ostream& stream() { return m_stream; }

  // makes sure that everything has arrived, and gives the file its name
  void finish()
  {
    m_stream.close();
    if (!m_stream)
      refuse("written");
    if (m_aside.empty())
      return;
    std::error_code error;
    std::filesystem::rename(m_aside, m_target, error);
    if (error)
      throw_file_problem(m_name, ": cannot be written: " + error.message());
    m_aside.clear();
  }

private:
  using Path = std::filesystem::path;

  // what a symbolic link leads to, if there is something
  static Path target_of(const Path& name)
  {
    std::error_code error;
    const Path target = std::filesystem::canonical(name, error);
    return error ? name : target;
  }

  // The permissions stay those of the file before.
  void open_aside(const std::filesystem::file_status& before)
  {
    std::error_code error;
    if (is_symlink(std::filesystem::symlink_status(m_target, error))) // that leads to nothing
      return;
    const std::string number = std::to_string(std::random_device()());
    const Path aside = m_target.parent_path() / (".smf_" + number + ".part");
    open(aside);
    if (!m_stream)
    {
      m_stream.clear();
      return;
    }
    m_aside = aside;
    if (is_regular_file(before))
      std::filesystem::permissions(m_aside, before.permissions(), error);
  }

  void open(const Path& file)
  {
    errno = 0;
    m_stream.open(file, std::ios::binary);
  }

  [[noreturn]] void refuse(const std::string& what) const
  {
    const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
    throw_file_problem(m_name, ": cannot be " + what + reason);
  }

  std::string m_name;
  Path m_target;
  Path m_aside; // empty if the file is written directly
  std::ofstream m_stream;
};

// Lets `write` write a file; if that fails, there is no file, or the one there was.
template <class Write>
void write_file(const std::string& file_name, const Write& write)
{
  Pending_file file(file_name);
  write(file.stream());
  file.finish();
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_WRITE_FILE_H
