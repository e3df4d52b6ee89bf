// SPDX-License-Identifier: MIT
//
// Normal draws spread evenly by an additive sequence: the fractional parts of i φ⁻ᵏ, φ^(d+1) = φ + 1 for d numbers
// (Roberts 2018), as pairs after Box and Muller.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

namespace bankshot::planning {

/// Standard normal numbers, `count` a draw.
class Draws {
 public:
  explicit Draws(std::size_t count) : step_(count + count % 2), at_(step_.size(), 0.5), normal_(step_.size()) {
    const double d = static_cast<double>(step_.size());
    double phi = 2;
    constexpr int enough = 60;
    for (int i = 0; i < enough; ++i) phi = std::pow(1 + phi, 1 / (d + 1));
    for (std::size_t k = 0; k < step_.size(); ++k) step_[k] = std::pow(phi, -static_cast<double>(k + 1));
  }

  const std::vector<double>& next() {
    for (std::size_t k = 0; k < at_.size(); ++k) at_[k] = std::fmod(at_[k] + step_[k], 1);
    for (std::size_t k = 0; k < at_.size(); k += 2) {
      const double size = std::sqrt(-2 * std::log(1 - at_[k])), turn = 2 * std::numbers::pi * at_[k + 1];
      normal_[k] = size * std::cos(turn);
      normal_[k + 1] = size * std::sin(turn);
    }
    return normal_;
  }

 private:
  std::vector<double> step_, at_, normal_;
};

}  // namespace bankshot::planning
