# Run as cmake -D SOURCE_DIR=<root of the package> -P every_file_is_listed.cmake: fails if a .cpp of
# the tests, examples or benchmarks is missing in its CMakeLists.txt, or an example in the manual.

set(package Surface_mesh_foliation)
set(missing "")

foreach(kind test example benchmark)
  set(folder ${SOURCE_DIR}/${kind}/${package})
  if(kind STREQUAL "example")
    set(folder ${SOURCE_DIR}/examples/${package})
  endif()
  file(READ ${folder}/CMakeLists.txt list)
  file(GLOB programs RELATIVE ${folder} ${folder}/*.cpp)
  foreach(program IN LISTS programs)
    get_filename_component(name ${program} NAME_WE)
    if(NOT list MATCHES "\n *smf_add_${kind}\\(${name}[ \n)]")
      string(APPEND missing "\n  ${program} is not in ${folder}/CMakeLists.txt")
    endif()
  endforeach()
endforeach()

file(READ ${SOURCE_DIR}/doc/${package}/examples.txt list)
file(GLOB programs RELATIVE ${SOURCE_DIR}/examples ${SOURCE_DIR}/examples/${package}/*.cpp)
foreach(program IN LISTS programs)
  if(NOT list MATCHES "\\\\example ${program}\n")
    string(APPEND missing "\n  ${program} is not in doc/${package}/examples.txt")
  endif()
endforeach()

if(missing)
  message(FATAL_ERROR "Forgotten files:${missing}")
endif()
