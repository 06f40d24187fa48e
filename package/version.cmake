# surface_mesh_foliation_version(<variable> <root of the package>): sets the variable to the version
# that include/CGAL/Surface_mesh_foliation/version.h says.
function(surface_mesh_foliation_version variable root)
  set(header ${root}/include/CGAL/Surface_mesh_foliation/version.h)
  file(STRINGS ${header} line REGEX "^#define CGAL_SURFACE_MESH_FOLIATION_VERSION \"")
  if(NOT line MATCHES "\"([0-9]+\\.[0-9]+\\.[0-9]+)\"$")
    message(FATAL_ERROR "${header} does not define CGAL_SURFACE_MESH_FOLIATION_VERSION as \"X.Y.Z\"")
  endif()
  set(${variable} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()
