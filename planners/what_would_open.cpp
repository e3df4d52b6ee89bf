// SPDX-License-Identifier: MIT
#include "planners/what_would_open.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

/// The softest shot of a changed puzzle.
std::optional<Shot> opened(Puzzle p, const Solve& solve) {
  p.prefer = Prefer::soft;
  p.budget = std::min(p.budget, settings::hints::most_simulations);
  const Answer a = solve(p);
  return a.shots.empty() ? std::nullopt : std::optional(a.shots.front());
}

}  // namespace

std::string what_would_open(const Puzzle& puzzle, const Solve& solve) {
  Puzzle p = puzzle;
  if (p.speed.high < settings::hints::strong_break && !is_ideal(p.physics)) {
    p.speed.high = settings::hints::strong_break;
    if (const auto shot = opened(p, solve))
      return fmt::format("a launch at {:.4g} m/s would do it", shot->launch.speed);
  }
  p = puzzle;
  if (p.angle) {
    p.angle.reset();
    if (const auto shot = opened(p, solve))
      return fmt::format("an aim of {:.4g}° would do it", degrees(shot->launch.angle));
  }
  p = puzzle;
  p.cushions = {.min = 0,
                .max = std::min(max_cushions, std::min(puzzle.cushions.max, settings::hints::most_cushions) + 1)};
  if (const auto shot = opened(p, solve)) {
    const std::size_t n = shot->cushions.size();
    std::string names;
    for (const Contact c : shot->cushions) names += (names.empty() ? " (" : ", ") + contact_name(p.table, c);
    return fmt::format("there is a shot with {} cushion{}{}", n, n == 1 ? "" : "s", names.empty() ? "" : names + ")");
  }
  if (is_straight(puzzle.physics) || puzzle.spin_range) return "";
  p = puzzle;
  for (const double side : settings::hints::side_spins) {
    p.spin.side = side;
    if (opened(p, solve)) return fmt::format("side spin {} would do it", side);
  }
  return "";
}

}  // namespace bankshot::planning
