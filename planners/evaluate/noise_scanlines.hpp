// SPDX-License-Identifier: MIT
//
// Lines of errors, all of one size along the band of what is made: where being made begins and ends on each, and the
// success of all of them together. Errors are counted in deviations of the player.
#pragma once

#include <span>
#include <vector>

namespace bankshot::planning {

/// Of a normal error.
double normal_below(double deviations);

struct NoiseScanline {
  struct Try {
    double across;
    bool made;
  };
  double along;
  std::vector<Try> tries{};     ///< in order of `across`
  std::vector<double> edges{};  ///< where being made begins or ends, in order
  bool open = false;            ///< made before the first edge
  double success = 0;           ///< of all errors on this line

  bool made(double across) const;
  /// The number of neighbouring tries that differ.
  int changes() const;
  /// Edges and success from the tries; an edge expected inside its bracket is taken to lie there.
  void read_off(const std::vector<double>& expected);
};

/// The success of all errors. Between lines, in order of `along`, it is a monotone cubic (Fritsch & Butland 1984),
/// summed with the normal density by Gauss's rule; beyond them it is that of the last.
double success_of(std::span<const NoiseScanline> lines);

}  // namespace bankshot::planning
