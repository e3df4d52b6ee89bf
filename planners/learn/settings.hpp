// SPDX-License-Identifier: MIT
//
// Settings of a fit. They decide how soon it finds the truth, not what the truth is.
#pragma once

#include <cstddef>

namespace bankshot::planning::settings::learn {

/// Least speed of a launch [m/s].
inline constexpr double least_speed = 0.02;
/// Prior of any launch before its track is seen: the time [s] between its first sample and the launch, and spins in
/// units of natural roll. Players mostly hit near the centre, a little high, and hold the cue nearly level.
inline constexpr double spread_of_start = 1;
inline constexpr double middle_of_top = 0.3, spread_of_spin = 0.8, spread_of_masse = 0.1;
/// Prior of the masse until the rest is known, since masse bends any path to any other.
inline constexpr double first_masse = 0.005;
/// Prior of the masse if only the first part is known, which cannot tell it from side.
inline constexpr double masse_of_first_part = 1e-3;
/// Prior of a launch that is given while only places of rest were observed: a share of the speed, rad, LaunchSpin.
inline constexpr double known_speed = 0.01, known_angle = 2e-3, known_spin = 0.02;
/// Prior around the intended launch, in usual errors. It keeps a fit where paths are nearly linear in the launch, and
/// is subtracted again from what the samples say.
inline constexpr double errors_of_a_player = 6;
/// Least information of the samples in a direction, as a share of that prior's; less counts as none. Otherwise
/// rounding, or launches that differ, leave a slope without an end, which unbounded errors would explain best.
inline constexpr double hardly_told = 0.1;
/// Steps in side: a usual error, and at least twice a player's error.
inline constexpr double little_aside = 0.05, much_aside = 0.15;
/// Prior of the masse, for which `noise` has no error.
inline constexpr double off_masse = 1e-4;
/// Spins from which a fit of a launch starts. None is without side, because the derivative by side is lost where side
/// dies.
inline constexpr double first_tops[] = {0.3, 1, -0.5, -1.2}, first_sides[] = {0.3, -0.3, 1, -1};
/// Number of different launches among these that are followed to the end of the shot.
inline constexpr std::size_t followed = 5;
/// A launch is fitted first up to this time after its first bounce [s], then after each next one.
inline constexpr double after_bounce = 0.25;
/// A bounce between the launch and the first samples is rare: such a launch must fit better by this factor.
inline constexpr double rare = 2;
/// In standard deviations: distances beyond `robust` weigh linearly until outliers are known, and samples beyond
/// `outlier` are outliers.
inline constexpr double robust = 2.5, outlier = 5;
/// Largest spread of a launch that is accepted; otherwise others are tried. Noise, and one sample in twenty that is an
/// outlier, make it 1.2.
inline constexpr double good = 1.35;

/// Tolerance of integrated impacts while a table is learnt (tolerance::impact), as a share of the normal approach
/// speed. It halves the time of a launch, which is the same to 1e-5 degrees. Derivatives are within 0.3 % of the
/// largest; at 1e-4, for a third less time again, they are off by up to 14 %.
inline constexpr double impact = 1e-6;

/// A shot whose spread is above this multiple of the median is not followed: the others teach the coefficients.
inline constexpr double lost = 3;
/// Largest root mean square distance in sigmas that noise explains, once outliers are known and the laws can follow the
/// shots. Beyond it the launch is another one. A track of 100 samples exceeds 1.15 once in 1000.
inline constexpr double chance = 1.15;

}  // namespace bankshot::planning::settings::learn
