// SPDX-License-Identifier: MIT
//
// How an arrival moves with the launch along the real path of balls that are sent on: where a cushion holds it,
// so that it rolls along a rail, no locked path leads. Cost: one simulation with dual numbers.
#pragma once

#include <optional>

#include "bankshot/simulate/work.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

struct Moved {
  Vec2d by_angle, by_log_speed;  ///< m per rad and per unit of ln speed; across the line of travel, unless it rests
};

/// None where the ball that is struck does not send others on as the shot says, or does in one more bounce.
std::optional<Moved> real_arrival(const SearchRequest& request, const Shot& shot, Work& work);

}  // namespace bankshot::planning
