// SPDX-License-Identifier: MIT
//
// Shots that make the target and leave the cue ball as the puzzle asks.
// Method: each root of the target is followed over launch speeds and spins, and each launch is played until all balls
// rest. If a place is asked for, the launches that rest near it lead to those that rest on it (rest.hpp). The most
// promising are played with the player's errors: their value is the share of plays that make the target and leave the
// cue ball as asked, less the cost of the shot. With `safest` a compass search over the launches that reach the target
// (launches.hpp) improves the best ways to play the shot, by a cheap estimate first and then by plays. Many more plays
// choose among the last few, since luck flatters the best of many.
// Cost: some 500 plays of each root where spin is free, 10 where it is not, and about 10,000 for the best of all.
// Guarantee: none beyond the replay of each launch; how many places are found is measured (docs/evidence.md).
#pragma once

#include <functional>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/search_result.hpp"

namespace bankshot::planning::play {

/// Finds roots of the target's locked paths, as a step does that is asked for starts.
using Roots = std::function<void(const SearchRequest&, EvaluationBudget&, SearchResult&)>;

/// Adds the shots, best first, with their leave, success and value. `roots` is asked once for each number of cushions.
void leave(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, const Roots& roots);

}  // namespace bankshot::planning::play
