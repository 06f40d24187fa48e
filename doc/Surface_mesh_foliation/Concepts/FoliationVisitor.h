/*!
\ingroup PkgSurfaceMeshFoliationConcepts
\cgalConcept

The concept `FoliationVisitor` describes the requirements of an object that
`CGAL::Surface_mesh_foliation::harmonic_foliation()` informs of its progress, and that can stop it.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Surface_mesh_foliation::Default_foliation_visitor`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Leaf_spread_recorder`}
\cgalHasModelsEnd
*/
class FoliationVisitor
{
public:
  /// is called after each iteration. If it returns `false` the solver stops, and the result is a
  /// foliation of the right class that need not be harmonic.
  bool after_iteration(const CGAL::Surface_mesh_foliation::Foliation_statistics& statistics);

  /// is optional. It is called after each iteration on a coarser mesh, which has the given number
  /// of vertices and from which the solver starts, before the first call of `after_iteration()`;
  /// the coarsest mesh comes first. `statistics` are those on the coarser mesh. If it returns
  /// `false` the solver stops, as above. With `CGAL::Parallel_tag` the linear solver may be running
  /// meanwhile, so it must not be accessed; a solver that is stopped here finishes its analysis
  /// first.
  bool after_coarse_iteration(std::size_t number_of_vertices,
                              const CGAL::Surface_mesh_foliation::Foliation_statistics& statistics);
};
