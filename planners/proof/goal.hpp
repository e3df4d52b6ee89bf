// SPDX-License-Identifier: MIT
//
// What a replay is held against: after which bounces the ball must reach a mark, and how exactly.
#pragma once

#include <vector>

#include "planners/question.hpp"

namespace bankshot::planning {

enum class Demand {
  exact,       ///< on the exact line or point, at the arrival speed asked
  off_centre,  ///< made, at the arrival speed asked
  made         ///< made, in the contract's sense
};

struct Goal {
  int min, max;                                    ///< bounces before the mark
  const std::vector<Contact>* sequence = nullptr;  ///< those, in order; must outlive this
  Demand demand = Demand::exact;
  const std::vector<Onward>* then = nullptr;  ///< these go on, by these cushions; null: as the puzzle asks
  /// As `success` and `margin` count a shot: its own ball and pocket, the cue ball must not fall, and a pot without a
  /// rule of cushions counts every fall.
  const Shot* counts = nullptr;

  struct Bounces {
    int min, max;
    const std::vector<Contact>* sequence;  ///< null: any
  };
  /// Of the ball that is sent on as the n-th, from 0.
  Bounces of_sent(const Question& q, std::size_t n) const {
    if (counts && n == q.then()->links.size() && q.then()->counts_any_fall()) return {0, max_cushions, nullptr};
    if (!then) {
      const CushionRule& rule = q.cushions_of(n);
      return {rule.min, rule.max, rule.sequence ? &*rule.sequence : nullptr};
    }
    const std::vector<Contact>& cushions = (*then)[n].cushions;
    const int count = static_cast<int>(cushions.size());
    return {count, count, &cushions};
  }
  /// The first ball may be this one.
  bool allows(int first) const {
    if (counts && !counts->hits.empty()) return counts->hits.front().ball == first;
    return !then || then->front().ball == first;
  }
  /// The shot may arrive at this mark.
  bool allows(const Question& q, const Mark& mark) const {
    return !counts || counts->hits.empty() || mark.taken_by == q.mark_of(*counts).taken_by;
  }

  /// As the puzzle asks.
  static Goal of(const Question& q, Demand demand = Demand::exact) {
    const CushionRule& c = q.cushions();
    return {c.min, c.max, c.sequence ? &*c.sequence : nullptr, demand};
  }
  static Goal exactly(const Question& q, int bounces, Demand demand = Demand::exact) {
    Goal goal = of(q, demand);
    goal.min = goal.max = bounces;
    return goal;
  }
  static Goal along(const std::vector<Contact>& contacts, Demand demand = Demand::made) {
    const int n = static_cast<int>(contacts.size());
    return {n, n, &contacts, demand};
  }
  /// As a shot does, which must outlive it.
  static Goal along(const Shot& shot, Demand demand = Demand::made) {
    Goal goal = along(shot.cushions, demand);
    if (!shot.then.empty()) goal.then = &shot.then;
    return goal;
  }
  /// As its success counts it: by any cushions that the puzzle allows. The shot must outlive it.
  static Goal counted(const Question& q, const Shot& shot) {
    Goal goal = of(q, Demand::made);
    goal.counts = &shot;
    return goal;
  }
  /// As its margin counts it: by its own cushions.
  static Goal counted_along(const Shot& shot) {
    Goal goal = along(shot);
    goal.counts = &shot;
    return goal;
  }
};

}  // namespace bankshot::planning
