// SPDX-License-Identifier: MIT
//
// Where what one aims at is blocked, some part of the target may be reached beside it: around each lead the clearance
// is climbed (widest.hpp).
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "planners/settings.hpp"
#include "planners/steps/steps.hpp"
#include "planners/steps/widest.hpp"

namespace bankshot::planning::steps {
bool alike(const Launch& a, const Launch& b) {
  return std::abs(angle_difference(a.angle, b.angle)) < settings::alike &&
         std::abs(std::log(a.speed / b.speed)) < settings::alike;
}

void parts(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  if (request.starts()) return;  // its leads are what is asked for
  std::vector<Candidate> leads;
  for (Candidate& lead : std::exchange(found.candidates, {})) {
    if (!found.shots.empty() || budget.spent()) return;
    const auto same = [&](const Candidate& known) {
      return alike(known.launch, lead.launch) && known.spin == lead.spin && known.aim_point == lead.aim_point &&
             known.route == lead.route;
    };
    if (std::ranges::any_of(leads, same)) continue;  // many pairs of routes lead to one root
    leads.push_back(std::move(lead));
    Widest(request, budget, found, leads.back()).find();
  }
}

}  // namespace bankshot::planning::steps
