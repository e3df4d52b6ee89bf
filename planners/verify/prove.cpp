// SPDX-License-Identifier: MIT
#include "planners/verify/prove.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/verify/bounds.hpp"

namespace bankshot::planning {
namespace {

bool fast_as_asked(const SearchRequest& request, double arrival_speed) {
  if (!request.arrival || request.stop) return true;
  const double slack = tolerance::exact_speed * std::max(1.0, request.arrival->high);
  return arrival_speed >= request.arrival->low - slack && arrival_speed <= request.arrival->high + slack;
}

/// Returns whether the shot counts on the jaws of its pocket.
bool falls_by_jaws(const SearchRequest& request, const Replay& r) {
  return r.path.touches_jaws && request.problem->drops();
}

bool good_enough(const SearchRequest& request, const Replay& r, Demand demand) {
  return demand == Demand::made ||
         (fast_as_asked(request, r.path.arrival.speed) &&
          (demand == Demand::off_centre || (request.problem->centred(r.miss) && !falls_by_jaws(request, r))));
}

Proof proved(const SearchRequest& request, EvaluationBudget& budget, const Launch& proposed, const Goal& goal) {
  Proof proof;
  Launch& launch = proof.shot.launch;
  launch = {proposed.speed, wrap_angle(radians(degrees(proposed.angle)))};
  proof.shot.spin = request.spin;
  const CushionRule& rule = request.cushions();
  const auto refused = [&](const Failure& why) { return proof.failure = why, proof; };
  if (goal.max < rule.min || goal.min > rule.max) return refused({FailureReason::other_bounces});
  if (!inside_aims(launch.angle, request.angle)) return refused({FailureReason::outside_aim});
  if (!bring_inside(launch.speed, request.speed))
    return refused(
        {launch.speed > request.speed.high ? FailureReason::too_fast : FailureReason::too_slow, {}, launch.speed});
  if (budget.spent()) return refused({FailureReason::no_budget});
  Replay r = replay(request, budget, launch, goal);
  proof.replayed = true;
  proof.shot.verification.miss = r.miss;
  proof.shot.verification.offset = r.offset;
  proof.shot.verification.off_centre = !request.problem->centred(r.miss) || falls_by_jaws(request, r);
  proof.failure = r.failure;
  if (r.made && !good_enough(request, r, goal.demand)) proof.failure = {FailureReason::inexact};
  proof.shot.path = std::move(r.path);
  return proof;
}

}  // namespace

Proof prove(const SearchRequest& request, EvaluationBudget& budget, const Launch& proposed, const Goal& goal) {
  if (!budget.measures) return proved(request, budget, proposed, goal);
  const auto begin = std::chrono::steady_clock::now();
  Proof proof = proved(request, budget, proposed, goal);
  budget.proof_us += std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
  return proof;
}

}  // namespace bankshot::planning
