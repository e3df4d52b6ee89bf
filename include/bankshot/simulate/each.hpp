// SPDX-License-Identifier: MIT
//
// Many launches of one scene.
#pragma once

#include <functional>
#include <span>

#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// Launch of the cue ball in one stroke.
struct Stroke {
  Launch launch;
  LaunchSpin spin{};
};

/// Calls `see(i, trajectory)` for each stroke, with the result of `simulate` for the scene with that stroke. The
/// trajectory is null if `simulate` would throw for the stroke. Work that strokes share is done once. Throws
/// InvalidInput if the scene breaks a rule; its own launch does not count.
void simulate_each(ShotRequest scene, std::span<const Stroke> strokes,
                   const std::function<void(std::size_t, const Trajectory*)>& see);

}  // namespace bankshot
