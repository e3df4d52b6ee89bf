// SPDX-License-Identifier: MIT
//
// A ball that touches a cushion may run exactly along it. It meets other cushions then than at any aim
// beside, so no map of aims shows it; but the aim is known, and only the speed is looked for.
// Method: launches at even steps of ln speed, both ways along each cushion touched; from each that is nearer
// to what was asked than its neighbours a golden-section search, then a certificate. Cost: some 600
// simulations a cushion. Guarantee: none.
#include <algorithm>
#include <cmath>
#include <vector>

#include "planners/methods/methods.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

constexpr int steps = 300;

/// How far a launch is from what is asked, no unit: of the diagonal, and of the arrival speed.
double error(Search& s, const Launch& launch) {
  const Replay r = replay(s, launch, Goal::of(s));
  if (!r.made && r.failure.foul != Foul::missed) return 1;
  const double miss = r.miss / s.boundary.diagonal;
  return s.arrival && !s.stop ? miss + std::abs(r.arrival.speed - s.asked) / std::max(1.0, s.asked) : miss;
}

/// The speed of least error between two, one of them.
double least_between(Search& s, double angle, double low, double high) {
  constexpr double golden = 0.6180339887498949, settled = 1e-15;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = error(s, {a, angle}), at_b = error(s, {b, angle});
  while (high - low > settled * high && !s.spent()) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a, a = high - golden * (high - low);
      at_a = error(s, {a, angle});
    } else {
      low = a, a = b, at_a = at_b, b = low + golden * (high - low);
      at_b = error(s, {b, angle});
    }
    if (!(low < a && a < b && b < high)) break;
  }
  return at_a < at_b ? a : b;
}

void at_angle(Search& s, double angle) {
  const CushionRule& rule = s.puzzle.cushions;
  const auto certify_at = [&](double speed) {
    for (int n = rule.min; n <= rule.max && !s.spent(); ++n) certify(s, {speed, angle}, n, "along");
  };
  if (s.one_unknown()) return certify_at(fixed_speed(s));
  const Range& v = s.puzzle.speed;
  const double low = std::max(v.low, 1e-3 * v.high);
  std::vector<double> speeds, errors;
  for (int i = 0; i <= steps && !s.spent(); ++i) {
    speeds.push_back(low * std::pow(v.high / low, static_cast<double>(i) / steps));
    errors.push_back(error(s, {speeds.back(), angle}));
  }
  for (std::size_t i = 0; i < errors.size() && !s.spent(); ++i) {
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, errors.size() - 1);
    if (errors[i] < 1 && errors[i] <= errors[before] && errors[i] <= errors[after])
      certify_at(least_between(s, angle, speeds[before], speeds[after]));
  }
}

}  // namespace

void along_touched(Search& s) {
  for (const Wall& w : s.boundary.walls) {
    if (!s.touches(w.contact)) continue;
    for (const Vec2d& way : {w.along, -w.along})
      if (!s.spent() && !s.satisfied()) at_angle(s, wrap_angle(std::atan2(way.y + 0.0, way.x)));  // + 0: -0 is no angle
  }
}

}  // namespace bankshot::planning
