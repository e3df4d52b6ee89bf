// SPDX-License-Identifier: MIT
//
// Pictures as SVG text: the table with its cushions, diamonds and pockets, and paths on it.
// Pure functions of their arguments; drawing simulates the shot once and, for a margin's fan, a few
// times more.
#pragma once

#include <span>
#include <string>

#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// A simulated shot: path, bounces, start and end.
std::string draw(const ShotRequest& request, const Trajectory& trajectory);

struct LabelledPath {
  std::string label;
  Trajectory trajectory;
};

/// Several paths on one table, each in its colour, with a legend.
std::string draw(const Table& table, const Ball& ball, std::span<const LabelledPath> paths);

/// A puzzle with its answer: every shot's path, the target, and the best shot's margin of aim as a
/// shaded fan.
std::string draw(const Puzzle& puzzle, const Answer& answer);

}  // namespace bankshot
