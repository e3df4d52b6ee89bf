// SPDX-License-Identifier: MIT
#include "bankshot/numbers/random.hpp"

#include <cmath>

namespace bankshot {

Random::Random(std::uint64_t seed, std::uint64_t number) : engine_(0) {
  const auto half = [](std::uint64_t x, int which) { return static_cast<std::uint32_t>(x >> (32 * which)); };
  std::seed_seq sequence{half(seed, 0), half(seed, 1), half(number, 0), half(number, 1)};
  engine_.seed(sequence);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
}

double Random::log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }

int Random::integer(int low, int high) {
  return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
}

}  // namespace bankshot
