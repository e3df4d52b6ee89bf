// SPDX-License-Identifier: MIT
//
// The success of a leave: the probability that the target is made and the cue ball stops as the puzzle asks. It is a
// share of plays with the player's errors (evaluate/plays.hpp), each with all balls until they rest.
// Cost: two simulations a play.
#pragma once

#include <functional>
#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/play/worth.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning::play {

/// Plays of a measurement, the first `skipped` of the sequence left out. It ends as soon as the success must be less
/// than `least`, and is then less than that.
struct Measurement {
  int plays;
  int skipped = 0;
  double least = 0;
};

/// The worth of an ending, from 0 to 1.
using Worth = std::function<double(const Ending&)>;

/// Returns the mean worth of the plays. `rests` gets the places in which the cue ball stops in those that make the
/// target, if it is not null.
double leave_success(const SearchRequest& request, EvaluationBudget& budget, const Worth& worth, const Shot& shot,
                     const Measurement& measurement, std::vector<Vec2d>* rests = nullptr);

/// Returns the mean worth of what a shot leaves where it makes its target, by four plays beside it: with more and less
/// aim and speed. `exact`: its ending without errors. If a region is asked for, it is the share of rests inside, drawn
/// from those that the plays span.
double estimated_worth(const SearchRequest& request, EvaluationBudget& budget, const LeaveWorth& worth,
                       const Shot& shot, const Ending& exact);

/// Computes the leave's success and spread of shots that have one, their success and margin if `robustness` is wanted,
/// and their value.
void rate_leaves(const SearchRequest& request, EvaluationBudget& budget, bool robustness, std::vector<Shot>& shots);

}  // namespace bankshot::planning::play
