// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_BALANCED_SIGNS_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_BALANCED_SIGNS_H

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Signs s_i = +-1 for which most s_i a_ij s_j off the diagonal are negative: all those along
// breadth-first trees of the entries. In the matrix of a foliation, the others lie on curves that
// join singularities of odd index. `matrix` is symmetric, with all its entries.
inline Eigen::VectorXd balanced_signs(const Eigen::SparseMatrix<double>& matrix)
{
  Eigen::VectorXd result = Eigen::VectorXd::Zero(matrix.cols());
  std::vector<int> queue;
  queue.reserve(matrix.cols());
  for (int root = 0; root < matrix.cols(); ++root)
  {
    if (result[root] != 0)
      continue;
    result[root] = 1;
    queue.assign(1, root);
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, queue[k]); it; ++it)
        if (result[it.row()] == 0 && it.value() != 0)
        {
          result[it.row()] = it.value() < 0 ? result[queue[k]] : -result[queue[k]];
          queue.push_back(static_cast<int>(it.row()));
        }
  }
  return result;
}

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_BALANCED_SIGNS_H
