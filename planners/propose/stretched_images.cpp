// SPDX-License-Identifier: MIT
//
// With spin no straight line leads to the aim point. A line that is bent as much as cushions bend it comes near. So
// images are unfolded with five ratios of the normal to the tangential loss, and each is moved onto a root of its own
// route. Cost: some ten locked simulations a seed. Guarantee: none beyond verification; a root is found where its seed
// leads.
#include "planners/propose/proposers.hpp"
#include "planners/propose/refine.hpp"
#include "planners/solve/newton.hpp"

namespace bankshot::planning::propose {

void stretched_images(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found) {
  refine_images(request, budget, found, word::unfold,
                [&](const Branch& aim, const Launch& seed) { return newton(aim, budget, seed, settings::wide); });
}

}  // namespace bankshot::planning::propose
