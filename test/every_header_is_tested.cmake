# Run as cmake -D SOURCE_DIR=<root of the package> -P every_header_is_tested.cmake: fails if a
# header of the package is included by no test program and no helper of the tests by its name. That
# it comes along with another header is not enough. (The units that only compile every header are
# generated, and do not count.)

set(package Surface_mesh_foliation)
file(GLOB_RECURSE headers RELATIVE ${SOURCE_DIR}/include ${SOURCE_DIR}/include/CGAL/*.h)
file(GLOB_RECURSE programs ${SOURCE_DIR}/test/${package}/*.cpp ${SOURCE_DIR}/test/${package}/*.h
  ${SOURCE_DIR}/generators/*.h)
list(FILTER programs EXCLUDE REGEX "/compile_failures/")
if(NOT headers OR NOT programs)
  message(FATAL_ERROR "No headers or no tests in ${SOURCE_DIR}")
endif()

set(included "")
foreach(program IN LISTS programs)
  file(STRINGS ${program} lines REGEX "^ *# *include *<CGAL/")
  foreach(line IN LISTS lines)
    if(line MATCHES "<(CGAL/[^>]*)>")
      list(APPEND included ${CMAKE_MATCH_1})
    endif()
  endforeach()
endforeach()

list(REMOVE_ITEM headers ${included})
if(headers)
  list(JOIN headers "\n  " names)
  message(FATAL_ERROR "Headers that no test includes:\n  ${names}")
endif()
