# Run as cmake -D SOURCE=<file> -D MESSAGE=<text> -P count_refusals.cmake -- <compiler> <argument>...:
# fails unless a static assertion with this message fails once for each line of the file that says
# "refused", and the compiler complains about nothing else.

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
string(REGEX MATCHALL "error: static[_ ]assert[^\n]*${MESSAGE}"
  refusals "${output}")
string(REGEX MATCHALL "error: " errors "${output}")
list(LENGTH refusals number_of_refusals)
list(LENGTH errors number_of_errors)
file(STRINGS ${SOURCE} lines REGEX "// refused$")
list(LENGTH lines expected)

if(result EQUAL 0 OR NOT number_of_refusals EQUAL expected OR NOT number_of_errors EQUAL expected)
  message(FATAL_ERROR "${expected} refusals expected, but there are ${number_of_refusals}, and "
    "${number_of_errors} errors:\n${output}")
endif()
