// SPDX-License-Identifier: MIT
//
// For the hard cases: a shot against 50 digits, and the worst seen of a class, printed once.
#pragma once

#include <cstdio>
#include <string>

#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "support/truth.hpp"
#include "truth/hard_cases.hpp"

namespace bankshot::test {

inline Compared against_truth(const ShotRequest& shot, int cushions = 1000000, long events = 5000) {
  const Boundary boundary(shot.table, shot.ball.body);
  return compare_with_truth({boundary, shot.physics, start_state(shot), cushions, events});
}

/// The worst of a class of cases; says so when it goes out of scope.
struct Worst {
  std::string what;
  double ratio = 0, kappa = 1, error = 0;
  int cases = 0, ties = 0;

  explicit Worst(std::string name) : what(std::move(name)) {}
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;
  ~Worst() {
    std::printf("%s: %d cases, %d ties, worst error %.2g m = %.2g of 2^-53 size kappa (C = %g), kappa up to %.2g\n",
                what.c_str(), cases, ties, error, ratio, tolerance::simulation_error, kappa);
  }
  /// True when the events agree, or part at a tie, and the error is within the bound.
  bool within_bound(const Compared& c) {
    ++cases;
    if (c.order == Compared::Order::tie) ++ties;
    if (c.order != Compared::Order::same) return c.order == Compared::Order::tie;
    ratio = std::max(ratio, c.ratio());
    kappa = std::max(kappa, c.kappa);
    error = std::max(error, c.error);
    return c.ratio() <= tolerance::simulation_error;
  }
};

}  // namespace bankshot::test
