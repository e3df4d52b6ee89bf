// SPDX-License-Identifier: MIT
//
// Tells how an arrival moves with the launch along the real path of object balls. It is for balls that a cushion holds,
// so that they roll along a rail, where no locked path leads. Cost: one simulation with dual numbers.
#pragma once

#include <optional>

#include "bankshot/simulate/work.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

struct Moved {
  Vec2d by_angle, by_log_speed;  ///< m per rad and per unit of ln speed; across the line of travel, unless it rests
};

/// Returns none where the cue ball does not set the others going as the shot says, or does in one more bounce.
std::optional<Moved> real_arrival(const SearchRequest& request, const Shot& shot, Work& work);

}  // namespace bankshot::planning
