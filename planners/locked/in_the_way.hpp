// SPDX-License-Identifier: MIT
//
// What a leg of a locked path, which sees cushions only, must keep from.
#pragma once

#include "bankshot/geometry/boundary.hpp"

namespace bankshot::planning {

/// What is round and must not be touched between two meetings of a ball: `f(circle)` of each. `next`: none on the last
/// leg, which ends at the pocket or ball that takes it.
template <class F>
void each_in_the_way(const Boundary& boundary, Contact before, Contact next, Contact taken_by, F&& f) {
  const Contact end = next ? next : taken_by;
  for (const Circle& pocket : boundary.pockets)
    if (pocket.contact != end) f(pocket);
  for (const Circle& tip : boundary.tips)
    if (tip.contact != before && tip.contact != end) f(tip);
  for (const Circle& ball : boundary.balls)
    if (ball.contact != end) f(ball);
}

}  // namespace bankshot::planning
