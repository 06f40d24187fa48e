// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LETTER_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LETTER_H

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// A half-arc of the tree T, a letter of the words: the place where one end of a lift meets its
// node. End 0 lies to the left of the loop. Letters, words and frames: see the glossary in
// ARCHITECTURE.md.
class Letter
{
public:
  constexpr Letter() noexcept = default; // none
  constexpr Letter(int lift, int end) noexcept : m_code(2 * lift + end) {}

  constexpr bool is_none() const noexcept { return m_code < 0; }
  constexpr int lift() const noexcept { return m_code / 2; }
  constexpr int end() const noexcept { return m_code % 2; }
  // the letter of the other end of the same lift
  constexpr Letter other_end() const noexcept { return Letter(m_code ^ 1); }

  friend constexpr bool operator==(Letter a, Letter b) noexcept { return a.m_code == b.m_code; }
  friend constexpr bool operator!=(Letter a, Letter b) noexcept { return !(a == b); }

private:
  explicit constexpr Letter(int code) noexcept : m_code(code) {}

  int m_code = -1; // 2 * lift + end
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_FOLIATION_LETTER_H
