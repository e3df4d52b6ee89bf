// SPDX-License-Identifier: MIT
#include "planners/search_result.hpp"

#include <algorithm>

namespace bankshot::planning {

void SearchResult::remember(const NearMiss& m) {
  if (m.miss < nearest.miss) nearest = m;
  for (Counted& c : failures) {
    if (!c.failure.like(m.failure)) continue;
    ++c.times;
    if (m.failure.reason == FailureReason::too_fast) c.failure.speed = std::min(c.failure.speed, m.failure.speed);
    if (m.failure.reason == FailureReason::too_slow) c.failure.speed = std::max(c.failure.speed, m.failure.speed);
    return;
  }
  failures.push_back({m.failure, 1});
}

}  // namespace bankshot::planning
