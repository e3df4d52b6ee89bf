// SPDX-License-Identifier: MIT
//
// Settings of searches with a free quantity; those of other searches are in planners/settings.hpp.
#pragma once

#include "planners/settings.hpp"

namespace bankshot::planning::settings {

// Settings of branch searches; lengths are in the scales of the coordinates.
namespace branch {
/// Scales of aim [rad], ln speed and spin [natural roll]: changes over which a locked path bends little.
inline constexpr double scale_of_aim = 0.05, scale_of_speed = 0.15, scale_of_spin = 0.25;
/// Most starts from which a surface of one route is climbed; it may have more than one top.
inline constexpr int most_starts = 3;
/// Most caroms that are tuned where one is wanted.
inline constexpr std::size_t most_tuned_caroms = 6;
/// Tolerance of the corrector along a curve, in scales, where an object ball is to drop. Most such curves have no shot,
/// and points this near to a curve show that as well. They are corrected fully before they are replayed. A tolerance of
/// 0.05 misses shots that full correction finds; full correction costs more simulations.
inline constexpr double loosely = 0.01;
/// Parts into which a step of a curve is divided where none of its points is made. Only steps with a clearance little
/// below 0 are divided: within these shares of the aim point's reach, on the curve or beside it.
inline constexpr int parts_between = 8;
inline constexpr double little_lack = 0.02, little_beside = 0.2;
/// Distances between launches tried beside a curve, as shares of the aim point's reach; they go as far as that to
/// either side. The second is for launches that fall by the jaws, which lie in wide windows.
inline constexpr double apart_beside = 0.05, apart_jaw_shots = 0.2;
/// Clearance of a seed, below 0 and as a share of the diagonal, at which its curve is given up. Seeds of curves with a
/// shot had at most 0.09.
inline constexpr double hopeless = 0.15;
/// Longest step of Newton's method onto a branch, of continuation and of a compass search, and the least step before
/// one is given up.
inline constexpr double longest_step = 2, finest = 0.05;
/// Most steps of continuation, each way.
inline constexpr int most_walked = 60;
/// Share of the merit to which an edge is bisected.
inline constexpr double fine_merit = 2e-4;
/// Most computations of success while a shot is tuned.
inline constexpr int most_tuned = 10;
}  // namespace branch

}  // namespace bankshot::planning::settings
