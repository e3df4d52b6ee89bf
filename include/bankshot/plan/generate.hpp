// SPDX-License-Identifier: MIT
//
// Generates puzzles that have a shot. Each is made from a simulated random shot; if a sequence of cushions or other
// balls are requested, it is made from a random target. Its numbers are rounded as a person would write them. A puzzle
// is kept only if `solve` finds its shot and the target is at least a fifth of the table's diagonal from the ball. The
// same seed gives the same puzzles.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "bankshot/numbers/random.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// A puzzle and the launch from which it was made.
struct Made {
  Puzzle puzzle;
  Launch launch;
  int bounces;
};

/// Makes a puzzle from a simulated shot with `least` to `most` bounces. Its target is the pocket that took the ball,
/// the point where it came to rest, or a point that it passed. Returns none if the shot does not suit the kind drawn.
std::optional<Made> ask(Random& random, const ShotRequest& shot, const Trajectory& trajectory, int least, int most);

/// The difficulty of a shot for a player with the default noise, by `success` and by the smaller side of the
/// aim's margin. easy: at least `easy_success` and `easy_margin`. hard: below `hard_success` or
/// `hard_margin`. medium: anything else.
enum class Difficulty { easy, medium, hard };
inline constexpr double easy_success = 0.9, hard_success = 0.4;
inline constexpr double easy_margin = radians(0.25), hard_margin = radians(0.0625);  ///< 2 and 0.5 sigma
const char* name(Difficulty difficulty);
/// The shot must have margin and success.
Difficulty difficulty(const Shot& shot);

struct Wish {
  Table table{};
  Physics physics{};
  Ball ball{};                     ///< radius and mass
  CushionRule cushions{1, 3, {}};  ///< a number between min and max, drawn for each puzzle, or the sequence
  enum class Kind { pocket, stop, pass, kick, pot, carom };
  std::optional<Kind> kind{};    ///< drop into a pocket, rest at a point, pass it at a speed; touch a ball, send a
                                 ///< ball into a pocket, touch two balls. None: one of the first three is drawn
  int others = 0;                ///< balls besides the cue ball; 0: none, or three if the kind needs some
  CushionRule then{0, 0, {}};    ///< rule for the object ball that is sent into a pocket
  std::optional<Range> speed{};  ///< m/s; launch speeds that a puzzle allows; none: any; not read in `ideal`
  bool spins = true;             ///< about half of the puzzles give the cue ball spin, if the physics carries it
  std::optional<Difficulty> difficulty{};
  bool unique = false;  ///< keep only puzzles for which `solve --all` finds exactly one shot
  int tries = 2000;     ///< puzzles to solve before giving up
};

struct Generated {
  Puzzle puzzle;
  Answer answer;
};

/// Counts of failed tries, for the message when there is no puzzle.
struct Tries {
  long draws = 0;  ///< shots simulated; most do not have the requested bounces
  int solved = 0;  ///< puzzles given to `solve`
  bool no_room = false;
  int no_shot = 0, other_difficulty = 0, not_unique = 0;
  std::string text() const;
};

/// Returns none if `wish.tries` puzzles, or 50 times as many draws, have failed.
std::optional<Generated> generate(const Wish& wish, Random& random, Tries* tries = nullptr);

}  // namespace bankshot
