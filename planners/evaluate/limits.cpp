// SPDX-License-Identifier: MIT
#include "planners/evaluate/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "planners/evaluate/settings.hpp"

namespace bankshot::planning {

using namespace settings::first_order;

void Limits::add(double room, const Vec2d& slope) { sides_.push_back({room, slope}); }

void Limits::rest(const Vec2<Dual<2>>& from_aim_point, double reach) {
  const Vec2d x = in_deviations(from_aim_point.x), y = in_deviations(from_aim_point.y);
  from_aim_point_ = {from_aim_point.x.a, from_aim_point.y.a};
  by_aim_ = {x.x, y.x};
  by_push_ = {x.y, y.y};
  reach_ = reach;
}

bool Limits::hold() const {
  const auto broken = [](const Side& side) { return !(side.room > 0); };
  return std::none_of(sides_.begin(), sides_.end(), broken) && !(reach_ > 0 && norm(from_aim_point_) > reach_);
}

double Limits::until_all_hold(const Vec2d& towards) const {
  double most = 0;
  for (const Side& side : sides_)
    if (const double gain = dot(side.slope, towards); side.room < 0 && gain > 0)
      most = std::max(most, -side.room / gain);
  if (!(reach_ > 0)) return most;
  // The near end of the line through the disc, or the nearest point of a line that misses the disc.
  const Vec2d move = by_aim_ * towards.x + by_push_ * towards.y;
  const double a = dot(move, move), b = -dot(move, from_aim_point_),
               c = dot(from_aim_point_, from_aim_point_) - reach_ * reach_;
  return c > 0 && b > 0 ? std::max(most, (b - std::sqrt(std::max(b * b - a * c, 0.0))) / a) : most;
}

double Limits::until(const Vec2d& towards) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Side& side : sides_) {
    const double loss = -dot(side.slope, towards);
    if (const double room = std::max(side.room, 0.0); room < least * loss) least = room / loss;
  }
  if (!(reach_ > 0)) return least;
  const Vec2d move = by_aim_ * towards.x + by_push_ * towards.y;
  const double a = dot(move, move), b = dot(move, from_aim_point_),
               c = std::max(reach_ * reach_ - dot(from_aim_point_, from_aim_point_), 0.0);
  const double root = std::sqrt(b * b + a * c);
  return std::min(least, b > 0 ? c / (b + root) : a > 0 ? (root - b) / a : least);
}

double Limits::success(const Vec2d& across, double half) const {
  const double stretch = std::min(half, 1.0);
  const double step = 2 * std::numbers::pi / directions, c1 = std::cos(step), s1 = std::sin(step);
  double c = std::cos(step / 2), s = std::sin(step / 2), sum = 0;
  for (int k = 0; k < directions; ++k) {
    const Vec2d towards = perpendicular(across) * c + across * (stretch * s);
    const double size2 = dot(towards, towards), rho = until(towards);
    sum -= stretch / size2 * std::expm1(-rho * rho * size2 / 2);
    const double next = c * c1 - s * s1;
    s = s * c1 + c * s1;
    c = next;
  }
  return std::min(sum / directions, 1.0);
}

double Limits::success() const {
  const Vec2d across =
      direction(std::atan2(2 * dot(by_aim_, by_push_), dot(by_aim_, by_aim_) - dot(by_push_, by_push_)) / 2);
  const double most = norm(by_aim_ * across.x + by_push_ * across.y),
               least = norm(by_push_ * across.x - by_aim_ * across.y);
  // A region that ends within a deviation both ways is stretched to a circle.
  return success(across, std::max(least, reach_) / most);
}

}  // namespace bankshot::planning
