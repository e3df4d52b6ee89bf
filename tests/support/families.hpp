// SPDX-License-Identifier: MIT
//
// Named families of random puzzles that have a shot: the four of random_puzzle.hpp, and one for each thing that a
// puzzle may leave free or that makes a shot hard to find. Each puzzle is made from a simulated shot: it asks for what
// that shot did, and every free range contains the shot's own value. The draws are seeded and use nothing of the
// planners.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "support/random_puzzle.hpp"

namespace bankshot::test {

struct NamedFamily {
  std::string_view name, summary;
  /// Draws until a shot qualifies. `bounces` is the exact number of bounces; -1 leaves it to the family. `puzzle.spin`
  /// is the spin of the shot that the puzzle was made from, also where the puzzle asks for ranges.
  Made (*make)(Random& random, Model model, int bounces);
  bool solvable = true;  ///< false when the evaluation budget may end first
};
std::span<const NamedFamily> named_families();
const NamedFamily* find_family(std::string_view name);

}  // namespace bankshot::test
