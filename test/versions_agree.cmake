# Run as cmake -D SOURCE_DIR=<root of the package> -P versions_agree.cmake: fails if a file names a
# version of the package other than that of version.h, if the number there is another one than the
# string, or if CHANGES.md does not begin with this release.

include(${SOURCE_DIR}/package/version.cmake)
surface_mesh_foliation_version(version ${SOURCE_DIR})
string(REGEX MATCH "^([0-9]+)\\.([0-9]+)\\.([0-9]+)$" version ${version})
math(EXPR number "10000 * ${CMAKE_MATCH_1} + 100 * ${CMAKE_MATCH_2} + ${CMAKE_MATCH_3}")
set(release ${CMAKE_MATCH_1}.${CMAKE_MATCH_2})
if(NOT CMAKE_MATCH_3 EQUAL 0)
  string(APPEND release .${CMAKE_MATCH_3})
endif()

set(faults "")

# expect(<file> <expected> <regular expression>): the group of the expression, where it matches first
function(expect file expected expression)
  file(READ ${SOURCE_DIR}/${file} text)
  if(NOT "\n${text}" MATCHES "${expression}")
    string(APPEND faults "\n  ${file} names no version")
  elseif(NOT CMAKE_MATCH_1 STREQUAL expected)
    string(APPEND faults "\n  ${file} has ${CMAKE_MATCH_1} instead of ${expected}")
  endif()
  set(faults "${faults}" PARENT_SCOPE)
endfunction()

set(demo demo/Surface_mesh_foliation)
expect(include/CGAL/Surface_mesh_foliation/version.h ${number} "_VERSION_NR ([0-9]+)\n")
expect(CHANGES.md ${release} "\n## Release ([^\n ]+)")
expect(CITATION.cff ${version} "\nversion: ([^\n]+)")
expect(python/pyproject.toml ${version} "\nversion = \"([^\"]+)\"")
expect(${demo}/package.json ${version} "\n  \"version\": \"([^\"]+)\"")
expect(${demo}/package-lock.json ${version} "\n  \"version\": \"([^\"]+)\"")
expect(${demo}/package-lock.json ${version} "\n      \"version\": \"([^\"]+)\"")
expect(package/vcpkg/vcpkg.json ${version} "\n  \"version\": \"([^\"]+)\"")

if(faults)
  message(FATAL_ERROR "Not version ${version} (package/set_version.sh changes all files):${faults}")
endif()
