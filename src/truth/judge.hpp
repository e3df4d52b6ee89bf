// SPDX-License-Identifier: MIT
//
// Judges whether a recorded path makes a target, and how it arrives, by the definition of "made" alone. No code is
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
  std::string why{};                ///< failure reason; empty if it is made
  std::vector<Contact> cushions{};  ///< cushions of the cue ball before the arrival or failure
  bool in_order = false;            ///< `cushions` are the named ones; two met at one instant may have either order
  double time = 0, speed = 0;
  double passed = 0;  ///< m; distance from the point
  double offset = 0;  ///< m; offset of the line into a pocket or onto a ball, positive on the left
  Vec2d at{}, heading{};
  Contact taken_by{};                  ///< the pocket or ball that ends the path
  bool touches_jaws = false;           ///< a jaw was touched before the arrival
  int ball = 0;                        ///< the ball that arrived: the cue ball or an object ball
  std::vector<ObjectBallPath> then{};  ///< object balls, each with its cushions
  struct Hit {
    int ball;
    Passing passing;  ///< of the hitting ball; `lateral` is relative to the hit ball's centre
  };
  std::vector<Hit> hits{};  ///< hits up to the target
  double incidence = 1;     ///< sine of the angle between the path and the rim of the pocket or ball
  bool made() const { return why.empty() && in_order; }
};

/// Requirements on a path. The objects that it points to must outlive it.
struct Goal {
  int min, max;
  const std::vector<Contact>* sequence;
  const std::vector<ObjectBallPath>* then = nullptr;  ///< required paths of the object balls; null: as in the puzzle
  double time;       ///< s; claimed time of arrival; of several passes the nearest to it counts
  double slack = 0;  ///< m; added to `within`
  /// If set, the path counts as for `success` and `margin` of this shot: only with its own ball and pocket, and a pot
  /// without a cushion rule counts every fall. A path ends at the target, so a later scratch is tested elsewhere
  /// (`Scene::scratches`).
  const Shot* counts = nullptr;
};

Arrived judge(const Scene& scene, const Path& path, const Goal& goal);

}  // namespace bankshot::truth
