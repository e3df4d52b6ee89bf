// SPDX-License-Identifier: MIT
//
// Draws pictures as SVG text: the table with its cushions, diamonds and pockets, the paths, and a caption that says how
// to play them. The functions are pure. Drawing simulates the shot once, and a few more times for the band of a margin.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// Draws a simulated shot: path, bounces, start and end.
std::string draw(const ShotRequest& request, const Trajectory& trajectory, const PictureStyle& style = {});

struct LabelledPath {
  std::string label;
  Trajectory trajectory;
};

/// Draws several paths on one table, each in its own colour, with a legend.
std::string draw(const Table& table, const Ball& ball, std::span<const LabelledPath> paths,
                 const PictureStyle& style = {});

/// Draws a puzzle with its answer. One shot is drawn as its path with numbered bounces and dots at equal times, the
/// margin of its aim as a band, and the line of aim as far as the diamond. Several shots are numbered and listed. If
/// there is no shot, the nearest miss is drawn. With an empty answer (`Answer{}`) only the puzzle is drawn.
std::string draw(const Puzzle& puzzle, const Answer& answer, const PictureStyle& style = {});

}  // namespace bankshot
