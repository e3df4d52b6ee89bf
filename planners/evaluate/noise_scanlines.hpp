// SPDX-License-Identifier: MIT
//
// Noise scanlines: lines of launches through the noise distribution. Each scanline has one error `along` the made
// strip, and all errors `across` it. It knows where the made intervals begin and end; all together they give the
// success. Errors are counted in deviations of the player.
#pragma once

#include <span>
#include <vector>

namespace bankshot::planning {

/// Returns the probability that a normal error is below so many deviations.
double normal_below(double deviations);

struct NoiseScanline {
  struct Try {
    double across;
    bool made;
  };
  double along;
  std::vector<Try> tries{};     ///< in order of `across`
  std::vector<double> edges{};  ///< ends of the made intervals, in order
  bool open = false;            ///< made before the first edge
  double success = 0;           ///< success of all errors on this scanline

  /// Returns the number of neighbouring tries that differ.
  int changes() const;
  /// Computes edges and success from the tries. An edge expected inside its bracket is taken to lie there.
  void read_off(const std::vector<double>& expected);
};

/// Returns the success of all errors. Between scanlines, in order of `along`, it is a monotone cubic (Fritsch & Butland
/// 1984), summed with the normal density by Gauss's rule. Beyond them it is that of the last.
double success_of(std::span<const NoiseScanline> lines);

}  // namespace bankshot::planning
