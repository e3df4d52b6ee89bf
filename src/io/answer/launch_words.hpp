// SPDX-License-Identifier: MIT
//
// Describes launches in words for a player: aim, speed, where the tip meets the ball, and the player's errors.
#pragma once

#include <string>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// Returns true if the line of aim runs into this pocket.
bool aims_into(const ShotRequest& shot, const Pocket& pocket);

/// Returns the diamond that the line of aim crosses (sights.hpp), or where the line enters the pocket that it runs
/// into.
std::string aim_words(const ShotRequest& shot, const Pocket* straight_into = nullptr);

/// Returns the speed by name, in m/s, in miles per hour and in lags. One lag is the speed that brings a ball from the
/// head string to the foot cushion and back to the head cushion.
std::string speed_words(const ShotRequest& shot);

/// Returns where the tip meets the ball and how far the cue is raised, with a warning beyond the miscue limit.
std::string tip_words(const ShotRequest& shot);

/// Returns how far a line passes from the middle of a pocket: "20 mm right of its middle as the ball rolls", or
/// "through its middle" if the distance is not visible.
std::string beside_words(const Vec2d& at, const Vec2d& aim, const Vec2d& centre);

/// Returns the errors as text: "0.125 degrees of aim and 0.075 m/s of speed".
std::string noise_words(const Noise& noise);
/// Returns the player as text: "a good league player who errs by 0.2 degrees of aim and 5 % of speed".
std::string player_words(const Noise& noise);

}  // namespace bankshot
