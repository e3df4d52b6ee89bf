// SPDX-License-Identifier: MIT
//
// Settings of what a shot is worth: its success, its margin, the order of shots; those of searches are in
// planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

namespace first_order {
/// Directions in which the edge of what is made is sought: with twice as many the success differs by 0.002.
inline constexpr int directions = 32;
}  // namespace first_order

namespace rank {
/// What success is at most: so many times the success estimate, and so much more. Of 9,600 random puzzles
/// with all families of tables 5 had another winner than success itself would choose.
inline constexpr double times = 1.1, more = 0.01;
/// Of value: so little less is as good, where shots differ in what they leave.
inline constexpr double as_likely = 0.02;
}  // namespace rank

namespace connected {
/// From one shot to another that may be the same.
inline constexpr int steps = 5;
}  // namespace connected

namespace margin {
/// Of the margin to where jaws are first touched, and of the widest there is: the longest step beyond, and by how much
/// each is longer than the one before. Balls that fall by the jaws lie in bands between balls that come out; narrower
/// bands than this may be jumped.
inline constexpr double rattling_step = 0.02, least_rattling_step = 1e-4;
/// m/s: a margin of speed beyond is none.
inline constexpr double widest_speed = 30;
/// rad, or of the speed: the first step, where derivatives say that a longer one would do.
inline constexpr double longest_first = 0.1;
/// Where the first look saw the end so nearly, limits are nearly straight and few steps inside are enough; else many:
/// with half of them 2 of 90,000 ends hid a band that is not made.
inline constexpr double nearly = 0.1;
inline constexpr int few_parts = 8, many_parts = 20;
/// The same where another ball is sent on: what the cue ball does meanwhile, no limit knows.
inline constexpr int parts_of_chains = 100;
/// Bands thinner than the aims that are one which may be passed over.
inline constexpr int most_passed = 4;
}  // namespace margin

namespace all_errors {
/// Simulations for the success of a player who errs in more than aim and speed.
inline constexpr int draws = 4096;
}  // namespace all_errors

// In standard deviations of the player, where nothing else is said.
namespace success {
/// Simulations after which no further line begins; where the cue ball was seen to fall; and points spread over each
/// line of such a shot but the first. 100 simulations are usual; docs/evidence.md says how far success may be off.
inline constexpr std::size_t most_samples = 150, most_samples_of_balls = 400, points_of_balls = 10;
/// Errors beyond are taken to do as those here: 0.001 of all.
inline constexpr double widest = 3.3;
/// The lines laid first: so many on either side of the middle one, evenly, and where the outermost are.
inline constexpr int lines_to_a_side = 4;
inline constexpr double outermost = 2.6;
/// How many times as much a gap between two lines counts where all errors are made on one and none on the other.
inline constexpr double of_change = 16;
/// Points spread over the only line, the first, and later ones.
inline constexpr std::size_t points_on_only = 100, points_on_first = 18, points_on_others = 4;
/// From where an edge is expected to the next point tried; it doubles until the edge is passed.
inline constexpr double step = 0.04;
/// Of probability: a bracket of an edge is bisected to this; where there is one line.
inline constexpr double narrow = 0.01, finest = 0.0008;
/// Where the lines and first order agree so nearly (of success), no further line is laid.
inline constexpr double agrees = 1e-3;
}  // namespace success

namespace outcome_map {
/// From one speed to the next, where they are laid over all that are allowed; and how many of them in which no aim is
/// made end that: a ball that moves may be in the way at some.
inline constexpr double coarse = 1.15;
inline constexpr int most_missed = 2;
/// How often a coarse step is halved at most.
inline constexpr int most_halvings = 6;
/// Deviations of the speed from one row to the next around the best one, and so many rows on either side.
inline constexpr double apart = 1.2;
inline constexpr int around = 3;
/// Two rows are too far apart where the change of success between them times their distance, in deviations, is more.
inline constexpr double uneven = 0.1;
/// Rows at most, which bounds the time of one shot.
inline constexpr std::size_t most_rows = 64;
/// Of the launch speed: where a player makes no errors of speed, rows are so far apart.
inline constexpr double least_deviation = 0.02;
/// Aims tried across what is expected to be made, and to either side of it, in deviations of the aim.
inline constexpr int aims = 6;
inline constexpr double least_beside = 0.25, most_beside = 2;
/// Deviations: farther than this nothing counts; and how exactly edges and best launches are settled, for edges as a
/// share of what is expected, if that is less.
inline constexpr double far = 8, finest = 0.05;
/// Of value: so much a finer look may find beyond the first one.
inline constexpr double hope = 0.05;
/// Launches of the map whose value is computed: the best of other speeds, where that of the best falls short of what
/// the map promised.
inline constexpr std::size_t most_tried = 4;
}  // namespace outcome_map

}  // namespace bankshot::planning::settings
