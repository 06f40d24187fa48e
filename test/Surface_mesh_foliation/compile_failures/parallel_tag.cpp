// Does not compile: the line marked as refused asks for threads without TBB.

#include <CGAL/Surface_mesh_foliation/harmonic_foliation.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace SMF = CGAL::Surface_mesh_foliation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

void misuse(const SMF::Loop_system<Mesh>& system)
{
  SMF::harmonic_foliation<CGAL::Parallel_if_available_tag>(system);
  SMF::harmonic_foliation<CGAL::Parallel_tag>(system); // refused
}
