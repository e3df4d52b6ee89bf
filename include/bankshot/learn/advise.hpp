// SPDX-License-Identifier: MIT
//
// Estimates a player's errors from recorded attempts, and advises which shots to choose.
//   const Advice advice = bankshot::advise(attempts);
//   puzzle.noise = advice.noise;         // success, margins and `robust` are then this player's
// The launch of each attempt is fitted to its observations; the physics is known. The errors of all attempts share one
// mean and one variance, found by maximising the restricted likelihood (Patterson & Thompson 1971). Each attempt enters
// with its own uncertainty, so that inexact tracks do not add to the noise. If several launches explain a track (a
// little side may or may not have died before the cushion), each counts by its likelihood. An attempt that is only
// known to be made or missed enters by the probability of that outcome.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/attempt.hpp"

namespace bankshot {

struct AdviseWish {
  /// The puzzles to choose from.
  std::span<const Puzzle> shots{};
  int threads = 1;
};

/// The error of this player in one number of a launch.
struct PlayerError {
  std::string name;           ///< angle [rad], speed [m/s], side or top [LaunchSpin]
  double sigma = 0;           ///< standard deviation; 0 if not identifiable, with an unbounded interval
  Range sigma_interval{};     ///< 95 % interval
  double bias = 0;            ///< mean error; for the speed, as a share of the intended speed
  Range bias_interval{};      ///< 95 % interval
  bool bias_is_told = false;  ///< bias was estimated; attempts known only as made or missed cannot tell it
};

/// The difference of one attempt from the intended launch.
struct AttemptError {
  std::string id;
  bool measured = false;        ///< its launch was fitted to a track or a position of rest
  double angle = 0, speed = 0;  ///< rad, m/s
  double side = 0, top = 0;
  double rms = 0;         ///< m; distance of the fitted path from the observations
  bool left_out = false;  ///< no launch explains the observations, or it is an outlier such as a miscue
};

/// One of the puzzles to choose from.
struct Choice {
  std::string id;
  Shot shot{};                               ///< the most successful shot under this player's noise
  Shot usual{};                              ///< the most successful shot under the puzzle's noise
  double success = 0, success_of_usual = 0;  ///< both under this player's noise
  bool solved = false;
};

struct Advice {
  Noise noise{};
  std::vector<PlayerError> errors{};
  std::vector<AttemptError> attempts{};
  std::vector<Choice> shots{};  ///< highest success first
  /// Success that this player gains: on average by choosing another shot of each puzzle, and by choosing another
  /// puzzle.
  double gain_by_shot = 0, gain_by_puzzle = 0;
};

/// Throws InvalidInput if there is nothing to learn from.
Advice advise(std::span<const Attempt> attempts, const AdviseWish& wish = {});

/// Returns the advice as text for a player.
std::string message_of(const Advice& advice);

/// Returns the `advice` document as one line of JSON.
std::string to_json(const Advice& advice);
/// Returns its noise alone, as JSON for the key "noise" of a puzzle.
std::string noise_of(const Advice& advice);

}  // namespace bankshot
