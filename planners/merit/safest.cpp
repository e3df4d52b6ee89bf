// SPDX-License-Identifier: MIT
#include "planners/merit/safest.hpp"

#include <optional>
#include <utility>

#include "planners/certify.hpp"
#include "planners/merit/first_order.hpp"
#include "planners/merit/outcome_map.hpp"
#include "planners/merit/success.hpp"
#include "planners/proof/aftermath.hpp"
#include "planners/proof/prove.hpp"

namespace bankshot::planning {
namespace {

/// The same shot with another launch; none where it is not made.
std::optional<Shot> moved(const Question& q, Ledger& ledger, const Shot& from, const Launch& to) {
  Proof proof = prove(q, ledger, to, Goal::along(from, q.puzzle.arrive ? Demand::off_centre : Demand::made));
  if (!proof.holds()) return {};
  Shot& shot = proof.shot;
  add_aftermath(q, ledger, shot);
  shot.planner = from.planner;
  shot.simulations = from.simulations;
  shot.moved = true;
  add_first_order(q, shot);
  shot.digits = promised_digits(q, shot);
  find_success(q, ledger, shot);
  return std::move(shot);
}

}  // namespace

bool make_safest(const Question& q, Ledger& ledger, Shot& shot, double worth) {
  const auto best = OutcomeMap(q, ledger, shot).best(worth);
  if (!best && worth > -1) return false;
  if (!shot.success) find_success(q, ledger, shot);
  if (!best) return true;
  if (auto there = moved(q, ledger, shot, best->launch); there && *there->value > *shot.value) shot = std::move(*there);
  return true;
}

}  // namespace bankshot::planning
