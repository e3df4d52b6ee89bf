// SPDX-License-Identifier: MIT
//
// Settings of the search where something is free; those of other searches are in planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

// Searches of branches where something is free; lengths in the scales of the coordinates.
namespace branch {
/// rad, of ln speed, of natural roll: changes over which a locked path bends little.
inline constexpr double scale_of_aim = 0.05, scale_of_speed = 0.15, scale_of_spin = 0.25;
/// Starts from which a surface of one route is climbed: it may have more than one top.
inline constexpr int most_starts = 3;
/// Caroms that are tuned where one is wanted.
inline constexpr std::size_t most_tuned_caroms = 6;
/// Where another ball may drop most curves have no shot, and points that are so near a curve tell that as well: they
/// are settled fully before they are replayed. With 0.05 lists are as long, but miss other shots than the full ones;
/// fully settled points cost 9 % more simulations.
inline constexpr double loosely = 0.01;
/// Parts into which a step of a curve is divided further where none of its points is made; and where it lacks so little
/// room, of the aim point's reach: on the curve, or beside it.
inline constexpr int parts_between = 8;
inline constexpr double little_lack = 0.02, little_beside = 0.2;
/// Of the aim point's reach: how far apart launches beside a curve are that are tried, to either side as far as that
/// reaches; and those that fall by the jaws, which lie in wide bands.
inline constexpr double apart_beside = 0.05, apart_jaw_shots = 0.2;
/// Of the diagonal: of 2,500 curves with a shot the seed lacked at most 0.09 of room; a third of those without lack
/// more.
inline constexpr double hopeless = 0.15;
/// Steps: the longest of Newton's method onto a branch, along a curve, and of a compass search; and the least before
/// one is given up.
inline constexpr double longest_step = 2, finest = 0.05;
/// Steps along a curve, each way.
inline constexpr int most_walked = 60;
/// An edge is bisected to this share of the merit.
inline constexpr double fine_merit = 2e-4;
/// Estimates of the last touch by simulated success, at most.
inline constexpr int most_tuned = 10;
}  // namespace branch

}  // namespace bankshot::planning::settings
