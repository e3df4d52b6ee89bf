// SPDX-License-Identifier: MIT
//
// Hard scenes for simulators and planners, by class. The tests in tests/hard check each against its bound, and
// `report` counts them and prints how near they come to it. Each test explains why its class is hard.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bankshot/scene/puzzle.hpp"
#include "truth/condition.hpp"

namespace bankshot::truth {

struct HardCase {
  std::string what;  ///< description for failure messages
  Table table;
  double radius;
  Physics physics;
  State<double> start;
  int cushions = 1000000;
  long events = 5000;
};

Compared compare_with_truth(const HardCase& hard);

/// Returns the classes whose error the simulator's property 6 bounds.
std::vector<std::string_view> hard_classes();
std::vector<HardCase> hard_cases(std::string_view name);

/// Returns the classes of puzzles. Every puzzle has an answer with a miss of at most tolerance::exact_miss of the
/// diagonal.
std::vector<std::string_view> hard_puzzle_classes();
std::vector<Puzzle> hard_puzzles(std::string_view name);

/// Returns a shot on a 2 m × 1 m table with the default physics `spin`.
ShotRequest spin_shot(Vec2d at, double speed, double degrees_, LaunchSpin spin = {});

}  // namespace bankshot::truth
