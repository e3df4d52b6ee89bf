// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

/// Brings a number that rounding carried just outside its bounds back in; returns false if it lies farther out.
inline bool bring_inside(double& v, const Range& r) {
  const double slack = tolerance::bound * std::max(1.0, std::abs(r.high));
  if (v < r.low - slack || v > r.high + slack) return false;
  v = std::clamp(v, r.low, r.high);
  return true;
}

/// Brings an aim inside its bounds likewise, whichever full turn the bounds are in.
inline bool inside_aims(double& angle, const std::optional<Range>& bounds) {
  if (!bounds) return true;
  constexpr double turn = radians(360);
  for (double a : {angle, angle + turn, angle - turn})
    if (bring_inside(a, *bounds)) return angle = wrap_angle(a), true;
  return false;
}

}  // namespace bankshot::planning
