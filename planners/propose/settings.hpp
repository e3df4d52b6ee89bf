// SPDX-License-Identifier: MIT
//
// Settings of the steps that set other balls going; those of one ball are in planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

namespace chains {
/// Of the angle by which an error of aim turns an object ball, as straight lines have it: as little as it may be.
inline constexpr double least_turned = 0.7;
/// Of a launch speed that is given: what the ball that is sent on may get.
inline constexpr std::array shares_of_speed{0.8, 0.5, 0.25, 0.1};
/// Cosine of the largest cut that a seed may have.
inline constexpr double least_cosine = 0.01;
/// Cosine below which no arrival speed turns a ball's launch so far that it can be hit.
inline constexpr double least_settled = -0.2;
/// Where Newton's method fails from the seed, faster launches are often on its side of a fold.
inline constexpr std::array faster_seeds{1.0, 1.2, 0.85};
}  // namespace chains

namespace contact_windows {
/// Parts into which launch speeds divide their bounds, evenly in their logarithm: of caroms at first, and where nothing
/// is found.
inline constexpr int few_rows = 2, rows = 64;
/// Aims around the circle, and of a band, to either side of its middle.
inline constexpr int fan_steps = 180, cut_steps = 12;
/// Sine of the largest cut: where a band ends.
inline constexpr double widest = 0.9998;
/// Of both ends: where a crossing is near enough for Newton's method.
inline constexpr double settled = 1e-4;
}  // namespace contact_windows

}  // namespace bankshot::planning::settings
