// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Files that are written: complete, or as they were.

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/IO/write_file.h>

#include "include/decimal_comma.h"
#include "include/temporary_folder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <ios>
#include <iterator>
#include <locale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

#if !defined(_WIN32) && !defined(__EMSCRIPTEN__)
#define SMF_HAS_POSIX
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#endif

namespace test_write_file {

using CGAL::Surface_mesh_foliation::internal::write_file;
namespace SMF = CGAL::Surface_mesh_foliation;
namespace fs = std::filesystem;

namespace {

class Write_file : public ::testing::Test
{
protected:
  // a file with something in it
  std::string old_file(const std::string& name) const { return folder.write(name, "old"); }

  std::size_t number_of_files() const
  {
    const fs::directory_iterator all(fs::path(folder.file_name("x")).parent_path());
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }

  static void write_new(std::ostream& output) { output << "new"; }

  smf_test::Temporary_folder folder;
};

// the message of a file that cannot be written
template <class Write>
std::string refusal(const std::string& file_name, const Write& write)
{
  try
  {
    write_file(file_name, write);
  }
  catch (const SMF::Invalid_file_exception& exception)
  {
    return exception.what();
  }
  ADD_FAILURE() << file_name << " is written";
  return "";
}

} // namespace

TEST_F(Write_file, writes_in_the_classic_locale_and_reports_failures)
{
  const std::locale before =
    std::locale::global(std::locale(std::locale::classic(), new smf_test::Decimal_comma));
  const std::string file_name = folder.file_name("f");
  write_file(file_name, [](std::ostream& output) { output << 1234.5 << "\r\n"; });
  std::locale::global(before);
  EXPECT_EQ(smf_test::file_text(file_name), "1234.5\r\n");
  write_file(file_name, [](std::ostream&) {}); // what was there is gone
  EXPECT_EQ(smf_test::file_text(file_name), "");

  const auto fail = [](std::ostream& output) { output.setstate(std::ios::badbit); };
  EXPECT_THROW(write_file(file_name, fail), SMF::Invalid_file_exception);
  const std::string missing = folder.file_name("none") + "/f";
  EXPECT_THROW(write_file(missing, [](std::ostream&) { FAIL() << "was called"; }),
               SMF::Invalid_file_exception);
}

TEST_F(Write_file, what_fails_leaves_the_file_as_it_was)
{
  const std::string file = old_file("f"), none = folder.file_name("none");
  const auto fail = [](std::ostream& output) {
    output << "new";
    output.setstate(std::ios::badbit);
  };
  const auto throw_in_the_middle = [](std::ostream& output) {
    output << "new" << std::flush;
    throw std::out_of_range("a property map of the user");
  };
  for (const std::string& name : {file, none})
  {
    EXPECT_THROW(write_file(name, fail), SMF::Invalid_file_exception);
    EXPECT_THROW(write_file(name, throw_in_the_middle), std::out_of_range);
  }
  EXPECT_EQ(smf_test::file_text(file), "old");
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Write_file, nobody_sees_half_a_file)
{
  const std::string file = old_file("f");
  write_file(file, [&](std::ostream& output) {
    output << "new" << std::flush;
    EXPECT_EQ(smf_test::file_text(file), "old");
  });
  EXPECT_EQ(smf_test::file_text(file), "new");
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Write_file, takes_any_name)
{
  for (const std::string name : {" a  b ", "\xC3\xA9l\xC3\xA9phant \xE8\xB1\xA1.ply",
                                 "two\nlines\t", "-x", "'\"$HOME\\", ".hidden"})
  {
    const std::string file = folder.file_name(name);
    write_file(file, write_new);
    EXPECT_EQ(smf_test::file_text(file), "new") << name;
  }
  EXPECT_EQ(number_of_files(), 6u);
  const std::string longest = folder.file_name(std::string(255, 'a'));
  write_file(longest, write_new);
  EXPECT_EQ(smf_test::file_text(longest), "new");
}

TEST_F(Write_file, refuses_folders)
{
  fs::create_directory(folder.file_name("d"));
  EXPECT_NE(refusal(folder.file_name("d"), write_new).find("cannot be opened"), std::string::npos);
  EXPECT_EQ(number_of_files(), 1u);
}

TEST_F(Write_file, whose_folder_vanishes)
{
  fs::create_directory(folder.file_name("d"));
  const std::string message = refusal(folder.file_name("d/f"), [&](std::ostream& output) {
    output << "new";
    fs::remove_all(folder.file_name("d"));
  });
  EXPECT_NE(message.find("cannot be written"), std::string::npos) << message;
  EXPECT_EQ(number_of_files(), 0u);
}

#ifdef SMF_HAS_POSIX

TEST_F(Write_file, keeps_permissions_and_symbolic_links)
{
  const std::string file = old_file("f"), link = folder.file_name("link");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(file, link);
  write_file(link, write_new);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(smf_test::file_text(file), "new");
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const std::string dangling = folder.file_name("dangling"), target = folder.file_name("target");
  fs::create_symlink(target, dangling);
  write_file(dangling, write_new);
  EXPECT_EQ(smf_test::file_text(target), "new");
}

TEST_F(Write_file, writes_to_pipes)
{
  const std::string pipe = folder.file_name("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::string text;
  std::thread reader([&] { text = smf_test::file_text(pipe); });
  write_file(pipe, write_new);
  reader.join();
  EXPECT_EQ(text, "new");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(Write_file, says_that_the_disk_is_full)
{
  if (!fs::exists("/dev/full"))
    GTEST_SKIP() << "there is no /dev/full";
  const std::string message = refusal("/dev/full", write_new);
  EXPECT_NE(message.find("No space left"), std::string::npos) << message;
}

// the same for a file, some of which has been written
TEST_F(Write_file, that_grows_too_large_is_not_there)
{
  const std::string file = old_file("f");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 100000;
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
    refusal(file, [](std::ostream& output) { output << std::string(200000, 'x'); });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("cannot be written: "), std::string::npos) << message;
  EXPECT_EQ(smf_test::file_text(file), "old");
  EXPECT_EQ(number_of_files(), 1u);
}

#endif

} // namespace test_write_file
