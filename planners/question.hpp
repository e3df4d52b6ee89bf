// SPDX-License-Identifier: MIT
//
// What one search is asked: the puzzle, seen as planners need it. It never changes while a step works on it; a step
// that wants another arrival speed or a fixed launch makes a question of its own.
#pragma once

#include <algorithm>
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

/// Which shots are wanted: the best one, the first that is proved, or every distinct one. `starts`: no shot, but roots
/// of locked paths, kept as leads.
enum class Wanted { best, first, all, starts };

/// The balls that a shot may set going, and the table as they see it.
struct Objects {
  struct Object {
    int ball;
    Ball at_rest;
    Boundary own;  ///< without itself
  };
  /// Set going one by the other: the struck ball touches the first.
  struct Chain {
    std::vector<const Object*> balls;
    std::vector<Boundary> moving;  ///< as the struck one and each of them see the table without any of them
  };
  std::list<Object> all{};      ///< which stay where they are
  std::vector<Chain> chains{};  ///< each begins with another ball
  std::vector<StandingBall> standing{};

  explicit Objects(const Puzzle& puzzle);
  Objects(const Objects&) = delete;
  Objects& operator=(const Objects&) = delete;
  const Object& find(int ball) const { return *std::ranges::find(all, ball, &Object::ball); }
  /// Null where none begins with this ball.
  const Chain* chain_by(int ball) const;
};

struct Question {
  explicit Question(const Puzzle& puzzle, Wanted wanted = Wanted::best);

  const Puzzle& puzzle;  ///< must outlive this
  Boundary boundary;
  std::optional<Boundary> cleared;         ///< without the other balls, where there are any
  std::shared_ptr<const Objects> objects;  ///< where balls are sent on, or touched on the way, else null
  std::shared_ptr<const Starts> whole;     ///< all balls as they start, where a ball is the target
  Physics rough;                           ///< the puzzle's, integrated no more finely than a seed needs
  Wanted wanted;
  bool valued = true;            ///< success is computed, and shots are ranked by it; else by first order
  bool every = false;            ///< all shots are wanted, also of a question for roots to start from
  std::vector<Mark> marks;       ///< the places to aim at
  std::vector<Contact> touched;  ///< what the ball touches at the start
  Range speed;                   ///< m/s, of the launch
  std::optional<Range> angle;    ///< rad, of the aim; none: any
  LaunchSpin spin;
  std::optional<Range> arrival;    ///< m/s at the mark; none: any
  bool stop;                       ///< the ball must come to rest at its mark
  double asked = 0;                ///< m/s: of a range of arrival speeds the one aimed for; `prefer` chooses
  double latest = forever;         ///< s: paths that take longer need not be followed
  double likelier = 0;             ///< roots that lead to shots less likely than this need not be found
  std::optional<double> pinned{};  ///< m/s: a launch speed to keep to; then any arrival in the range will do
  std::optional<Route> route{};    ///< the cushions, where the puzzle gives them in order
  CushionRule cue_cushions;        ///< of the cue ball: the puzzle's rule, or a stage of it
  CushionRule object_cushions;     ///< the same of the last object ball

  /// The same with another arrival speed of its range to aim for.
  Question asking(double arrival_speed) const;
  /// The same at one launch speed.
  Question launched_at(double launch_speed) const;
  /// Roots to start from, at this arrival speed and with this spin, wherever they lie: the bounds are the families'.
  Question starts_at(double arrival_speed, const LaunchSpin& launch_spin) const;
  /// The same with another spin of its ranges.
  Question spinning(const LaunchSpin& launch_spin) const;

  /// A stage of the search, by so many cushions of the cue ball and of the last object ball.
  Question stage(int cue, int object) const;

  /// For shots better than this one, as far as `prefer` bounds them.
  Question better_than(const Shot& shot) const;

  /// As if the struck ball were alone. Others block roots and make none, so maps look through them.
  const Boundary& alone() const { return cleared ? *cleared : boundary; }
  bool all() const { return wanted == Wanted::all; }
  bool first() const { return wanted == Wanted::first; }
  /// Shots leave the exact line where that has a larger value.
  bool safest() const { return aim_of(puzzle) == Aim::safest; }
  bool starts() const { return wanted == Wanted::starts; }
  /// What the struck ball sends another to; null where it goes itself.
  const Then* then() const { return then_of(puzzle.target); }
  /// The struck ball goes on to another, off a first one.
  bool carom() const { return off_of(puzzle.target) != 0; }
  RouteBalls balls() const {
    if (!objects) return {boundary};
    return {boundary, objects->standing, collisions(puzzle.physics), carom()};
  }
  const Boundary& boundary_of(int ball) const { return ball == 0 ? boundary : objects->find(ball).own; }
  const CushionRule& cushions() const { return cue_cushions; }
  /// Of the n-th object ball of a shot, from 0.
  const CushionRule& cushions_of(std::size_t n) const {
    return n == then()->links.size() ? object_cushions : then()->links[n].cushions;
  }
  /// Only the aim is unknown.
  bool one_unknown() const { return !arrival || pinned; }
  /// The launch speed where only the aim is unknown: the fixed one, or `ideal_speed`.
  double fixed_speed() const;
  /// Some mark takes the ball: a pocket, or another ball.
  bool captures() const { return !marks.empty() && marks.front().captures(); }
  /// A pocket is asked for.
  bool drops() const { return !marks.empty() && marks.front().drops(); }
  /// Of those that this contact takes the ball to, the nearest; null where it leads to none.
  const Mark* mark_taken_by(Contact contact, const Vec2d& arrived, int ball = 0) const;
  const Mark& nearest_mark(const Vec2d& arrived, int ball = 0) const;
  /// Of a made shot.
  const Mark& mark_of(const Shot& shot) const { return nearest_mark(shot.arrival.at, shot.arriving()); }
  /// The ball that stands where the struck one is to pass or to rest, if any does.
  Contact covering() const;
  /// Other things than cushions stand where a path to part of a mark may lead.
  bool has_obstacles() const { return captures() || !boundary.balls.empty(); }
  /// A miss this small is one of the exact line or point.
  bool centred(double miss) const;
  /// A ball there touches a cushion, as nearly as an answer is exact: rounding may decide whether it bounces.
  bool on_a_line(int ball, const Vec2d& at) const { return centred(boundary_of(ball).clearance(at)); }

  /// The ball touches this cushion or vertex at the start.
  bool touches(Contact contact) const { return std::ranges::find(touched, contact) != touched.end(); }
  /// A point stands in a vertex: it has no side with which to bounce there.
  bool in_vertex() const { return puzzle.ball.body.radius == 0 && touched.size() > 1; }
  /// A launch at this angle would drive the ball into a cushion that it touches: a bounce before it moves.
  bool into_touched_cushion(double launch_angle) const;
};

/// `f` of the question with the spin of a shot, which is the shot's own where the puzzle leaves it free.
template <class F>
decltype(auto) as_struck(const Question& q, const Shot& shot, F&& f) {
  return shot.spin == q.spin ? f(q) : f(q.spinning(shot.spin));
}

/// What the balls of a shot meet: cushions, and one ball the next.
Route route_of(const Shot& shot);
/// With the jaws that the struck ball touches as well.
Route route_with_jaws_of(const Shot& shot);

/// b − a brought into (−π, π].
double angle_difference(double a, double b);

}  // namespace bankshot::planning
