# The port of vcpkg, with the sources that it stands in:
#   vcpkg install surface-mesh-foliation --overlay-ports=package/vcpkg
# In a registry, vcpkg_from_github() sets SOURCE_PATH instead, with the SHA512 of the release's
# tarball, which package/release.sh prints.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

vcpkg_check_features(OUT_FEATURE_OPTIONS features
  FEATURES
    program SURFACE_MESH_FOLIATION_BUILD_PROGRAM)

set(VCPKG_BUILD_TYPE release) # headers, and a program that nobody debugs

vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${features}
    -DSURFACE_MESH_FOLIATION_BUILD_TESTS=OFF
    -DSURFACE_MESH_FOLIATION_BUILD_EXAMPLES=OFF
    -DSURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(
  PACKAGE_NAME Surface_mesh_foliation
  CONFIG_PATH share/cmake/Surface_mesh_foliation)
vcpkg_fixup_pkgconfig()
if("program" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES surface-mesh-foliation AUTO_CLEAN)
endif()

file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE.md")
