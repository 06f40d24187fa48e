// Files of all formats: those that the package reads, and those of libraries that the program was
// compiled with; and the standard input.

#ifndef SMF_EXAMPLES_MAIN_PROGRAM_READ_FILE_H
#define SMF_EXAMPLES_MAIN_PROGRAM_READ_FILE_H

#include "Options.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>
#ifdef SMF_HAS_ASSIMP
#include <CGAL/Surface_mesh_foliation/IO/read_with_assimp.h>
#endif
#ifdef SMF_HAS_VTK
#include <CGAL/Surface_mesh_foliation/IO/read_with_vtk.h>
#endif

#include <filesystem>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>

namespace main_program {

namespace SMF = CGAL::Surface_mesh_foliation;

inline std::string extension(const std::string& file)
{
  return std::filesystem::path(file).extension().string();
}

inline bool is_vtk_file(const std::string& file)
{
  return extension(file) == ".vtp" || extension(file) == ".vtu";
}

inline bool is_gltf_file(const std::string& file)
{
  return extension(file) == ".gltf" || extension(file) == ".glb";
}

// It can be read once only.
inline const std::string& standard_input()
{
  static const std::string text(std::istreambuf_iterator<char>(std::cin), {});
  return text;
}

inline SMF::Polygon_soup read_polygons(const Options& options)
{
  const std::string& file = options.mesh;
  if (is_standard_input(options))
  {
    std::istringstream input(standard_input());
    return SMF::read_polygon_soup(input, options.format, "the standard input");
  }
  if (is_vtk_file(file))
#ifdef SMF_HAS_VTK
    return SMF::read_polygon_soup_with_vtk(file);
#else
    throw std::invalid_argument(file + ": to read it, the program must be compiled with VTK");
#endif
  if (is_gltf_file(file))
#ifdef SMF_HAS_ASSIMP
    return SMF::read_polygon_soup_with_assimp(file);
#else
    throw std::invalid_argument(file + ": to read it, the program must be compiled with Assimp");
#endif
  return SMF::read_polygon_soup(file);
}

} // namespace main_program

#endif // SMF_EXAMPLES_MAIN_PROGRAM_READ_FILE_H
