// SPDX-License-Identifier: MIT
#include "planners/play/two_pots.hpp"

#include <algorithm>
#include <cmath>

#include "planners/play/settings.hpp"

namespace bankshot::planning::play {

using namespace settings::two_pots;

double TwoPots::operator()(const PottingOrder& order, const Ending& ending, EvaluationBudget& budget) const {
  const std::vector<NextPot::Best> pots = next_.pots(order, ending.places);
  double best = 0;
  for (const NextPot::Best& pot : pots)
    if (pot.chance > best && pot.chance >= worth_a_try * pots.front().chance)
      best = std::max(best, pot.chance * after(pot, order, ending, budget));
  return best;
}

double TwoPots::after(const NextPot::Best& pot, const PottingOrder& order, const Ending& ending,
                      EvaluationBudget& budget) const {
  if (pot.pocket < 0) return 1;  // no ball is left
  const Range top = request_.puzzle().spin_range ? request_.puzzle().spin_range->top : Range{0, 0};
  double best = 0;
  for (const double speed : speeds)
    for (const double share : {0.5, 0.0, 1.0}) {
      const double v = std::clamp(speed, request_.speed.low, request_.speed.high);
      auto places = play_on(request_, budget, ending.places, {v, std::atan2(pot.line.y, pot.line.x)},
                            {.top = top.low + share * (top.high - top.low)});
      places[static_cast<std::size_t>(pot.ball)].reset();
      best = std::max(best, next_.best(order, places).chance);
    }
  return best;
}

}  // namespace bankshot::planning::play
