// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SMF_TEST_WRAPPED_MESH_H
#define SMF_TEST_WRAPPED_MESH_H

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Graph_with_descriptor_with_graph.h>

// A surface mesh whose descriptors know it, and complain when they meet another one. CGAL's wrapper
// lacks dynamic property maps (two definitions are equally good for it); here are those of the mesh
// inside.

namespace smf_test {

template <class Point>
using Wrapped_mesh = CGAL::Graph_with_descriptor_with_graph<CGAL::Surface_mesh<Point>>;

template <class Point, class Tag>
struct Wrapped_dynamic_map
{
  using Inner = typename boost::property_map<CGAL::Surface_mesh<Point>, Tag>::type;
  using type =
    CGAL::Graph_with_descriptor_with_graph_property_map<CGAL::Surface_mesh<Point>, Inner>;
  using const_type = type;
};

} // namespace smf_test

#define SMF_TEST_WRAP_DYNAMIC_MAP(tag)                                                         \
  namespace boost {                                                                            \
  template <class Point, class T>                                                              \
  struct property_map<smf_test::Wrapped_mesh<Point>, CGAL::tag<T>>                             \
    : smf_test::Wrapped_dynamic_map<Point, CGAL::tag<T>>                                       \
  {};                                                                                          \
  }                                                                                            \
  namespace CGAL {                                                                             \
  template <class Point, class T>                                                              \
  typename smf_test::Wrapped_dynamic_map<Point, tag<T>>::type get(                             \
    const tag<T>& property, const Graph_with_descriptor_with_graph<Surface_mesh<Point>>& mesh) \
  {                                                                                            \
    return {*mesh.graph, get(property, *mesh.graph)};                                          \
  }                                                                                            \
  }

SMF_TEST_WRAP_DYNAMIC_MAP(dynamic_vertex_property_t)
SMF_TEST_WRAP_DYNAMIC_MAP(dynamic_halfedge_property_t)
SMF_TEST_WRAP_DYNAMIC_MAP(dynamic_edge_property_t)
SMF_TEST_WRAP_DYNAMIC_MAP(dynamic_face_property_t)

#undef SMF_TEST_WRAP_DYNAMIC_MAP

#endif // SMF_TEST_WRAPPED_MESH_H
