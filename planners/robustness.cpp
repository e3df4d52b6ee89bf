// SPDX-License-Identifier: MIT
#include "planners/robustness.hpp"

#include <algorithm>
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

}  // namespace

double angle_difference(double a, double b) { return wrap_angle(b - a + radians(180)) - radians(180); }

void find_margin(Search& s, Shot& shot) {
  Goal goal = Goal::exactly(s, static_cast<int>(shot.cushions.size()));
  goal.sequence = &shot.cushions;
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
  // The R2 sequence (Roberts 2018, plastic number), turned normal by Box and Muller's map.
  constexpr double plastic = 1.32471795724474602596;
  const Goal goal = Goal::of(s);
  double a = 0.5, b = 0.5;
  int made = 0;
  for (int i = 0; i < success_samples; ++i) {
    a = std::fmod(a + 1 / plastic, 1.0);
    b = std::fmod(b + 1 / (plastic * plastic), 1.0);
    const double r = std::sqrt(-2 * std::log(1 - a)), turn = radians(360) * b;
    const double speed = shot.launch.speed + s.puzzle.noise.speed * r * std::cos(turn);
    const double angle = shot.launch.angle + s.puzzle.noise.angle * r * std::sin(turn);
    if (speed > 0 && replay(s, {speed, wrap_angle(angle)}, goal).made) ++made;
  }
  shot.success = static_cast<double>(made) / success_samples;
}

}  // namespace bankshot::planning
