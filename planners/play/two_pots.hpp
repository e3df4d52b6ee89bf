// SPDX-License-Identifier: MIT
//
// The chance of the next pot and of the best one after it: the worth of a leave by two plies. The next pot is an
// estimate (next_pot.hpp) and is played without errors, at some speeds and heights of the tip; the ball is taken as
// fallen. The best estimate for the ball after it, from where the cue ball then stops, is the second chance.
// Cost: nine simulations for each pocket that is worth a try.
#pragma once

#include "planners/play/next_pot.hpp"
#include "planners/verify/aftermath.hpp"

namespace bankshot::planning::play {

/// Returns the largest product of the two chances for balls that are potted in this order; the first chance alone
/// where no ball is left after it. `next`: the estimate for the request's puzzle.
double two_pots(const SearchRequest& request, EvaluationBudget& budget, const NextPot& next, const PottingOrder& order,
                const Ending& ending);

}  // namespace bankshot::planning::play
