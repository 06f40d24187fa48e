/*!
\ingroup PkgSurfaceMeshFoliationConcepts
\cgalConcept

The concept `FoliationVisitor` describes the requirements of an object that
`CGAL::Surface_mesh_foliation::harmonic_foliation()`,
`CGAL::Surface_mesh_foliation::Foliation_solver` and
`CGAL::Surface_mesh_foliation::whitehead_foliation()` tell about their progress, and that can stop
them. Functions that find poles and loops, `CGAL::Surface_mesh_foliation::detect_feature_poles()`
and `CGAL::Surface_mesh_foliation::loop_hierarchy()` with those that use it, only ask its `go_on()`.

- *Softly:* `after_iteration()` or `after_coarse_iteration()` returns `false`. After that no
  further iteration begins, on this mesh or any other, and the visitor is not told of any. The
  leaves are carried to the mesh itself if need be, folds are smoothed out where they are, and the
  result is a certified foliation of the right class that need not be harmonic. That takes time
  \f$ O(n \log n) \f$; linear systems are only solved if a fold is too wide to be smoothed out
  locally, which is rare.
- *For good:* `go_on()` returns `false`, and the solver throws a
  `CGAL::Surface_mesh_foliation::Stopped_exception`. There is no result.

Each member function may throw. The exception is passed on unchanged and ends the run; nothing
leaks, results of earlier runs are as they were, and a `Foliation_solver` can begin the next run at
once. All calls come from the thread that called the solver.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Surface_mesh_foliation::Default_foliation_visitor`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Leaf_spread_recorder`}
\cgalHasModelsEnd
*/
class FoliationVisitor
{
public:
  /// is called after each iteration (with Whitehead moves: each sweep). If it returns `false` the
  /// solver stops softly.
  bool after_iteration(const CGAL::Surface_mesh_foliation::Foliation_statistics& statistics);

  /// is optional. It is called after each iteration on a coarser mesh, which has the given number
  /// of vertices and on which the solver finds its beginning, before the first call of
  /// `after_iteration()`; the coarsest mesh comes first. `statistics` are those on the coarse mesh;
  /// `has_converged` is `false`. If it returns `false` the solver stops softly. With
  /// `CGAL::Parallel_tag` the linear solver may be at work meanwhile, so it must not be touched; a
  /// solver that is stopped here, in whatever way, ends its analysis first.
  bool after_coarse_iteration(std::size_t number_of_vertices,
                              const CGAL::Surface_mesh_foliation::Foliation_statistics& statistics);

  /// is optional. It is called once in a run of `harmonic_foliation()` or
  /// `Foliation_solver::solve()`, when the leaves have come to the mesh itself, before the first
  /// iteration there. `arcs` has the arc of each vertex, in the order of `vertices(mesh)`; for a
  /// vertex at a node, it has the number of arcs. Iterations move some of the vertices (a tenth of
  /// them, or fewer, on usual shapes) to another arc, so a program can sketch the parts of the
  /// surface now, after less than half of the time that the result takes.
  void at_start(const std::vector<std::size_t>& arcs);

  /// is optional. It is called before each step that may take long: making a coarser mesh, the
  /// analysis, factorization and solution of a linear system, moving the leaves, a Whitehead sweep,
  /// cutting the mesh along leaves, the certificate; and in a solver that has been stopped softly,
  /// too. If it returns `false` the solver throws a
  /// `CGAL::Surface_mesh_foliation::Stopped_exception`. No step is interrupted; the longest is the
  /// first factorization on the mesh itself.
  bool go_on();
};
