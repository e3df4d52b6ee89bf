// SPDX-License-Identifier: MIT
#include "planners/problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

Physics roughly(Physics p) {
  if (double* const error = impact_tolerance(p.cushion)) *error = std::max(*error, tolerance::rough_impact);
  return p;
}

/// Returns the cushions and vertices that a ball touches.
std::vector<Contact> touched_by(const Boundary& boundary, const Vec2d& at) {
  const double slack = boundary.touch;
  std::vector<Contact> out;
  for (const Wall& w : boundary.walls) {
    const double s = dot(w.along, at);
    if (std::abs(dot(w.normal, at) - w.offset) <= slack && s >= w.begin - slack && s <= w.end + slack &&
        boundary.break_at(w, s) < 0)
      out.push_back(w.contact);
  }
  for (const Circle& tip : boundary.tips)
    if (norm(at - tip.centre) - tip.radius <= slack) out.push_back(tip.contact);
  return out;
}

/// Returns the scene without a launch.
ShotRequest scene_of(const Puzzle& p) {
  return {.table = p.table, .physics = p.physics, .ball = p.ball, .others = p.others};
}

}  // namespace

Objects::Objects(const Puzzle& p) {
  const Then* const then = then_of(p.target);
  const auto object_of = [&](int k) {
    const auto known = std::ranges::find(all, k, &Object::ball);
    if (known != all.end()) return &*known;
    const Ball& ball = p.others[static_cast<std::size_t>(k) - 1];
    all.push_back({k, ball, Boundary(p.table, ball.body, p.others, std::array{k})});
    standing.push_back({k, &all.back().own, ball.at});
    return &all.back();
  };
  for (const int first : touched_first(p.target)) {
    std::vector<int> numbers{first};
    if (then)
      for (const Link& link : then->links) numbers.push_back(link.ball);
    Chain& chain = chains.emplace_back();
    chain.moving.emplace_back(p.table, p.ball.body, p.others, numbers);
    for (const int k : numbers) {
      chain.balls.push_back(object_of(k));
      chain.moving.emplace_back(p.table, chain.balls.back()->at_rest.body, p.others, numbers);
    }
  }
}

const Objects::Chain* Objects::chain_by(int ball) const {
  const auto chain = std::ranges::find(chains, ball, [](const Chain& c) { return c.balls.front()->ball; });
  return chain == chains.end() ? nullptr : &*chain;
}

Problem::Problem(const Puzzle& p)
    : puzzle(p),
      boundary(p.table, p.ball.body, p.others),
      cleared(p.others.empty() ? std::nullopt : std::optional(Boundary(p.table, p.ball.body))),
      objects(goes_on_after_contact(p.target) ? std::make_shared<const Objects>(p) : nullptr),
      whole(is_ball(p.target) ? std::make_shared<const Starts>(scene_of(p)) : nullptr),
      rough(roughly(p.physics)),
      aim_points(then_of(p.target) ? aim_points_of(p) : aim_points_of(p.target, boundary)),
      touched(touched_by(boundary, p.ball.at)) {}

const AimPoint& Problem::nearest_aim_point(const Vec2d& arrived, int ball) const {
  // Aim points of the ball come before all others.
  const auto rank = [&](const AimPoint& p) { return std::pair(p.ball != ball, p.apart(arrived)); };
  return *std::ranges::min_element(aim_points, {}, rank);
}

const AimPoint* Problem::aim_point_taken_by(Contact contact, const Vec2d& arrived, int ball) const {
  const AimPoint* best = nullptr;
  for (const AimPoint& aim_point : aim_points)
    if (aim_point.taken_by == contact && aim_point.ball == ball &&
        (!best || aim_point.apart(arrived) < best->apart(arrived)))
      best = &aim_point;
  return best;
}

bool Problem::keeps_cushions(std::span<const ObjectBallPath> sent) const {
  return sent.empty() || static_cast<int>(sent.back().cushions.size()) <= then()->cushions_of(then()->links.size()).max;
}

Contact Problem::covering() const {
  const auto covers = [&](const Circle& ball) {
    return !captures() && !objects && norm(aim_points.front().at - ball.centre) < ball.radius - boundary.touch;
  };
  const auto ball = std::ranges::find_if(boundary.balls, covers);
  return ball == boundary.balls.end() ? Contact{} : ball->contact;
}

bool Problem::centred(double miss) const { return miss <= tolerance::exact_miss * boundary.diagonal; }

bool Problem::into_touched_cushion(double launch_angle) const {
  if (touched.empty()) return false;
  const Vec2d towards = direction(launch_angle);
  return std::ranges::any_of(
      touched, [&](Contact contact) { return dot(boundary.normal(contact, puzzle.ball.at), towards) < 0; });
}

std::vector<double> Problem::along_touched_cushions() const {
  std::vector<double> angles;
  for (const Wall& wall : boundary.walls)
    if (touches(wall.contact))
      for (const Vec2d& way : {wall.along, -wall.along})
        angles.push_back(wrap_angle(std::atan2(way.y + 0.0, way.x)));  // + 0: -0 is no angle
  return angles;
}

Route route_with_jaws_of(const Shot& shot) {
  return shot.path.touches_jaws && shot.path.then.empty() ? route_by(shot.path.met) : route_of(shot);
}

Route route_of(const Shot& shot) {
  Route route = route_by(shot.path.cushions);
  if (shot.path.then.empty() && shot.path.hits.size() > 1)  // the last hit is the target's
    for (const Hit& hit : std::span(shot.path.hits).first(shot.path.hits.size() - 1))
      route.insert(route.begin() + hit.after, {0, Contact::ball(hit.ball)});
  int by = 0;
  for (const ObjectBallPath& path : shot.path.then) {
    route.push_back({by, Contact::ball(path.ball)});
    by = path.ball;
    for (const Contact contact : path.cushions) route.push_back({by, contact});
  }
  return route;
}

double angle_difference(double a, double b) { return wrap_angle(b - a + radians(180)) - radians(180); }

}  // namespace bankshot::planning
