// SPDX-License-Identifier: MIT
#include "planners/robustness.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "bankshot/tolerances.hpp"
#include "planners/verify.hpp"

namespace bankshot::planning {
namespace {

constexpr double widest_angle = radians(180);
constexpr double widest_speed = 30;  // m/s

/// The largest step, up to `limit`, such that `made` holds all the way; none when it never breaks.
/// A gap in between narrower than a quarter of the step so far can be stepped over.
template <class Made>
std::optional<double> how_far(double scale, double limit, Made&& made) {
  double good = 0, step = std::min(scale / 4, limit);
  while (made(step)) {
    if (step >= limit) return {};
    good = step;
    step = std::min(1.25 * step, limit);
  }
  while (step - good > tolerance::margin * step && step > 1e-15) {
    const double middle = good + (step - good) / 2;
    (made(middle) ? good : step) = middle;
  }
  return good;
}

using Quantiles = std::array<double, success_samples>;

double normal_below(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

/// Of the normal distribution, at (i + 1/2) / n, by Newton's method.
Quantiles quantiles() {
  Quantiles z{};
  constexpr double pi = radians(180);
  for (std::size_t i = 0; i < success_samples; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / success_samples;
    constexpr int enough = 60;
    for (int k = 0; k < enough; ++k) {
      const double density = std::exp(-z[i] * z[i] / 2) / std::sqrt(2 * pi);
      const double step = (normal_below(z[i]) - p) / density;
      z[i] -= std::clamp(step, -0.5, 0.5);
    }
  }
  return z;
}

/// The shot to first order: made where |at + a·by_angle + b·by_speed| <= reach, a and b in standard
/// deviations of the player. Its chance is known; sampling only has to find what it gets wrong
/// (a control variate).
class LinearModel {
 public:
  LinearModel(const Search& s, const Shot& shot)
      : a_(shot.by_angle * s.puzzle.noise.angle), b_(shot.by_speed * s.puzzle.noise.speed), reach_(s.nearest_reach(shot.arrival.at)) {
    at_ = shot.arrival.at - s.nearest_aim_point(shot.arrival.at);
    if (s.stop) return;
    // Only what lies across the line of travel is a miss.
    const double size = norm(a_);
    const Vec2d across = size > 0 ? a_ / size : Vec2d{0, 0};
    at_ = across * dot(across, at_);
  }

  bool made(double a, double b) const { return norm(at_ + a_ * a + b_ * b) <= reach_; }

  /// Exact in the error that matters more, even steps of probability in the other.
  double chance(const Quantiles& normal) const {
    const bool speed_first = dot(b_, b_) > dot(a_, a_);
    const Vec2d &exact = speed_first ? b_ : a_, &stepped = speed_first ? a_ : b_;
    const double square = dot(exact, exact);
    if (!(square > 0)) return norm(at_) <= reach_ ? 1 : 0;
    double sum = 0;
    for (const double z : normal) {
      const Vec2d from = at_ + stepped * z;
      const double middle = -dot(from, exact) / square, beside = cross(from, exact);
      const double half2 = (reach_ * reach_ - beside * beside / square) / square;
      if (half2 > 0) sum += normal_below(middle + std::sqrt(half2)) - normal_below(middle - std::sqrt(half2));
    }
    return sum / success_samples;
  }

 private:
  Vec2d at_{}, a_, b_;
  double reach_;
};

}  // namespace

double angle_difference(double a, double b) { return wrap_angle(b - a + radians(180)) - radians(180); }

void find_margin(Search& s, Shot& shot) {
  const Goal goal = Goal::along(shot.cushions);
  const Launch& at = shot.launch;
  const auto made = [&](double speed, double angle) {
    return speed > 0 && replay(s, {speed, wrap_angle(angle)}, goal).made;
  };
  const double scale = s.nearest_reach(shot.arrival.at) / std::max(shot.condition, 1e-6 * s.boundary.diagonal);
  const auto negative = [](std::optional<double> v) { return v ? std::optional(-*v) : v; };
  Margin m;
  const double angle_scale = std::clamp(scale, 1e-12, 0.1);
  m.angle[0] = negative(how_far(angle_scale, widest_angle, [&](double d) { return made(at.speed, at.angle - d); }));
  m.angle[1] = how_far(angle_scale, widest_angle, [&](double d) { return made(at.speed, at.angle + d); });
  if (!is_ideal(s.puzzle.physics)) {
    const double speed_scale = std::clamp(scale, 1e-12, 0.1) * at.speed;
    m.speed[0] = negative(how_far(speed_scale, at.speed, [&](double d) { return made(at.speed - d, at.angle); }));
    m.speed[1] = how_far(speed_scale, widest_speed, [&](double d) { return made(at.speed + d, at.angle); });
  }
  shot.margin = m;
}

void find_success(Search& s, Shot& shot) {
  // The Fibonacci lattice (i/144, 89 i/144): even in both errors apart and together.
  constexpr std::size_t generator = 89;
  static const Quantiles normal = quantiles();
  const Goal goal = Goal::of(s);
  const LinearModel model(s, shot);
  int difference = 0;  // made, over what the linear model says of the same errors
  for (std::size_t i = 0; i < success_samples; ++i) {
    const double by_speed = normal[i * generator % success_samples], by_angle = normal[i];
    const double speed = shot.launch.speed + s.puzzle.noise.speed * by_speed, angle = shot.launch.angle + s.puzzle.noise.angle * by_angle;
    difference += speed > 0 && replay(s, {speed, wrap_angle(angle)}, goal).made;
    difference -= model.made(by_angle, by_speed);
  }
  shot.success = std::clamp(model.chance(normal) + static_cast<double>(difference) / success_samples, 0.0, 1.0);
}

}  // namespace bankshot::planning
