// SPDX-License-Identifier: MIT
//
// Whether a recorded path makes a target, and how it arrives there: by the definition of "made" alone. No code is
// shared with the planners' own verification.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bankshot/plan/shot.hpp"
#include "truth/run.hpp"

namespace bankshot::truth {

class Scene;

struct Arrived {
  std::string why{};                ///< it is not made; empty when it is
  std::vector<Contact> cushions{};  ///< met before it arrived, or failed to
  bool in_order = false;            ///< those are the ones named; two met in one instant may come in either order
  double time = 0, speed = 0;
  double passed = 0;  ///< m, how near it came to a point
  double offset = 0;  ///< m, of the line into a pocket or onto a ball, positive on the left of its centre
  Vec2d at{}, heading{};
  Contact taken_by{};             ///< the pocket or ball
  bool rattles = false;           ///< it touched jaws on its way
  int ball = 0;                   ///< that arrived: the struck one, or one that it sent on
  std::vector<Contact> onward{};  ///< the cushions of that
  std::optional<Passing> hit{};   ///< of the struck ball where it touched it, its lateral seen from that ball's centre
  double incidence = 1;           ///< sine of the angle between the path and the rim of what takes it
  bool made() const { return why.empty() && in_order; }
};

/// What a path is held against. Whatever it points to must outlive it.
struct Goal {
  int min, max;
  const std::vector<Contact>* sequence;
  const Onward* then = nullptr;  ///< what the ball that is sent on is to do; null: as the puzzle asks
  double time;                   ///< s, when the arrival is claimed; of several passes the nearest to it counts
  double slack = 0;              ///< m, beyond `within`
};

Arrived judge(const Scene& scene, const Path& path, const Goal& goal);

}  // namespace bankshot::truth
