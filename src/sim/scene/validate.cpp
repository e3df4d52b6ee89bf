// SPDX-License-Identifier: MIT
//
// Checks the rules for puzzles and shots, whether they come from a file or from a C++ program.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/scene/in_hand.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/scene/tip.hpp"
#include "sim/scene/ideal_speeds.hpp"
#include "sim/scene/validate_launch.hpp"
#include "sim/scene/validate_scene.hpp"

namespace bankshot {
namespace {

using namespace validation;

void check_speed(double v, const std::string& path) {
  if (!(v >= 0)) fail(path, fmt::format("{} must be at least 0", v));
  if (v > tolerance::fastest)
    fail(path, fmt::format("{} m/s is too fast to compute with; at most {:g}", v, tolerance::fastest));
  if (v > 0 && v < tolerance::slowest)
    fail(path, fmt::format("{} m/s is too slow to compute with; at least {:g}, or 0", v, tolerance::slowest));
}

void check_range(const Range& r, const std::string& path) {
  const bool one = r.fixed();
  check_speed(r.low, one ? path : path + "/0");
  check_speed(r.high, one ? path : path + "/1");
  if (!(r.low <= r.high)) fail(path, fmt::format("[{}, {}] must have its lower end first", r.low, r.high));
}

/// Checks that the spin of a puzzle needs a tip position on the ball.
void check_tip(const LaunchSpin& spin, const Body& body) {
  const double R = body.radius, from_centre = tip_of(spin, R).from_centre();
  if (from_centre > R)
    fail("/ball/spin",
         fmt::format("top {}, side {} would need a tip {:.3g} mm from the ball's centre, and the ball ends "
                     "at {:.3g} mm",
                     spin.top, spin.side, 1e3 * from_centre, 1e3 * R));
}

void check_number(const Puzzle& p, int k, const std::string& path) {
  if (k < 1 || k > static_cast<int>(p.others.size())) fail(path, fmt::format("there is no ball number {}", k));
}

/// Checks that every combination link touches a different ball.
void check_links(const Puzzle& p, const ObjectBallTarget& asked) {
  std::vector<int> before = asked.balls;
  std::string path = "/target/then";
  for (const Link& link : asked.then.links) {
    check_number(p, link.ball, path + "/ball");
    if (std::ranges::count(before, link.ball) > 0)
      fail(path + "/ball", contact_name(p, Contact::ball(link.ball)) + " is touched before");
    before.push_back(link.ball);
    path += "/then";
  }
}

void check_balls(const Puzzle& p, const std::vector<int>& balls) {
  if (balls.empty()) fail("/target/ball", "names no ball to touch");
  for (std::size_t i = 0; i < balls.size(); ++i) {
    check_number(p, balls[i], "/target/ball");
    if (std::ranges::count(balls, balls[i]) > 1)
      fail(at("/target/ball", i), contact_name(p, Contact::ball(balls[i])) + " is listed twice");
  }
}

void check_carom(const Puzzle& p, const CaromTarget& asked) {
  check_number(p, asked.first, "/target/carom/0");
  if (asked.second.balls.size() != 1) fail("/target/carom", "must be a pair of balls");
  const int second = asked.second.balls.front();
  check_number(p, second, "/target/carom/1");
  if (second == asked.first) fail("/target/carom/1", contact_name(p, Contact::ball(second)) + " is the first, too");
}

void check_cut(const BallTarget& asked) {
  if (!(std::abs(asked.exact_cut()) < radians(90.0)))
    fail("/target/cut", fmt::format("{:g}° must be inside -90° and 90°", degrees(*asked.cut)));
  if (!(asked.cut_within() > 0)) fail("/target/within", "must be greater than 0");
}

void check_cushions(const CushionRule& c, const Boundary& boundary, const std::string& path) {
  if (c.min < 0 || c.max < c.min || c.max > max_cushions)
    fail(path, fmt::format("{} to {} must be within 0 and {}", c.min, c.max, max_cushions));
  if (!c.sequence) return;
  for (std::size_t i = 0; i < c.sequence->size(); ++i) {
    const auto [kind, number] = (*c.sequence)[i];
    const bool bounces = kind == ContactKind::rail || kind == ContactKind::vertex;
    if (!bounces || number < 0 || number >= static_cast<int>(boundary.walls.size()))
      fail(at(path, i), fmt::format("there is no cushion number {}", number));
  }
}

void check_target(const Puzzle& p, const Boundary& boundary) {
  if (const auto* carom = std::get_if<CaromTarget>(&p.target))
    check_carom(p, *carom);
  else if (is_ball(p.target))
    check_balls(p, touched_first(p.target));
  if (const BallTarget* const touch = touch_of(p.target)) check_cut(*touch);
  if (const auto* sends = std::get_if<ObjectBallTarget>(&p.target)) check_links(p, *sends);
  std::string path = "/target";
  if (const Then* const then = then_of(p.target))
    for (std::size_t n = 0; n <= then->links.size(); ++n) {
      path += "/then";
      check_cushions(then->cushions_of(n), boundary, path + "/cushions");
    }
  const std::vector<AimPoint> aim_points = p.others.empty() ? aim_points_of(p.target, boundary) : aim_points_of(p);
  if (aim_points.empty())
    fail(path + "/pocket", p.table.pockets.empty() ? "this table has no pockets" : "there is no pocket of that number");
  for (const AimPoint& aim_point : aim_points) {
    if (aim_point.captures()) continue;
    const std::optional<Boundary> own =
        aim_point.ball == 0
            ? std::nullopt
            : std::optional(Boundary(p.table, p.others[static_cast<std::size_t>(aim_point.ball) - 1].body));
    check_inside(own ? *own : boundary, aim_point.at, path + "/point", "the centre of a ball at the target");
    if (!(aim_point.reach > 0)) fail(path + "/within", "must be greater than 0");
  }
}

/// Checks that the cue ball comes to rest after it has touched another ball.
void check_may_rest(const Puzzle& p, const std::string& path) {
  if (!is_ball(p.target))
    fail(path, "is where the cue ball rests after it has touched another, and no ball is the target");
  if (is_ideal(p.physics)) fail(path, "in ideal physics no ball comes to rest");
}

void check_order(const Puzzle& p, const PottingOrder& order, const std::string& path) {
  if (order.empty()) fail(path, "must name a ball");
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i].empty()) fail(at(path, i), "must name a ball");
    for (const int ball : order[i]) check_number(p, ball, at(path, i));
  }
  if (p.table.pockets.empty()) fail(path, "is of balls to pot, and this table has no pockets");
}

void check_leave(const Puzzle& p, const Boundary& boundary) {
  check_may_rest(p, "/leave");
  if (p.rest_near) fail("/prefer/leave", "stands beside \"leave\", which says where the cue ball is to rest");
  if (const LeavePlace* const place = std::get_if<LeavePlace>(&*p.leave)) {
    check_inside(boundary, place->at, "/leave/point", "the centre of the cue ball");
    if (!(place->within > 0)) fail("/leave/within", "must be greater than 0");
  }
  if (const auto* region = std::get_if<LeaveRegion>(&*p.leave)) {
    constexpr std::size_t fewest = 3;
    if (region->vertices.size() < fewest) fail("/leave/polygon", "must have at least 3 vertices");
    for (std::size_t i = 0; i < region->vertices.size(); ++i) {
      need_finite(region->vertices[i].x, at("/leave/polygon", i));
      need_finite(region->vertices[i].y, at("/leave/polygon", i));
    }
    for (const Wall& wall : boundary.walls)
      if (p.table.is_rectangle() &&
          std::ranges::all_of(region->vertices, [&](const Vec2d& v) { return dot(wall.normal, v) < wall.offset; }))
        fail("/leave/polygon", "lies where no cue ball can be: beyond a cushion");
  }
  if (const auto* next = std::get_if<LeaveForNext>(&*p.leave))
    check_order(p, next->order, p.game ? "/target/order" : "/leave/for");
  if (const auto* against = std::get_if<LeaveAgainst>(&*p.leave)) check_order(p, against->order, "/leave/against");
  if (const auto* safe = std::get_if<LeaveSafe>(&*p.leave)) {
    if (safe->balls.empty()) fail("/leave/safe", "must name a ball");
    for (std::size_t i = 0; i < safe->balls.size(); ++i) check_number(p, safe->balls[i], at("/leave/safe", i));
  }
}

}  // namespace

void validate(const Puzzle& p) {
  const Boundary boundary = check_scene(p.table, p.ball, p.physics);
  check_others(p.table, boundary, p.ball, p.others, p.physics);
  if (carries_spin(p.physics) && !p.spin_range) check_tip(p.spin, p.ball.body);
  if (p.in_hand && !may_place(p, boundary, p.ball.at)) fail("/ball/at", "is no place where the cue ball may be put");
  check_target(p, boundary);
  check_cushions(p.cushions, boundary, "/cushions");
  check_range(p.speed, "/speed");
  if (!(p.speed.high > 0)) fail("/speed", "0 must be greater than 0");
  if (p.arrive) {
    check_range(*p.arrive, "/arrive/speed");
    if (p.speed.fixed())
      fail("/arrive", "the launch speed is fixed, so the speed at the target cannot be asked as well");
    const Range speeds = ideal_speeds(p);
    if (is_ideal(p.physics) && !(speeds.low <= speeds.high && speeds.high > 0))
      fail("/arrive/speed", speeds.high > 0
                                ? "in ideal physics a ball keeps its speed, and none asked here is within \"speed\""
                                : "in ideal physics no ball comes to rest");
  }
  if (p.rest_near) {
    check_may_rest(p, "/prefer/leave");
    check_inside(boundary, *p.rest_near, "/prefer/leave", "the centre of the cue ball");
  }
  if (p.leave) check_leave(p, boundary);
  if ((p.noise.side > 0 || p.noise.top > 0 || p.noise.tip > 0) && !carries_spin(p.physics))
    fail(p.noise.side > 0  ? "/noise/side"
         : p.noise.top > 0 ? "/noise/top"
                           : "/noise/tip",
         "needs the physics \"spin\": in \"ideal\" and \"rolling\" the ball rolls from the start");
  if (p.angle && !(p.angle->low <= p.angle->high && std::isfinite(p.angle->high)))
    fail("/angle", "must be a finite range");
}

void validate(const Launch& launch, const LaunchSpin& spins) {
  check_speed(launch.speed, "/shot/speed");
  need_finite(launch.angle, "/shot/angle");
  for (const double spin : {spins.top, spins.side, spins.masse})
    if (!(std::abs(spin) * launch.speed <= tolerance::fastest))
      fail("/shot/spin", fmt::format("{} times {} m/s is too fast to compute with; at most {:g} m/s", spin,
                                     launch.speed, tolerance::fastest));
}

void validate(const ShotRequest& s) {
  const Boundary boundary = check_scene(s.table, s.ball, s.physics);
  check_others(s.table, boundary, s.ball, s.others, s.physics);
  validate(s.launch, s.spin);
}

}  // namespace bankshot
