// SPDX-License-Identifier: MIT
#include "planners/proof/aftermath.hpp"

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::planning {

bool scratches(const Question& q, Ledger& ledger, const Launch& launch) {
  const Puzzle& p = q.puzzle;
  if (p.table.pockets.empty()) return false;
  ledger.charge(0);
  const Starts starts(
      {.table = p.table, .physics = p.physics, .ball = p.ball, .others = p.others, .launch = launch, .spin = q.spin});
  const long most = is_ideal(p.physics) ? ideal_cushions : max_events;
  return with_physics(p.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(starts.balls(), motion, cushion, collisions(p.physics));
    for (long i = 0; i < most && sim.in_play(0); ++i)
      if (sim.step().event.kind == EventKind::horizon) break;
    return !sim.in_play(0);
  });
}

}  // namespace bankshot::planning
