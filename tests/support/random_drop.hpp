// SPDX-License-Identifier: MIT
//
// Random shots that drop, each turned into a puzzle that therefore has a shot.
#pragma once

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// A puzzle whose pocket, cushions (their number or order) and arrival speed are those of a shot.
struct Drop {
  Puzzle puzzle;
  Trajectory path;

  /// Returns true for a jaw shot, by the jaws of any pocket.
  bool touches_jaws() const;
  /// Returns true when the ball touches no jaws but those of its own pocket, and no cushion after them.
  bool only_at_the_end() const;
};
/// Draws a shot on a preset with pockets, with or without jaws. `spin` selects the preset's spin physics, otherwise the
/// physics are `rolling`.
Drop random_drop(Random& r, bool jaws, bool spin, int most_cushions);

}  // namespace bankshot::test
