// SPDX-License-Identifier: MIT
//
// The launches around a shot that make its target, found once, so that the value of any of them costs no simulation.
// Method: the outcome map tries aims at several launch speeds and bisects every change between them. The success of a
// launch is the sum over the intervals that are made, weighed by the player's normal errors. A first look at all
// allowed speeds is coarse; the map is then refined around the best one. Speeds and aims lie on a lattice which the
// shot does not move. So all shots of one region lead to one map and to the same safest launch, and a mirrored shot to
// its mirror image. An interval between two aims is missed, so the result is an estimate. Cost: some twenty simulations
// for each of twenty speeds.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_request.hpp"
#include "planners/verify/goal.hpp"

namespace bankshot::planning {

class OutcomeMap {
 public:
  /// `request` has the spin of the shot, which must outlive this.
  OutcomeMap(const SearchRequest& request, EvaluationBudget& budget, const Shot& shot);

  /// Returns launches inside the puzzle's bounds with their values, best first: the one of the largest value, and those
  /// of other speeds. None where nothing is made, or where the first look at all speeds leaves no hope of a value of
  /// `worth`.
  struct Best {
    Launch launch;
    double value = 0;
  };
  std::vector<Best> best(double worth);

 private:
  /// An interval of aims that are made [rad beside `origin_`].
  struct Band {
    double low, high;
    double width() const { return high - low; }
    double middle() const { return (low + high) / 2; }
  };
  /// A launch that is made.
  struct Seen {
    double aim;     ///< rad beside `origin_`
    int contacts;   ///< cushions and jaws that its balls meet
    bool as_asked;  ///< it arrives at a speed that the puzzle gives, and the object ball keeps to its cushions
  };
  /// The launches of one speed.
  struct Row {
    double speed;                ///< m/s
    std::vector<Band> bands{};   ///< intervals that are made, in order
    std::vector<Seen> seen{};    ///< in order
    std::optional<Best> best{};  ///< its best launch, until a row is added that changes it
    bool made() const { return !bands.empty(); }
    const Band& widest() const { return *std::ranges::max_element(bands, {}, &Band::width); }
  };

  /// A row, and how much the success of an aim at its speed counts at another speed.
  struct Weight {
    const Row* row;
    double share;
  };

  /// A place on the lattice of launch speeds.
  using Rung = int;

  bool is_made(double aim, Row& row);
  Row row_at(double speed, const Band& expected);
  Band expected_at(double speed) const;
  bool add(Rung rung);
  void look_along();
  bool refine(double speed);
  bool refine_changes(const Launch& best);
  std::vector<Best> best_so_far();
  Launch launch(double aim, double speed) const;
  Best at(double aim, double speed, const Row& row, std::span<const Weight> weights) const;
  Best best_at(double speed) const;
  double deviation(double speed) const;
  std::vector<Weight> weights_at(double speed) const;
  double success(double aim, std::span<const Weight> weights) const;
  double success_at(double aim, const Row& row) const;
  double safest_aim(double speed, std::span<const Weight> weights) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  const Shot& shot_;
  Goal goal_;
  double angle_;             ///< deviation of the aim [rad]
  double origin_;            ///< aim of the lattice that is nearest to the shot's [rad]
  double own_;               ///< the shot's aim, seen from there [rad]
  bool one_speed_;           ///< only the speed of the shot is allowed, or preferred
  Band first_{};             ///< the interval that the shot's derivatives expect
  std::vector<Row> rows_{};  ///< slowest first
};

}  // namespace bankshot::planning
