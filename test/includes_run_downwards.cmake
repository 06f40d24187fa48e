# Run as cmake -D SOURCE_DIR=<root of the package> -P includes_run_downwards.cmake: fails if a header
# of a room (a folder of internal/) includes a public header, or a header of a room that does not
# lie below its own.

# The rooms, from the ground up; those of one floor do not know each other.
set(floors
  "Common"
  "Mesh"
  "Loops Homotopy Repair"
  "Scalar_reeb_graph Foliation Features"
  "Edge_values Automatic_loops Leaves Solver"
  "IO Component_coordinates Canonical_loops")
# What stands apart sees the ground only, and nothing else in internal/ sees it.
set(rooms_apart "Matching")

set(package CGAL/Surface_mesh_foliation)
set(internal ${SOURCE_DIR}/include/${package}/internal)

set(number 0)
foreach(floor IN LISTS floors)
  string(REPLACE " " ";" rooms "${floor}")
  foreach(room IN LISTS rooms)
    set(floor_of_${room} ${number})
  endforeach()
  math(EXPR number "${number} + 1")
endforeach()
foreach(room IN LISTS rooms_apart)
  set(floor_of_${room} apart)
endforeach()

# sets `result` to whether headers of the room `from` may include those of the room `to`
function(may_include from to result)
  set(above ${floor_of_${from}})
  set(below ${floor_of_${to}})
  if(from STREQUAL to)
    set(${result} TRUE PARENT_SCOPE)
  elseif(NOT DEFINED floor_of_${to} OR below STREQUAL apart)
    set(${result} FALSE PARENT_SCOPE)
  elseif(above STREQUAL apart)
    string(COMPARE EQUAL ${below} 0 answer)
    set(${result} ${answer} PARENT_SCOPE)
  elseif(below LESS above)
    set(${result} TRUE PARENT_SCOPE)
  else()
    set(${result} FALSE PARENT_SCOPE)
  endif()
endfunction()

file(GLOB_RECURSE headers RELATIVE ${internal} ${internal}/*)
if(NOT headers)
  message(FATAL_ERROR "No headers in ${internal}")
endif()

set(faults "")
foreach(header IN LISTS headers)
  string(REGEX MATCH "^[^/]*" room ${header})
  if(NOT DEFINED floor_of_${room} OR NOT header MATCHES "^[^/]+/[^/]+\\.h$")
    string(APPEND faults "\n  ${header} is no header of a room")
    continue()
  endif()
  file(STRINGS ${internal}/${header} lines REGEX "^ *# *include.*Surface_mesh_foliation")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^ *# *include *<${package}/internal/([^/>]+)/[^/>]+>")
      string(APPEND faults "\n  ${header} includes a public header: ${line}")
      continue()
    endif()
    set(other ${CMAKE_MATCH_1})
    may_include(${room} ${other} is_downwards)
    if(NOT is_downwards)
      string(APPEND faults "\n  ${header} includes a header of ${other}, which is not below ${room}")
    endif()
  endforeach()
endforeach()

if(faults)
  message(FATAL_ERROR "Includes that do not run downwards:${faults}")
endif()
