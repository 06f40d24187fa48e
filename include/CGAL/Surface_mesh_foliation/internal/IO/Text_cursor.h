// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_TEXT_CURSOR_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_TEXT_CURSOR_H

#include <CGAL/Surface_mesh_foliation/internal/Common/exceptions.h>
#include <CGAL/Surface_mesh_foliation/internal/Common/problem.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Reads in blocks: the size of a pipe is unknown, and that of a directory is meaningless.
inline std::string read_whole_stream(std::istream& input, const std::string& name)
{
  constexpr std::size_t block_size = std::size_t(1) << 16;
  std::string text;
  std::vector<char> block(block_size);
  while (input)
  {
    input.read(block.data(), static_cast<std::streamsize>(block_size));
    text.append(block.data(), static_cast<std::size_t>(input.gcount()));
  }
  if (input.bad())
    throw_file_problem(name, ": cannot be read");
  return text;
}

inline std::string read_whole_file(const std::string& file_name)
{
  std::ifstream file(file_name, std::ios::binary);
  if (!file)
    throw_file_problem(file_name, std::string(": cannot be opened: ") + std::strerror(errno));
  std::string text = read_whole_stream(file, file_name);
  // libc++ reads nothing from a directory and reports no error
  std::error_code error;
  if (std::filesystem::is_directory(file_name, error))
    throw_file_problem(file_name, ": cannot be read");
  return text;
}

// walks over the nonempty lines of a text, and over the words of each line. Blanks and carriage
// returns separate words; a comment goes from its first character to the end of the line. A line
// that ends with the continuation character, outside a comment, goes on in the next one. Skipped
// are a byte-order mark of UTF-8 at the beginning of the text, and NUL characters at both ends of a
// line, which programs leave behind that are interrupted when they write. The text must outlive the
// cursor.
class Text_cursor
{
public:
  static constexpr char no_comments = '\n';
  static constexpr char no_continuation = '\n';

  Text_cursor(std::string file_name,
              std::string_view text,
              char comment_character,
              char continuation_character = no_continuation)
    : m_file_name(std::move(file_name)),
      m_text(text),
      m_comment_character(comment_character),
      m_continuation_character(continuation_character)
  {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (m_text.substr(0, byte_order_mark.size()) == byte_order_mark)
      m_text.remove_prefix(byte_order_mark.size());
  }

  // goes to the next line with a word; `false` at the end of the text
  bool next_line()
  {
    while (m_is_continued)
      take_line();
    m_line = {};
    while (m_line.empty() && m_next_line_begin < m_text.size())
    {
      take_line();
      skip_blanks();
    }
    m_line_number_of_word = m_line_number;
    return !m_line.empty();
  }

  // From now on the ends of lines are blanks, and the rest of the text is one line.
  void join_lines() { m_are_lines_joined = true; }

  // takes the next word of the line; empty at the end of the line
  std::string_view next_word()
  {
    std::size_t length = 0;
    while (length < m_line.size() && !is_blank(m_line[length]))
      ++length;
    const std::string_view word = m_line.substr(0, length);
    m_line.remove_prefix(length);
    m_line_number_of_word = m_line_number;
    skip_blanks();
    return word;
  }

  bool is_line_finished() const { return m_line.empty(); }

  // what follows the current line
  std::string_view remaining_text() const { return m_text.substr(m_next_line_begin); }

  // the place of the last word in the file, for messages
  std::string place() const
  {
    const std::size_t line_number = std::max<std::size_t>(m_line_number_of_word, 1);
    return m_file_name + ":" + std::to_string(line_number) + ": ";
  }

  [[noreturn]] void fail(const std::string& what) const { throw_file_problem(place(), what); }

private:
  static bool is_blank(char c)
  {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }
  static bool is_blank_or_nul(char c) { return is_blank(c) || c == '\0'; }

  // goes to the next line as it is in the text
  void take_line()
  {
    ++m_line_number;
    const std::size_t end = (std::min)(m_text.find('\n', m_next_line_begin), m_text.size());
    m_line = m_text.substr(m_next_line_begin, end - m_next_line_begin);
    m_next_line_begin = (std::min)(end + 1, m_text.size());
    const std::size_t comment = m_line.find(m_comment_character);
    m_line = m_line.substr(0, comment);
    while (!m_line.empty() && is_blank_or_nul(m_line.front()))
      m_line.remove_prefix(1);
    while (!m_line.empty() && is_blank_or_nul(m_line.back()))
      m_line.remove_suffix(1);
    m_is_continued = comment == std::string_view::npos && !m_line.empty() &&
                     m_line.back() == m_continuation_character;
    if (m_is_continued)
    {
      m_line.remove_suffix(1);
      check_no_word_is_split();
    }
  }

  // Readers do not agree whether a word goes on after the continuation character, or another one
  // begins.
  void check_no_word_is_split()
  {
    const bool is_word_before = !m_line.empty() && !is_blank(m_line.back());
    const bool is_word_after = m_next_line_begin < m_text.size() &&
                               !is_blank(m_text[m_next_line_begin]) &&
                               m_text[m_next_line_begin] != '\n';
    if (!is_word_before || !is_word_after)
      return;
    m_line_number_of_word = m_line_number;
    fail("the line is continued in the middle of a word; there must be a blank before " +
         quoted(std::string_view(&m_continuation_character, 1)));
  }

  void skip_blanks()
  {
    while (true)
    {
      while (!m_line.empty() && is_blank(m_line.front()))
        m_line.remove_prefix(1);
      const bool goes_on =
        m_is_continued || (m_are_lines_joined && m_next_line_begin < m_text.size());
      if (!m_line.empty() || !goes_on)
        return;
      take_line();
    }
  }

  std::string m_file_name;
  std::string_view m_text;
  char m_comment_character;
  char m_continuation_character;
  std::string_view m_line; // the rest of the current line, up to where it is continued
  std::size_t m_next_line_begin = 0;
  std::size_t m_line_number = 0;
  std::size_t m_line_number_of_word = 0; // differs after the last word before a continuation
  bool m_is_continued = false;
  bool m_are_lines_joined = false;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_IO_TEXT_CURSOR_H
