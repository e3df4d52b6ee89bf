// SPDX-License-Identifier: MIT
//
// Settings of the search where something is free; those of other searches are in planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

// Families of roots where something is free; lengths in the scales of the coordinates.
namespace family {
/// rad, of ln speed, of natural roll: changes over which a locked path bends little.
inline constexpr double scale_of_aim = 0.05, scale_of_speed = 0.15, scale_of_spin = 0.25;
/// Starts from which a surface of one route is climbed: it may have more than one top.
inline constexpr int most_starts = 3;
/// Caroms that are tuned where one is wanted.
inline constexpr std::size_t most_tuned_caroms = 6;
/// m: a locked path that lacks more room is no shot.
inline constexpr double uncertain = 1e-6;
/// Where another ball may drop most curves have no shot, and points that are so near a curve tell that as well: they
/// are settled fully before they are replayed. With 0.05 lists are as long, but miss other shots than the full ones;
/// fully settled points cost 9 % more simulations.
inline constexpr double loosely = 0.01;
/// Parts into which a curve is divided further where none of its points is made: so many at least and at most, and one
/// for each so many of the aim point's reach that it moves across a launch between. And where it lacks so little room,
/// of the aim point's reach: on the curve, or beside it.
inline constexpr int least_parts = 4, most_parts = 8;
inline constexpr double across_a_part = 0.25;
inline constexpr double little_lack = 0.02, little_beside = 0.2;
/// Sine: an aim point that is hidden by more at two points is hidden between them. From 0.02 to 0.1 no list changes;
/// with 0 one shot of 3,836 is lost.
inline constexpr double little_turn = 0.05;
/// Of the aim point's reach: how far apart launches beside a curve are that are tried, and how many to either side.
inline constexpr double apart_beside = 0.05;
inline constexpr int most_beside = 24;
/// The same of launches that fall by the jaws, and every how many-th point of a curve is looked at: likely ones fall in
/// wide bands, which change little along a curve, though what moves may block some of them.
inline constexpr double apart_jaw_shots = 0.2;
inline constexpr int most_jaw_shots = 4;
inline constexpr std::size_t jaw_shot_points = 2;
/// Of the diagonal: of 2,500 curves with a shot the seed lacked at most 0.09 of room; a third of those without lack
/// more.
inline constexpr double hopeless = 0.15;
/// Newton's steps onto the family: the longest, and the miss from which a short step is exact to rounding.
inline constexpr double longest_step = 2, nearly = 1e-6;
/// Steps along a curve: the first, the longest, the least before it is given up; and how many each way.
inline constexpr double first_walk = 1, longest_walk = 2, least_walk = 0.02;
inline constexpr int most_walked = 60;
/// Of the merit: an edge is bisected to this. Parabolas through three points of a curve bring nothing more after two.
inline constexpr double fine_merit = 2e-4;
inline constexpr int parabolas = 2;
/// The compass search: its longest and its finest step, its evaluations, and a gain that is not worth one.
inline constexpr double longest_climb = 4, finest_climb = 0.01, least_gain = 1e-6;
inline constexpr int most_climbed = 120;
/// rad: turns of the compass that never repeat.
inline constexpr double golden_turn = 2.399963;
/// Steps of the last touch by simulated success: estimates at most, and the finest step.
inline constexpr int most_tuned = 10;
inline constexpr double finest_tuning = 0.2;
/// A success that is worth comparing.
inline constexpr double playable = 0.01;
}  // namespace family

}  // namespace bankshot::planning::settings
