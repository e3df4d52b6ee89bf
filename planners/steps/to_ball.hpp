// SPDX-License-Identifier: MIT
//
// The cue ball by itself, on its way to the first ball that it sets going: aims across that, for the steps of chains
// and caroms.
#pragma once

#include <functional>
#include <vector>

#include "planners/steps/steps.hpp"

namespace bankshot::planning::steps {

/// m/s, of the launch, in the middle of its bounds: where aims across a ball are laid.
double middle_speed(const SearchRequest& request);

/// A route to a ball, and the aims at which it is touched at one speed, or nearly.
struct Approach {
  Route route;
  Range across;
};

/// All routes by these cushions that the roots of a step have.
std::vector<Approach> approaches(const SearchRequest& request, EvaluationBudget& budget, const Objects::Object& object,
                                 const CushionRule& cushions, Step starts);

/// The same to the last ball of a chain, by all those before it; also where the middle speed is too slow to get there,
/// since a ball may be touched that is not reached.
std::vector<Approach> approaches_to_last(const SearchRequest& request, EvaluationBudget& budget,
                                         const Objects::Chain& chain);

/// Evenly in the cut and in the logarithm of the speed.
struct Grid {
  int aims;    ///< to either side of the middle
  int speeds;  ///< one, where it is given
};
/// m/s, of its launches.
double slowest_tried(const SearchRequest& request);
/// `look(launch, number of its speed)` of each node, aim by aim, until it says that it is over.
void each_launch(const SearchRequest& request, const Range& across, const Grid& grid,
                 const std::function<bool(const Launch&, int)>& look);

/// Roots of locked paths by images and, where these may miss some, by maps.
void starts_by_map(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found);

}  // namespace bankshot::planning::steps
