// SPDX-License-Identifier: MIT
//
// Seeded random numbers: the same seed gives the same numbers on every machine and with every standard library.
#pragma once

#include <cstdint>
#include <random>

namespace bankshot {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Starts a separate stream for each number, so that the puzzles of a seed do not depend on how many are requested.
  Random(std::uint64_t seed, std::uint64_t number);
  double uniform(double low, double high);  ///< own arithmetic, because std distributions differ between libraries
  double log_uniform(double low, double high);
  int integer(int low, int high);  ///< both ends included
  bool chance(double p) { return uniform(0, 1) < p; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace bankshot
