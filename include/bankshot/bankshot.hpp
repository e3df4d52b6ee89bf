// SPDX-License-Identifier: MIT
//
// All of it: scenes, simulation, plans and drawings. Whoever wants less includes the headers below one by one;
// what they include in turn from bankshot/detail/ is theirs alone. Headers of plan/ need bankshot::planners, the others
// bankshot::sim.
#pragma once

#include "bankshot/contact/custom.hpp"   // a cushion of your own
#include "bankshot/draw/acceptance.hpp"  // pictures
#include "bankshot/draw/map.hpp"
#include "bankshot/draw/page.hpp"
#include "bankshot/draw/svg.hpp"
#include "bankshot/geometry/boundary.hpp"  // a table as a ball sees it
#include "bankshot/geometry/contact.hpp"   // what a ball met, and its name
#include "bankshot/plan/answer.hpp"
#include "bankshot/plan/batch.hpp"       // solve many
#include "bankshot/plan/generate.hpp"    // puzzles
#include "bankshot/plan/launch_map.hpp"  // which launches make it
#include "bankshot/plan/planner.hpp"     // solve one
#include "bankshot/plan/start_map.hpp"   // from where it can be solved
#include "bankshot/scene/json.hpp"       // puzzles and shots as text
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/scene.hpp"          // tables, balls and physics by name
#include "bankshot/simulate/acceptance.hpp"  // what a pocket takes
#include "bankshot/simulate/each.hpp"        // many launches of one scene
#include "bankshot/simulate/locked.hpp"      // a path along given cushions
#include "bankshot/simulate/many_balls.hpp"  // event by event, with other balls
#include "bankshot/simulate/simulator.hpp"   // event by event, in any scalar
#include "bankshot/simulate/trajectory.hpp"  // a whole shot, recorded
