# Run as cmake -D SOURCE=<file> -P count_refusals.cmake -- <compiler> <argument>...: fails unless the
# static assertion with the text of the last line "// message: <text>" fails once for each line of
# the file that says "refused", and the compiler complains about nothing else.

set(command "")
set(is_command FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(is_command)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(is_command TRUE)
  endif()
endforeach()

execute_process(COMMAND ${command} ${SOURCE} RESULT_VARIABLE result OUTPUT_VARIABLE output
  ERROR_VARIABLE output)

set(messages "")
set(number_expected 0)
file(STRINGS ${SOURCE} lines REGEX "// refused$|// message: ")
foreach(line IN LISTS lines)
  if(line MATCHES "// message: (.*)")
    set(message "${CMAKE_MATCH_1}")
    list(APPEND messages "${message}")
    set(expected_${message} 0)
  else()
    math(EXPR expected_${message} "${expected_${message}} + 1")
    math(EXPR number_expected "${number_expected} + 1")
  endif()
endforeach()

string(REGEX MATCHALL "error: " errors "${output}")
list(LENGTH errors number_of_errors)
if(result EQUAL 0 OR NOT number_of_errors EQUAL number_expected)
  message(FATAL_ERROR "${number_expected} refusals expected, but there are ${number_of_errors} "
    "errors:\n${output}")
endif()
foreach(message IN LISTS messages)
  string(REGEX MATCHALL "error: static[_ ]assert[^\n]*${message}" refusals "${output}")
  list(LENGTH refusals number_of_refusals)
  if(expected_${message} EQUAL 0 OR NOT number_of_refusals EQUAL expected_${message})
    message(FATAL_ERROR "${expected_${message}} refusals with \"${message}\" expected, but there "
      "are ${number_of_refusals}:\n${output}")
  endif()
endforeach()
