// SPDX-License-Identifier: MIT
//
// The goal of a replay: after which bounces the ball must reach an aim point, and how exactly.
#pragma once

#include <vector>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

enum class Demand {
  exact,       ///< on the exact line or point, at the arrival speed asked
  off_centre,  ///< made, at the arrival speed asked
  made         ///< made, in the contract's sense
};

struct Goal {
  int min, max;                                    ///< bounces before the aim point
  const std::vector<Contact>* sequence = nullptr;  ///< these bounces, in order; must outlive this
  Demand demand = Demand::exact;
  const std::vector<ObjectBallPath>* then = nullptr;  ///< object balls and their cushions; null: as the puzzle asks
  /// The shot, if it is judged as `success` and `margin` count it: by its own ball and pocket, without a scratch. A pot
  /// without a rule of cushions then counts however the ball falls.
  const Shot* counts = nullptr;

  struct Bounces {
    int min, max;
    const std::vector<Contact>* sequence;  ///< null: any
  };
  /// Returns the rule for the n-th object ball, counted from 0.
  Bounces of_sent(const SearchRequest& request, std::size_t n) const {
    if (counts && n == request.problem->then()->links.size() && request.problem->then()->counts_any_fall())
      return {0, max_cushions, nullptr};
    if (!then) {
      const CushionRule& rule = request.cushions_of(n);
      return {rule.min, rule.max, rule.sequence ? &*rule.sequence : nullptr};
    }
    const std::vector<Contact>& cushions = (*then)[n].cushions;
    const int count = static_cast<int>(cushions.size());
    return {count, count, &cushions};
  }
  /// Returns whether the first ball may be this one.
  bool allows(int first) const {
    if (counts && !counts->path.hits.empty()) return counts->path.hits.front().ball == first;
    return !then || then->front().ball == first;
  }
  /// Returns whether the shot may arrive at this aim point.
  bool allows(const SearchRequest& request, const AimPoint& aim_point) const {
    return !counts || counts->path.hits.empty() ||
           aim_point.taken_by == request.problem->aim_point_of(*counts).taken_by;
  }

  /// Returns the goal as the puzzle asks.
  static Goal of(const SearchRequest& request, Demand demand = Demand::exact) {
    const CushionRule& c = request.cushions();
    return {c.min, c.max, c.sequence ? &*c.sequence : nullptr, demand};
  }
  static Goal exactly(const SearchRequest& request, int bounces, Demand demand = Demand::exact) {
    Goal goal = of(request, demand);
    goal.min = goal.max = bounces;
    return goal;
  }
  static Goal along(const std::vector<Contact>& contacts, Demand demand = Demand::made) {
    const int n = static_cast<int>(contacts.size());
    return {n, n, &contacts, demand};
  }
  /// Returns the goal to do as a shot does; the shot must outlive it.
  static Goal along(const Shot& shot, Demand demand = Demand::made) {
    Goal goal = along(shot.path.cushions, demand);
    if (!shot.path.then.empty()) goal.then = &shot.path.then;
    return goal;
  }
  /// Returns the goal by which success counts a shot: by any cushions that the puzzle allows. The shot must outlive it.
  static Goal counted(const SearchRequest& request, const Shot& shot) {
    Goal goal = of(request, Demand::made);
    goal.counts = &shot;
    return goal;
  }
  /// Returns the goal by which the margin counts a shot: by its own cushions. The shot must outlive it.
  static Goal counted_along(const Shot& shot) {
    Goal goal = along(shot);
    goal.counts = &shot;
    return goal;
  }
};

}  // namespace bankshot::planning
