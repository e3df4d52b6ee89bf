// SPDX-License-Identifier: MIT
//
// Which launches around a shot are made, labelled once, so that the value of any of them costs no simulation.
// Method: at each of some launch speeds aims are tried across what is expected to be made, and every change between
// them is bisected. The success of a launch is the sum of the bands that are made under the player's normal errors.
// Speeds are laid in few steps over all that the puzzle allows, and then finely around the best of them. Bands between
// two aims are not seen, so that what the map says is an estimate. Cost: some twenty simulations for each of twenty
// speeds.
#pragma once

#include <algorithm>
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

  /// Launches inside the puzzle's bounds with their values: that of the largest value, and those of other speeds, best
  /// first. None where nothing is made, or where the first look at all speeds leaves no hope of a value of `worth`.
  struct Best {
    Launch launch;
    double value = 0;
  };
  std::vector<Best> best(double worth);

  /// Of the shot as it is.
  double own_value() const;

 private:
  /// Aims that are made, from one to another [rad beside the shot's].
  struct Band {
    double low, high;
    double width() const { return high - low; }
    double middle() const { return (low + high) / 2; }
  };
  /// What is made at one launch speed.
  struct Row {
    double speed;               ///< m/s
    std::vector<Band> bands{};  ///< in order
    double arrival = 0;         ///< m/s, at the target
    bool made() const { return !bands.empty(); }
    const Band& widest() const { return *std::ranges::max_element(bands, {}, &Band::width); }
  };

  std::optional<double> arrival_at(double aim, double speed);
  Row row_at(double speed, const Band& expected, int aims);
  Band expected_at(double speed) const;
  bool add(double speed, int aims);
  void look_along();
  bool refine(double speed);
  std::vector<Best> best_so_far() const;
  double deviation(double speed) const;
  double success(double aim, double speed) const;
  double success_at(double aim, const Row& row) const;
  double safest_aim(const Row& row) const;
  bool allowed(const Row& row) const;

  const Question& q_;
  Ledger& ledger_;
  const Shot& shot_;
  Goal goal_;
  double angle_;             ///< rad, deviation of the aim
  Band first_{};             ///< what the shot's derivatives expect
  std::vector<Row> rows_{};  ///< slowest first
};

}  // namespace bankshot::planning
