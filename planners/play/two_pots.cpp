// SPDX-License-Identifier: MIT
#include "planners/play/two_pots.hpp"

#include <algorithm>
#include <cmath>

#include "planners/play/settings.hpp"

namespace bankshot::planning::play {

using namespace settings::two_pots;

namespace {

/// Returns the largest chance of a pot after this one.
double after(const SearchRequest& request, EvaluationBudget& budget, const NextPot& next, const PottingOrder& order,
             const Ending& ending, const NextPot::Best& pot) {
  if (pot.pocket < 0) return 1;  // no ball is left
  const Range top = request.puzzle().spin_range ? request.puzzle().spin_range->top : Range{0, 0};
  double best = 0;
  for (const double speed : speeds)
    for (const double share : {0.5, 0.0, 1.0}) {
      const double v = std::clamp(speed, request.speed.low, request.speed.high);
      auto places = play_on(request, budget, ending.places, {v, std::atan2(pot.line.y, pot.line.x)},
                            {.top = top.low + share * (top.high - top.low)});
      places[static_cast<std::size_t>(pot.ball)].reset();
      best = std::max(best, next.best(order, places).chance);
    }
  return best;
}

}  // namespace

double two_pots(const SearchRequest& request, EvaluationBudget& budget, const NextPot& next, const PottingOrder& order,
                const Ending& ending) {
  const std::vector<NextPot::Best> pots = next.pots(order, ending.places);
  double best = 0;
  for (const NextPot::Best& pot : pots)
    if (pot.chance > best && pot.chance >= worth_a_try * pots.front().chance)
      best = std::max(best, pot.chance * after(request, budget, next, order, ending, pot));
  return best;
}

}  // namespace bankshot::planning::play
