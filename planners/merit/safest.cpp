// SPDX-License-Identifier: MIT
#include "planners/merit/safest.hpp"

#include <algorithm>
#include <optional>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/certify.hpp"
#include "planners/merit/first_order.hpp"
#include "planners/merit/room.hpp"
#include "planners/merit/settings.hpp"
#include "planners/merit/success.hpp"
#include "planners/proof/aftermath.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

/// The same shot with another launch; none where it is not made, or where the budget ends.
std::optional<Shot> moved(const Question& q, Ledger& ledger, const Shot& from, const Launch& to) {
  if (!(to.speed > 0)) return {};
  Proof proof = prove(q, ledger, to, Goal::along(from));
  if (!proof.holds()) return {};
  Shot& shot = proof.shot;
  add_aftermath(q, ledger, shot);
  shot.planner = from.planner;
  shot.simulations = from.simulations;
  add_first_order(q, shot);
  shot.digits = promised_digits(q, shot);
  find_success(q, ledger, shot);
  if (ledger.spent()) return {};  // its success may have been cut short
  return std::move(shot);
}

/// The turn of the aim that leads to the middle of what the pocket offers in the shot's direction, to first order; 0 of
/// a point.
double turn_to_middle(const Question& q, const Shot& shot) {
  const double by_aim = norm(shot.by_angle);
  if (!q.captures() || !(by_aim > 0)) return 0;
  const Gap<double> room = room_beside(q, shot, shot.by_angle / by_aim);
  return (room.low + room.high) / 2 / by_aim;
}

}  // namespace

void make_safest(const Question& q, Ledger& ledger, Shot& shot) {
  using namespace settings::safest;
  if (!shot.success) find_success(q, ledger, shot);
  if (ledger.spent()) return shot.success.reset();
  const Launch middle{shot.launch.speed, wrap_angle(shot.launch.angle + turn_to_middle(q, shot))};
  if (auto start = moved(q, ledger, shot, middle); start && *start->success > *shot.success) shot = std::move(*start);
  const Noise& noise = q.puzzle.noise;
  // Neither number of the player may be 0: a step must lead somewhere.
  const double least = tolerance::same_aim;
  double turn = std::max(noise.angle, least), push = is_ideal(q.puzzle.physics) ? 0 : std::max(noise.speed, least);
  for (int halved = 0, steps = 0; halved < halvings && steps < most_steps && !ledger.spent(); ++steps) {
    const Launch& at = shot.launch;
    const Launch around[] = {{at.speed, wrap_angle(at.angle + turn)},
                             {at.speed, wrap_angle(at.angle - turn)},
                             {at.speed + push, at.angle},
                             {at.speed - push, at.angle}};
    std::optional<Shot> best;
    for (const Launch& to : around) {
      auto next = moved(q, ledger, shot, to);
      if (next && *next->success > std::max(*shot.success, best ? *best->success : 0.0)) best = std::move(next);
    }
    if (best) {
      shot = std::move(*best);
    } else {
      turn /= 2, push /= 2;
      ++halved;
    }
  }
}

}  // namespace bankshot::planning
