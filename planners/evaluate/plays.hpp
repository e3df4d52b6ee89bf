// SPDX-License-Identifier: MIT
//
// The plays of one launch by the player of a puzzle: draws of all errors at once. An additive sequence spreads them
// evenly (draws.hpp); it is the same for every launch. Balls that a draw puts beyond a cushion or into each other are
// moved apart again, just so far that they touch.
#pragma once

#include <functional>

#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Plays once: the request has the scene and the spin that a draw gives, and the launch is the one that is struck.
/// Returns whether to go on.
using Play = std::function<bool(const SearchRequest& own, const Launch& struck)>;

/// Calls `play` for each of `draws` draws, the first `skipped` of the sequence left out, until it says to stop. A draw
/// whose launch has no speed is no play. `request` has the intended spin.
void each_play(const SearchRequest& request, const Launch& launch, int draws, const Play& play, int skipped = 0);

}  // namespace bankshot::planning
