// SPDX-License-Identifier: MIT
//
// Every number that steers a search, each with its unit, its reason and what breaks without it. None decides whether a
// launch is a shot: that is what numbers/tolerances.hpp is for. A better value makes searches faster or finds more.
// Those of what a shot is worth, of what is free and of other balls are in merit, family and steps/settings.hpp.
#pragma once

#include <array>
#include <cstddef>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot::planning {

/// The longest steps of a search: rad, and of ln speed; and how many of them it may go from where it starts.
struct Neighbourhood {
  double step_aim, step_speed;
  double far = 3;
};

/// The cells of a map: rad of aim, and of ln speed.
struct Spacing {
  double aim, speed;
  bool whole = false;       ///< also speeds at which neighbouring paths arrive too fast or never
  bool locked = true;       ///< follow a route that is given on its locked path, not where it really occurs
  double narrowest = 1e-4;  ///< rad: routes narrower than this between two others are not looked for
  bool every_root = true;   ///< also of routes that have one, and are not seen to have another
};

inline constexpr Range whole_turn{0, radians(360)};

}  // namespace bankshot::planning

namespace bankshot::planning::settings {

/// Shots to choose from. Most puzzles have fewer; where there are more, the answer says that others were not compared.
inline constexpr std::size_t enough_to_compare = 32;

/// The slowest launch that is looked at, of the fastest that is allowed: a slower one rolls a millionth as far.
inline constexpr double slowest_of_fastest = 1e-3;

/// Ratios of the normal to the tangential loss to unfold with, as shares of the cushion's own restitution. Spin changes
/// the angle of a rebound, and one of these comes near it; with fewer of them more puzzles need a map.
inline constexpr std::array restitution_shares{1.0, 0.8, 1.2, 0.6, 1.5};

/// m/s: the fastest launch from which a family is followed, which may lead back inside the bounds; a strong break shot.
inline constexpr double fastest_start = 15;

/// How far Newton's method may go from an image or a node that is no neighbour of the root: farther leads to others.
inline constexpr Neighbourhood wide{0.3, 0.5};

/// Parts into which each range of spin is divided: five values a component, so 125 searches at most.
inline constexpr int steps_of_spin = 4;

/// Simulations that may go into the words of an answer.
inline constexpr long most_spent_on_words = 200;

/// Reasons of failure that an answer names; a person reads no more.
inline constexpr std::size_t most_reasons_named = 3;

namespace unfolding {
/// Sequences the tree may visit: about 150 MB and a second. That there are more is said in the answer.
inline constexpr long most_visited = 500'000;
/// Images a lattice may list at once: the same memory.
inline constexpr long most_images = 500'000;
/// rad: rays that miss a window's end by this, or twice that, still pass. It is the rounding of images after thousands
/// of reflections; without it paths through corners are lost.
inline constexpr double ray_slack = 1e-10;
/// Of the diagonal: so far from a vertex a ray is seen to lead over the table or out of it. Rays within 1e-6 rad of a
/// cushion count as leading over it; the replay decides.
inline constexpr double little_way = 1e-6;
/// Nodes for which memory is taken at once: most puzzles visit fewer.
inline constexpr std::size_t usual_nodes = 64;
/// Walls for which the distances of all pairs are kept; beyond, the table would cost more than it saves.
inline constexpr std::size_t most_walls_paired = 64;
}  // namespace unfolding

namespace exact_line {
/// Each turn is nearer by the pocket's size over the distance, a tenth or less; a ball closer than that needs a search.
inline constexpr int most_turns = 30;
/// Of the pocket's radius: where turning ends, at rounding.
inline constexpr double settled = 1e-15;
}  // namespace exact_line

namespace image {
/// Aims tried across the part of a target that a ray may reach: windows narrower than a thirtieth of it are missed.
inline constexpr int aims_across = 33;
}  // namespace image

namespace window {
/// rad: where the bisection between two aims that fail differently gives up; a narrower window is no shot for anybody.
inline constexpr double narrowest = 1e-10;
/// Of the way to the limit: the first step towards a window's end, and how steps grow inside and shrink outside.
inline constexpr double first_step = 1.0 / 64, longer = 1.5, shorter = 0.5;
}  // namespace window

namespace sweep {
/// Aims around the circle: a sequence narrower than 0.18° between two equal neighbours is missed.
inline constexpr int fan = 2048;
/// rad: neighbours nearer than this differ only by rounding.
inline constexpr double finest = 1e-14;
/// Cosine of the angle between a leg's directions at two neighbours (6°) beyond which a change of side may hide there.
inline constexpr double widest_turn = 0.995;
}  // namespace sweep

namespace ceres {
/// Aims tried as seeds where no image exists: every half degree.
inline constexpr int aims_in_fan = 720;
}  // namespace ceres

namespace newton {
/// A search that has not settled by then jumps between two sides of a kink.
inline constexpr int most_steps = 40;
/// Steps after which one that does not come nearer is halved; before, Newton's method may overshoot and still converge.
inline constexpr int usual_steps = 4;
/// Steps after which each must come nearer.
inline constexpr int patience = 12;
/// Of a longest step: the step after one so short is exact to rounding.
inline constexpr double settled = 1e-7;
/// The same from which impacts are integrated finely: what is found must be a root, what leads there need not be.
inline constexpr double fine_from = 0.01;
}  // namespace newton

namespace levenberg_marquardt {
/// What Ceres' TinySolver is told. Its cost is half the squared residual, which has no unit: `exact_cost` is a miss of
/// 1e-14 of the diagonal, `converged_cost` one of 1e-6, from where the proof decides.
inline constexpr int most_iterations = 30;
inline constexpr double least_gradient = 1e-18, least_step = 1e-16, exact_cost = 1e-28, converged_cost = 1e-12;
/// The residual where no path arrives: so high that the solver turns back.
inline constexpr double nowhere = 1e3;
}  // namespace levenberg_marquardt

namespace speed_at {
/// Of the squared speed: near enough for a seed; the step after it finds the rest.
inline constexpr double near = 0.05;
inline constexpr int most_steps = 12;
}  // namespace speed_at

namespace speed_near {
inline constexpr int most_steps = 30;
/// Of ln speed: where rounding ends the search, and the longest step.
inline constexpr double settled = 1e-14, longest_step = 0.5;
/// How much further to look for the other side of the root.
inline constexpr double beyond = 1.1;
}  // namespace speed_near

namespace forward {
/// Of the diagonal: a leg that begins this far past the target no longer leads to it.
inline constexpr double behind = 0.05;
/// Of the way to a mouth: how far beside its line of travel a ball that slides may bend.
inline constexpr double bends = 0.3;
}  // namespace forward

namespace roots {
/// Cells from a node to a root that it may seed: neighbouring nodes overlap, so that none is lost between them.
inline constexpr double seed_reach = 1.5;
/// Cells: a Newton step this short tells which root it goes to.
inline constexpr double near = 0.05;
/// How many times likelier or quicker, a cell away, a root may be than the derivatives say. With 2 half as many more of
/// the likeliest shots are lost, for a twelfth fewer simulations.
inline constexpr double distrust = 20;
/// Of the way to a root: a first step that misses it by more leads to another, perhaps.
inline constexpr double astray = 0.7;
/// Cells between two roots that are one: rounding of a root where the map is steep.
inline constexpr double least_apart = 1e-6;
/// Roots of one route: more are one root, which rounding scatters beside a kink.
inline constexpr std::ptrdiff_t most_of_a_route = 64;
/// Cells around a root at which Newton's method starts again to find its twin across a fold, in so many directions.
inline constexpr std::array rings{0.02, 0.1, 0.3};
inline constexpr int ways = 8;
/// Of the diagonal: so near a rail the map bends within a hundredth of a cell.
inline constexpr double hugging = 1e-3;
/// Cells beside a root of such a mark at which the other side is looked for, and how they grow.
inline constexpr double nearest_beside = 0.003, farthest_beside = 1, beside_grows = 1.25;
/// Of the diagonal: a mark nearer to the last cushion is reached soon after it, by balls hardly fast enough.
inline constexpr double beside = 0.2;
/// Halvings of ln speed towards the slowest launch that reaches the last cushion, and by how much faster seeds are.
inline constexpr int halvings = 8;
inline constexpr std::array faster{0.003, 0.01, 0.03};
/// Of ln speed: the longest step from there, where the map is steep.
inline constexpr double step_after_last = 0.03;
}  // namespace roots

namespace forward_map {
/// Of three cushions these cells leave nothing out that a map sixteen times as fine finds (tests/plan/map_test.cpp).
inline constexpr Spacing usual{radians(2), 0.12};
/// Bounces for which `usual` is fine enough: paths with more bend the map more.
inline constexpr int plain_bounces = 3;
/// Cells of speed from a node to launches that arrive as asked, beyond which it is left alone.
inline constexpr double band = 1.5;
/// Rows below those where the neighbour's band began.
inline constexpr std::size_t before_band = 2;
/// rad: where the division between two ways to leave a route that is given ends.
inline constexpr double narrowest_given = 1e-7;
/// By how much farther than predicted a new node lies beyond the end of a cushion, to be surely past it.
inline constexpr double past_the_end = 1.02;
}  // namespace forward_map

namespace along {
/// Launch speeds along a cushion that is touched, evenly spaced in their logarithm.
inline constexpr int speeds = 300;
/// Of the speed: rounding ends the search there.
inline constexpr double settled = 1e-15;
}  // namespace along

namespace parts {
/// rad, and a share of the speed: leads so near each other are one.
inline constexpr double alike = 1e-6;
/// Aims across the part of a target beside a lead.
inline constexpr std::size_t aims_across = 17;
/// A lead whose speed is this much outside its bounds may lead to a shot inside.
inline constexpr double nearly_allowed = 1.3;
}  // namespace parts

namespace rattles {
/// How mouths are looked into: cells from which launches are sent, radii of the ball from one to the next across a
/// mouth, and off the jaws of how many mouths the ball may come on its way. One look after the other until there is a
/// shot: of random drops between jaws the first two leave 0.2 % unsolved with `spin`, the next two 0.1 %, where the
/// usual budget ends; with `rolling`, whose looks are at one speed, all six leave none of 100,000.
struct Look {
  Spacing cell;
  double apart;
  int on_the_way;
};
inline constexpr int most_on_the_way = 2;
inline constexpr std::array looks{Look{{radians(2), 0.1}, 0.25, 0},   Look{{radians(2), 0.1}, 0.25, 1},
                                  Look{{radians(1), 0.15}, 0.25, 1},  Look{{radians(2), 0.3}, 0.25, 2},
                                  Look{{radians(0.5), 0.1}, 0.12, 1}, Look{{radians(0.5), 0.2}, 0.12, 2}};
/// The same in the last mouth of a ball that came off others: any launch that drops will do.
inline constexpr double apart_at_last = 0.75;
/// Radii that launches are sent beyond the ends of the rails, and into what leads straight in, since derivatives tell
/// less the farther a path goes. In the last mouth less than this loses shots after four cushions.
inline constexpr double beyond = 0.2, beyond_at_last = 1.5;
/// The longest step along a band; how many at most; and how often one is shortened, by how much, where the ball does
/// not drop.
inline constexpr Neighbourhood farthest{radians(10), 0.5};
inline constexpr int most_steps = 12, most_shortened = 3;
inline constexpr double shorter = 4;
/// Shots enough to choose from.
inline constexpr std::size_t enough = 8;
}  // namespace rattles

namespace widest {
/// rad: where golden sections end.
inline constexpr double finest = 1e-15;
/// Of the clearance there is, or lacks: less to gain is not worth a simulation.
inline constexpr double little_gain = 0.1;
/// rad beside a lead: wider windows belong to other leads.
inline constexpr double widest_half = radians(10);
/// rad, or a share of the speed: where bisections end.
inline constexpr double narrowest = 1e-10;
/// The speed that arrives as asked jumps where it changes by more than this from one aim to the next.
inline constexpr double jump = 1.002;
/// Rows of aims at speeds across a jump, which begin and end this far beyond it.
inline constexpr int rows = 8;
inline constexpr double beyond = 1.01;
}  // namespace widest

namespace automatic {
/// Of the budget that is left: what bisecting leads may use before finer maps have their turn.
inline constexpr double first_share_of_parts = 0.2;
/// Of value: what more cushions must be able to add to be worth a search. The contract lets a wider question be
/// answered worse by twice as much.
inline constexpr double worth_a_stage = 0.005;
/// Of value: what is found only by looking closely, off jaws or round balls, hardly ever has more.
inline constexpr double best_found_closely = 0.75;
/// Of chance: no rival of such a shot is worth a map.
inline constexpr double sure_enough = 0.995;
/// The map that looks for them. Of 8,000 puzzles each with `robust`, `soft`, `quick` a better shot was missed in 33, 3
/// and 5; in 57, 10 and 15 by cells of twice the width, for four fifths of the simulations.
inline constexpr Spacing rival{.aim = radians(12), .speed = 1, .narrowest = radians(4), .every_root = false};
/// The maps that follow the usual one: finer; where the route really occurs; the last, for pockets.
inline constexpr Spacing fine{radians(0.7), 0.08, true};
inline constexpr Spacing as_it_occurs{radians(2), 0.12, true, false};
inline constexpr Spacing finest{radians(0.8), 0.05, true, false};
}  // namespace automatic

namespace edge {
/// Times what rounding can do: so far beside a launch its bounces are tried where it arrives on a cushion's line. Less
/// would trust the bound to a digit.
inline constexpr double surely = 100;
/// Of the diagonal: how far beside such a target the ball is sent, well inside tolerance::exact_miss.
inline constexpr std::array beside{2e-11, 2e-10, 8e-10};
/// rad, or a share of the speed: an arrival that hardly moves with one of them is not moved by it.
inline constexpr double farthest = 1e-6;
/// The same that is tried all the same: what rounding does to the path before.
inline constexpr double unmoved = 1e-12;
}  // namespace edge

namespace nlopt {
/// Evaluations at most: a start of a local method, a search of a global one, a local search inside MLSL.
inline constexpr int bobyqa_evaluations = 300, sbplx_evaluations = 1000, slsqp_evaluations = 100;
inline constexpr int global_evaluations = 20000, mlsl_local_evaluations = 60;
/// Of the draws of CRS and MLSL.
inline constexpr unsigned long seed = 1;
/// Worse than any miss: what a launch costs that never has the bounces asked.
inline constexpr double wrong_bounces = 1;
/// Where a search ends: the squared miss over the diagonal's square, and the relative step.
inline constexpr double small_enough = 1e-20, least_step = 1e-13;
}  // namespace nlopt

namespace nearest {
/// Launches of the grid, at so many speeds where the speed is free: with 1,000 at 8 speeds, and 4 starts, 10 of 453
/// misses were farther than the nearest of 1,000 random launches.
inline constexpr int launches = 2400, speeds_across = 12;
/// From how many of the best a compass search begins, and where it ends.
inline constexpr std::size_t starts = 12;
inline constexpr int halvings = 20, most_steps = 60;
}  // namespace nearest

namespace sensitivity {
/// m/m. The slope of a level table where it varies: so little that it moves nothing, and its direction has derivatives.
inline constexpr double least_rise = 1e-9;
}  // namespace sensitivity

namespace hints {
/// m/s: a strong break shot; no more speed is suggested.
inline constexpr double strong_break = 15;
/// Simulations for one hint, which must not cost more than the search.
inline constexpr long most_simulations = 30000;
/// Cushions up to which others than those asked are suggested.
inline constexpr int most_cushions = 4;
/// Of natural roll.
inline constexpr std::array side_spins{0.5, -0.5};
}  // namespace hints

}  // namespace bankshot::planning::settings
