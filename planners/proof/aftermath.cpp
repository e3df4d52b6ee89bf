// SPDX-License-Identifier: MIT
#include "planners/proof/aftermath.hpp"

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "planners/start.hpp"

namespace bankshot::planning {

Aftermath aftermath(const Question& q, EvaluationBudget& budget, const Launch& launch) {
  const bool rests = !is_ideal(q.puzzle.physics);
  if (!q.whole || (q.puzzle.table.pockets.empty() && !rests)) return {};
  budget.charge(0);
  std::vector<BallStart<double>> balls(q.whole->balls().begin(), q.whole->balls().end());
  balls.front().state = start_of(q, launch);
  const long most = rests ? max_events : ideal_cushions;
  Aftermath out;
  with_physics(q.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(std::span<const BallStart<double>>(balls), motion, cushion, collisions(q.puzzle.physics));
    for (long i = 0; i < most; ++i) {
      const BallEvent e = sim.step();
      if (e.event.kind == EventKind::pocket && e.ball == 0) return void(out.scratch_pocket = e.event.contact.index);
      if (e.event.kind == EventKind::horizon) {
        if (rests) out.cue_rests = sim.state(0).at;
        return;
      }
    }
  });
  return out;
}

void add_aftermath(const Question& q, EvaluationBudget& budget, Shot& shot) {
  if (shot.hits.empty()) return;
  const Aftermath after = aftermath(q, budget, shot.launch);
  shot.scratch_pocket = after.scratch_pocket;
  shot.scratch = after.scratch_pocket.has_value();
  shot.cue_rests = after.cue_rests;
}

}  // namespace bankshot::planning
