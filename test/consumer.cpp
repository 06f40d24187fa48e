// The program of the projects consumer_*: uses the package as they got it.

#include <CGAL/Surface_mesh_foliation/exceptions.h>
#include <CGAL/Surface_mesh_foliation/version.h>

#include <cstdlib>
#include <iostream>
#include <string>

#ifndef CGAL_EIGEN3_ENABLED
#error "the package did not bring Eigen along"
#endif

int main()
{
  const std::string version = CGAL_SURFACE_MESH_FOLIATION_VERSION;
  const CGAL::Surface_mesh_foliation::Invalid_file_exception exception(
    {CGAL::Surface_mesh_foliation::Problem_kind::FILE, "no such file", {}, {}, {}});
  std::cout << "Surface_mesh_foliation " << version << ": " << exception.what() << std::endl;
  return version == EXPECTED_VERSION ? EXIT_SUCCESS : EXIT_FAILURE;
}
