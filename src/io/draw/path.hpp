// SPDX-License-Identifier: MIT
//
// Draws moving things on the table: paths with arrowheads and dots at equal times, the balls at bounces with their
// numbers, the margin as a band, and the line of aim as far as the diamond.
#pragma once

#include "bankshot/plan/shot.hpp"
#include "bankshot/simulate/trajectory.hpp"
#include "io/answer/sights.hpp"
#include "io/draw/canvas.hpp"

namespace bankshot::drawing {

struct PathStyle {
  std::string_view colour;
  double width = 2.6;
  double opacity = 1;
  bool dashed = false;
  bool ghosts = true;   ///< draw the ball at each bounce
  bool numbers = true;  ///< number the bounces, on the cushions
};

void draw_path(Canvas& c, const Ball& ball, const Trajectory& t, const PathStyle& style);

/// Returns the seconds between two dots: 0.5, doubled until there are at most 40 dots.
double dot_step(const Trajectory& t);
void draw_dots(Canvas& c, const ShotRequest& shot, const Trajectory& t, std::string_view colour);

/// Draws a number in a disc on the first cushion of a path, or on the path if it meets none.
void draw_tag(Canvas& c, const Ball& ball, const Trajectory& t, int number, std::string_view colour);

/// Draws all aims of the margin as one band, leg by leg between the outermost paths.
void draw_band(Canvas& c, const Puzzle& puzzle, const Shot& shot);

/// Draws the line of aim from the ball to the diamond, or to the nose line if the table has no diamonds.
void draw_aim(Canvas& c, const Vec2d& from, const Sight& aim);

/// Draws another ball with its name. If the name is a number from 1 to 15, the ball has the colours of pool.
void draw_other(Canvas& c, const Ball& ball, const Vec2d& at, double opacity = 1);
/// Returns the colour of the ball and its path.
std::string_view colour_of(const Canvas& c, const Ball& ball);

/// Draws the cue ball. `edge` is the colour of its outline; empty means the theme's.
void draw_ball(Canvas& c, const Ball& ball, const Vec2d& at, double opacity = 1, std::string_view edge = {});

/// Draws the end of the cue ball's path: a ball with a ring if it stops there, a cross if it falls.
void draw_stop(Canvas& c, const Ball& ball, const Vec2d& at, bool stops);

}  // namespace bankshot::drawing
