// SPDX-License-Identifier: MIT
//
// How a launch of a puzzle ends, replayed in 50 digits: does it make the target, when, where, how fast?
// Written from the definition of "made" and the recorded events alone; no code is shared with the planners'
// own verification.
#pragma once

#include <list>
#include <optional>
#include <string>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/shot.hpp"
#include "truth/run.hpp"

namespace bankshot::truth {

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

/// How far a ball's centre keeps from what it may not touch, by less than 0 where it does [m]: on a line of this
/// offset, where it enters the pocket's circle and, with jaws, since it left the table; none where it cannot come from
/// there.
std::optional<double> room_of_line(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double offset);

/// The offset of a pocket's exact line [m], not a number where no line leads straight in; from its definition: lines
/// beside the ball's own enter farther and farther off, up to the last one that enters where a ball's centre can be.
/// `heading` need not be a unit vector.
double exact_offset(const Boundary& boundary, const Circle& rim, const Vec2d& heading, double own);

class Scene {
 public:
  explicit Scene(const Puzzle& puzzle);

  /// Of a launch along the cushions of `claim`; of several passes by a point the one nearest in time to the claim's.
  /// `slack` [m] more than `within` still counts as made.
  Arrived replay(const Launch& launch, const Shot& claim, double slack) const;
  /// How far an arrival is off the point, or off the exact line to a pocket or ball [m].
  double miss(const Arrived& there) const;
  /// By differences in 50 digits; none where no launch beside this one meets the same events.
  std::optional<double> condition(const Shot& shot) const;
  /// Whether a launch is made along the cushions of `claim`, in double: many launches have no use for more digits.
  bool seems_made(const Launch& launch, const Shot& claim) const;
  /// The share of seeded draws from the player's errors that makes the target by any cushions allowed,
  /// in double: a sample has no use for more digits.
  double chance(const Shot& shot, int draws) const;

  const Puzzle& puzzle;
  const Boundary boundary;

 private:
  struct Goal;
  Run run(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  Run in_double(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  Arrived judge(const Path& path, const Goal& goal) const;
  Arrived judge_sent(const Path& path, const Goal& goal) const;
  Path truth_of(const Launch& launch, const LaunchSpin& spin, int cushions, double turned = 0, double pushed = 0) const;
  Path double_of(const Launch& launch, const LaunchSpin& spin, int cushions) const;
  ShotRequest request_of(const Launch& launch, const LaunchSpin& spin) const;
  const Boundary& boundary_of(int ball) const;
  Arrived at_point(Arrived a, const Passing& p) const;
  /// `line`: the event whose line of travel counts.
  Arrived taken(Arrived a, const TruthEvent& e, const TruthEvent& line) const;

  std::list<Boundary> others_{};  ///< as balls that may be sent on see the table
  Physics physics_;               ///< integrated impacts far finer than the solver's
  bool stops_;
};

}  // namespace bankshot::truth
