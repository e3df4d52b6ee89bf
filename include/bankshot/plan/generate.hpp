// SPDX-License-Identifier: MIT
//
// Puzzles that have a shot. Each is made from a simulated shot, or where a sequence of cushions or other balls are
// wished from a drawn target, with its numbers rounded to what a person would write; it is kept only when
// `solve` finds its shot, and when the target is a fifth of the table's diagonal from the ball or more. Seeded: the
// same seed gives the same puzzles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// A puzzle and the launch it was made from.
struct Made {
  Puzzle puzzle;
  Launch launch;
  int bounces;
};

/// What to ask about a simulated shot with `least` to `most` bounces: the pocket it dropped into, where it
/// came to rest, or a point it passed. None when it does not lend itself to the kind drawn.
std::optional<Made> ask(Random& random, const ShotRequest& shot, const Trajectory& trajectory, int least, int most);

/// How hard a shot is for a player with the default noise, by `success` and by the smaller side of the
/// aim's margin. easy: at least `easy_success` and `easy_margin`. hard: below `hard_success` or
/// `hard_margin`. medium: between.
enum class Difficulty { easy, medium, hard };
inline constexpr double easy_success = 0.9, hard_success = 0.4;
inline constexpr double easy_margin = radians(0.25), hard_margin = radians(0.0625);  ///< two, half a deviation
const char* name(Difficulty difficulty);
/// Needs margin and success.
Difficulty difficulty(const Shot& shot);

struct Wish {
  Table table{};
  Physics physics{};
  Ball ball{};                     ///< radius and mass
  CushionRule cushions{1, 3, {}};  ///< a number between min and max is drawn for each puzzle, or the sequence
  enum class Kind { pocket, stop, pass, kick, pot, carom };
  std::optional<Kind> kind{};  ///< drop, rest at a point, pass it at a speed; else one of these three is drawn. Or
                               ///< touch a ball, send one into a pocket, touch one and then another
  int others = 0;              ///< balls beside the struck one; 0: none, or three where the kind needs some
  CushionRule then{0, 0, {}};  ///< of the ball that is sent into a pocket
  std::optional<Difficulty> difficulty{};
  bool unique = false;  ///< `solve --all` finds exactly one shot
  int tries = 2000;     ///< puzzles to solve before giving up
};

struct Generated {
  Puzzle puzzle;
  Answer answer;
};

/// Why tries failed, for the message when there is no puzzle.
struct Tries {
  long draws = 0;  ///< shots simulated; most have other bounces than wished
  int solved = 0;  ///< puzzles given to `solve`
  bool no_room = false;
  int no_shot = 0, other_difficulty = 0, not_unique = 0;
  std::string text() const;
};

/// None after `wish.tries` puzzles, or 50 times as many draws.
std::optional<Generated> generate(const Wish& wish, Random& random, Tries* tries = nullptr);

}  // namespace bankshot
