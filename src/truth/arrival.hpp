// SPDX-License-Identifier: MIT
//
// Replays a launch of a puzzle in 50 digits to see if, when, where and how fast it makes the target.
// It uses only the definition of "made" and the recorded events; it shares no code with the planners'
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

  /// Replays a launch along the cushions of `claim`. If it passes a point several times, the pass nearest in time to
  /// the claim counts. `slack` [m] is added to `within`.
  Arrived replay(const Launch& launch, const Shot& claim, double slack) const;
  /// Returns the distance of an arrival from the point, or from the exact line to a pocket or ball [m].
  double miss(const Arrived& there) const;
  /// The side of the shot's aim and speed on which differences are taken. With `beyond`, they start one step beside the
  /// shot, past events that may change within its rounding.
  struct Sides {
    int aim = 1, speed = 1;
    bool beyond = false;
  };
  struct Condition {
    double metres;    ///< see Verification::condition
    double rounding;  ///< its relative error by rounding, if the ball creeps up to a cushion
  };
  /// Returns the condition by differences in 50 digits; none if no launch beside the shot meets the same events.
  std::optional<Condition> condition(const Shot& shot, const Sides& sides) const;
  /// Returns true if a launch counts for the margin of `claim`: it is made along the claim's cushions, with its ball
  /// and pocket, and the cue ball does not fall. The scratch is tested in double.
  bool counts(const Launch& launch, const Shot& claim) const;
  /// Does the same entirely in double, which suffices for many launches.
  bool seems_to_count(const Launch& launch, const Shot& claim) const;
  /// Returns true if a ball is the target and the cue ball falls into a pocket before all balls rest; in double.
  bool scratches(const Launch& launch, const LaunchSpin& spin) const;
  bool may_scratch() const;
  /// Returns the fraction of seeded draws from the player's errors that make the target. As for `success`, any allowed
  /// cushions count, with the shot's own ball and pocket and without a scratch. Draws are simulated in double, which
  /// suffices for a sample.
  double chance(const Shot& shot, int draws) const;

  /// Returns the boundary for the cue ball or an object ball.
  const Boundary& boundary_of(int ball) const;

  const Puzzle& puzzle;
  const Boundary boundary;
  bool stops;  ///< the ball must rest at a point

 private:
  Run run(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  Run in_double(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  double creeping(const Path& path, std::size_t arrives) const;

  std::optional<ShotRequest> all_{};  ///< the scene of all balls, if there is an object-ball path or a carom
  std::list<Boundary> others_{};      ///< boundaries for the other balls
  Physics physics_;                   ///< with integrated impacts far finer than the solver's
};

}  // namespace bankshot::truth
