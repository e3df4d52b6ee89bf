// SPDX-License-Identifier: MIT
//
// The two searches in one dimension that planners use. Neither counts what it costs: whoever evaluates does.
//   bisect   moves together two numbers, one where something holds and one where it does not
//   climb    golden sections (Kiefer 1953): three numbers of which the middle one is best close in on a maximum
#pragma once

#include <cmath>

namespace bankshot::planning {

inline double arithmetic_mean(double a, double b) { return a + (b - a) / 2; }
inline double geometric_mean(double a, double b) { return std::sqrt(a * b); }

/// `holds` at `inside`, not at `outside`, which may lie on either side. Goes on while `wide(inside, outside)` and
/// numbers are left between them.
template <class Wide, class Holds>
void bisect(double& inside, double& outside, Wide&& wide, Holds&& holds,
            double (*mean)(double, double) = arithmetic_mean) {
  while (wide(inside, outside)) {
    const double middle = mean(inside, outside);
    if (middle == inside || middle == outside) return;
    (holds(middle) ? inside : outside) = middle;
  }
}

/// `Point` has the members `x` and `value`; `low.x <= best.x <= high.x` and best.value is the largest.
/// `attempt(x, best)` makes a Point. Ends when the ends are `finest` apart, or `settled(low, best, high)`.
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
