// SPDX-License-Identifier: MIT
#include "planners/evaluate/safest.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "planners/evaluate/first_order.hpp"
#include "planners/evaluate/outcome_map.hpp"
#include "planners/evaluate/settings.hpp"
#include "planners/evaluate/success.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/certify.hpp"
#include "planners/verify/prove.hpp"

namespace bankshot::planning {
namespace {

/// Returns the shot with another launch; none where that is not made. It may brush a rail where the puzzle allows that.
std::optional<Shot> moved(const SearchRequest& request, EvaluationBudget& budget, const Shot& from, const Launch& to) {
  Goal goal = Goal::counted(request, from);
  if (request.puzzle().arrive) goal.demand = Demand::off_centre;
  Proof proof = prove(request, budget, to, goal);
  if (!proof.holds()) return {};
  Shot& shot = proof.shot;
  add_aftermath(request, budget, shot);
  shot.provenance = from.provenance;
  shot.provenance.moved = true;
  add_first_order(request, shot, budget.work());
  shot.verification.digits = promised_digits(request, shot);
  find_success(request, budget, shot);
  return std::move(shot);
}

}  // namespace

double worth_of(const Shot& shot) {
  constexpr double scratch = 2;  // more than values differ by
  return shot.robustness.value ? *shot.robustness.value - (shot.path.scratch ? scratch : 0) : -infinite;
}

bool make_safest(const SearchRequest& request, EvaluationBudget& budget, Shot& shot, double worth) {
  using namespace settings::outcome_map;
  const auto likely = likely_launches(request, budget, shot, worth);
  if (likely.empty() && worth > -1) return false;
  std::optional<Shot> best;
  const std::size_t tried = request.all() ? 1 : most_tried;  // a list has many shots
  for (const auto& [launch, value] : std::span(likely).first(std::min(likely.size(), tried))) {
    if (best && worth_of(*best) >= value) break;  // the others promise no more
    auto there = moved(request, budget, shot, launch);
    if (there && request.problem->keeps_cushions(*there) && (!best || worth_of(*there) > worth_of(*best)))
      best = std::move(there);
  }
  if (!shot.robustness.success) find_success(request, budget, shot);
  if (best && (!request.problem->keeps_cushions(shot) || worth_of(*best) > worth_of(shot))) shot = std::move(*best);
  return true;
}

}  // namespace bankshot::planning
