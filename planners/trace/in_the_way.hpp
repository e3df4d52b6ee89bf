// SPDX-License-Identifier: MIT
//
// What a leg of a locked path, which sees cushions only, must keep from.
#pragma once

#include <algorithm>
#include <span>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/route.hpp"

namespace bankshot::planning {

/// What is round and must not be touched between two meetings of a ball: `f(circle)` of each. `before`: of the route,
/// the meetings so far. `next`: none on the last leg, which ends at the pocket or ball that takes it.
template <class F>
void each_in_the_way(const Boundary& boundary, std::span<const Meeting> before, Contact next, Contact taken_by, F&& f) {
  const Contact end = next ? next : taken_by, last = before.empty() ? Contact{} : before.back().with;
  // A ball that was touched stands there no more.
  const auto gone = [&](Contact ball) { return std::ranges::count(before, ball, &Meeting::with) > 0; };
  for (const Circle& pocket : boundary.pockets)
    if (pocket.contact != end) f(pocket);
  for (const Circle& tip : boundary.tips)
    if (tip.contact != last && tip.contact != end) f(tip);
  for (const Circle& ball : boundary.balls)
    if (ball.contact != end && !gone(ball.contact)) f(ball);
}

}  // namespace bankshot::planning
