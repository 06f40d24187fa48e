# smf_demo_package: the package, and what it needs, compiled by Emscripten.

if(NOT EMSCRIPTEN)
  message(FATAL_ERROR "This is to be configured by emcmake, see build_engine.sh")
endif()
get_filename_component(smf_root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)

# The headers of the libraries, in a folder of their own: beside them in /usr/include are headers of
# this system's C library, which must not be seen.
set(SMF_SYSTEM_INCLUDE_DIR /usr/include CACHE PATH "The folder that has CGAL, boost and eigen3")
set(smf_links ${CMAKE_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${smf_links})
foreach(library CGAL boost eigen3/Eigen)
  if(NOT EXISTS ${SMF_SYSTEM_INCLUDE_DIR}/${library})
    message(FATAL_ERROR "There is no ${SMF_SYSTEM_INCLUDE_DIR}/${library}: install the packages "
      "libcgal-dev and libeigen3-dev, or set SMF_SYSTEM_INCLUDE_DIR")
  endif()
  get_filename_component(name ${library} NAME)
  file(CREATE_LINK ${SMF_SYSTEM_INCLUDE_DIR}/${library} ${smf_links}/${name} SYMBOLIC)
endforeach()

add_library(smf_demo_package INTERFACE)
target_compile_features(smf_demo_package INTERFACE cxx_std_17)
target_include_directories(smf_demo_package INTERFACE ${smf_root}/include ${smf_root})
target_include_directories(smf_demo_package SYSTEM INTERFACE ${smf_links})
# WebAssembly knows one rounding mode only, so CGAL has to widen its intervals instead.
target_compile_definitions(smf_demo_package INTERFACE CGAL_ALWAYS_ROUND_TO_NEAREST
  CGAL_EIGEN3_ENABLED)
target_compile_options(smf_demo_package INTERFACE -fwasm-exceptions)
target_link_options(smf_demo_package INTERFACE -fwasm-exceptions
  -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=64MB -sMAXIMUM_MEMORY=4GB -sTOTAL_STACK=16MB)
