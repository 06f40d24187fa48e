// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_GEODESIC_STEP_H
#define CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_GEODESIC_STEP_H

#include <CGAL/Surface_mesh_foliation/internal/Foliation/Foliation_state.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/forces.h>
#include <CGAL/Surface_mesh_foliation/internal/Foliation/lengths.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace CGAL {
namespace Surface_mesh_foliation {
namespace internal {

// Moves all vertices at once along geodesics of T, at constant speeds during the time from 0 to
// `duration`. The passages over nodes are events, handled in the order of their times. A vertex
// that arrives at a node moves on if there is one direction ahead; if there are several, it takes
// the one that outweighs all others together; if there is no such direction, it waits and tries
// again whenever a neighbor has moved.
class Geodesic_step
{
public:
  explicit Geodesic_step(Foliation_state& state) : m_state(state) {}

  // the vertices that arrived at a node or left one, with repetitions
  const std::vector<int>& moved() const { return m_moved; }

  // the derivative of the energy along the step at its end
  double slope() const
  {
    return sum_of_numbers(m_state.executor(), m_state.mesh().number_of_vertices(), [&](int v) {
      double result = 0;
      if (m_state.is_free_in_arc(v) && m_vertices[v].velocity != 0)
        for (int h : m_state.mesh().ring(v))
          result -= 2 * pull_at_source(m_state, h) * m_vertices[v].velocity;
      return result;
    });
  }

  // speed: by vertex, change of the parameter during unit time
  template <class Speed>
  void operator()(const Speed& speed, double duration)
  {
    m_duration = duration;
    start(speed);
    while (!m_queue.empty())
    {
      const Arrival arrival = m_queue.top();
      m_queue.pop();
      if (m_vertices[arrival.vertex].number_of_plans == arrival.plan)
        arrive(arrival);
    }
    put_into_place();
  }

  // The same, but a vertex that arrives at a node stays there.
  template <class Speed>
  void stopping_at_nodes(const Speed& speed, double duration)
  {
    m_duration = duration;
    start(speed);
    for (; !m_queue.empty(); m_queue.pop())
    {
      const int v = m_queue.top().vertex;
      m_state.move_to_node(v, m_state.half_arc(v, speed[v] > 0 ? 1 : 0));
      m_moved.push_back(v);
    }
    put_into_place();
  }

private:
  template <class Speed>
  void start(const Speed& speed)
  {
    m_moved.clear();
    m_vertices.assign(m_state.mesh().number_of_vertices(), Motion());
    for (int v = 0; v < m_state.mesh().number_of_vertices(); ++v)
      if (m_state.is_free_in_arc(v))
      {
        m_vertices[v].velocity = speed[v];
        schedule(v);
      }
  }

  struct Motion // small, since there is one for each vertex
  {
    double velocity = 0;             // of the parameter
    double start = 0;                // the time at which the parameter in the state was correct
    Letter back;                     // the letter over which a waiting vertex arrived
    signed char number_of_plans = 0; // earlier arrivals in the queue are void
    signed char number_of_departures = 0;
    bool is_waiting = false;
  };

  struct Arrival
  {
    double time;
    int vertex, plan;
    bool operator<(const Arrival& other) const
    {
      return time != other.time ? time > other.time : vertex > other.vertex;
    }
  };

  double position(int v, double time) const
  {
    return m_state.parameter(v) + m_vertices[v].velocity * (time - m_vertices[v].start);
  }

  void schedule(int v)
  {
    Motion& motion = m_vertices[v];
    ++motion.number_of_plans;
    if (motion.velocity == 0)
      return;
    const double length = m_state.system().height(m_state.arc(v));
    const double way = motion.velocity > 0 ? length - m_state.parameter(v) : -m_state.parameter(v);
    const double time = motion.start + way / motion.velocity;
    if (time < m_duration)
      m_queue.push({time, v, motion.number_of_plans});
  }

  void arrive(const Arrival& arrival)
  {
    const int v = arrival.vertex;
    Motion& motion = m_vertices[v];
    motion.back = m_state.half_arc(v, motion.velocity > 0 ? 1 : 0);
    motion.velocity = std::abs(motion.velocity);
    motion.start = arrival.time;
    motion.is_waiting = true;
    m_state.move_to_node(v, motion.back);
    m_moved.push_back(v);
    try_to_leave(v, arrival.time);
    if (motion.is_waiting)
      for (int h : m_state.mesh().ring(v))
        try_to_leave(m_state.mesh().target(h), arrival.time);
  }

  void try_to_leave(int first, double time)
  {
    std::vector<int> stack = {first};
    while (!stack.empty())
    {
      const int v = stack.back();
      stack.pop_back();
      const Letter letter = m_vertices[v].is_waiting ? way_ahead(v, time) : Letter();
      if (letter.is_none())
        continue;
      leave(v, letter);
      const Flat_mesh::Ring ring = m_state.mesh().ring(v);
      for (int i = ring.size() - 1; i >= 0; --i)
        stack.push_back(m_state.mesh().target(ring[i]));
    }
  }

  // the letter over which v leaves its node, or none if it has to wait
  Letter way_ahead(int v, double time)
  {
    if (m_vertices[v].number_of_departures > max_departures)
      return Letter();
    find_directions(m_state, v, m_directions);
    const std::vector<Letter>& letters = m_directions.letters;
    int ahead = 0;
    Letter last;
    for (Letter letter : letters)
      if (letter != m_vertices[v].back)
      {
        ++ahead;
        last = letter;
      }
    if (ahead <= 1)
      return last;
    find_forces(m_state, v, m_directions, [&](int h) { return length_at(h, time); });
    int strongest = -1;
    for (int d = 0; d < m_directions.size(); ++d)
      if (letters[d] != m_vertices[v].back &&
          (strongest < 0 || m_directions.force[d] > m_directions.force[strongest]))
        strongest = d;
    const bool outweighs = 2 * m_directions.force[strongest] > m_directions.total_force;
    return outweighs ? letters[strongest] : Letter();
  }

  // w of the spoke h of a waiting vertex
  double length_at(int h, double time) const
  {
    const int v = m_state.mesh().target(h);
    const double t = m_state.is_at_node(v) ? 0 : position(v, time);
    return (std::max)(0., is_forward(h) ? length_of_edge(m_state, edge_of(h), 0, t)
                                        : length_of_edge(m_state, edge_of(h), t, 0));
  }

  // The vertex continues as if it had not waited: `start` remains the time of its arrival.
  void leave(int v, Letter letter)
  {
    Motion& motion = m_vertices[v];
    m_state.move_into_arc(v, letter, letter.end() == 0 ? 0 : m_state.length_of_arc(letter));
    motion.is_waiting = false;
    ++motion.number_of_departures;
    if (letter.end() == 1)
      motion.velocity = -motion.velocity;
    m_moved.push_back(v);
    schedule(v);
  }

  void put_into_place()
  {
    for_each_number(m_state.executor(), m_state.mesh().number_of_vertices(), [&](int v) {
      if (!m_state.is_free_in_arc(v))
        return;
      const double length = m_state.system().height(m_state.arc(v));
      m_state.set_parameter(v, inner_parameter(position(v, m_duration), length));
    });
  }

  // more passages of one vertex in one step mean that it is going in circles
  static constexpr int max_departures = 12;

  Foliation_state& m_state;
  std::vector<Motion> m_vertices; // during and after a step; before the first, there are none
  std::vector<int> m_moved;
  std::priority_queue<Arrival> m_queue;
  Directions m_directions;
  double m_duration = 1;
};

} // namespace internal
} // namespace Surface_mesh_foliation
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_FOLIATION_INTERNAL_SOLVER_GEODESIC_STEP_H
