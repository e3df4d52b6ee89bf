// SPDX-License-Identifier: MIT
#include "planners/merit/robustness.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/proof/prove.hpp"

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

}  // namespace bankshot::planning
