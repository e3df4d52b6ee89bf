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

class TwoPots {
 public:
  explicit TwoPots(const SearchRequest& request) : request_(request), next_(request.puzzle()) {}

  /// Returns the largest product of the two chances for balls that are potted in this order; the first chance alone
  /// where no ball is left after it.
  double operator()(const PottingOrder& order, const Ending& ending, EvaluationBudget& budget) const;

 private:
  /// Returns the largest chance of a pot after this one.
  double after(const NextPot::Best& pot, const PottingOrder& order, const Ending& ending,
               EvaluationBudget& budget) const;

  SearchRequest request_;
  NextPot next_;
};

}  // namespace bankshot::planning::play
