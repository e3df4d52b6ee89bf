// SPDX-License-Identifier: MIT
//
// Settings of the steps that set object balls going; those of one ball are in planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

namespace chains {
/// Least angle by which an error of aim turns an object ball, as a share of the angle that straight lines give.
inline constexpr double least_turned = 0.7;
/// Launch speeds tried for the object ball, as shares of the cue ball's fixed launch speed.
inline constexpr std::array shares_of_speed{0.8, 0.5, 0.25, 0.1};
/// Cosine of the largest cut that a seed may have.
inline constexpr double least_cosine = 0.01;
/// Cosine of the angle from the line through both balls to an object ball's launch. Below it no arrival speed turns the
/// launch so far that a straight hit gives it.
inline constexpr double least_settled = -0.2;
/// Factors on the launch speed of a seed. If Newton's method fails from the seed itself, another speed is often on the
/// root's side of a fold.
inline constexpr std::array faster_seeds{1.0, 1.2, 0.85};
}  // namespace chains

namespace contact_windows {
/// Parts into which launch speeds divide their bounds, evenly in their logarithm: for caroms at first, and where
/// nothing is found.
inline constexpr int few_rows = 2, rows = 64;
/// Numbers of aims: around the circle, and to either side of the middle of a window.
inline constexpr int fan_steps = 180, cut_steps = 12;
/// Sine of the largest cut, at which a window ends.
inline constexpr double widest = 0.9998;
/// Value of a crossing that is near enough for Newton's method, as a share of the values at both ends.
inline constexpr double settled = 1e-4;
}  // namespace contact_windows

}  // namespace bankshot::planning::settings
