// SPDX-License-Identifier: MIT
//
// What a player's own attempts say of the player: how far launches lie from what was meant, and which shots to choose.
//   const Advice advice = bankshot::advise(attempts);
//   puzzle.noise = advice.noise;         // success, margins and `robust` are then this player's
// The launch of each attempt is fitted to what was seen of it, the physics being known; the errors of all attempts have
// a common mean and variance, whose restricted likelihood (Patterson & Thompson 1971) is maximised with what each
// attempt tells, so that an inexact track makes no noise of its own. Where launches that differ explain a track, as
// where little side may have died before the cushion or not, each counts by its likelihood. Attempts of which only is
// known whether they were made weigh by their chance of that.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bankshot/plan/shot.hpp"
#include "bankshot/scene/attempt.hpp"

namespace bankshot {

struct AdviseWish {
  /// Puzzles to choose from.
  std::span<const Puzzle> shots{};
  int threads = 1;
};

/// One number of a launch, by which this player errs.
struct PlayerError {
  std::string name;           ///< angle [rad], speed [m/s], side or top [LaunchSpin]
  double sigma = 0;           ///< standard deviation; 0 where the attempts tell nothing of it: an interval without end
  Range sigma_interval{};     ///< of 95 %
  double bias = 0;            ///< mean; of the speed as a share of what was meant
  Range bias_interval{};      ///< of 95 %
  bool bias_is_told = false;  ///< whether a shot was made says nothing of it
};

/// How far one attempt lay from what was meant.
struct AttemptError {
  std::string id;
  bool measured = false;        ///< a track or a place of rest told its launch
  double angle = 0, speed = 0;  ///< rad, m/s
  double side = 0, top = 0;
  double rms = 0;         ///< m, from where the ball was seen
  bool left_out = false;  ///< no launch explains what was seen, or it lies too far from the others: a miscue
};

/// One of the puzzles to choose from.
struct Choice {
  std::string id;
  Shot shot{};                               ///< with the best chance by this player's noise
  Shot usual{};                              ///< with the best chance by the puzzle's
  double success = 0, success_of_usual = 0;  ///< both by this player's noise
  bool solved = false;
};

struct Advice {
  Noise noise{};
  std::vector<PlayerError> errors{};
  std::vector<AttemptError> attempts{};
  std::vector<Choice> shots{};  ///< likeliest first
  /// Chance that this player gains: in each puzzle by another shot, and by another puzzle.
  double gain_by_shot = 0, gain_by_puzzle = 0;
};

/// Throws InvalidInput where there is nothing to learn from.
Advice advise(std::span<const Attempt> attempts, const AdviseWish& wish = {});

/// Said plainly.
std::string message_of(const Advice& advice);

/// The `advice` document, one line.
std::string to_json(const Advice& advice);
/// Its noise alone, as JSON that a puzzle's "noise" may be.
std::string noise_of(const Advice& advice);

}  // namespace bankshot
