// SPDX-License-Identifier: MIT
//
// Settings of the search for a leave.
#pragma once

#include <array>
#include <cstddef>

#include "bankshot/numbers/angle.hpp"

namespace bankshot::planning::settings {

namespace leave {
/// Launches of one root of the target that are played: so many speeds, from this share of the root's to so many times
/// it, and so many values of a free spin. For a place asked for, so many of them, the nearest of each list of cushions,
/// lead on. The second grid is for a place that the first does not reach: its speeds end at the bounds, where the
/// nearest launch often is.
struct Grid {
  int speeds, spins;
  std::size_t nearest;
  bool to_bounds;
};
inline constexpr Grid usual{10, 5, 3, false}, close{20, 9, 6, true};
inline constexpr double slowest = 0.4, fastest = 6;
/// Places across a pocket are so many deviations apart, and no more than so many are tried.
inline constexpr double room_for_errors = 4;
inline constexpr int most_shifts = 3;
/// Contact points across a ball, if any contact counts.
inline constexpr int contacts = 15;
/// m/s at the target, of the roots.
inline constexpr double arrival = 1;
/// Launches that get a first look by plays; ways to play the shot that then climb by estimates; and launches that climb
/// on by plays, with each halved step.
inline constexpr std::size_t looked_at = 120, compared = 12;
inline constexpr std::array<std::size_t, 3> improved{4, 2, 1};
/// Errors of the plays of an estimate [standard deviations], and the number of rests that are drawn from those plays.
inline constexpr double aim_error = 0.8, speed_error = 1.2;
inline constexpr int rests_drawn = 32;
/// Plays of a first look, of a step of the improvement, of the final choice, and of what is printed.
inline constexpr int first_plays = 16, step_plays = 48, judged_plays = 256, last_plays = 512;
/// Shots by the same way are alike if their ln speed differs by less.
inline constexpr double alike_speed = 0.4;
/// A success that nobody plays for.
inline constexpr double hopeless = 0.01;
/// A success below which the answer says that spin would help.
inline constexpr double likely_left = 0.2;
/// The compass search: first steps across the target [share of its width], of ln speed and of spin.
inline constexpr double step_across = 0.15, step_speed = 0.12, step_spin = 0.25;
/// If no launch stops the cue ball as asked, so many ways to play it are improved until they stop it as near as they
/// can, with the steps halved so often. With 24 ways brute force comes more than 1 cm nearer in 5 of 400 layouts, and
/// with 72 as well.
inline constexpr std::size_t approached = 24;
inline constexpr int approach_halvings = 6;
/// Residual below which an equation is solved, as a share of the diagonal.
inline constexpr double solved = 1e-12;
}  // namespace leave

namespace in_hand {
/// Distances as shares of the table's diagonal: of the grid of places, between the first places that are solved, and
/// the steps of the compass search.
inline constexpr double grid = 0.015, farthest_apart = 0.25, first_step = 0.03, last_step = 0.004;
inline constexpr std::size_t starts_at_most = 8;
/// Value less of a place where a double hit is likely: the rules forbid it, and the model does not know it.
inline constexpr double double_hit = 0.01;
}  // namespace in_hand

namespace next_pot {
/// m on either side of a gap, since a ball that touches a jaw may fall: at a corner; at a middle pocket, for a ball
/// that comes square to the rail. In a corner a rail guides balls in that come along it: so much wider for one that
/// runs by it, less by even steps up to this angle [rad]. Of 1,500 random pots on pool-9ft the estimate errs by 0.07
/// (rms).
inline constexpr double off_jaws = 0.018, off_middle_jaws = 0.01, along_rail = 0.055, guided = radians(30.0);
/// Cosine: thinner cuts are not played.
inline constexpr double thinnest = 0.1;
}  // namespace next_pot

namespace two_pots {
/// m/s, of the next pot.
inline constexpr std::array speeds{1.0, 1.8, 3.2};
/// Pockets that are tried have at least this share of the chance of the best one.
inline constexpr double worth_a_try = 0.7;
}  // namespace two_pots

}  // namespace bankshot::planning::settings
