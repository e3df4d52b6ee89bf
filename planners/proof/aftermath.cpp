// SPDX-License-Identifier: MIT
#include "planners/proof/aftermath.hpp"

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"

namespace bankshot::planning {

Aftermath aftermath(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch) {
  const bool rests = !is_ideal(request.puzzle().physics);
  if (!request.problem->whole || (request.puzzle().table.pockets.empty() && !rests)) return {};
  budget.charge(0);
  std::vector<BallStart<double>> balls(request.problem->whole->balls().begin(), request.problem->whole->balls().end());
  balls.front().state = start_of(request, launch);
  const long most = rests ? max_events : ideal_cushions;
  Aftermath out;
  with_physics(request.puzzle().physics, [&](const auto& motion, const auto& cushion) {
    ManyBalls sim(std::span<const BallStart<double>>(balls), motion, cushion, collisions(request.puzzle().physics));
    bool over = false;
    for (long i = 0; i < most && !over; ++i) {
      const BallEvent e = sim.step();
      const bool scratch = e.event.kind == EventKind::pocket && e.ball == 0;
      over = scratch || e.event.kind == EventKind::horizon;
      if (scratch) out.scratch_pocket = e.event.contact.index;
      if (over && !scratch && rests) out.cue_rests = sim.state(0).at;
    }
    budget.work() += sim.work();
  });
  return out;
}

void add_aftermath(const SearchRequest& request, EvaluationBudget& budget, Shot& shot) {
  if (shot.path.hits.empty()) return;
  const Aftermath after = aftermath(request, budget, shot.launch);
  shot.path.scratch_pocket = after.scratch_pocket;
  shot.path.scratch = after.scratch_pocket.has_value();
  shot.path.cue_rests = after.cue_rests;
}

}  // namespace bankshot::planning
