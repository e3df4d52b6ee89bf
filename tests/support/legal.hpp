// SPDX-License-Identifier: MIT
//
// Decides by the public simulator alone whether a play of a shot counts: it follows all balls until they rest. It
// shares no code with the planners and follows the contract's definitions of "made" and of a legal shot.
#pragma once

#include <cstdint>
#include <optional>

#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/shot.hpp"

namespace bankshot::test {

/// Returns true when `played` makes the target of the puzzle as `success` counts it: with the shot's own ball and
/// pocket, by any allowed cushions. When the target is a ball, the cue ball must stay on the table.
bool is_legal(const Puzzle& puzzle, const Shot& shot, const ShotRequest& played);

/// Returns one play of the shot with the errors of the puzzle's player; none when the cue ball would not be struck.
std::optional<ShotRequest> noisy_play(const Puzzle& puzzle, const Shot& shot, Random& random);

/// Returns the share of `plays` noisy plays that are legal.
double share_of_plays(const Puzzle& puzzle, const Shot& shot, int plays, std::uint64_t seed);

}  // namespace bankshot::test
