// SPDX-License-Identifier: MIT
//
// Compares a path that is told its branch with the simulation of the same launch: each is a test of the other.
#pragma once

#include <string>

#include "bankshot/scene/puzzle.hpp"
#include "planners/search_request.hpp"

namespace bankshot::test {

struct TraceTally {
  long launches = 0, meetings = 0;  ///< that were compared
  double worst = 0;  ///< m of difference, over the diagonal, or over how far a radian, a unit of ln speed, or the
                     ///< launch speed as spin moves it
};

/// The largest difference that rounding explains, in the units of TraceTally::worst.
inline constexpr double rounded_difference = 1e-12;

/// Simulates a shot. Follows the branch of one ball: the cue ball's, or with `sends` that of the ball that was set
/// going last. Compares the places right after up to `most` of its meetings. Returns what differs; empty if nothing.
/// A branch ends before a ball that moves already, since a trace knows only balls that stand. It ends where a cushion
/// holds the ball or nearly does, where two balls may stay together or touch a third, and where rounding decides if a
/// ball rolls.
std::string differs_from_trace(const ShotRequest& shot, bool sends, std::size_t most, TraceTally& tally);

/// Discovers the path of a launch, and compares the residuals after each of its prefixes with those of a trace of that
/// prefix, value and derivatives.
std::string differs_from_discovery(const planning::SearchRequest& request, const Launch& launch, TraceTally& tally);

}  // namespace bankshot::test
