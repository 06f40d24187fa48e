// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_PICTURES_VECTOR_H
#define SMF_PICTURES_VECTOR_H

#include <cmath>

// A point, a direction, or a color with channels from 0 to 1.
struct Vector
{
  double x = 0, y = 0, z = 0;
};

inline Vector operator+(const Vector& a, const Vector& b)
{
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline Vector operator-(const Vector& a, const Vector& b)
{
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Vector operator*(double s, const Vector& a)
{
  return {s * a.x, s * a.y, s * a.z};
}

inline double dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector cross(const Vector& a, const Vector& b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The vector itself if it is zero.
inline Vector unit(const Vector& a)
{
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? (1 / length) * a : a;
}

inline Vector mix(const Vector& a, const Vector& b, double t)
{
  return (1 - t) * a + t * b;
}

#endif // SMF_PICTURES_VECTOR_H
