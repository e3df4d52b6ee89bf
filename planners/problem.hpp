// SPDX-License-Identifier: MIT
//
// The problem of a search: a puzzle with everything that planners build from it once. It does not change. What a step
// varies, such as bounds or an arrival speed, is in its search request (search_request.hpp).
#pragma once

#include <algorithm>
#include <limits>
#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/target.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/starts.hpp"

namespace bankshot::planning {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// The balls that a shot may set going, and the table as they see it.
struct Objects {
  struct Object {
    int ball;
    Ball at_rest;
    Boundary own;  ///< the table as this ball sees it, without itself
  };
  /// A combination: the cue ball touches the first ball, and each ball sets the next going.
  struct Chain {
    std::vector<const Object*> balls;
    std::vector<Boundary> moving;  ///< the table without any of these balls, as the cue ball and each of them see it
  };
  std::list<Object> all{};      ///< a list, since chains point to its elements
  std::vector<Chain> chains{};  ///< each begins with another ball
  std::vector<StandingBall> standing{};

  explicit Objects(const Puzzle& puzzle);
  Objects(const Objects&) = delete;
  Objects& operator=(const Objects&) = delete;
  const Object& find(int ball) const { return *std::ranges::find(all, ball, &Object::ball); }
  /// Returns the chain that begins with this ball, or null.
  const Chain* chain_by(int ball) const;
};

struct Problem {
  /// `puzzle` is valid (scene/puzzle.hpp) and outlives this.
  explicit Problem(const Puzzle& puzzle);

  const Puzzle& puzzle;
  Boundary boundary;
  std::optional<Boundary> cleared;         ///< without the other balls; none if there are none
  std::shared_ptr<const Objects> objects;  ///< null unless object balls are to be sent on, or touched on the way
  std::shared_ptr<const Starts> whole;     ///< all balls as they start, if a ball is the target; else null
  Physics rough;                           ///< the puzzle's, with impacts integrated no more finely than a seed needs
  std::vector<AimPoint> aim_points;
  std::vector<Contact> touched;  ///< contacts of the ball at the start

  /// Returns the table as if the cue ball were alone. Other balls block roots and make none, so maps look through them.
  const Boundary& alone() const { return cleared ? *cleared : boundary; }
  /// Returns whether shots leave the exact line if that has a larger value.
  bool safest() const { return aim_of(puzzle) == Aim::safest; }
  /// Returns what the object balls are to do; null if the cue ball itself goes to the target.
  const Then* then() const { return then_of(puzzle.target); }
  /// Returns whether the last object ball of a shot uses no more cushions than the puzzle allows. A pot that counts by
  /// any cushions may be found by one too many; it leads to launches that use none.
  bool keeps_cushions(std::span<const ObjectBallPath> sent) const;
  bool keeps_cushions(const Shot& shot) const { return keeps_cushions(shot.path.then); }
  /// Returns whether the cue ball goes off a first ball to another.
  bool carom() const { return first_of_carom(puzzle.target) != 0; }
  RouteBalls balls() const {
    if (!objects) return {boundary};
    return {boundary, objects->standing, collisions(puzzle.physics), carom()};
  }
  const Boundary& boundary_of(int ball) const { return ball == 0 ? boundary : objects->find(ball).own; }
  /// Returns whether an aim point captures the ball: a pocket, or another ball.
  bool captures() const { return !aim_points.empty() && aim_points.front().captures(); }
  /// Returns whether a pocket is asked for.
  bool drops() const { return !aim_points.empty() && aim_points.front().drops(); }
  /// Returns the nearest of the aim points to which this contact takes the ball; null if there is none.
  const AimPoint* aim_point_taken_by(Contact contact, const Vec2d& arrived, int ball = 0) const;
  const AimPoint& nearest_aim_point(const Vec2d& arrived, int ball = 0) const;
  /// Returns the aim point of a made shot.
  const AimPoint& aim_point_of(const Shot& shot) const {
    return nearest_aim_point(shot.path.arrival.at, shot.arriving());
  }
  /// Returns the ball that stands where the cue ball is to pass or to rest, if any does.
  Contact covering() const;
  /// Returns whether a miss is so small that the shot counts as on the exact line or point.
  bool centred(double miss) const;
  /// Returns whether a ball there touches a cushion, as nearly as an answer is exact: rounding may decide whether it
  /// bounces.
  bool on_a_line(int ball, const Vec2d& at) const { return centred(boundary_of(ball).clearance(at)); }
  /// Returns whether the ball touches this cushion or vertex at the start.
  bool touches(Contact contact) const { return std::ranges::find(touched, contact) != touched.end(); }
  /// Returns whether the ball is a point that stands in a vertex: it has no side with which to bounce there.
  bool in_vertex() const { return puzzle.ball.body.radius == 0 && touched.size() > 1; }
  /// Returns whether a launch at this angle would drive the ball into a cushion that it touches: a bounce before it
  /// moves.
  bool into_touched_cushion(double launch_angle) const;
  /// Returns the angles along the cushions that the ball touches, both ways [rad].
  std::vector<double> along_touched_cushions() const;
};

/// Returns the route of a shot: its cushions, and its contacts from ball to ball.
Route route_of(const Shot& shot);
/// Returns the route with the jaws that the cue ball touches.
Route route_with_jaws_of(const Shot& shot);

/// Returns b − a, brought into (−π, π].
double angle_difference(double a, double b);

}  // namespace bankshot::planning
