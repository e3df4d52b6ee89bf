// SPDX-License-Identifier: MIT
//
// Simulates one launch and reports how it comes by a target, for by_force.hpp; uses nothing of the planners.
#pragma once

#include <array>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

/// The target of a puzzle, prepared for simulations.
struct Aimed {
  explicit Aimed(const Puzzle& puzzle);
  const Puzzle& puzzle;  ///< must outlive this object
  Boundary boundary;
  bool falls, stops;  ///< the target is a pocket; the ball is to rest at a point
  Vec2d at{};         ///< the point of the target [m]
  int pocket = -1;    ///< the pocket asked for; -1: any
};

/// A passage of the ball by the target after its `bounces`-th bounce. The target lies `beside` metres to the left of
/// the line of travel. The speed there is `fast` [m/s]; for a stop, `fast` is how far beyond the target the ball rests
/// [m].
struct Pass {
  int bounces;
  std::uint64_t route;  ///< a hash of the route, the pocket included
  double fast, beside, time;
};

struct Flight {
  static constexpr int most = 16;
  std::array<Pass, most> passes;
  int count = 0;
  bool too_fast = false;  ///< did not end within the allowed bounces, and was too fast on the last leg
};

/// Returns the passes after each number of bounces that the puzzle allows. `arrival` is the largest arrival speed of
/// interest [m/s].
Flight fly(const Aimed& aimed, const Launch& launch, const LaunchSpin& spin, double arrival,
           std::vector<Contact>* contacts = nullptr);

/// Returns true when the launch makes the target in the format's sense; jaw shots count too.
bool makes(const Aimed& aimed, const Launch& launch, const LaunchSpin& spin);

}  // namespace bankshot::test
