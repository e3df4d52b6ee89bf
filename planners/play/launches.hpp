// SPDX-License-Identifier: MIT
//
// Launches that make a target, each with what it leaves: from a root of the target to other speeds, spins and places
// across it. Each is replayed and played out without errors.
// Cost: on_target's simulations (rest.hpp) and two more for a launch.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "planners/play/rest.hpp"
#include "planners/play/worth.hpp"
#include "planners/verify/aftermath.hpp"
#include "planners/verify/prove.hpp"

namespace bankshot::planning::play {

/// A root of the target, from which other launches are found.
struct Root {
  Branch branch;
  Vector x;
  double slope = 0;             ///< m across the target for a radian of aim
  std::optional<Range> made{};  ///< of a pocket: the widest range of shifts that are made
};

/// A launch that makes its target, and how it leaves the cue ball.
struct Launched {
  const Root* root;
  Vector x;
  double shift;  ///< m, across the target
  Shot shot;
  Ending ending;
  double promise = 0;               ///< its value, as far as it can be told without plays
  std::optional<double> success{};  ///< that the target is made and the cue ball left as asked
  int plays = 0;                    ///< by which the success was measured
  double lost = 0;                  ///< what these were worth less than 1 each, in sum
  double value() const { return success ? *success - cost_of(shot) : promise; }
};

class Launches {
 public:
  /// All outlive this.
  Launches(const SearchRequest& request, EvaluationBudget& budget, const LeaveWorth& worth)
      : request_(request), budget_(budget), worth_(worth), box_(branch::box_of(request)) {}

  const branch::Box& box() const { return box_; }
  bool safest() const { return request_.problem->safest(); }
  /// Returns whether any contact with the target ball counts, so that the offset there is free.
  bool any_offset(const Branch& branch) const { return safest() && branch.aim_point.cuts.has_value(); }
  /// Returns whether the target has two equations, which leave neither the speed nor the place across it free.
  bool two_equations() const { return request_.stop || (request_.arrival && request_.arrival->fixed()); }
  bool speed_given() const { return two_equations() || !box_.free(branch::log_speed); }

  /// Finds the widest range of places across a pocket that are made at the speed of a root.
  void look_across(Root& root) const;

  /// Returns the success of a launch to first order, of a pocket in what is made across it at the speed of its root.
  double likely(const Root& root, double shift, const Shot& shot) const;

  /// Plays a launch without errors; none if it does not make the target, or the cue ball falls. `like`: it must make
  /// the target as this shot does.
  std::optional<Launched> play(const Root& root, const Vector& x, double shift, const Shot* like = nullptr) const;

  /// Plays the launch nearest to `x` that reaches its target.
  std::optional<Launched> play_near(const Root& root, const Vector& x, double shift, const Shot* like = nullptr) const;

  /// Compass search over the launches that reach the target, by steps of one size (Kolda, Lewis & Torczon, SIAM Review
  /// 45, 2003, algorithm 3.2). `is_better(one)` says whether a launch is better than `best`, which it then becomes.
  void climb(Launched& best, double scale, const std::function<bool(Launched&)>& is_better) const;

 private:
  Proof prove_at(const Vector& x, const Shot* like = nullptr) const;

  /// A coordinate of a launch, and the first step along it.
  struct Move {
    int coordinate;  ///< -1: across the target
    double step;
  };
  std::vector<Move> moves_of(const Launched& one) const;

  const SearchRequest& request_;
  EvaluationBudget& budget_;
  const LeaveWorth& worth_;
  branch::Box box_;
};

}  // namespace bankshot::planning::play
