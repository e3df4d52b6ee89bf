// SPDX-License-Identifier: MIT
//
// Named families of random puzzles that have a shot: the four of random_puzzle.hpp, and one for each thing that a
// puzzle may leave free or that makes a shot hard to see. Each puzzle is made from a forward shot: what that shot did
// is what is asked, and every range that is left free contains the shot's own value. Seeded; nothing of the planners.
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "support/random_puzzle.hpp"

namespace bankshot::test {

struct NamedFamily {
  std::string_view name, summary;
  /// Draws until a shot qualifies. `bounces`: exactly so many, -1 for what is usual in the family. The spin of the shot
  /// it was made from is `puzzle.spin`, also where ranges are asked.
  Made (*make)(Random& random, Model model, int bounces);
  bool solvable = true;  ///< false where the budget may end first
};
std::span<const NamedFamily> named_families();
const NamedFamily* find_family(std::string_view name);

}  // namespace bankshot::test
