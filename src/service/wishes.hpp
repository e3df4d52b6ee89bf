// SPDX-License-Identifier: MIT
//
// The options of `generate` as text, and the puzzles made from them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bankshot/plan/generate.hpp"

namespace bankshot::service {

/// Names in the order of Wish::Kind.
inline constexpr std::string_view kinds[] = {"pocket", "stop", "pass", "kick", "pot", "carom"};

/// The most other balls of a puzzle.
inline constexpr int most_balls = 21;

/// Values of the options with the same names; an empty one means any.
struct Wishes {
  std::uint64_t seed = 0;
  std::string table = "pool-9ft", physics = "spin", cushions = "1-3", then = "0", difficulty, target;
  int balls = 0;
  bool unique = false, no_spin = false;
  std::vector<double> speed{};  ///< m/s; the only one, or the lowest and the highest
};

/// Turns the options into a wish. Throws BadOption, which names the option.
Wish read_wish(const Wishes& wishes);

/// One puzzle as a line of text; an empty line if none was found, and `tries` says why.
struct Made {
  std::string line;
  Tries tries;
};
/// Makes puzzle `number`, counted from 1.
Made make(const Wishes& wishes, const Wish& wish, long number);

}  // namespace bankshot::service
