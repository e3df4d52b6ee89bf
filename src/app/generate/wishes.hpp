// SPDX-License-Identifier: MIT
//
// What `generate` is asked for, in words, and a puzzle after it.
#pragma once

#include <cstdint>
#include <string>

#include "bankshot/plan/generate.hpp"

namespace bankshot::app::generate {

/// In the order of Wish::Kind.
inline constexpr const char* kinds[] = {"pocket", "stop", "pass", "kick", "pot", "carom"};

/// As after the flags of the same names; empty: any.
struct Wishes {
  std::uint64_t seed = 0;
  std::string table = "pool-9ft", physics = "spin", cushions = "1-3", then = "0", difficulty, target;
  int balls = 0;
  bool unique = false;
};

/// Throws FileError, which names the flag.
Wish read_wish(const Wishes& wishes);

/// One puzzle as text, or why there is none.
struct Made {
  std::string line;
  Tries tries;
};
/// Puzzle `number`, from 1, of these wishes.
Made make(const Wishes& wishes, const Wish& wish, long number);

}  // namespace bankshot::app::generate
