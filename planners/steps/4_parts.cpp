// SPDX-License-Identifier: MIT
//
// Where what one aims at is blocked, some part of the target may be reached beside it: around each lead the clearance
// is climbed (widest.hpp), and where that leaves hope, rows of aims are bisected.
#include <algorithm>
#include <cmath>

#include "planners/certify.hpp"
#include "planners/images/window.hpp"
#include "planners/locked/speed.hpp"
#include "planners/settings.hpp"
#include "planners/steps/steps.hpp"
#include "planners/steps/widest.hpp"

namespace bankshot::planning::steps {
namespace {

using namespace settings::parts;

/// A window around a lead, along its route, at the speed that each aim needs.
bool bisect_candidate(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found,
                      const Candidate& candidate) {
  const Branch locked{request, candidate.route, candidate.aim_point};
  const std::vector<Contact> contacts = contacts_of(candidate.route);
  const Goal goal = Goal::along(contacts);
  const auto launch = [&](double aim) -> std::optional<Launch> {
    const auto speed = speed_near(locked, budget, aim, candidate.launch.speed);
    if (!speed) return {};
    return Launch{*speed, wrap_angle(aim)};
  };
  const AimRow row{[&](double aim) {
                     const auto l = launch(aim);
                     return l ? replay(request, budget, *l, goal) : Replay{};
                   },
                   [&](double aim, int bounces) {
                     const auto l = launch(aim);
                     return l && certify(request, budget, found, *l, bounces, word::parts, Demand::off_centre);
                   }};
  const Range aims{candidate.launch.angle - candidate.half, candidate.launch.angle + candidate.half};
  return find_window(row, budget, aims, candidate.launch.angle, aims_across);
}

/// A bisection may still find a part: the target is less than its own size away, at a speed that is allowed, or nearly.
bool hopeful(const SearchRequest& request, const Candidate& candidate) {
  const Range& v = request.speed;
  return candidate.half > 0 && candidate.room > -candidate.aim_point.reach &&
         candidate.launch.speed > v.low / nearly_allowed && candidate.launch.speed < v.high * nearly_allowed;
}

}  // namespace

bool alike(const Launch& a, const Launch& b) {
  return std::abs(angle_difference(a.angle, b.angle)) < settings::alike &&
         std::abs(std::log(a.speed / b.speed)) < settings::alike;
}

void Parts::climb(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (request.starts()) return;  // its leads are what is asked for
  for (Candidate& candidate : found.candidates) {
    if (!found.shots.empty() || budget.spent()) break;
    if (request.problem->objects && was_tried(candidate)) continue;  // many pairs of routes lead to one root
    Widest(request, budget, found, candidate).find();
    tried_.push_back(std::move(candidate));
  }
  found.candidates.clear();
}

bool Parts::was_tried(const Candidate& candidate) const {
  return std::ranges::any_of(tried_, [&](const Candidate& known) {
    return alike(known.launch, candidate.launch) && known.spin == candidate.spin &&
           known.aim_point == candidate.aim_point && known.route == candidate.route;
  });
}

void Parts::bisect(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, double share) {
  const long until = budget.share_of_rest(share);
  std::sort(tried_.begin(), tried_.end(), [](const auto& a, const auto& b) { return a.room < b.room; });
  for (; !tried_.empty() && found.shots.empty() && !budget.spent() && budget.simulations() < until; tried_.pop_back()) {
    Candidate& candidate = tried_.back();
    if (hopeful(request, candidate) && !Widest(request, budget, found, candidate).across_jumps())
      bisect_candidate(request, budget, found, candidate);
  }
}

}  // namespace bankshot::planning::steps
