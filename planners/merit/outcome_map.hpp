// SPDX-License-Identifier: MIT
//
// Which launches around a shot are made, labelled once, so that the value of any of them costs no simulation.
// Method: at each of some launch speeds the aims that are made form an interval, whose ends are bisected, beginning
// where the neighbouring speeds have them. The success of a launch is the sum of these intervals under the player's
// normal errors (Gauss and Hermite's rule of five nodes across the speeds). Speeds are laid in few steps over all that
// the puzzle allows, and then finely around the best of them. Bands beside the interval are not seen, so that what the
// map says is an estimate. Cost: some eight simulations for each of twenty speeds.
#pragma once

#include <optional>
#include <vector>

#include "planners/ledger.hpp"
#include "planners/proof/goal.hpp"
#include "planners/question.hpp"

namespace bankshot::planning {

class OutcomeMap {
 public:
  /// `q` has the spin of the shot, which must outlive this.
  OutcomeMap(const Question& q, Ledger& ledger, const Shot& shot);

  /// The launch inside the puzzle's bounds whose value is largest, and that value; none where nothing is made.
  struct Best {
    Launch launch;
    double value = 0;
  };
  std::optional<Best> best();

 private:
  /// The aims that are made at one launch speed.
  struct Row {
    double speed;                       ///< m/s
    bool made = false;                  ///< at any aim
    double low = 0, high = 0;           ///< rad beside the shot's aim
    double arrival = 0;                 ///< m/s, at the target, in the middle
    double middle() const { return (low + high) / 2; }
    double width() const { return high - low; }
  };

  std::optional<double> arrival_at(double aim, double speed);
  bool made(double aim, double speed) { return arrival_at(aim, speed).has_value(); }
  Row row_at(double speed, double low, double high);
  double edge(const Row& row, double expected, double side);
  Row expected_at(double speed) const;
  bool add(double speed);
  void look_along();
  bool refine(double speed);
  double deviation(double speed) const;
  double success(double aim, double speed) const;
  double success_at(double aim, double speed) const;
  double safest_aim(const Row& row) const;
  bool allowed(const Row& row) const;

  const Question& q_;
  Ledger& ledger_;
  const Shot& shot_;
  Goal goal_;
  double angle_;  ///< rad, deviation of the aim
  std::vector<Row> rows_{};  ///< slowest first
};

}  // namespace bankshot::planning
