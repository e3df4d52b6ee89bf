// SPDX-License-Identifier: MIT
//
// The one-dimensional searches that planners use. None counts its evaluations; the function that evaluates does.
//   bisect          moves two numbers together, one where something holds and one where it does not
//   climb           golden sections (Kiefer 1953): three numbers, the middle one the best, close in on a maximum
//   false_position  (Illinois; Dowell & Jarratt 1971) two numbers between which a function changes its sign
#pragma once

#include <cmath>

namespace bankshot::planning {

inline double arithmetic_mean(double a, double b) { return a + (b - a) / 2; }

/// Moves `inside`, where `holds` is true, and `outside`, where it is not, together; either may be the larger. It
/// continues while `wide(inside, outside)` and numbers are left between them.
template <class Wide, class Holds>
void bisect(double& inside, double& outside, Wide&& wide, Holds&& holds) {
  while (wide(inside, outside)) {
    const double middle = arithmetic_mean(inside, outside);
    if (middle == inside || middle == outside) return;
    (holds(middle) ? inside : outside) = middle;
  }
}

/// Returns a number between a and b where `value` is within `enough` of 0. It stops early after `most` evaluations, or
/// where `value`, an optional number, has none. If the same end stays twice, its value is halved.
template <class Value>
double false_position(double a, double at_a, double b, double at_b, double enough, int most, Value&& value) {
  double middle = a;
  for (int i = 0; i < most; ++i) {
    middle = at_a == at_b ? (a + b) / 2 : a + (b - a) * at_a / (at_a - at_b);
    const auto there = value(middle);
    if (!there || std::abs(*there) < enough) break;
    if ((*there > 0) == (at_b > 0))
      at_a /= 2;
    else
      a = b, at_a = at_b;
    b = middle, at_b = *there;
  }
  return middle;
}

/// Finds a maximum. `Point` has the members `x` and `value`; `low.x <= best.x <= high.x` and best.value is the largest.
/// `attempt(x, best)` makes a Point. The search ends when the ends are `finest` apart, or `settled(low, best, high)`.
template <class Point, class Attempt, class Settled>
Point climb(Point low, Point best, Point high, double finest, Attempt&& attempt, Settled&& settled) {
  constexpr double golden = 0.3819660112501051;  // (3 − √5) / 2
  while (high.x - low.x > finest && !settled(low, best, high)) {
    const bool up = high.x - best.x > best.x - low.x;
    const Point next = attempt(best.x + golden * ((up ? high : low).x - best.x), best);
    if (next.value > best.value) {
      (up ? low : high) = best;
      best = next;
    } else {
      (up ? high : low) = next;
    }
  }
  return best;
}

}  // namespace bankshot::planning
