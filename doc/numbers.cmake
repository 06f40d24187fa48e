# Run as cmake -D OUTPUT=<numbers.doxy> -P numbers.cmake <page.txt>...: numbers the pages of the
# manual, which are its chapters, in the given order, and the figures within each. Writes a Doxygen
# alias \smfNumber_<id> for every chapter and figure; \smfChapter, \cgalFigureBegin and
# \cgalFigureRef print them. The main page is chapter 1.

cmake_minimum_required(VERSION 3.22)

set(aliases "")
set(chapter 0)
set(is_page FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(is_page)
    math(EXPR chapter "${chapter} + 1")
    file(READ ${CMAKE_ARGV${i}} text)
    if(text MATCHES "\\\\smfChapter{([A-Za-z_]+),")
      string(APPEND aliases "ALIASES += \"smfNumber_${CMAKE_MATCH_1}=${chapter}\"\n")
    elseif(NOT text MATCHES "\\\\mainpage")
      message(FATAL_ERROR "${CMAKE_ARGV${i}} has neither \\mainpage nor \\smfChapter")
    endif()
    set(figure 0)
    string(REGEX MATCHALL "\\\\cgalFigureBegin{[A-Za-z_]+," begins "${text}")
    foreach(begin IN LISTS begins)
      math(EXPR figure "${figure} + 1")
      string(REGEX MATCH "{([A-Za-z_]+)" id "${begin}")
      string(APPEND aliases "ALIASES += \"smfNumber_${CMAKE_MATCH_1}=${chapter}.${figure}\"\n")
    endforeach()
  elseif(CMAKE_ARGV${i} MATCHES "numbers[.]cmake$")
    set(is_page TRUE)
  endif()
endforeach()
file(WRITE ${OUTPUT} "${aliases}")
