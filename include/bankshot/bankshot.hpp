// SPDX-License-Identifier: MIT
//
// Includes the public interface: scenes, simulation, plans and drawings. Programs that need less can include single
// headers; bankshot/detail/ is internal to them. Simulation needs the CMake target bankshot::sim, JSON, CSV, text and
// pictures need bankshot::io, and headers of plan/ need bankshot::planners, which brings both.
#pragma once

#include "bankshot/contact/custom.hpp"   // user-defined cushions
#include "bankshot/draw/acceptance.hpp"  // pictures
#include "bankshot/draw/map.hpp"
#include "bankshot/draw/page.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"  // where a ball's centre can be
#include "bankshot/geometry/contact.hpp"   // contacts and their names
#include "bankshot/plan/answer.hpp"
#include "bankshot/plan/batch.hpp"        // many puzzles
#include "bankshot/plan/generate.hpp"     // generated puzzles
#include "bankshot/plan/launch_map.hpp"   // launches that make the shot
#include "bankshot/plan/place_value.hpp"  // how likely the next pot is from a place
#include "bankshot/plan/planner.hpp"      // one puzzle
#include "bankshot/plan/start_map.hpp"    // starts from which it can be solved
#include "bankshot/scene/json.hpp"        // puzzles and shots as text
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/scene.hpp"          // tables, balls and physics by name
#include "bankshot/simulate/acceptance.hpp"  // lines that a pocket accepts
#include "bankshot/simulate/each.hpp"        // many launches of one scene
#include "bankshot/simulate/locked.hpp"      // a path along given cushions
#include "bankshot/simulate/many_balls.hpp"  // event by event, several balls
#include "bankshot/simulate/simulator.hpp"   // event by event, in any scalar
#include "bankshot/simulate/trajectory.hpp"  // a whole shot, recorded
