// SPDX-License-Identifier: MIT
//
// Random shots that drop, each asked as a puzzle that therefore has a shot.
#pragma once

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/random_puzzle.hpp"

namespace bankshot::test {

/// A puzzle whose pocket, cushions (their number or order) and arrival speed are those of a shot.
struct Drop {
  Puzzle puzzle;
  Trajectory path;

  /// Off the jaws of some pocket.
  bool rattles() const;
  /// Off no jaws but those of its pocket, and no cushion after them.
  bool only_at_the_end() const;
};
/// On a preset with pockets, with or without jaws; `spin` physics with their usual laws, else `rolling`.
Drop random_drop(Random& r, bool jaws, bool spin, int most_cushions);

}  // namespace bankshot::test
