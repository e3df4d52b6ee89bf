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

  struct Bounces {
    int min, max;
    const std::vector<Contact>* sequence;  ///< null: any
  };
  /// Of the ball that is sent on as the n-th, from 0.
  Bounces of_sent(const Question& q, std::size_t n) const {
    if (!then) {
      const CushionRule& rule = q.then()->cushions_of(n);
      return {rule.min, rule.max, rule.sequence ? &*rule.sequence : nullptr};
    }
    const std::vector<Contact>& cushions = (*then)[n].cushions;
    const int count = static_cast<int>(cushions.size());
    return {count, count, &cushions};
  }
  /// The first ball may be this one.
  bool allows(int first) const { return !then || then->front().ball == first; }

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
};

}  // namespace bankshot::planning
