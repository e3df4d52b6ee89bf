// SPDX-License-Identifier: MIT
//
// The obstacles that a leg of a locked path must not touch. The locked path itself sees cushions only.
#pragma once

#include <algorithm>
#include <span>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/route.hpp"

namespace bankshot::planning {

/// Calls `f(circle)` for each round obstacle between two meetings of a ball. `before`: the meetings of the route so
/// far. `next`: the meeting that ends the leg; none on the last leg, which ends at the pocket or ball that takes it.
template <class F>
void each_in_the_way(const Boundary& boundary, std::span<const Meeting> before, Contact next, Contact taken_by, F&& f) {
  const Contact end = next ? next : taken_by, last = before.empty() ? Contact{} : before.back().with;
  // A ball that was touched has left its place.
  const auto gone = [&](Contact ball) { return std::ranges::count(before, ball, &Meeting::with) > 0; };
  for (const Circle& pocket : boundary.pockets)
    if (pocket.contact != end) f(pocket);
  for (const Circle& tip : boundary.tips)
    if (tip.contact != last && tip.contact != end) f(tip);
  for (const Circle& ball : boundary.balls)
    if (ball.contact != end && !gone(ball.contact)) f(ball);
}

}  // namespace bankshot::planning
