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
  Contact taken_by{};          ///< the pocket or ball
  bool rattles = false;        ///< it touched jaws before it arrived
  int ball = 0;                ///< that arrived: the struck one, or one that was sent on
  std::vector<Onward> then{};  ///< those that were sent on, each with its cushions
  struct Hit {
    int ball;
    Passing passing;  ///< of the ball that hits, its lateral seen from the other's centre
  };
  std::vector<Hit> hits{};  ///< up to the target
  double incidence = 1;     ///< sine of the angle between the path and the rim of what takes it
  bool made() const { return why.empty() && in_order; }
};

/// Requirements on a path. Whatever it points to must outlive it.
struct Goal {
  int min, max;
  const std::vector<Contact>* sequence;
  const std::vector<Onward>* then = nullptr;  ///< what those that are sent on are to do; null: as the puzzle asks
  double time;       ///< s, when the arrival is claimed; of several passes the nearest to it counts
  double slack = 0;  ///< m, beyond `within`
  /// As `success` and `margin` count this shot: its own ball and pocket, and a pot without a rule of cushions counts
  /// every fall. A path ends at the target, so whether the cue ball falls later is asked elsewhere
  /// (`Scene::scratches`).
  const Shot* counts = nullptr;
};

Arrived judge(const Scene& scene, const Path& path, const Goal& goal);

}  // namespace bankshot::truth
