// SPDX-License-Identifier: MIT
//
// Images as seeds if paths are not straight. With spin a cushion changes the angle of the rebound, and one of a few
// ratios of the normal to the tangential loss comes near it.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "planners/verify/certify.hpp"

namespace bankshot::planning {

/// Goes from a seed near a root of one route to the root; none if that fails.
using RootFinder = std::function<std::optional<Launch>(const Branch&, const Launch& seed)>;

/// Refines every image until there are enough seeds; each root becomes a shot or a candidate.
void refine_images(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, std::string_view step,
                   const RootFinder& find);

/// Refines one aim along a route of about `length` metres. Returns whether it leads to a root, be it a shot or not.
bool refine_aim(const Branch& aim, EvaluationBudget& budget, SearchResult& found, double angle, double length,
                std::string_view step, const RootFinder& find);

}  // namespace bankshot::planning
