// SPDX-License-Identifier: MIT
//
// How far a locked path is from being a shot: one number that is positive where every bounce lies on its
// cushion, no pocket is in the way and the target is reached, and that grows continuously towards such
// launches from beside them. Where it is positive a launch is nearly certainly a shot; the replay decides.
// Worked number: a bank bounces 40 mm inside the end of its cushion, passes a side pocket's circle at 12 mm and its
// aim point at 3 mm, which may be missed by 10: the clearance is min(40, 12, 10 − 3) = 7 mm.
// Cost: one simulation.
#pragma once

#include <algorithm>
#include <optional>

#include "planners/trace/residual.hpp"

namespace bankshot::planning {

/// m: what a locked path has to spare.
struct Room {
  double on_the_way;  ///< the least of: how far each bounce is inside its cushion's ends, how far each leg keeps from
                      ///< the pockets and the vertices that it should not meet; where that is more than the aim point's
                      ///< reach, which bounds what is below, that
  double at_aim_point;  ///< the least of: how far inside the target the ball passes, how far inside the table it
                        ///< arrives, and how far it would roll on into a pocket
  double hidden = 0;    ///< of a pocket, as below
  double least() const { return std::min(on_the_way, at_aim_point); }
};

/// None where the path never gets to its last leg.
std::optional<Room> room(const Branch& aim, EvaluationBudget& budget, const Launch& launch);

/// Sine of the turn after which a line in direction u would first see some of an opening; 0 where it does.
double hidden(const Opening& opening, const Vec2d& u);

/// The least room.
std::optional<double> clearance(const Branch& aim, EvaluationBudget& budget, const Launch& launch);

}  // namespace bankshot::planning
