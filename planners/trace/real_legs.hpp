// SPDX-License-Identifier: MIT
//
// Follows the real path of one ball, leg by leg, for `discover` and the steps that look through other balls.
#pragma once

#include <type_traits>

#include "bankshot/motion/arc.hpp"
#include "bankshot/simulate/event.hpp"
#include "bankshot/simulate/work.hpp"

namespace bankshot::planning {

/// Follows the ball of a simulator. A leg ends with a meeting, or where the path ends by itself. A slide that turns
/// into a roll does not end it. `begins()` is asked before each leg, and `ends(event)` after it; false ends the path.
/// `watch` sees each arc, and the parameter up to which it was followed. The work is added to `work`.
template <class Simulator, class Begins, class Ends, class Watch = Unwatched>
void each_leg(Simulator& sim, Work& work, Begins&& begins, Ends&& ends, Watch&& watch = {}) {
  const auto never = std::decay_t<decltype(sim.time())>(forever);
  bool goes_on = true;
  while (goes_on && begins()) {
    Event e;
    do {
      e = sim.step(never, watch);
      watch(sim.arc(), sim.travelled());
    } while (e.kind == EventKind::slide_to_roll);
    goes_on = ends(e);
  }
  work += sim.work();
}

}  // namespace bankshot::planning
