// SPDX-License-Identifier: MIT
//
// Settings of a shot's worth: its success, its margin, the order of shots. Those of searches are in
// planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

namespace first_order {
/// Directions in which the edge of what is made is sought. With twice as many the success differs by 0.002.
inline constexpr int directions = 32;
}  // namespace first_order

namespace rank {
/// Bound on success: so many times the success estimate, and so much more. First order knows nothing of balls that fall
/// by a rail or a jaw: with 1.1 times, a shot by three cushions that is likelier by 0.07 was passed over.
inline constexpr double times = 2, more = 0.01;
/// Difference in value that does not count where shots differ in what they leave.
inline constexpr double as_likely = 0.02;
}  // namespace rank

namespace connected {
/// Steps from one shot to another that may be the same.
inline constexpr int steps = 5;
}  // namespace connected

namespace margin {
/// Largest step past the first jaw contact, as a fraction of the margin up to it and of the widest margin there is; the
/// larger one counts. It grows by the first of these fractions from step to step. Balls that fall by the jaws lie in
/// intervals between balls that come out; narrower intervals than this may be missed.
inline constexpr double rattling_step = 0.02, least_rattling_step = 1e-4;
/// Largest margin of speed that is looked for [m/s]; beyond it nothing breaks the shot.
inline constexpr double widest_speed = 30;
/// Longest first step, where derivatives say that a longer one would do [rad, or share of the speed].
inline constexpr double longest_first = 0.1;
/// Share of the margin within which the first look must see the end. Limits are then nearly straight, and few steps
/// inside are enough. Otherwise many are taken: with half of them an interval that is not made may stay hidden.
inline constexpr double nearly = 0.1;
inline constexpr int few_parts = 8, many_parts = 20;
/// Steps inside the margin where an object ball is set going: no limit knows what the cue ball does meanwhile.
inline constexpr int parts_of_chains = 100;
/// Most intervals that may be passed over, each thinner than aims that count as one.
inline constexpr int most_passed = 4;
}  // namespace margin

namespace all_errors {
/// Simulations for the success of a player who errs in more than aim and speed.
inline constexpr int draws = 4096;
}  // namespace all_errors

// Lengths are in standard deviations of the player, where nothing else is said.
namespace success {
/// Most simulations after which another scanline may begin, and those where the cue ball was seen to fall. The third is
/// the number of points spread over each scanline of such a shot but the first. docs/evidence.md says how far success
/// may be off.
inline constexpr std::size_t most_samples = 150, most_samples_of_balls = 400, points_of_balls = 10;
/// Largest error that is simulated; larger ones are taken to do as it does.
inline constexpr double widest = 3.3;
/// Scanlines laid first: so many on either side of the middle one, evenly, and the place of the outermost.
inline constexpr int lines_to_a_side = 4;
inline constexpr double outermost = 2.6;
/// Weight of a difference in success between two scanlines, where the next one is chosen.
inline constexpr double of_change = 16;
/// Points spread over the only scanline, the first, and later ones.
inline constexpr std::size_t points_on_only = 100, points_on_first = 18, points_on_others = 4;
/// Distance from where an edge is expected to the next point tried; it doubles until the edge is passed.
inline constexpr double step = 0.04;
/// Width to which a bracket of an edge is bisected, in probability; the second where there is one scanline.
inline constexpr double narrow = 0.01, finest = 0.0008;
/// Difference in success between the scanlines and first order at which no further scanline is laid.
inline constexpr double agrees = 1e-3;
}  // namespace success

namespace outcome_map {
/// Ratio of one speed to the next in the first look over all that are allowed, and the number of them without a made
/// aim that ends it: a moving ball may block the path at some.
inline constexpr double coarse = 1.15;
inline constexpr int most_missed = 2;
/// Most times that a coarse step is halved.
inline constexpr int most_halvings = 6;
/// Distance of the speeds around the best one, in deviations of the speed, and their number on either side.
inline constexpr double apart = 1.2;
inline constexpr int around = 3;
/// Change of success between two speeds times their distance in deviations, above which they are too far apart.
inline constexpr double uneven = 0.1;
/// Most speeds, which bounds the time of one shot.
inline constexpr std::size_t most_rows = 64;
/// Least deviation of the speed, as a share of it. It spaces the speeds of a player who makes no errors of speed.
inline constexpr double least_deviation = 0.02;
/// Least number of aims tried across what is expected to be made, and the distance to either side of it, in deviations
/// of the aim. With 6 aims 9 of 600 shots are worth less by more than 0.005, and one is worth more.
inline constexpr int aims = 9;
inline constexpr double least_beside = 0.25, most_beside = 2;
/// Deviations beyond which nothing counts, and the precision of edges and best launches. For edges it is a share of
/// what is expected, if that is less.
inline constexpr double far = 8, finest = 0.05;
/// Value that a finer look may add to the first one. With half of it, one that adds 0.063 was passed over.
inline constexpr double hope = 0.1;
/// Most launches of the map whose value is computed: those of other speeds follow if the best falls short of what the
/// map promised.
inline constexpr std::size_t most_tried = 4;
}  // namespace outcome_map

}  // namespace bankshot::planning::settings
