// SPDX-License-Identifier: MIT
//
// The problem of one search: the puzzle as planners need it. It does not change while a step works on it; a step that
// wants another arrival speed or a fixed launch makes a problem of its own.
#pragma once

#include <algorithm>
#include <limits>
#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/target.hpp"
#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/starts.hpp"

namespace bankshot::planning {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// The shots that are wanted: the best one, the first that is verified, or every distinct one. `starts`: no shot, but
/// roots of locked paths, kept as candidates.
enum class Wanted { best, first, all, starts };

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

struct Question {
  explicit Question(const Puzzle& puzzle, Wanted wanted = Wanted::best);

  const Puzzle& puzzle;  ///< must outlive this
  Boundary boundary;
  std::optional<Boundary> cleared;         ///< without the other balls; none if there are none
  std::shared_ptr<const Objects> objects;  ///< null unless object balls are to be sent on, or touched on the way
  std::shared_ptr<const Starts> whole;     ///< all balls as they start, if a ball is the target; else null
  Physics rough;                           ///< the puzzle's, with impacts integrated no more finely than a seed needs
  Wanted wanted;
  bool valued = true;                ///< success is computed and ranks shots; otherwise its first-order estimate does
  bool every = false;                ///< all shots are wanted, even if this problem asks for roots to start from
  std::vector<AimPoint> aim_points;  ///< the aim points
  std::vector<Contact> touched;      ///< contacts of the ball at the start
  Range speed;                       ///< m/s, of the launch
  std::optional<Range> angle;        ///< rad, of the aim; none: any
  LaunchSpin spin;
  std::optional<Range> arrival;    ///< m/s at the aim point; none: any
  bool stop;                       ///< the ball must come to rest at its aim point
  double asked = 0;                ///< m/s; the arrival speed to aim for in its range, chosen by `prefer`
  double latest = forever;         ///< s; paths that take longer need not be followed
  double likelier = 0;             ///< roots of shots with less success than this need not be found
  std::optional<double> pinned{};  ///< m/s; a launch speed to keep; then any arrival speed in the range will do
  std::optional<Route> route{};    ///< the cushions, if the puzzle gives them in order
  CushionRule cue_cushions;        ///< of the cue ball: the puzzle's rule, or a stage of it
  CushionRule object_cushions;     ///< of the last object ball, likewise

  /// Returns the problem with another arrival speed of its range to aim for.
  Question asking(double arrival_speed) const;
  /// Returns the problem at one launch speed.
  Question launched_at(double launch_speed) const;
  /// Returns the problem of finding roots to start from, at this arrival speed and with this spin. They may lie outside
  /// the bounds, which hold for the branches that start there.
  Question starts_at(double arrival_speed, const LaunchSpin& launch_spin) const;
  /// Returns the problem with another spin of its ranges.
  Question spinning(const LaunchSpin& launch_spin) const;

  /// Returns a stage of the search, by so many cushions of the cue ball and of the last object ball.
  Question stage(int cue, int object) const;

  /// Returns the problem of finding shots better than this one, as far as `prefer` bounds them.
  Question better_than(const Shot& shot) const;

  /// Returns the table as if the cue ball were alone. Other balls block roots and make none, so maps look through them.
  const Boundary& alone() const { return cleared ? *cleared : boundary; }
  bool all() const { return wanted == Wanted::all; }
  bool first() const { return wanted == Wanted::first; }
  /// Returns whether shots leave the exact line if that has a larger value.
  bool safest() const { return aim_of(puzzle) == Aim::safest; }
  bool starts() const { return wanted == Wanted::starts; }
  /// Returns what the object balls are to do; null if the cue ball itself goes to the target.
  const Then* then() const { return then_of(puzzle.target); }
  /// Returns whether the cue ball goes off a first ball to another.
  bool carom() const { return off_of(puzzle.target) != 0; }
  RouteBalls balls() const {
    if (!objects) return {boundary};
    return {boundary, objects->standing, collisions(puzzle.physics), carom()};
  }
  const Boundary& boundary_of(int ball) const { return ball == 0 ? boundary : objects->find(ball).own; }
  const CushionRule& cushions() const { return cue_cushions; }
  /// Returns the rule of cushions for the n-th object ball of a shot, counted from 0.
  const CushionRule& cushions_of(std::size_t n) const {
    return n == then()->links.size() ? object_cushions : then()->links[n].cushions;
  }
  /// Returns whether only the aim is unknown.
  bool one_unknown() const { return !arrival || pinned; }
  /// Returns the launch speed if only the aim is unknown: the fixed one, or `ideal_speed`.
  double fixed_speed() const;
  /// Returns whether an aim point captures the ball: a pocket, or another ball.
  bool captures() const { return !aim_points.empty() && aim_points.front().captures(); }
  /// Returns whether a pocket is asked for.
  bool drops() const { return !aim_points.empty() && aim_points.front().drops(); }
  /// Returns the nearest of the aim points to which this contact takes the ball; null if there is none.
  const AimPoint* aim_point_taken_by(Contact contact, const Vec2d& arrived, int ball = 0) const;
  const AimPoint& nearest_aim_point(const Vec2d& arrived, int ball = 0) const;
  /// Returns the aim point of a made shot.
  const AimPoint& aim_point_of(const Shot& shot) const { return nearest_aim_point(shot.arrival.at, shot.arriving()); }
  /// Returns the ball that stands where the cue ball is to pass or to rest, if any does.
  Contact covering() const;
  /// Returns whether anything but cushions may block a path to part of the target.
  bool has_obstacles() const { return captures() || !boundary.balls.empty(); }
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
};

/// Calls `f` with the problem that has the shot's spin, which differs if the puzzle leaves the spin free.
template <class F>
decltype(auto) as_struck(const Question& q, const Shot& shot, F&& f) {
  return shot.spin == q.spin ? f(q) : f(q.spinning(shot.spin));
}

/// Returns the route of a shot: its cushions, and its contacts from ball to ball.
Route route_of(const Shot& shot);
/// Returns the route with the jaws that the cue ball touches.
Route route_with_jaws_of(const Shot& shot);

/// Returns b − a, brought into (−π, π].
double angle_difference(double a, double b);

}  // namespace bankshot::planning
