# Run as cmake -D SOURCE_DIR=<root of the package> -D BINARY_DIR=<folder> -D CGAL_DIR=<folder>
# -P vcpkg_port.cmake: follows the portfile of vcpkg, with functions that stand in for those of vcpkg,
# which Debian does not have, and fails if what the port installs is not all that a port has to have,
# or if find_package() or pkg-config would not find it there. That vcpkg itself accepts the port is
# not checked.

cmake_minimum_required(VERSION 3.22)

set(PORT surface-mesh-foliation)
set(FEATURES core)
set(CURRENT_PACKAGES_DIR ${BINARY_DIR}/packages/${PORT})
file(REMOVE_RECURSE ${BINARY_DIR})
file(MAKE_DIRECTORY ${BINARY_DIR})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "OUT_FEATURE_OPTIONS" "FEATURES")
  set(options "")
  while(arg_FEATURES)
    list(POP_FRONT arg_FEATURES feature option)
    set(is_on OFF)
    if(feature IN_LIST FEATURES)
      set(is_on ON)
    endif()
    list(APPEND options -D${option}=${is_on})
  endwhile()
  set(${arg_OUT_FEATURE_OPTIONS} ${options} PARENT_SCOPE)
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
  run(${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${BINARY_DIR}/build -D CGAL_DIR=${CGAL_DIR}
    -D CMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR} ${arg_OPTIONS})
  # an option that the package does not know has no help text
  execute_process(COMMAND ${CMAKE_COMMAND} -L -N -B ${BINARY_DIR}/build OUTPUT_VARIABLE cache)
  foreach(option IN LISTS arg_OPTIONS)
    string(REGEX REPLACE "^-D(.*)=.*" "\\1" name ${option})
    if(NOT cache MATCHES "${name}:BOOL")
      message(FATAL_ERROR "the package has no option ${name}")
    endif()
  endforeach()
endfunction()

function(vcpkg_cmake_install)
  run(${CMAKE_COMMAND} --build ${BINARY_DIR}/build)
  run(${CMAKE_COMMAND} --install ${BINARY_DIR}/build)
endfunction()

# (vcpkg's function also moves the files, to share/<package>, and corrects the paths in them)
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PACKAGE_NAME;CONFIG_PATH" "")
  set(folder ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH})
  foreach(file Config.cmake ConfigVersion.cmake Targets.cmake Components.cmake)
    if(NOT EXISTS ${folder}/${arg_PACKAGE_NAME}${file})
      message(FATAL_ERROR "there is no ${folder}/${arg_PACKAGE_NAME}${file}")
    endif()
  endforeach()
endfunction()

function(vcpkg_fixup_pkgconfig)
  if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/share/pkgconfig/${PORT}.pc)
    message(FATAL_ERROR "there is no share/pkgconfig/${PORT}.pc")
  endif()
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
  file(COPY_FILE ${arg_FILE_LIST} ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright)
endfunction()

include(${SOURCE_DIR}/package/vcpkg/portfile.cmake)

foreach(file include/CGAL/Surface_mesh_foliation.h share/${PORT}/copyright share/${PORT}/usage)
  if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/${file})
    message(FATAL_ERROR "the port does not install ${file}")
  endif()
endforeach()
file(GLOB_RECURSE others RELATIVE ${CURRENT_PACKAGES_DIR} ${CURRENT_PACKAGES_DIR}/*)
list(FILTER others EXCLUDE REGEX "^(include/CGAL|share/(cmake|pkgconfig|${PORT}))/")
if(others)
  message(FATAL_ERROR "the port installs what a port should not: ${others}")
endif()

# The manifest: the name of the port, and only components and options that there are as features.
file(READ ${SOURCE_DIR}/package/vcpkg/vcpkg.json manifest)
string(JSON name GET "${manifest}" name)
string(JSON count LENGTH "${manifest}" features)
include(${SOURCE_DIR}/package/components.cmake)
string(TOLOWER "program;${surface_mesh_foliation_components}" known)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
  string(JSON feature MEMBER "${manifest}" features ${i})
  if(NOT feature IN_LIST known)
    message(FATAL_ERROR "vcpkg.json has a feature ${feature}, which is no component")
  endif()
endforeach()
if(NOT name STREQUAL PORT)
  message(FATAL_ERROR "vcpkg.json names the port ${name}")
endif()
