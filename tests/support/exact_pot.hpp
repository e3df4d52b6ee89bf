// SPDX-License-Identifier: MIT
//
// Pots of ball 1 along the exact line into a pocket, for measurements of where they leave the cue ball.
#pragma once

#include <cmath>
#include <optional>

#include "planners/play/rest.hpp"
#include "planners/verify/prove.hpp"
#include "support/played.hpp"
#include "support/random_layout.hpp"

namespace bankshot::test {

/// Returns a random layout that asks for a pot of ball 1 into any pocket without cushions, beside so many other balls.
inline Puzzle random_pot(Random& random, int others) {
  Puzzle p = random_layout(random, others + 1);
  p.target = ObjectBallTarget{{1}, {.target = PocketTarget{}}};
  p.cushions = CushionRule::exactly(0);
  return p;
}

struct Struck {
  Launch launch;
  LaunchSpin spin;
};

/// Returns the launch of this speed and spin on the exact line into a mouth; none if there is none.
inline std::optional<Struck> exact_pot(const planning::SearchRequest& request, const AimPoint& mouth, double speed,
                                       const LaunchSpin& spin) {
  namespace branch = planning::branch;
  const Puzzle& p = request.puzzle();
  const Vec2d object = p.others[0].at, way = mouth.at - object;
  const Vec2d ghost = object - way * (2 * p.ball.body.radius / norm(way)), run = ghost - p.ball.at;
  const Route hit{{0, Contact::ball(1)}};
  planning::EvaluationBudget budget(1000000);
  const auto x = planning::play::on_target({request, hit, mouth}, budget, branch::box_of(request),
                                           branch::vector_of({speed, std::atan2(run.y, run.x)}, spin), 0);
  if (!x) return {};
  return Struck{branch::launch_of(*x), branch::spin_of(*x)};
}

/// Returns where an exact pot leaves the cue ball; none if the ball does not fall, meets a rail, a jaw or another ball
/// on its way, or the cue ball falls.
inline std::optional<Vec2d> rest_after_pot(const planning::SearchRequest& request, const Struck& struck) {
  const auto places = played(request.puzzle(), struck.launch, struck.spin);
  if (places[1] || !places[0]) return {};
  const planning::SearchRequest own = request.spinning(struck.spin);
  planning::EvaluationBudget budget(1000000);
  if (!planning::prove(own, budget, struck.launch, planning::Goal::of(own)).holds()) return {};
  return places[0];
}

}  // namespace bankshot::test
