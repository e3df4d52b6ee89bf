// SPDX-License-Identifier: MIT
#include "sim/simulate/path_length.hpp"

#include <cmath>

#include "bankshot/detail/roots/roots.hpp"

namespace bankshot {

double length(const Arc<double>& arc, double t) {
  const double a = norm(arc.acceleration);
  if (!arc.bends || a == 0) return norm(arc.position(t) - arc.at);
  const double across = std::abs(cross(arc.acceleration, arc.velocity)) / a, across2 = across * across,
               begin = dot(arc.acceleration, arc.velocity) / a, end = begin + a * t, slow = std::hypot(begin, across),
               fast = std::hypot(end, across);
  if (!(slow + fast > 0)) return 0;
  const double part = begin * ((begin + end) / (slow + fast));
  const double turned = across2 > 0 ? across2 / a * std::asinh(a * t * (slow - part) / across2) : 0;
  return (t * (fast + part) + turned) / 2;
}

namespace {

/// Returns the time at which a ball on this arc has covered `metres`; forever if that is beyond the arc's end.
double time_to_length(const Arc<double>& arc, double duration, double metres) {
  double low = 0, high = duration;
  if (!(length(arc, high) > metres)) return forever;
  if (!arc.bends) return arc.seconds(detail::time_at_length(arc, metres));
  for (double t = low + (high - low) / 2; t > low && t < high; t = low + (high - low) / 2)
    (length(arc, t) < metres ? low : high) = t;
  return high;
}

}  // namespace

double time_to_length(std::span<const Leg> legs, double metres) {
  for (const Leg& leg : legs) {
    const double t = time_to_length(leg.arc, leg.duration, metres);
    if (t < forever) return leg.begin - legs.front().begin + t;
    metres -= length(leg.arc, leg.duration);
  }
  return forever;
}

}  // namespace bankshot
