// SPDX-License-Identifier: MIT
//
// The numbers that steer a search, each with its unit, its reason and the harm without it. None decides whether a
// launch is a shot; numbers/tolerances.hpp does that. A better value makes searches faster or finds more. Settings for
// a shot's value, for free speeds and spins, and for object balls are in the settings.hpp of evaluate, solve and
// propose.
#pragma once

#include <array>
#include <cstddef>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

/// The longest steps of a search, in rad and in ln speed, and how many of them it may go from its start.
struct Neighbourhood {
  double step_aim, step_speed;
  double far = 3;
};

/// The cells of a map: rad of aim, and of ln speed.
struct Spacing {
  double aim, speed;
  bool whole = false;       ///< look also at speeds at which neighbouring paths arrive too fast or never, and for a
                            ///< given route where it really occurs, not on its locked path
  double narrowest = 1e-6;  ///< rad; routes narrower than this between two others are not looked for
  bool every_root = true;   ///< look for more roots of a route that has one, even if none is likely
};

inline constexpr Range whole_turn{0, radians(360)};

}  // namespace bankshot::planning

namespace bankshot::planning::settings {

/// Shots to choose from. Most puzzles have fewer; if there are more, the answer says that others were not compared.
inline constexpr std::size_t enough_to_compare = 32;

/// The slowest launch that is tried, as a share of the fastest allowed: it rolls a millionth as far.
inline constexpr double slowest_of_fastest = 1e-3;

/// Step at which Newton's method has converged, as a share of the longest one: the step after one so short is exact to
/// rounding.
inline constexpr double settled = 1e-7;

/// Change at which rounding ends any other iteration: rad, or a share of what changes.
inline constexpr double rounding = 1e-15;

/// Most steps of an iteration; one that has not ended by then jumps between two sides of a kink.
inline constexpr int most_steps = 40;

/// Steps of Newton's method after which each must come nearer: before, it may overshoot and still converge.
inline constexpr int patience = 12;

/// Width at which bisections end: rad, or a share of the speed. Nobody can play a narrower window.
inline constexpr double narrowest = 1e-10;

/// Largest difference between two that are one: rad, a share of the speed, cells of a map, or value.
inline constexpr double alike = 1e-6;

/// Aims tried across the part of a target that a ray may reach; windows narrower than a sixteenth of it are missed.
inline constexpr int aims_across = 17;

/// Success that no further search need improve.
inline constexpr double sure = 0.995;

/// Value that a further search must be able to add. The contract lets a wider puzzle be answered worse by twice as
/// much.
inline constexpr double worth_a_search = 0.005;

/// Ratios of the normal to the tangential loss for unfolding, as shares of the cushion's own restitution. Spin changes
/// the angle of a rebound, and one of these comes near it; with fewer of them more puzzles need a map.
inline constexpr std::array restitution_shares{1.0, 0.8, 1.2, 0.6, 1.5};

/// Launch speed of a strong break shot [m/s]: the fastest that is suggested, and from which a branch is followed, as it
/// may lead back inside the bounds.
inline constexpr double fastest_start = 15;

/// Bounds of Newton's method from an image, or from a node that is no neighbour of the root: a longer way leads to
/// others.
inline constexpr Neighbourhood wide{0.3, 0.5};

/// Parts into which each range of spin is divided: five values per component, so 125 searches at most.
inline constexpr int steps_of_spin = 4;

/// Simulations that may go into the words of an answer.
inline constexpr long most_spent_on_words = 200;

namespace unfolding {
/// Images that are listed at most, in a tree or a lattice: about 150 MB and a second. The answer says if there are
/// more.
inline constexpr long most_images = 500'000;
/// Tolerance of rays that miss a window's end [rad]: by this, or twice that, they still pass. It is the rounding of
/// images after thousands of reflections; without it paths through corners are lost.
inline constexpr double ray_slack = 1e-10;
/// Distance from a vertex at which to test whether a ray leads over the table, as a share of the diagonal. Rays within
/// 1e-6 rad of a cushion count as leading over it; the replay decides.
inline constexpr double little_way = 1e-6;
}  // namespace unfolding

namespace sweep {
/// Aims around the circle, of a sweep and as seeds of `ceres` if there is no image; a sequence narrower than 0.18°
/// between two equal neighbours is missed.
inline constexpr int fan = 2048;
/// Cosine of the angle between a leg's directions at two neighbours (6°) beyond which a change of side may hide there.
inline constexpr double widest_turn = 0.995;
}  // namespace sweep

namespace newton {
/// Step from which impacts are integrated finely, as a share of the longest: the result must be a root, the
/// steps towards it need not.
inline constexpr double fine_from = 0.01;
}  // namespace newton

namespace levenberg_marquardt {
/// Settings of Ceres' TinySolver. Its cost is half the squared residual, which has no unit. `exact_cost` is a miss of
/// 1e-14 of the diagonal, `converged_cost` one of 1e-6, from which verification decides.
inline constexpr double exact_cost = 1e-28, converged_cost = 1e-12;
/// Residual if no path arrives: so high that the solver turns back.
inline constexpr double nowhere = 1e3;
}  // namespace levenberg_marquardt

namespace speed_at {
/// Error of the squared speed, as a share, that is near enough for a seed; the step after it finds the rest.
inline constexpr double near = 0.05;
}  // namespace speed_at

namespace discover {
/// Distance, as a share of the diagonal: a leg that begins this far past the target no longer leads to it.
inline constexpr double behind = 0.05;
/// Bend of a ball that slides, beside its line of travel, as a share of the way to a mouth.
inline constexpr double bends = 0.3;
}  // namespace discover

namespace roots {
/// Most cells from a node to a root that it may seed; neighbouring nodes overlap, so that no root between them is lost.
inline constexpr double seed_reach = 1.5;
/// Length of a Newton step, in cells, that tells which root it goes to.
inline constexpr double near = 0.05;
/// Factor by which a root, one cell away, may be likelier or quicker than the derivatives say. A small one loses more
/// of the likeliest shots and saves few simulations.
inline constexpr double distrust = 20;
}  // namespace roots

namespace forward_map {
/// Cells fine enough by three cushions: a map sixteen times as fine finds no more (tests/plan/map_test.cpp).
inline constexpr Spacing usual{radians(2), 0.12};
/// Bounces for which `usual` is fine enough; paths with more bend the map more.
inline constexpr int plain_bounces = 3;
/// Factor on the predicted turn to the end of a cushion, which puts a new node surely past it.
inline constexpr double past_the_end = 1.02;
/// Least turn from a node to where an interval is divided, as a share of the interval. It bounds the nodes where the
/// prediction is wrong.
inline constexpr double least_turn = 0.01;
}  // namespace forward_map

namespace along {
/// Launch speeds along a cushion that is touched, evenly spaced in their logarithm.
inline constexpr int speeds = 300;
}  // namespace along

namespace jaw_shots {
/// One look into the mouths of pockets. It has the cells from which launches are sent, the distance of launches across
/// a mouth in radii of the ball, and the number of mouths off whose jaws the ball may come on its way. Looks follow
/// each other until there is a shot; each costs more and solves a few more puzzles.
struct Look {
  Spacing cell;
  double apart;
  int on_the_way;
};
inline constexpr std::array looks{Look{{radians(2), 0.1}, 0.25, 0},   Look{{radians(2), 0.1}, 0.25, 1},
                                  Look{{radians(1), 0.15}, 0.25, 1},  Look{{radians(2), 0.3}, 0.25, 2},
                                  Look{{radians(0.5), 0.1}, 0.12, 1}, Look{{radians(0.5), 0.2}, 0.12, 2}};
/// Distance of launches, in radii, in the last mouth of a ball that came off other jaws: any launch that drops will do.
inline constexpr double apart_at_last = 0.75;
/// Radii by which launches are sent beyond the ends of the rails, and into the opening, since derivatives tell less the
/// farther a path goes. In the last mouth less than this loses shots after four cushions.
inline constexpr double beyond = 0.2, beyond_at_last = 1.5;
/// Longest step along the launches that drop, and how often a step is halved if the ball does not drop.
inline constexpr Neighbourhood farthest{radians(10), 0.5};
inline constexpr int most_shortened = 6;
/// Shots enough to choose from.
inline constexpr std::size_t enough = 8;
}  // namespace jaw_shots

namespace widest {
/// Least gain that is worth a simulation, as a share of the size of the clearance.
inline constexpr double little_gain = 0.1;
/// Largest half width of a window beside a candidate [rad]; wider windows belong to other candidates.
inline constexpr double widest_half = radians(10);
}  // namespace widest

namespace automatic {
/// The map of an improvement pass. Cells of twice the width miss about twice as many better shots and save a fifth of
/// the simulations.
inline constexpr Spacing improvement{.aim = radians(12), .speed = 1, .narrowest = radians(4), .every_root = false};
/// The map that follows the usual one where that found nothing.
inline constexpr Spacing fine{radians(0.7), 0.08, true};
}  // namespace automatic

namespace edge {
/// Factor on the rounding error: a launch that arrives on a cushion's line must bounce as often if it is moved by so
/// much. A smaller one would trust the bound to a digit.
inline constexpr double surely = 100;
/// Distances, as shares of the diagonal, by which the ball is sent beside such a target, well inside
/// tolerance::exact_miss.
inline constexpr std::array beside{2e-11, 2e-10, 8e-10};
/// Largest change of a launch: rad, or a share of the speed. An unknown that needs more hardly moves the arrival and is
/// kept.
inline constexpr double farthest = 1e-6;
/// Least change that is tried even so, rad or a share of the speed: the rounding of the path before.
inline constexpr double unmoved = 1e-12;
}  // namespace edge

namespace nlopt {
/// Most evaluations: of one start of a local method, of a global search, and of a local search inside MLSL.
inline constexpr int local_evaluations = 1000, global_evaluations = 20000, mlsl_local_evaluations = 60;
/// Seed of the draws of CRS and MLSL.
inline constexpr unsigned long seed = 1;
/// End of a search: the squared miss over the diagonal's square, and the relative step.
inline constexpr double small_enough = 1e-20, least_step = 1e-13;
}  // namespace nlopt

namespace nearest {
/// Launches of the grid, and number of speeds if the speed is free. With half as many, random launches sometimes
/// come nearer.
inline constexpr int launches = 2400, speeds_across = 12;
/// Number of the best from which a compass search begins.
inline constexpr std::size_t starts = 12;
}  // namespace nearest

namespace sensitivity {
/// Slope of a level table if it varies [m/m]: too small to move anything, but its direction has derivatives.
inline constexpr double least_rise = 1e-9;
}  // namespace sensitivity

namespace hints {
/// Simulations for one hint, which must not cost more than the search.
inline constexpr long most_simulations = 30000;
/// Most cushions that are suggested in place of those asked.
inline constexpr int most_cushions = 4;
/// Side spins that are suggested, in units of natural roll.
inline constexpr std::array side_spins{0.5, -0.5};
}  // namespace hints

}  // namespace bankshot::planning::settings
