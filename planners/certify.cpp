// SPDX-License-Identifier: MIT
#include "planners/certify.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/merit/first_order.hpp"

namespace bankshot::planning {
namespace {

/// Metres between two arrivals of one launch that are one: a bounce at the target lies between them.
double same_arrival(const Question& q) { return 10 * tolerance::exact_miss * q.boundary.diagonal; }

bool same_launch(const Launch& a, const Launch& b) {
  return std::abs(angle_difference(a.angle, b.angle)) < tolerance::same_aim &&
         std::abs(a.speed - b.speed) <= tolerance::exact_speed * std::max(1.0, b.speed);
}

bool same_shot(const Question& q, const Shot& known, const Shot& shot) {
  return same_launch(known.launch, shot.launch) &&
         !(std::abs(known.arrival.time - shot.arrival.time) * shot.launch.speed > same_arrival(q));
}

void count_failure(Findings& found, const Proof& proof, int bounces) {
  const Foul foul = proof.failure.foul;
  // An aim outside its bounds is no near miss, but is better than none.
  const double miss = foul == Foul::outside_aim ? std::numeric_limits<double>::max() : proof.shot.miss;
  if (proof.replayed || foul == Foul::outside_aim) found.remember({proof.shot.launch, bounces, miss, proof.failure});
}

/// True unless the shot is known already, with no more bounces.
bool make_room(const Question& q, std::vector<Shot>& shots, const Shot& shot) {
  for (Shot& known : shots) {
    if (!same_shot(q, known, shot)) continue;
    if (known.cushions.size() <= shot.cushions.size()) return false;
    std::swap(known, shots.back());  // the bounce at the target itself is one too many
    shots.pop_back();
    return true;
  }
  return true;
}

}  // namespace

bool certify(const Question& q, Ledger& ledger, Findings& found, const Launch& launch, int bounces,
             std::string_view step, Demand demand) {
  Proof proof = prove(q, ledger, launch, Goal::exactly(q, bounces, demand));
  if (!proof.holds()) return count_failure(found, proof, bounces), false;
  keep(q, ledger, found, std::move(proof.shot), step);
  return true;
}

void keep(const Question& q, Ledger& ledger, Findings& found, Shot shot, std::string_view step) {
  if (!make_room(q, found.shots, shot)) return;
  shot.planner = step;
  shot.simulations = ledger.simulations();
  add_first_order(q, shot);
  found.shots.push_back(std::move(shot));
}

bool certify_root(const LockedAim& aim, Ledger& ledger, Findings& found, const Launch& root, std::string_view step) {
  const int bounces = static_cast<int>(aim.route.size());
  if (!aim.q.starts() && certify(aim.q, ledger, found, root, bounces, step)) return true;
  found.leads.push_back({root, {aim.route.begin(), aim.route.end()}, aim.mark, aim.q.spin});
  return false;
}

}  // namespace bankshot::planning
