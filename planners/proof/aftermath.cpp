// SPDX-License-Identifier: MIT
#include "planners/proof/aftermath.hpp"

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::planning {

void add_aftermath(const Question& q, Ledger& ledger, Shot& shot) {
  const Puzzle& p = q.puzzle;
  const bool rests = !is_ideal(p.physics);
  if (shot.hits.empty() || (p.table.pockets.empty() && !rests)) return;
  ledger.charge(0);
  const Starts starts({.table = p.table,
                       .physics = p.physics,
                       .ball = p.ball,
                       .others = p.others,
                       .launch = shot.launch,
                       .spin = q.spin});
  const long most = rests ? max_events : ideal_cushions;
  with_physics(p.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(starts.balls(), motion, cushion, collisions(p.physics));
    bool over = false;
    for (long i = 0; i < most && sim.in_play(0) && !over; ++i) over = sim.step().event.kind == EventKind::horizon;
    shot.scratch = !sim.in_play(0);
    if (rests && over && !shot.scratch) shot.cue_rests = sim.state(0).at;
  });
}

}  // namespace bankshot::planning
