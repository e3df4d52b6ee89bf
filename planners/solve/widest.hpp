// SPDX-License-Identifier: MIT
//
// Finds the largest clearance around a candidate (trace/clearance.hpp), over aims at the speeds that arrive as asked.
// If that is positive, a shot is likely. Cost: some 100 simulations a candidate.
// Guarantee: none; what it finds is verified by a replay.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "planners/evaluation_budget.hpp"
#include "planners/search_result.hpp"
#include "planners/settings.hpp"
#include "planners/trace/residual.hpp"

namespace bankshot::planning {

class Widest {
 public:
  /// Sets the candidate's `half` where it is 0.
  Widest(const SearchRequest& request, EvaluationBudget& budget, SearchResult& found, Candidate& candidate);

  /// Finds the largest clearance, which the candidate's `room` receives; it may make a shot.
  void find();

 private:
  static constexpr std::size_t aims_across = settings::aims_across, middle = aims_across / 2;
  static constexpr double blocked = -std::numeric_limits<double>::infinity();

  /// An aim at a speed, and its clearance.
  struct Tried {
    double x = 0;  ///< rad
    double speed = 0;
    double value = blocked;
  };
  using Row = std::array<Tried, aims_across>;

  static const Tried& before(const Row& row, std::size_t i) { return row[i > 0 ? i - 1 : i]; }
  static const Tried& after(const Row& row, std::size_t i) { return row[std::min(i + 1, aims_across - 1)]; }
  static std::vector<std::size_t> peaks_of(const Row& row);
  template <class Attempt>
  static Tried highest(const Row& row, std::size_t peak, const Attempt& attempt);

  double half_window() const;
  Row along_lead() const;
  double aim_at(std::size_t i) const {
    return candidate_.launch.angle + candidate_.half * (static_cast<double>(i) / middle - 1);
  }
  Tried attempt(double aim, double guess) const;
  Tried at_speed(double aim, double speed) const;
  bool shot(const Tried& t) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  SearchResult& found_;
  Candidate& candidate_;
  Branch aim_;
};

}  // namespace bankshot::planning
