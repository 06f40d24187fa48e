// Copyright (c) 2026 The Surface_mesh_foliation authors. All rights reserved.
//
// This file is part of Surface_mesh_foliation.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What JavaScript sees of a session. No exception of C++ leaves these functions: each returns an
// object that has either a `value` or a `problem`.

#include "Session.h"
#include "values.h"

#include <CGAL/Surface_mesh_foliation/exceptions.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace smf_engine {

namespace {

using emscripten::val;

val problem_value(const char* kind, const std::string& message)
{
  val result = val::object();
  result.set("kind", std::string(kind));
  result.set("message", message);
  for (const char* places : {"vertices", "faces", "loops"})
    result.set(places, val::array());
  return result;
}

val out_of_memory()
{
  return problem_value("memory", "the mesh needs more memory than a page of the browser can have; "
                                 "use a coarser one, or the program");
}

// calls a function and catches what it throws
template <class Function>
val guarded(const Function& function)
{
  val result = val::object();
  try
  {
    result.set("value", function());
  }
  catch (const SMF::Foliation_exception& exception)
  {
    result.set("problem", to_value(exception.problem()));
  }
  catch (const std::bad_alloc&)
  {
    result.set("problem", out_of_memory());
  }
  catch (const std::length_error&) // of a container larger than all memory
  {
    result.set("problem", out_of_memory());
  }
  catch (const std::exception& exception)
  {
    result.set("problem", problem_value("internal", exception.what()));
  }
  return result;
}

// `progress` is a function of JavaScript that takes a string and returns whether to go on.
Progress to_progress(const val& progress)
{
  return [progress](const std::string& stage) { return progress(stage).as<bool>(); };
}

val open_session(const std::string& file, bool repairs, bool fills_openings)
{
  return guarded([&] { return val(std::make_shared<Session>(file, repairs, fills_openings)); });
}

val loaded(const Session& session)
{
  return guarded([&] { return to_value(session.loaded()); });
}

val find_poles(Session& session)
{
  return guarded([&] { return to_value(session.find_poles()); });
}

val solve(Session& session, const val& state, const val& progress)
{
  return guarded([&] { return to_value(session.solve(state_of(state), to_progress(progress))); });
}

// `show` is a function of JavaScript that takes a sketch.
void show_sketches(Session& session, const val& show)
{
  session.show_sketches([show](const Sketch& sketch) { show(to_value(sketch)); });
}

val hierarchy(Session& session, const val& poles)
{
  return guarded(
    [&] { return to_value(session.hierarchy(poles_of(poles)), session.loaded().mesh); });
}

val leaves(const Session& session, unsigned int number_per_arc)
{
  return guarded([&] { return to_value(session.leaves(number_per_arc)); });
}

// Of the state, the poles and the loops.
val check_loop(const Session& session, const val& picks, const val& state)
{
  return guarded([&] { return to_value(session.check_loop(indices_of(picks), state_of(state))); });
}

val write(const Session& session, const std::string& what, const std::string& file)
{
  return guarded([&] {
    session.write(what, file);
    return val(file);
  });
}

} // namespace

EMSCRIPTEN_BINDINGS(surface_mesh_foliation)
{
  emscripten::class_<Session>("Session")
    .smart_ptr<std::shared_ptr<Session>>("Session")
    .function("loaded", &loaded)
    .function("findPoles", &find_poles)
    .function("showSketches", &show_sketches)
    .function("solve", &solve)
    .function("hierarchy", &hierarchy)
    .function("leaves", &leaves)
    .function("checkLoop", &check_loop)
    .function("write", &write);
  emscripten::function("openSession", &open_session);
}

} // namespace smf_engine
