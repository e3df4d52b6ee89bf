// SPDX-License-Identifier: MIT
//
// Pictures as SVG text: the table with its cushions, diamonds and pockets, paths on it, and words below that say how to
// play them. Pure functions of their arguments; drawing simulates the shot once and, for a margin's band, a few times
// more.
#pragma once

#include <span>
#include <string>

#include "bankshot/draw/style.hpp"
#include "bankshot/plan/answer.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

/// A simulated shot: path, bounces, start and end.
std::string draw(const ShotRequest& request, const Trajectory& trajectory, const PictureStyle& style = {});

struct LabelledPath {
  std::string label;
  Trajectory trajectory;
};

/// Several paths on one table, each in its colour, with a legend.
std::string draw(const Table& table, const Ball& ball, std::span<const LabelledPath> paths,
                 const PictureStyle& style = {});

/// A puzzle with its answer. One shot: its path with numbered bounces and a dot each half second, the margin of its aim
/// as a band, the line of aim as far as the diamond. Several: numbered, with a list. None: the nearest miss. An answer
/// of its own making (`Answer{}`) leaves the question alone.
std::string draw(const Puzzle& puzzle, const Answer& answer, const PictureStyle& style = {});

}  // namespace bankshot
