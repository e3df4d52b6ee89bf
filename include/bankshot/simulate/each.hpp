// SPDX-License-Identifier: MIT
//
// Many launches of one scene.
#pragma once

#include <functional>
#include <span>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// How a ball is struck.
struct Stroke {
  Launch launch;
  LaunchSpin spin{};
};

/// `see(i, trajectory)` of each stroke, what `simulate` gives for the scene struck so; null where it would throw for
/// the stroke. What strokes share is made once. Throws InvalidInput where the scene, whose own launch does not count,
/// breaks a rule.
void simulate_each(ShotRequest scene, std::span<const Stroke> strokes,
                   const std::function<void(std::size_t, const Trajectory*)>& see);

}  // namespace bankshot
