// Ends the main program between two files, if it is interrupted while it writes them.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_INTERRUPTION_H
#define SMF_EXAMPLES_MAIN_PROGRAM_INTERRUPTION_H

#include <csignal>

namespace main_program {

inline volatile std::sig_atomic_t caught_signal = 0;

// the second signal ends the program at once
extern "C" inline void catch_signal(int number)
{
  caught_signal = number;
  std::signal(number, SIG_DFL);
}

// While it lives, a signal that asks the program to end is remembered only. One that was ignored
// stays so.
class Signal_catcher
{
public:
  explicit Signal_catcher(int number)
    : m_number(number), m_before(std::signal(number, catch_signal))
  {
    if (m_before == SIG_IGN)
      std::signal(number, SIG_IGN);
  }
  ~Signal_catcher() { std::signal(m_number, m_before); }

  Signal_catcher(const Signal_catcher&) = delete;
  Signal_catcher& operator=(const Signal_catcher&) = delete;

private:
  int m_number;
  void (*m_before)(int);
};

struct Interrupted
{
  int signal;
};

inline void throw_if_interrupted()
{
  if (caught_signal != 0)
    throw Interrupted{caught_signal};
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_INTERRUPTION_H
