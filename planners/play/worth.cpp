// SPDX-License-Identifier: MIT
#include "planners/play/worth.hpp"

#include <algorithm>
#include <variant>

namespace bankshot::planning::play {

double LeaveWorth::operator()(std::span<const std::optional<Vec2d>> places) const {
  if (!places[0]) return 0;
  const Leave& wanted = *puzzle_.leave;
  if (const auto* place = std::get_if<LeavePlace>(&wanted)) return norm(*places[0] - place->at) <= place->within;
  if (const auto* region = std::get_if<LeaveRegion>(&wanted)) return distance_to(*region, *places[0]) == 0;
  if (const auto* next = std::get_if<LeaveForBall>(&wanted)) return next_.best(next->ball, places).chance;
  return std::ranges::none_of(std::get<LeaveSafe>(wanted).balls,
                              [&](int ball) { return can_be_hit(puzzle_, ball, places); });
}

}  // namespace bankshot::planning::play
