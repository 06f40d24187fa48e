// Progress messages of the main program.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_PROGRESS_H
#define SMF_EXAMPLES_MAIN_PROGRAM_PROGRESS_H

#include <CGAL/Surface_mesh_foliation.h>

#include <CGAL/Real_timer.h>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <cstddef>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>

namespace main_program {

namespace SMF = CGAL::Surface_mesh_foliation;

inline bool standard_error_is_a_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// Progress on a terminal: one line, which the next one replaces and which is erased at the end. The
// beginning of a stage is shown once the program has run for a while, or if the stage may take a
// while.
class Progress
{
public:
  explicit Progress(bool is_on) : m_is_on(is_on && standard_error_is_a_terminal())
  {
    m_timer.start();
  }
  ~Progress() { show(""); }

  void begin(const std::string& stage, std::size_t size)
  {
    m_stage = stage;
    if (m_timer.time() > 1 || size > 50000) // vertices, or kilobytes of a file
      show(stage);
  }

  bool after_coarse_iteration(std::size_t size, const SMF::Foliation_statistics& statistics)
  {
    return tell(m_stage + " on " + std::to_string(size) + " vertices", statistics);
  }

  bool after_iteration(const SMF::Foliation_statistics& statistics)
  {
    return tell(m_stage, statistics);
  }

private:
  bool tell(const std::string& where, const SMF::Foliation_statistics& statistics)
  {
    std::ostringstream text;
    text << where << ", iteration " << statistics.number_of_iterations << ", optimality "
         << statistics.optimality << ", " << statistics.number_of_moves << " moves";
    if (m_timer.time() > 1 && m_timer.time() > m_last_time + 0.1)
      show(text.str());
    return true;
  }

  void show(const std::string& text)
  {
    if (!m_is_on || text == m_text)
      return;
    std::cerr << '\r' << text
              << std::string(m_text.size() > text.size() ? m_text.size() - text.size() : 0, ' ')
              << (text.empty() ? "\r" : "") << std::flush;
    m_text = text;
    m_last_time = m_timer.time();
  }

  bool m_is_on;
  CGAL::Real_timer m_timer;
  double m_last_time = 0;
  std::string m_stage, m_text; // what is on the line
};

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_PROGRESS_H
