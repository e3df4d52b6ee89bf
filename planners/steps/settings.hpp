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
/// Steps of a launch speed towards the arrival speed that is asked.
inline constexpr int most_secants = 12;
}  // namespace chains

namespace bands {
/// Parts into which launch speeds divide their bounds, evenly in their logarithm: of caroms at first, and where nothing
/// is found.
inline constexpr int few_rows = 2, rows = 64;
/// Aims around the circle; of a band, to either side of its middle; and the largest cut there [rad].
inline constexpr int fan_steps = 180, cut_steps = 12, last_steps = 24;
inline constexpr double widest_cut = radians(89);
/// Sine of the largest cut: where a band ends.
inline constexpr double widest = 0.9998;
/// Of ln speed: from farther Newton's method would lead to another root, if to any.
inline constexpr double farthest = 1;
/// Of both ends: where a crossing is near enough for Newton's method; evaluations at most.
inline constexpr double settled = 1e-4;
inline constexpr int most_halvings = 20;
/// Of one route, launches after which the ball fell that are tried.
inline constexpr std::size_t most_falls = 8;
/// Rad, and of ln speed: a difference that tells a slope.
inline constexpr double small = 1e-5;
}  // namespace bands

}  // namespace bankshot::planning::settings
