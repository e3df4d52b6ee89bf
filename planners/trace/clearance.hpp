// SPDX-License-Identifier: MIT
//
// The clearance of a locked path: one number [m] that tells how far it is from being a shot. It is positive where every
// bounce lies on its cushion, no pocket blocks the path and the target is reached. It grows continuously towards such
// launches from beside them. A launch with a positive clearance is nearly certainly a shot; the replay decides.
// Worked number: a bank bounces 40 mm inside the end of its cushion, passes a side pocket's circle at 12 mm and its
// aim point at 3 mm, which may be missed by 10: the clearance is min(40, 12, 10 − 3) = 7 mm.
// Cost: one simulation.
#pragma once

#include <algorithm>
#include <optional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// The clearances of a locked path [m].
struct Room {
  double on_the_way;    ///< the least distance of a bounce from its cushion's ends, and of a leg from the pockets,
                        ///< vertices and balls that it must not meet; at most the aim point's reach, which also bounds
                        ///< the clearance below
  double at_aim_point;  ///< the least of: how far inside the target the ball passes, how far inside the table it
                        ///< arrives, and how far it would roll on into a pocket
  double hidden = 0;    ///< for a pocket, the value of `hidden` below
  double least() const { return std::min(on_the_way, at_aim_point); }
};

/// Returns the clearances of a launch; none where the path never gets to its last leg.
std::optional<Room> room(const Branch& aim, EvaluationBudget& budget, const Launch& launch);

/// Returns the sine of the turn after which a line in direction u would first see some of an opening; 0 where it does.
double hidden(const Opening& opening, const Vec2d& u);

/// Returns the least of the clearances.
std::optional<double> clearance(const Branch& aim, EvaluationBudget& budget, const Launch& launch);

}  // namespace bankshot::planning
