// SPDX-License-Identifier: MIT
//
// Solves puzzles of a family, each made from a shot, and checks that each is solved and that no answer is wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/random_puzzle.hpp"

namespace bankshot::test {

struct FoundAgain {
  std::vector<std::string> unsolved;  ///< the puzzles that were not solved
  int off_centre = 0;
};
/// Solves `count` puzzles, verifies the first shot of each by an independent replay, and checks every `each_truth`-th
/// answer in 50 digits.
FoundAgain find_again(const std::string& family, Model model, int count, std::uint64_t seed, int each_truth);

}  // namespace bankshot::test
