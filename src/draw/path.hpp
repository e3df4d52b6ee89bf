// SPDX-License-Identifier: MIT
//
// What moves on the table: paths with arrowheads and a dot at equal times, the balls at bounces with their numbers, the
// margin as a band, the line of aim as far as the diamond.
#pragma once

#include "answer/sights.hpp"
#include "bankshot/plan/shot.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "draw/canvas.hpp"

namespace bankshot::drawing {

struct PathStyle {
  std::string_view colour;
  double width = 2.6;
  double opacity = 1;
  bool dashed = false;
  bool ghosts = true;   ///< balls at bounces
  bool numbers = true;  ///< of the bounces, on the cushions
};

void draw_path(Canvas& c, const Ball& ball, const Trajectory& t, const PathStyle& style);

/// Seconds between two dots: half of one, or as many as keep them apart.
double dot_step(const Trajectory& t);
void draw_dots(Canvas& c, const ShotRequest& shot, const Trajectory& t, std::string_view colour);

/// A number in a disc on the cushion that a path meets first, or on the path where it meets none.
void draw_tag(Canvas& c, const Ball& ball, const Trajectory& t, int number, std::string_view colour);

/// All aims of the margin as one band, leg by leg between the outermost paths.
void draw_band(Canvas& c, const Puzzle& puzzle, const Shot& shot);

/// From the ball to the diamond, or to the nose where a table has none.
void draw_aim(Canvas& c, const Vec2d& from, const Sight& aim);

/// Another ball, with its name: in the colours of pool where that is a number from 1 to 15.
void draw_other(Canvas& c, const Ball& ball, const Vec2d& at, double opacity = 1);
/// The colour of its path.
std::string_view colour_of(const Canvas& c, const Ball& ball);

/// `edge`: its outline, the theme's where empty.
void draw_ball(Canvas& c, const Ball& ball, const Vec2d& at, double opacity = 1, std::string_view edge = {});

/// Where the cue ball ends: a ball with a ring round it where it stops, a cross where it falls.
void draw_stop(Canvas& c, const Ball& ball, const Vec2d& at, bool stops);

}  // namespace bankshot::drawing
