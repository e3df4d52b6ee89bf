// SPDX-License-Identifier: MIT
#include "planners/verify/in_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bankshot::planning {
namespace {

/// A circle as seen from a point.
struct Seen {
  Vec2d to;  ///< from the point to its centre
  double radius;
  double middle, half;  ///< rad: its directions, from that of the ball that is looked for

  /// Returns the distance to it in a direction; infinite if it is not met there.
  double distance(double turn) const {
    if (!(std::abs(turn - middle) < half)) return std::numeric_limits<double>::infinity();
    const double away = norm(to), along = away * std::cos(turn - middle), beside = away * std::sin(turn - middle);
    return along - std::sqrt(std::max(0.0, radius * radius - beside * beside));
  }
};

}  // namespace

bool in_sight(const Vec2d& from, const Circle& ball, std::span<const Circle> others) {
  const Vec2d way = ball.centre - from;
  const auto turn_of = [&](const Vec2d& to) { return std::atan2(cross(way, to), dot(way, to)); };
  const auto seen = [&](const Circle& circle) {
    const Vec2d to = circle.centre - from;
    return Seen{to, circle.radius, turn_of(to), std::asin(std::min(1.0, circle.radius / norm(to)))};
  };
  const Seen wanted = seen(ball);
  std::vector<Seen> before;
  std::vector<double> edges{-wanted.half, wanted.half};
  const auto add_edge = [&](double turn) {
    if (std::abs(turn) < wanted.half) edges.push_back(turn);
  };
  for (const Circle& circle : others) {
    const Seen other = seen(circle);
    const double apart = norm(other.to - way);
    if (std::abs(other.middle) > wanted.half + other.half) continue;
    before.push_back(other);
    add_edge(other.middle - other.half);
    add_edge(other.middle + other.half);
    // Both are touched at once in the points in which the circles cross.
    if (!(apart > std::abs(wanted.radius - other.radius)) || apart >= wanted.radius + other.radius) continue;
    const Vec2d across = (other.to - way) / apart;
    const double along = (apart * apart + wanted.radius * wanted.radius - other.radius * other.radius) / (2 * apart);
    const double beside = std::sqrt(std::max(0.0, wanted.radius * wanted.radius - along * along));
    for (const double side : {-beside, beside}) add_edge(turn_of(way + across * along + perpendicular(across) * side));
  }
  std::ranges::sort(edges);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const double turn = (edges[i - 1] + edges[i]) / 2, distance = wanted.distance(turn);
    if (std::ranges::none_of(before, [&](const Seen& other) { return other.distance(turn) < distance; })) return true;
  }
  return false;
}

}  // namespace bankshot::planning
