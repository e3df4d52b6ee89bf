// SPDX-License-Identifier: MIT
//
// Images as seeds where paths are no straight lines: with spin a cushion changes the rebound's angle, and one of a few
// ratios of the normal to the tangential loss comes near it.
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "planners/certify.hpp"

namespace bankshot::planning {

/// From a seed near a root of one route to the root; none where that fails.
using RootFinder = std::function<std::optional<Launch>(const LockedAim&, const Launch& seed)>;

/// Every image, until there are seeds enough; each root becomes a shot or a lead.
void refine_images(const Question& q, Ledger& ledger, Findings& found, std::string_view step, const RootFinder& find);

/// One aim along a route some `length` metres long; true when it leads to a root, a shot or not.
bool refine_aim(const LockedAim& aim, Ledger& ledger, Findings& found, double angle, double length,
                std::string_view step, const RootFinder& find);

}  // namespace bankshot::planning
