/*!
\ingroup PkgSurfaceMeshFoliationConcepts
\cgalConcept

The concept `FoliationLinearSolver` describes the requirements of an object that solves the linear
systems of `CGAL::Surface_mesh_foliation::harmonic_foliation()`. Their matrices are symmetric and,
with positive weights, positive definite; all matrices of one run have one pattern, that of the
edges of the mesh and the diagonal, so the symbolic analysis is separate from the numeric
factorization. Vertices that cannot move are decoupled: off the diagonal their entries are zeros.

A solver may iterate, and its solutions need not be exact up to rounding. Each system is that of a
step from the current foliation, and `CGAL::Surface_mesh_foliation::harmonic_foliation()` continues
until the foliation itself meets its tolerance; so an inexact solution costs further iterations, but
does not affect the result.

A solver need not be copyable. It is passed by `std::ref()` and holds its last analysis and
factorization. If it has a member function `void %clear()` that frees them,
`CGAL::Surface_mesh_foliation::harmonic_foliation()` calls it once nothing more is to be solved,
before it makes the certificate; after that, the solver must still accept `analyze_pattern()`.

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Surface_mesh_foliation::Supernodal_cholesky_solver`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Simplicial_cholesky_solver`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Cholmod_solver`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Boomer_amg_solver`}
\cgalHasModelsEnd
*/
class FoliationLinearSolver
{
public:
  /// analyzes a pattern of entries. With `CGAL::Parallel_tag` this may happen in another thread,
  /// while the visitor's `after_coarse_iteration()` is called in this one; no other function of the
  /// solver is called meanwhile.
  /// \param matrix the lower triangle and the diagonal, compressed, row indices ascending; the
  ///   values mean nothing
  void analyze_pattern(const Eigen::SparseMatrix<double>& matrix);

  /// prepares to solve with a matrix of the pattern analyzed last, and returns whether that was
  /// possible; if not, `harmonic_foliation()` throws a `Solver_exception`.
  bool factorize(const Eigen::SparseMatrix<double>& matrix);

  /// returns the solution for a right-hand side. A solver that has found none throws a
  /// `CGAL::Surface_mesh_foliation::Solver_exception`, or returns numbers that are not finite; then
  /// `harmonic_foliation()` throws one.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_side);
};

/*!
\ingroup PkgSurfaceMeshFoliationConcepts
\cgalConcept

The concept `UpdatableFoliationLinearSolver` refines `FoliationLinearSolver` by access to a
factorization \f$ A = P^T L D L^T P \f$ with \f$L\f$ lower triangular, \f$D\f$ diagonal and \f$P\f$
a permutation. With it, a system whose matrix differs from \f$A\f$ in few rows is solved without a
new factorization (Woodbury's formula), which makes all iterations after the first cheap. *Rows* are
those of \f$L\f$, *unknowns* those of \f$A\f$.

\cgalRefines{FoliationLinearSolver}

\cgalHasModelsBegin
\cgalHasModels{`CGAL::Surface_mesh_foliation::Supernodal_cholesky_solver`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Simplicial_cholesky_solver`}
\cgalHasModels{`CGAL::Surface_mesh_foliation::Cholmod_solver`}
\cgalHasModelsEnd
*/
class UpdatableFoliationLinearSolver
{
public:
  /// returns \f$ L^{-1} P b \f$.
  Eigen::VectorXd forward(const Eigen::VectorXd& b) const;

  /// returns \f$ P^T L^{-T} D^{-1} z \f$.
  Eigen::VectorXd backward(const Eigen::VectorXd& z) const;

  /// returns the rows in which \f$ L^{-1} P e_i \f$ may be nonzero for one of the given unknowns
  /// \f$i\f$, ascending: the paths from the unknowns to the roots of the elimination tree.
  std::vector<int> forward_rows(const std::vector<int>& unknowns) const;

  /// returns the columns \f$ L^{-1} P e_i \f$ of the given unknowns, restricted to the rows that
  /// `forward_rows()` gave, as a dense matrix of Eigen.
  Matrix forward_columns(const std::vector<int>& unknowns, const std::vector<int>& rows) const;

  /// returns an entry of \f$D\f$.
  double pivot(int row) const;

  /// returns approximately how many multiplications a factorization takes.
  double work_of_factorization() const;

  /// returns how many multiplications a row takes in `forward()`.
  double work_of_column(int row) const;
};
