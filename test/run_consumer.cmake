# Run by the tests consumer.*: configures, builds and runs the project consumer_${CONSUMER}, which
# uses the package as its users do.

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output
    ECHO_OUTPUT_VARIABLE)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGV}")
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${BINARY_DIR})

if(CONSUMER STREQUAL "compiled") # the package with its library
  run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${BINARY_DIR}/package
    -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${CXX_COMPILER}
    -D CMAKE_TOOLCHAIN_FILE=${TOOLCHAIN_FILE}
    -D CMAKE_BUILD_TYPE=Debug
    -D CGAL_DIR=${CGAL_DIR}
    -D SURFACE_MESH_FOLIATION_BUILD_LIBRARY=ON
    -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF
    -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=OFF
    -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF)
  run(${CMAKE_COMMAND} --build ${BINARY_DIR}/package --config Debug)
  run(${CMAKE_COMMAND} --install ${BINARY_DIR}/package --config Debug
    --prefix ${BINARY_DIR}/prefix)
  set(where -D CMAKE_PREFIX_PATH=${BINARY_DIR}/prefix)
elseif(CONSUMER MATCHES "^(find_package|components|pkg_config)$")
  run(${CMAKE_COMMAND} --install ${PACKAGE_BINARY_DIR} --config ${BUILD_TYPE}
    --prefix ${BINARY_DIR}/prefix)
  set(where -D CMAKE_PREFIX_PATH=${BINARY_DIR}/prefix)
else()
  set(where -D SURFACE_MESH_FOLIATION_SOURCE_DIR=${SOURCE_DIR})
endif()

if(CONSUMER STREQUAL "pkg_config")
  run(${SOURCE_DIR}/test/consumer_pkg_config.sh ${CXX_COMPILER} ${BINARY_DIR}/prefix ${VERSION}
    ${BINARY_DIR}/consumer)
  return()
endif()

# The consumer only has to build and run, and most of the time goes into optimizing it: so it is not
# optimized. The generator expression, which is empty, keeps a generator for many configurations
# from putting the program into a folder for each.
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/test/consumer_${CONSUMER} -B ${BINARY_DIR}/build
  -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${CXX_COMPILER}
  -D CMAKE_TOOLCHAIN_FILE=${TOOLCHAIN_FILE}
  -D CMAKE_BUILD_TYPE=Debug
  -D CMAKE_RUNTIME_OUTPUT_DIRECTORY=${BINARY_DIR}/build/$<1:>
  -D CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE=ON
  -D CGAL_DIR=${CGAL_DIR}
  -D EXPECTED_VERSION=${VERSION}
  -D EXPECTED_COMPONENTS=${COMPONENTS}
  ${where})
if(output MATCHES "libcgal-demo")
  message(FATAL_ERROR "users are told of meshes that only our tests need")
endif()
run(${CMAKE_COMMAND} --build ${BINARY_DIR}/build --config Debug)
run(${BINARY_DIR}/build/consumer)

if(CONSUMER STREQUAL "compiled") # the results are the same, to the last bit
  set(compiled "${output}")
  run(${BINARY_DIR}/build/header_only)
  if(NOT compiled STREQUAL output OR output STREQUAL "")
    message(FATAL_ERROR "with the compiled library:\n${compiled}with headers only:\n${output}")
  endif()
endif()
