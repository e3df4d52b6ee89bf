// SPDX-License-Identifier: MIT
//
// Whether a play of a shot counts, by the public simulator alone: all balls, until they rest. It shares no code with
// the planners, and says what the contract says of "made" and of a legal shot.
#pragma once

#include <cstdint>
#include <optional>

#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/shot.hpp"

namespace bankshot::test {

/// `played` makes the target of the puzzle as `success` counts it: the shot's own ball and pocket, by any cushions that
/// are allowed, and where a ball is the target the cue ball stays on the table.
bool is_legal(const Puzzle& puzzle, const Shot& shot, const ShotRequest& played);

/// One play of the shot with the errors of the puzzle's player; none where the ball would not be struck.
std::optional<ShotRequest> noisy_play(const Puzzle& puzzle, const Shot& shot, Random& random);

/// The share of so many noisy plays that is legal.
double share_of_plays(const Puzzle& puzzle, const Shot& shot, int plays, std::uint64_t seed);

}  // namespace bankshot::test
