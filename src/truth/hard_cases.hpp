// SPDX-License-Identifier: MIT
//
// The scenes that simulators and planners find hard, by class: the tests of tests/hard hold each to its bound,
// and `report` counts them and says how near to the bound they come. Why each is hard stands in its test.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/scene/puzzle.hpp"
#include "truth/condition.hpp"

namespace bankshot::truth {

struct HardCase {
  std::string what;  ///< in words, for a failure
  Table table;
  double radius;
  Physics physics;
  State<double> start;
  int cushions = 1000000;
  long events = 5000;
};

Compared compare_with_truth(const HardCase& hard);

/// Classes whose error is bounded by the simulator's property 6.
std::vector<std::string_view> hard_classes();
std::vector<HardCase> hard_cases(std::string_view name);

/// Classes of puzzles; every one has an answer with a miss of at most tolerance::exact_miss of the diagonal.
std::vector<std::string_view> hard_puzzle_classes();
std::vector<Puzzle> hard_puzzles(std::string_view name);

/// A shot on a 2 × 1 table with the default physics `spin`.
ShotRequest spin_shot(Vec2d at, double speed, double degrees_, LaunchSpin spin = {});

}  // namespace bankshot::truth
