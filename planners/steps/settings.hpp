// SPDX-License-Identifier: MIT
//
// Settings of the steps that set other balls going; those of one ball are in planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

namespace chains {
/// Of the angle by which an error of aim turns an object ball, as straight lines have it: as little as it may be.
inline constexpr double least_turned = 0.7;
/// Of the bounds of the launch: speeds between which legs of a chain are looked for.
inline constexpr double slowest_sent = 1e-3, fastest_sent = 3;
/// Of a launch speed that is given: what the ball that is sent on may get.
inline constexpr std::array shares_of_speed{0.8, 0.5, 0.25, 0.1};
/// Cosine of the largest cut that a seed may have, and rad that a ball's launch is off its image at most, with spin.
inline constexpr double least_cosine = 0.01, image_off = radians(30);
/// Cosine below which no arrival speed turns a ball's launch so far that it can be hit.
inline constexpr double least_settled = -0.2;
/// Turns of the ghost by what throw turned the other ball, and rad where they end: Newton's method does the rest.
inline constexpr int most_corrections = 4;
inline constexpr double settled_turn = 1e-3;
/// Where Newton's method fails from the seed, faster launches are often on its side of a fold.
inline constexpr std::array faster_seeds{1.0, 1.2, 0.85};
/// Rad: the largest cut of a sweep, how many steps to either side, halvings between two, how far beyond what first
/// order says the ball is wide, and rad that are never left.
inline constexpr double widest_cut = radians(89), sweep_beyond = 1.3, widest_aims = radians(30);
/// Of the bound on the launch: no slower speed is where a sweep begins.
inline constexpr double slowest_swept = 0.05;
inline constexpr int sweep_steps = 24, sweep_halvings = 8;
/// Of the aim point's reach: where a launch of a sweep lacks more clearance, nothing beside it is looked for.
inline constexpr double least_hope = 3;
/// Aims to either side and speeds of a grid, and how many of its cells away a root may be that a node predicts.
inline constexpr int grid_steps = 12, grid_rows = 12;
inline constexpr double grid_reach = 2;
/// Of the middle launch speed: where a ball is too slow to reach the other's place it may touch it all the same.
inline constexpr std::array approach_speeds{1.0, 2.0};
/// Times as many aims where the speed is given.
inline constexpr int finer_alone = 2;
/// Steps of a launch speed towards the arrival speed that is asked.
inline constexpr int most_secants = 12;
}  // namespace chains

namespace bands {
/// Launch speeds, evenly in their logarithm, every second of them where all else fails; aims around the circle; of a
/// band, to either side of its middle.
inline constexpr int rows = 32, fan_steps = 180, cut_steps = 12, last_steps = 24;
/// Last of all, of a step from one of these speeds to the next; and of what is left of the budget, so that this does
/// not end the search.
inline constexpr int most_parts = 16;
inline constexpr double share_between = 0.5;
/// Sine of the largest cut: where a band ends.
inline constexpr double widest = 0.9998;
/// Of ln speed: from farther Newton's method would lead to another root, if to any.
inline constexpr double farthest = 1;
/// Of both ends: where a crossing is near enough for Newton's method; evaluations at most.
inline constexpr double settled = 1e-4;
inline constexpr int most_halvings = 20;
/// Halvings between two aims whose balls end otherwise, and how near to the aim point one of them must pass, of its
/// reach.
inline constexpr int most_divisions = 6;
inline constexpr double near = 4;
/// Of one route, launches after which the ball fell that are tried.
inline constexpr std::size_t most_falls = 8;
/// Rad, and of ln speed: a difference that tells a slope.
inline constexpr double small = 1e-5;
}  // namespace bands

namespace caroms {
/// Aims to either side across the first ball and launch speeds: of the first look, and of a closer one.
inline constexpr int aims = 40, speeds = 8, close_aims = 160, close_speeds = 16;
/// Roots that are kept of one route on one side of a fold: they may be of two families.
inline constexpr int most_alike = 2;
}  // namespace caroms

}  // namespace bankshot::planning::settings
