// SPDX-License-Identifier: MIT
#include "planners/verify/certify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bankshot/numbers/tolerances.hpp"
#include "planners/evaluate/first_order.hpp"
#include "planners/settings.hpp"
#include "planners/verify/aftermath.hpp"

namespace bankshot::planning {
namespace {

/// Returns the distance [m] below which two arrivals of one launch are one: a bounce at the target lies between them.
double same_arrival(const SearchRequest& request) {
  return 10 * tolerance::exact_miss * request.problem->boundary.diagonal;
}

bool same_launch(const Launch& a, const Launch& b) {
  return std::abs(angle_difference(a.angle, b.angle)) < tolerance::same_aim &&
         std::abs(a.speed - b.speed) <= tolerance::exact_speed * std::max(1.0, b.speed);
}

void count_failure(SearchResult& found, const Proof& proof) {
  const FailureReason reason = proof.failure.reason;
  // An aim outside its bounds is no near miss, but better than none.
  const double miss =
      reason == FailureReason::outside_aim ? std::numeric_limits<double>::max() : proof.shot.verification.miss;
  if (proof.replayed || reason == FailureReason::outside_aim) found.remember({proof.shot.launch, miss, proof.failure});
}

/// Returns true unless the shot is known already with no more bounces; removes a known one that has more.
bool make_room(const SearchRequest& request, std::vector<Shot>& shots, const Shot& shot) {
  for (Shot& known : shots) {
    if (!same_shot(request, known, shot)) continue;
    if (known.path.cushions.size() <= shot.path.cushions.size()) return false;
    std::swap(known, shots.back());  // the bounce at the target itself is one too many
    shots.pop_back();
    return true;
  }
  return true;
}

/// Returns the error [m] that rounding can cause at an arrival (simulate/simulator.hpp, property 6).
double rounding(const SearchRequest& request, const Shot& shot) {
  const bool integrated = impact_tolerance(request.puzzle().physics.cushion);
  const double pieces = is_level(request.puzzle().physics) ? 1 : tolerance::pieces_rounding;
  const double unit = integrated ? tolerance::impact : tolerance::simulation_error * 0x1p-53 * pieces;
  return unit * (1 + static_cast<double>(shot.path.cushions.size())) *
         (request.problem->boundary.extent + shot.verification.condition);
}

/// The change of a launch that moves the arrival by some metres: rad, and a share of the speed.
struct Turn {
  double aim, speed;
};
Turn turn_by(double metres, const Shot& shot) {
  const auto change = [&](double by) { return by * settings::edge::farthest > metres ? metres / by : 0; };
  return {change(norm(shot.verification.by_angle)), change(norm(shot.verification.by_speed) * shot.launch.speed)};
}

Launch turned(const Launch& l, const Turn& t, int aim, int speed) {
  return {l.speed * (1 + speed * t.speed), wrap_angle(l.angle + aim * t.aim)};
}

/// Returns whether launches that rounding can hardly tell from the shot's bounce as often as it does. `least`: their
/// least difference, in rad and as a share of the speed.
bool is_firm(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot, double least = 0) {
  const Turn by = turn_by(settings::edge::surely * rounding(request, shot), shot);
  const Turn t{std::max(by.aim, least), std::max(by.speed, least)};
  const Goal goal = Goal::along(shot);
  for (const auto& [aim, speed] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
    if (!replay(request, budget, turned(shot.launch, t, aim, speed), goal).made) return false;
  return true;
}

bool arrives_on_a_line(const SearchRequest& request, const Shot& shot) {
  return request.problem->on_a_line(request.problem->aim_point_of(shot).ball, shot.path.arrival.at);
}

/// Finds a firm launch beside the shot's, as near as an exact answer must be, on the side that keeps the bounces.
std::optional<Shot> firm_beside(const SearchRequest& request, EvaluationBudget& budget, const Goal& goal,
                                const Shot& shot) {
  for (const double metres : settings::edge::beside) {
    const Turn t = turn_by(metres * request.problem->boundary.diagonal, shot);
    for (const auto& [aim, speed] : {std::pair{0, -1}, {0, 1}, {1, 0}, {-1, 0}, {1, -1}, {-1, -1}, {1, 1}, {-1, 1}}) {
      Proof proof = prove(request, budget, turned(shot.launch, t, aim, speed), goal);
      if (!proof.holds()) continue;
      add_first_order(request, proof.shot, budget.work());
      if (is_firm(request, budget, proof.shot)) return std::move(proof.shot);
    }
  }
  return {};
}

/// Makes the shot firm. Returns false if rounding decides its bounces and no launch beside is firm.
bool make_firm(const SearchRequest& request, EvaluationBudget& budget, const Goal& goal, Shot& shot) {
  if (budget.spent() || is_firm(request, budget, shot)) return true;
  auto beside = firm_beside(request, budget, goal, shot);
  if (!beside) return false;
  shot = *std::move(beside);
  return true;
}

/// Replaces a launch whose ball was at its target, on a cushion's line, and by rounding bounced once more there:
/// returns a launch beside it, if one is firm.
Proof without_last_bounce(const SearchRequest& request, EvaluationBudget& budget, const Goal& goal, Proof proof) {
  const bool at_target =
      proof.replayed && goal.demand == Demand::exact && request.problem->centred(proof.shot.verification.miss) &&
      static_cast<int>(proof.shot.path.cushions.size()) == goal.max && arrives_on_a_line(request, proof.shot);
  if (!at_target) return proof;
  add_first_order(request, proof.shot, budget.work());
  if (auto beside = firm_beside(request, budget, goal, proof.shot)) return {*std::move(beside), {}, true};
  return proof;
}

}  // namespace

bool same_shot(const SearchRequest& request, const Shot& known, const Shot& shot) {
  return same_launch(known.launch, shot.launch) &&
         !(std::abs(known.path.arrival.time - shot.path.arrival.time) * shot.launch.speed > same_arrival(request));
}

std::optional<int> promised_digits(const SearchRequest& request, const Shot& shot) {
  const double of_diagonal = rounding(request, shot) / request.problem->boundary.diagonal;
  if (!(of_diagonal > tolerance::exact_miss)) return {};
  return std::max(1, static_cast<int>(-std::log10(of_diagonal)));
}

bool certify(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Launch& launch,
             int bounces, std::string_view step, Demand demand) {
  const Goal goal = Goal::exactly(request, bounces, demand);
  Proof proof = prove(request, budget, launch, goal);
  if (!proof.holds()) proof = without_last_bounce(request, budget, goal, std::move(proof));
  if (!proof.holds()) return count_failure(found, proof), false;
  if (request.problem->objects && proof.shot.verification.off_centre) {
    // A launch that is made only by rounding is no shot. Examples are a cushion that ends at a pocket's circle, and a
    // contact that would leave the cue ball standing. A ball that rolls along a rail arrives alike, but may bounce
    // differently.
    add_first_order(request, proof.shot, budget.work());
    if (!is_firm(request, budget, proof.shot, settings::edge::unmoved)) return false;
  }
  keep(request, budget, found, std::move(proof.shot), goal, step);
  return true;
}

void keep(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Shot shot, const Goal& goal,
          std::string_view step) {
  if (!make_room(request, found.shots, shot)) return;
  add_first_order(request, shot, budget.work());
  const std::vector<double> along = request.problem->along_touched_cushions();
  const bool looked_at = goal.demand == Demand::exact && arrives_on_a_line(request, shot) &&
                         std::ranges::find(along, shot.launch.angle) == along.end();
  shot.verification.digits = !looked_at || make_firm(request, budget, goal, shot) ? promised_digits(request, shot) : 0;
  add_aftermath(request, budget, shot);
  shot.provenance.planner = step;
  shot.provenance.simulations = budget.simulations();
  found.shots.push_back(std::move(shot));
}

bool certify_root(const Branch& aim, EvaluationBudget& budget, SearchResult& found, const Launch& root,
                  std::string_view step) {
  const int bounces = bounces_of(aim.route);
  if (!aim.request.starts() && certify(aim.request, budget, found, root, bounces, step)) return true;
  found.candidates.push_back({root, {aim.route.begin(), aim.route.end()}, aim.aim_point, aim.request.spin});
  return false;
}

}  // namespace bankshot::planning
