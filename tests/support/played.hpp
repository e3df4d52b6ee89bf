// SPDX-License-Identifier: MIT
//
// A launch as the plain simulator plays it to the end: the judge of leaves.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::test {

/// Returns the places of all balls after a simulation of them, the cue ball first; none where a ball fell.
inline std::vector<std::optional<Vec2d>> places_of(const Puzzle& p, const Trajectory& t) {
  std::vector<std::optional<Vec2d>> places;
  for (int k = 0; k <= static_cast<int>(p.others.size()); ++k) {
    const auto fell = [&](const Record& e) { return e.kind == EventKind::pocket && e.ball == k; };
    places.push_back(std::ranges::any_of(t.events, fell) ? std::nullopt : std::optional(end_of(t, k).state.at));
  }
  return places;
}

/// Returns the places of all balls after a launch.
inline std::vector<std::optional<Vec2d>> played(const Puzzle& p, const Launch& launch, const LaunchSpin& spin) {
  return places_of(p, simulate({{}, p.table, p.physics, p.ball, p.others, launch, spin, {}}));
}

}  // namespace bankshot::test
