// SPDX-License-Identifier: MIT
//
// Partial targets, for an exact line that is blocked. Around each candidate the clearance is climbed (widest.hpp).
// If that leaves hope, aims are bisected.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "planners/propose/proposers.hpp"
#include "planners/propose/window.hpp"
#include "planners/settings.hpp"
#include "planners/solve/speed.hpp"
#include "planners/solve/widest.hpp"
#include "planners/verify/certify.hpp"

namespace bankshot::planning::propose {
namespace {

/// Bisects a window of aims around a candidate, along its route, at the speed that each aim needs.
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
                     return l && certify(request, budget, found, *l, bounces, word::partition, Demand::off_centre);
                   }};
  const Range aims{candidate.launch.angle - candidate.half, candidate.launch.angle + candidate.half};
  return find_window(row, budget, aims, candidate.launch.angle, settings::aims_across);
}

/// Returns whether a bisection may still find a partial target: it is less than its own size away, at an allowed speed.
bool hopeful(const SearchRequest& request, const Candidate& candidate) {
  return candidate.half > 0 && candidate.room > -candidate.aim_point.reach &&
         request.speed.contains(candidate.launch.speed);
}

}  // namespace

bool alike(const Launch& a, const Launch& b) {
  return std::abs(angle_difference(a.angle, b.angle)) < settings::alike &&
         std::abs(std::log(a.speed / b.speed)) < settings::alike;
}

void partial_targets(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (request.starts()) return;  // candidates are what is asked for
  std::vector<Candidate> leads;
  for (Candidate& lead : std::exchange(found.candidates, {})) {
    if (!found.shots.empty() || budget.spent()) return;
    const auto same = [&](const Candidate& known) {
      return alike(known.launch, lead.launch) && known.spin == lead.spin && known.aim_point == lead.aim_point &&
             known.route == lead.route;
    };
    if (std::ranges::any_of(leads, same)) continue;  // many pairs of routes lead to one root
    leads.push_back(std::move(lead));
    climb_clearance(request, budget, found, leads.back());
  }
  if (!request.problem->objects) return;  // the partition of one ball sees them
  std::ranges::stable_sort(leads, std::ranges::greater{}, &Candidate::room);
  for (const Candidate& lead : leads)
    if (found.shots.empty() && !budget.spent() && hopeful(request, lead))
      bisect_candidate(request, budget, found, lead);
}

}  // namespace bankshot::planning::propose
