// SPDX-License-Identifier: MIT
//
// What a launch does near a target, for by_force.hpp: one simulation, nothing of the planners.
#pragma once

#include <array>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::test {

/// The target as a replay sees it.
struct Aimed {
  explicit Aimed(const Puzzle& puzzle);
  const Puzzle& puzzle;  ///< must outlive this
  Boundary boundary;
  bool falls, stops;  ///< into a pocket; to rest at a point
  Vec2d at{};         ///< the point
  int pocket = -1;    ///< -1: any
};

/// How the ball comes by the target after its `bounces`-th bounce. `beside` is how far left of the line of travel the
/// target lies; `fast` the speed there, or for a stop how far beyond the target it rests [m/s, m].
struct Pass {
  int bounces;
  std::uint64_t route;  ///< a number for what it met in order, the pocket included
  double fast, beside, time;
};

struct Flight {
  static constexpr int most = 16;
  std::array<Pass, most> passes;
  int count = 0;
  bool too_fast = false;  ///< it bounced too often, and was faster than `arrival` when it last came by
};

/// The passes after each number of bounces that the puzzle's rule allows. `arrival`: the largest that matters [m/s].
Flight fly(const Aimed& aimed, const Launch& launch, const LaunchSpin& spin, double arrival,
           std::vector<Contact>* contacts = nullptr);

/// Whether it is made in the format's sense, by the jaws of pockets too.
bool makes(const Aimed& aimed, const Launch& launch, const LaunchSpin& spin);

}  // namespace bankshot::test
