// SPDX-License-Identifier: MIT
//
// Compares the shots of the hard cases with 50-digit arithmetic and prints the worst error of each class once. A tie
// cannot be compared, so each class states how many ties it may have: 0, or a few times the usual count.
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

/// The worst error seen in a class of cases; the destructor prints it.
struct Worst {
  std::string what;
  double ratio = 0, kappa = 1, error = 0;
  int cases = 0, ties = 0, most_ties;

  explicit Worst(std::string name, int ties_at_most = 0) : what(std::move(name)), most_ties(ties_at_most) {}
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;
  ~Worst() {
    std::printf(
        "%s: %d cases, %d ties (at most %d), worst error %.2g m = %.2g units (C = %g), kappa up to "
        "%.2g\n",
        what.c_str(), cases, ties, most_ties, error, ratio, tolerance::simulation_error, kappa);
  }
  /// Returns true when the events agree and the error is within the bound, or when the runs part at one of the allowed
  /// ties.
  bool within_bound(const Compared& c) {
    ++cases;
    if (c.order == Compared::Order::tie) return ++ties <= most_ties;
    if (c.order == Compared::Order::wrong) return false;
    ratio = std::max(ratio, c.ratio());
    kappa = std::max(kappa, c.kappa);
    error = std::max(error, c.error);
    return c.ratio() <= tolerance::simulation_error;
  }
};

}  // namespace bankshot::test
