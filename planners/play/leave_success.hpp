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

/// The worth of an ending, from 0 to 1.
using Worth = std::function<double(const Ending&)>;

/// Plays a shot, the first `skipped` of the sequence of plays left out, until there are `plays` or `count` says to
/// stop. `count` gets the worth of each play, 0 where it misses the target, and returns whether to go on. `rests` gets
/// the places in which the cue ball stops in plays that make the target, if it is not null.
void play_leave(const SearchRequest& request, EvaluationBudget& budget, const Worth& worth, const Shot& shot, int plays,
                int skipped, const std::function<bool(double)>& count, std::vector<Vec2d>* rests = nullptr);

/// Returns the mean worth of so many plays, those left out by which a shot is chosen: these would flatter it.
double leave_success(const SearchRequest& request, EvaluationBudget& budget, const Worth& worth, const Shot& shot,
                     std::vector<Vec2d>* rests = nullptr);

/// Returns the mean worth of what a shot leaves where it makes its target, by four plays beside it: with more and less
/// aim and speed. `exact`: its ending without errors. If a region is asked for, it is the share of rests inside, drawn
/// from those that the plays span.
double estimated_worth(const SearchRequest& request, EvaluationBudget& budget, const LeaveWorth& worth,
                       const Shot& shot, const Ending& exact);

/// Computes the leave's success and spread of shots that have one, their success and margin if `robustness` is wanted,
/// and their value.
void rate_leaves(const SearchRequest& request, EvaluationBudget& budget, bool robustness, std::vector<Shot>& shots);

}  // namespace bankshot::planning::play
