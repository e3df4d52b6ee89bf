// SPDX-License-Identifier: MIT
//
// Of a family, whose puzzles were each made from a shot: that each is solved, and that no answer is wrong.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/random_puzzle.hpp"

namespace bankshot::test {

struct FoundAgain {
  std::vector<std::string> unsolved;  ///< puzzles
  int off_centre = 0;
};
/// Solves `count` puzzles, checks each shot by a replay of its own and every `each_truth`th in 50 digits.
FoundAgain find_again(const std::string& family, Model model, int count, std::uint64_t seed, int each_truth);

}  // namespace bankshot::test
