// SPDX-License-Identifier: MIT
#include "bankshot/geometry/aim_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

namespace {

AimPoint aim_point_of(const Circle& ball, const BallTarget& asked) {
  const auto offset = [&](double at) { return -ball.radius * std::sin(std::clamp(at, -any_touch, any_touch)); };
  const double cut = asked.exact_cut(), within = asked.cut_within();
  return {.at = ball.centre,
          .reach = ball.radius,
          .taken_by = ball.contact,
          .cuts = Cuts{offset(cut + within), offset(cut), offset(cut - within)}};
}

}  // namespace

std::vector<AimPoint> aim_points_of(const Target& target, const Boundary& boundary) {
  if (const BallTarget* const asked = touch_of(target)) {
    std::vector<AimPoint> aim_points;
    for (const int k : asked->balls) aim_points.push_back(aim_point_of(*boundary.rim(Contact::ball(k)), *asked));
    return aim_points;
  }
  if (const auto* point = std::get_if<PointTarget>(&target)) return {{point->at, point->within}};
  const auto& wanted = std::get<PocketTarget>(target).pocket;
  std::vector<AimPoint> aim_points;
  for (const Circle& pocket : boundary.pockets) {
    if (wanted && pocket.contact.index != *wanted) continue;
    for (const Opening& opening : openings(boundary, pocket))
      aim_points.push_back(
          {.at = pocket.centre, .reach = pocket.radius, .taken_by = pocket.contact, .opening = opening});
  }
  return aim_points;
}

double AimPoint::apart(const Vec2d& arrived) const {
  const double off = norm(arrived - at);
  if (cuts) return std::abs(off - reach);
  return drops() ? opening.distance(arrived - at) : off;
}

std::vector<AimPoint> aim_points_of(const Puzzle& p) {
  const Then* const then = then_of(p.target);
  if (!then) return aim_points_of(p.target, Boundary(p.table, p.ball.body, p.others));
  const Target target = std::visit([](const auto& t) { return Target(t); }, then->target);
  std::vector<AimPoint> all;
  for (const int k : then->links.empty() ? touched_first(p.target) : std::vector{then->links.back().ball}) {
    const Body& body = p.others[static_cast<std::size_t>(k) - 1].body;
    for (AimPoint aim_point : aim_points_of(target, Boundary(p.table, body, p.others, std::array{k}))) {
      aim_point.ball = k;
      all.push_back(aim_point);
    }
  }
  return all;
}

}  // namespace bankshot
