// SPDX-License-Identifier: MIT
#include <algorithm>

#include "planners/propose/forward_map.hpp"
#include "planners/propose/proposers.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning::propose {

void partition(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Spacing& spacing) {
  ForwardMap(request, budget, found, spacing).run();
}

/// Paths with more bounces bend more within a cell.
Spacing usual_spacing(const SearchRequest& request) {
  using namespace settings::forward_map;
  const double finer = static_cast<double>(plain_bounces) / std::max(plain_bounces, request.cushions().max);
  return request.all() ? Spacing{usual.aim * finer, usual.speed * finer} : usual;
}

}  // namespace bankshot::planning::propose
