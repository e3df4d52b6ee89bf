// SPDX-License-Identifier: MIT
#include "support/nearness.hpp"

#include <algorithm>
#include <limits>

namespace bankshot::test {
namespace {

/// Searches each of a few pieces of an arc by ternary search.
double nearest_on(const Arc<double>& arc, double end, const Vec2d& place) {
  constexpr int pieces = 8, steps = 60;
  const auto off = [&](double s) { return norm(arc.position(s) - place); };
  double least = std::min(off(0), off(end));
  for (int i = 0; i < pieces; ++i) {
    double low = end * i / pieces, high = end * (i + 1) / pieces;
    for (int k = 0; k < steps; ++k) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (off(a) < off(b) ? high : low) = off(a) < off(b) ? b : a;
    }
    least = std::min(least, off(low));
  }
  return least;
}

}  // namespace

double nearest_on(const Trajectory& t, const Vec2d& place, double until) {
  double least = std::numeric_limits<double>::infinity();
  for (const Leg& leg : t.legs) {
    if (leg.ball != 0 || !(leg.begin < until)) continue;
    const double end = std::min({leg.duration, leg.arc.parameter(until - leg.begin), 1e4});
    least = std::min(least, nearest_on(leg.arc, end, place));
  }
  return least;
}

}  // namespace bankshot::test
