// SPDX-License-Identifier: MIT
//
// Seeded draws: the same seed gives the same numbers on every machine and with every library.
#pragma once

#include <cstdint>
#include <random>

namespace bankshot {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// A stream of its own for each number: the puzzles of a seed do not depend on how many are asked for.
  Random(std::uint64_t seed, std::uint64_t number);
  double uniform(double low, double high);  ///< own arithmetic: std distributions differ by library
  double log_uniform(double low, double high);
  int integer(int low, int high);  ///< both ends included
  bool chance(double p) { return uniform(0, 1) < p; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace bankshot
