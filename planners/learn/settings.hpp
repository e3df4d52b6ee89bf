// SPDX-License-Identifier: MIT
//
// What a fit chooses; none of it decides what is true, but how soon it is found.
#pragma once

#include <cstddef>

namespace bankshot::planning::settings::learn {

/// m/s: slower is no launch.
inline constexpr double least_speed = 0.02;
/// What is known of any launch before a track is seen. s: between its first sample and the launch. Spins are in units
/// of natural roll: players mostly hit near the centre, a little high, and hold the cue nearly level.
inline constexpr double spread_of_start = 1;
inline constexpr double middle_of_top = 0.3, spread_of_spin = 0.8, spread_of_masse = 0.1;
/// Of the masse until the rest is known: it bends any path to any other.
inline constexpr double first_masse = 0.005;
/// And where no more than the first part is known, which cannot tell it from side.
inline constexpr double masse_of_first_part = 1e-3;
/// A launch that is given where nothing but places of rest was seen is known so well: a share of the speed, rad,
/// LaunchSpin.
inline constexpr double known_speed = 0.01, known_angle = 2e-3, known_spin = 0.02;
/// What a player meant says of what came of it: that it is within so many usual errors. Taken out again of what the
/// samples say, it keeps fits where paths are nearly straight lines of the launch.
inline constexpr double errors_of_a_player = 6;
/// Of the information that this is: what samples tell beyond it in a direction, if less than this share, counts as
/// nothing. Of so little, rounding or launches that differ leave a slope without an end, and errors without bounds
/// explain that best.
inline constexpr double hardly_told = 0.1;
/// In side, a usual error, and at least twice a player's error.
inline constexpr double little_aside = 0.05, much_aside = 0.15;
/// In massé, of which `noise` knows no error.
inline constexpr double off_masse = 1e-4;
/// Spins that a fit of a launch starts from: without side the derivative by it is lost where it fades.
inline constexpr double first_tops[] = {0.3, 1, -0.5, -1.2}, first_sides[] = {0.3, -0.3, 1, -1};
/// Of those, so many different ones are followed to the end of the shot.
inline constexpr std::size_t followed = 5;
/// s. A launch is fitted first up to so long after its first bounce, then up to each next one.
inline constexpr double after_bounce = 0.25;
/// A bounce between the launch and the first samples is rare: such a launch must fit so many times as well.
inline constexpr double rare = 2;
/// In standard deviations: distances beyond weigh linearly until outliers are known, and are outliers beyond that.
inline constexpr double robust = 2.5, outlier = 5;
/// A launch whose spread is below this is the one; else others are tried. Chance and one sample in twenty that is an
/// outlier make it 1.2.
inline constexpr double good = 1.35;

/// Of the normal approach speed: what integrated impacts may neglect while a table is learnt (tolerance::impact). A
/// launch takes half the time and comes out the same to 1e-5 degrees. Derivatives are within 0.3 % of the largest; at
/// 1e-4, for a third less time again, they are off by up to 14 %.
inline constexpr double impact = 1e-6;

/// A shot whose spread is so many times that of half of the shots is not followed: the others teach the coefficients.
inline constexpr double lost = 3;
/// Where outliers are known and the laws can follow the shots: a root mean square distance of so many sigmas is not
/// chance, the launch is another's. A track of 100 samples is within 1.15 but once in 1000.
inline constexpr double chance = 1.15;

}  // namespace bankshot::planning::settings::learn
