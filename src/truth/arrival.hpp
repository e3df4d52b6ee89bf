// SPDX-License-Identifier: MIT
//
// How a launch of a puzzle ends, replayed in 50 digits: does it make the target, when, where, how fast?
// Written from the definition of "made" and the recorded events alone; no code is shared with the planners'
// own verification.
#pragma once

#include <list>
#include <optional>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/shot.hpp"
#include "truth/judge.hpp"

namespace bankshot::truth {

class Scene {
 public:
  explicit Scene(const Puzzle& puzzle);

  /// Of a launch along the cushions of `claim`; of several passes by a point the one nearest in time to the claim's.
  /// `slack` [m] more than `within` still counts as made.
  Arrived replay(const Launch& launch, const Shot& claim, double slack) const;
  /// How far an arrival is off the point, or off the exact line to a pocket or ball [m].
  double miss(const Arrived& there) const;
  /// By differences in 50 digits, on one side of the shot's aim and speed; none where no launch beside this one meets
  /// the same events. `beyond`: begins a step beside the shot, past what may change within rounding of it.
  struct Sides {
    int aim = 1, speed = 1;
    bool beyond = false;
  };
  struct Condition {
    double metres;
    double rounding;  ///< the share of it that rounding may change, since the ball creeps up to a cushion
  };
  std::optional<Condition> condition(const Shot& shot, const Sides& sides) const;
  /// Whether a launch counts for the margin of `claim`: made along its cushions, by its own ball and pocket, and the
  /// cue ball does not fall. The fall is looked for in double.
  bool counts(const Launch& launch, const Shot& claim) const;
  /// The same in double alone: many launches have no use for more digits.
  bool seems_to_count(const Launch& launch, const Shot& claim) const;
  /// Whether the cue ball falls into a pocket before all balls rest, where a ball is the target; in double.
  bool scratches(const Launch& launch, const LaunchSpin& spin) const;
  bool may_scratch() const;
  /// The share of seeded draws from the player's errors that makes the target by any cushions allowed, as `success`
  /// counts it: by the shot's own ball and pocket, and without a scratch. In double: a sample has no use for more
  /// digits.
  double chance(const Shot& shot, int draws) const;

  /// As a ball sees the table: the cue ball, or one that it may send on.
  const Boundary& boundary_of(int ball) const;

  const Puzzle& puzzle;
  const Boundary boundary;
  bool stops;  ///< the ball is asked to rest at a point

 private:
  Run run(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  Run in_double(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  double creeping(const Path& path, std::size_t arrives) const;

  std::optional<ShotRequest> all_{};  ///< the balls, where one is sent on
  std::list<Boundary> others_{};      ///< as balls that may be sent on see the table
  Physics physics_;                   ///< integrated impacts far finer than the solver's
};

}  // namespace bankshot::truth
