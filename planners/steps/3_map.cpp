// SPDX-License-Identifier: MIT
#include <algorithm>

#include "planners/settings.hpp"
#include "planners/steps/forward_map.hpp"
#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

void map(const Question& q, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing) {
  ForwardMap(q, budget, found, spacing, word::map).run();
}

/// Paths with more bounces bend the map more.
Spacing usual_spacing(const Question& q) {
  using namespace settings::forward_map;
  const double finer = static_cast<double>(plain_bounces) / std::max(plain_bounces, q.cushions().max);
  return q.all() ? Spacing{usual.aim * finer, usual.speed * finer} : usual;
}

}  // namespace bankshot::planning::steps
