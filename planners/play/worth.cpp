// SPDX-License-Identifier: MIT
#include "planners/play/worth.hpp"

#include <algorithm>
#include <variant>

namespace bankshot::planning::play {

std::optional<bool> LeaveWorth::is_inside(const Vec2d& at) const {
  if (const auto* place = std::get_if<LeavePlace>(&*puzzle_.leave)) return norm(at - place->at) <= place->within;
  if (const auto* region = std::get_if<LeaveRegion>(&*puzzle_.leave)) return distance_to(*region, at) == 0;
  return {};
}

double LeaveWorth::operator()(const Ending& ending) const {
  const auto& places = ending.places;
  if (!places[0]) return 0;
  const Leave& wanted = *puzzle_.leave;
  if (const auto inside = is_inside(*places[0])) return *inside;
  if (const auto* next = std::get_if<LeaveForNext>(&wanted)) return next_.best(next->order, places).chance;
  if (const auto* against = std::get_if<LeaveAgainst>(&wanted))
    return ending.rail_after_contact ? 1 - next_.best(against->order, places).chance : 0;
  return std::ranges::all_of(std::get<LeaveSafe>(wanted).balls, [&](int ball) {
    return places[static_cast<std::size_t>(ball)] && !can_be_hit(puzzle_, ball, places);
  });
}

}  // namespace bankshot::planning::play
