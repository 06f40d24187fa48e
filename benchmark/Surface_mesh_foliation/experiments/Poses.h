// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_EXPERIMENTS_POSES_H
#define SMF_EXPERIMENTS_POSES_H

#include "Shapes.h"
#include "generators/Random.h"

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace smf_experiments {

// Bends the limbs of a shape, each in its middle, as rigidly as possible.
class Poses
{
public:
  explicit Poses(const Shape& shape) : m_shape(shape), m_zones(shape.limbs.size())
  {
    const double unit = diagonal(shape.mesh);
    for (const Vertex v : vertices(shape.mesh))
    {
      const int part = shape.part_of_vertex[v.idx()];
      if (part == shape.trunk())
        continue;
      const double length = shape.limbs[part].length * unit;
      const bool is_outer = shape.distances[part][v.idx()] < length / 2;
      (is_outer ? m_zones[part].outer : m_zones[part].bend).push_back(v);
    }
  }

  // a copy of the mesh whose limbs are bent by random angles up to a right one, about random axes
  // across them
  Mesh pose(std::uint64_t seed) const
  {
    Mesh result = m_shape.mesh;
    smf_test::Random random(seed);
    std::vector<Bend> bends;
    for (std::size_t i = 0; i < m_zones.size(); ++i)
      bends.push_back(random_bend(i, random));

    CGAL::Surface_mesh_deformation<Mesh> deformation(result);
    for (const Zones& zones : m_zones)
    {
      deformation.insert_roi_vertices(zones.bend.begin(), zones.bend.end());
      deformation.insert_roi_vertices(zones.outer.begin(), zones.outer.end());
      deformation.insert_control_vertices(zones.outer.begin(), zones.outer.end());
    }
    if (!deformation.preprocess())
      throw std::runtime_error("a pose cannot be computed");
    constexpr int steps = 6; // of at most 15 degrees
    for (int step = 1; step <= steps; ++step)
    {
      for (std::size_t i = 0; i < m_zones.size(); ++i)
        for (const Vertex v : m_zones[i].outer)
          deformation.set_target_position(
            v, turned(m_shape.mesh.point(v), bends[i], bends[i].angle * step / steps));
      deformation.deform(step == steps ? 15 : 4, 0);
    }
    return result;
  }

private:
  using Vector = Kernel::Vector_3;

  // of a limb: what turns as it is, and what bends
  struct Zones
  {
    std::vector<Vertex> outer, bend;
  };

  struct Bend
  {
    Point joint;
    Vector axis; // of length 1
    double angle;
  };

  static Vector normalized(const Vector& vector)
  {
    return vector / std::sqrt(vector.squared_length());
  }

  Bend random_bend(std::size_t limb, smf_test::Random& random) const
  {
    Vector sum = CGAL::NULL_VECTOR;
    for (const Vertex v : m_zones[limb].bend)
      sum = sum + (m_shape.mesh.point(v) - CGAL::ORIGIN);
    const Point joint = CGAL::ORIGIN + sum / static_cast<double>(m_zones[limb].bend.size());
    const Vector along = normalized(m_shape.mesh.point(m_shape.limbs[limb].tip) - joint);
    Vector across;
    do
      across = CGAL::cross_product(
        along, Vector(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
    while (across.squared_length() < 0.01);
    return {joint, normalized(across), random.between(0, CGAL_PI / 2)};
  }

  // Rodrigues' formula
  static Point turned(const Point& point, const Bend& bend, double angle)
  {
    const Vector arm = point - bend.joint;
    return bend.joint + arm * std::cos(angle) +
           CGAL::cross_product(bend.axis, arm) * std::sin(angle) +
           bend.axis * (bend.axis * arm) * (1 - std::cos(angle));
  }

  const Shape& m_shape;
  std::vector<Zones> m_zones; // by limb
};

} // namespace smf_experiments

#endif // SMF_EXPERIMENTS_POSES_H
