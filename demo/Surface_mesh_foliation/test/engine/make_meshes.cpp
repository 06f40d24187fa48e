// make_meshes FOLDER: writes meshes of the package's generators, small ones of every kind that the
// engine has to deal with.
//
// make_meshes FOLDER MESH TIMES: writes a mesh whose faces were cut into four that many times.

#include "generators/genus_soups.h"
#include "generators/openings.h"
#include "generators/revolution.h"
#include "generators/soups.h"

#include <CGAL/Surface_mesh_foliation/IO/polygon_soup.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace soups = smf_test::soups;
using Soup = CGAL::Surface_mesh_foliation::Triangle_soup;

namespace {

void write(const std::string& file, const Soup& soup)
{
  std::ofstream output(file);
  output.precision(17);
  output << "OFF\n" << soup.points.size() << ' ' << soup.triangles.size() << " 0\n";
  for (const auto& p : soup.points)
    output << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& t : soup.triangles)
    output << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
  output.close();
  if (!output)
    throw std::runtime_error(file + " cannot be written");
}

Soup with_openings(const Soup& soup, std::size_t number)
{
  smf_test::Random random(number);
  return soups::with_random_openings(soup, number, random);
}

// two surfaces side by side
Soup joined(Soup first, const Soup& second)
{
  const std::size_t before = first.points.size();
  for (const auto& p : second.points)
    first.points.push_back({p[0] + 100, p[1], p[2]});
  for (const auto& t : second.triangles)
    first.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  return first;
}

Soup subdivided(Soup soup, int times)
{
  for (int i = 0; i < times; ++i)
    soup = soups::midpoint_subdivided(soup);
  return soup;
}

std::vector<std::pair<std::string, Soup>> all_meshes()
{
  return {{"tetrahedron", soups::tetrahedron()},
          {"ball", soups::icosphere(3)},
          {"three_limbs", soups::limbed_sphere(3, 4)},
          {"five_limbs", soups::limbed_sphere(5, 4)},
          {"six_limbs", soups::limbed_sphere(6, 5)},
          {"noisy_limbs", soups::noisy(soups::limbed_sphere(4, 4), 0.01, 7)},
          {"torus", soups::torus(40, 20, 3, 1)},
          {"thin_torus", soups::torus(60, 12, 8, 1)},
          {"capsule", soups::capsule(6, 24).first},
          {"genus_2", subdivided(soups::genus_surface(2), 1)},
          {"genus_3", soups::genus_surface(3, 3)},
          {"genus_5", soups::genus_surface(5, 3)},
          {"handles_3", soups::handle_surface(3)},
          {"open_limbs", with_openings(soups::limbed_sphere(5, 4), 2)},
          {"open_torus", with_openings(soups::torus(40, 20, 3, 1), 3)},
          {"disk", soups::disk(10, 24)},
          {"two_parts", joined(soups::limbed_sphere(4, 4), soups::icosphere(2))}};
}

std::vector<std::pair<std::string, Soup>> wanted_meshes(int argc, char* argv[])
{
  if (argc == 2)
    return all_meshes();
  const Soup soup = CGAL::Surface_mesh_foliation::read_triangle_soup(argv[2]);
  return {{"subdivided", subdivided(soup, std::stoi(argv[3]))}};
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2 && argc != 4)
  {
    std::cerr << "make_meshes FOLDER [MESH TIMES]" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    for (const auto& [name, soup] : wanted_meshes(argc, argv))
      write(std::string(argv[1]) + "/" + name + ".off", soup);
  }
  catch (const std::exception& exception)
  {
    std::cerr << exception.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
