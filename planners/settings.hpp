// SPDX-License-Identifier: MIT
//
// Every number that steers a search, each with its unit, its reason and what breaks without it. None decides whether a
// launch is a shot: that is what numbers/tolerances.hpp is for. A better value makes searches faster or finds more.
// Those of the steps that set other balls going are in steps/settings.hpp.
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
/// How many times likelier or quicker, a cell away, a root may be than the derivatives say. With 2 a third more of the
/// likeliest shots are lost, for a twelfth fewer simulations.
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
/// Parts into which a curve is divided further where none of its points is made; and where it lacks so little room, of
/// the mark's reach.
inline constexpr int finer_walk = 4;
inline constexpr double little_lack = 0.02;
/// Of the mark's reach: how far apart launches beside a curve are that are tried, and how many to either side.
inline constexpr double apart_beside = 0.1;
inline constexpr int most_beside = 12;
/// The same of launches that rattle in, and every how many-th point of a curve is looked at: likely ones fall in wide
/// bands, which change little along a curve.
inline constexpr double apart_rattles = 0.2;
inline constexpr int most_rattles = 4;
inline constexpr std::size_t rattle_points = 2;
/// Of the diagonal: of 2,500 curves with a shot the seed lacked at most 0.09 of room; a third of those without lack
/// more.
inline constexpr double hopeless = 0.15;
/// Newton's steps onto the family; the step after one so short is exact to rounding, if the miss was so small.
inline constexpr int most_steps = 40;
/// Steps after which each must be shorter.
inline constexpr int patience = 8;
inline constexpr double longest_step = 2, settled = 1e-7, nearly = 1e-6;
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
/// Steps of the last touch by simulated success: estimates at most, the finest step, a gain of chance that is worth
/// one, and a chance that needs none.
inline constexpr int most_tuned = 10;
inline constexpr double finest_tuning = 0.2, worth_tuning = 0.001, sure = 0.995;
/// A chance nearer to 0 or 1 is certain.
inline constexpr double least_chance = 1e-15;
}  // namespace family

namespace automatic {
/// Of the budget that is left: what bisecting leads may use before finer maps have their turn.
inline constexpr double first_share_of_parts = 0.2;
/// Of chance: no rival of such a shot is worth a map.
inline constexpr double sure_enough = 0.995;
/// The map that looks for them. Of 8,000 puzzles each with `robust`, `soft`, `quick` a better shot was missed in 33, 3
/// and 5; in 57, 10 and 15 by cells of twice the width, for four fifths of the simulations.
inline constexpr Spacing rival{.aim = radians(12), .speed = 1, .narrowest = radians(4), .every_root = false};
/// The maps that follow the usual one: finer; where the route really occurs; the last, for pockets.
inline constexpr Spacing fine{radians(0.7), 0.08, true};
inline constexpr Spacing as_it_occurs{radians(2), 0.12, true, false};
inline constexpr Spacing finest{radians(0.8), 0.05, true, false};
/// Steps between two shots that may be one.
inline constexpr int between_shots = 5;
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

namespace first_order {
/// Of the diagonal. Balls farther than this from a leg limit nothing.
inline constexpr double far_ball = 0.25;
/// Directions in which the edge of what is made is sought: with twice as many the chance differs by 0.002.
inline constexpr int directions = 32;
/// Deviations: what is farther breaks no shot that counts; and the narrowest band that is stretched.
inline constexpr double farthest = 6, narrowest = 1e-9;
}  // namespace first_order

namespace rank {
/// What success is at most: so many times the first-order chance, and so much more. Of 9,600 random puzzles
/// with all families of tables 5 had another winner than success itself would choose.
inline constexpr double times = 1.1, more = 0.01;
/// The same of a point whose disc reaches over a cushion line: there a ball passes it twice.
inline constexpr double at_cushion_times = 2.5, at_cushion_more = 0.1;
/// Deviations: shots so near that the player's errors may lead from one to the other.
inline constexpr double beside = 4;
/// Of success: so little less is as good, where shots differ in what they leave.
inline constexpr double as_likely = 0.02;
}  // namespace rank

namespace nearest {
/// Launches of the grid, at so many speeds where the speed is free: with 1,000 at 8 speeds, and 4 starts, 10 of 453
/// misses were farther than the nearest of 1,000 random launches.
inline constexpr int launches = 2400, speeds_across = 12;
/// From how many of the best a compass search begins, and where it ends.
inline constexpr std::size_t starts = 12;
inline constexpr int halvings = 20, most_steps = 60;
}  // namespace nearest

namespace margin {
/// Of the margin to where jaws are first touched, and of the widest there is: the longest step beyond, and by how much
/// each is longer than the one before. Balls that rattle in lie in bands between balls that come out; narrower bands
/// than this may be jumped.
inline constexpr double rattling_step = 0.02, least_rattling_step = 1e-4;
/// rad, m/s: margins beyond are none.
inline constexpr double widest_angle = radians(180), widest_speed = 30;
/// Of a step: Newton's method has found an end where it moves less; its steps at most.
inline constexpr double settled = 1e-7;
inline constexpr int most_looks = 20;
/// Where the first look saw the end so nearly, limits are nearly straight and few steps inside are enough; else many:
/// with half of them 2 of 90,000 ends hid a band that is not made.
inline constexpr double nearly = 0.1;
inline constexpr int few_parts = 8, many_parts = 20;
/// The same where another ball is sent on: what the struck ball does meanwhile, no limit knows.
inline constexpr int parts_of_chains = 100;
/// Bands thinner than the aims that are one which may be passed over.
inline constexpr int most_passed = 4;
/// rad or m/s: a margin this small is 0.
inline constexpr double finest = 1e-15;
/// Of the diagonal, per radian: the least condition that a first-order margin is taken from; and bounds of that margin.
inline constexpr double flat = 1e-6, least_scale = 1e-12, most_scale = 0.1;
}  // namespace margin

namespace all_errors {
/// Simulations for the chance of a player who errs in more than aim and speed.
inline constexpr int draws = 4096;
}  // namespace all_errors

namespace sensitivity {
/// m/m. The slope of a level table where it varies: so little that it moves nothing, and its direction has derivatives.
inline constexpr double least_rise = 1e-9;
/// Of a coefficient, to either side: where a law is integrated, rounding and truncation are alike.
inline constexpr double difference = 1e-5;
}  // namespace sensitivity

// In standard deviations of the player, where nothing else is said.
namespace success {
/// Simulations at most; 100 are usual. What the chance is off by is in planners/README.md.
inline constexpr std::size_t most_samples = 150;
/// Errors beyond are taken to do as those here: 0.001 of all.
inline constexpr double widest = 3.3;
/// From where an edge is expected to the next point tried, and how often that doubles.
inline constexpr double step = 0.08;
inline constexpr int most_doublings = 6;
/// A bracket of an edge is bisected to this; on the first line, whose edges all others inherit; where there is one
/// line.
inline constexpr double narrow = 0.05, finer = 0.01, finest = 0.002;
/// Where lines across the band begin.
inline constexpr std::array first_lines{0.0, 0.6, -0.6, 1.2, -1.2, 1.8, -1.8, 2.6, -2.6};
/// Where the outermost two of a band that ends within reach are laid.
inline constexpr double outermost = 2.5, beyond_end = 1.1;
/// Of chance: no further line is worth while below this doubt; and what a line costs at least.
inline constexpr double least_doubt = 2e-4;
inline constexpr std::size_t cheapest_line = 5;
/// How doubt grows with the change of chance between two lines, and what is left where there is none.
inline constexpr double doubt_of_change = 0.15, doubt_always = 0.01;
/// Points spread over the only line, the first, later ones, and later ones where no edge is expected.
inline constexpr std::size_t points_on_only = 100, points_on_first = 18, points_on_others = 4, points_without_edges = 3;
/// Of probability, at either end, where no point is spread.
inline constexpr double tail = 0.0015;
/// Where the first lines and first order agree so nearly (of chance), no further line is laid.
inline constexpr double agrees = 1e-3;
/// Of a bracket's width: what lies z deviations out counts by this times exp(-z²/2), and never more than all.
inline constexpr double thin_out = 3;
/// Of the other shots whose bands are looked at: the least first-order chance, and how many at most; a line so near to
/// one is the line through it.
inline constexpr double least_beside = 5e-4, same_line = 0.05;
inline constexpr std::size_t most_known = 4;
/// Edges this close on neighbouring lines are one; how far beside a new one its neighbours are tried.
inline constexpr double same_edge = 0.3, beside_edge = 0.5;
}  // namespace success

namespace safest {
/// The compass begins with the player's own deviations and ends after so many halvings, or steps.
inline constexpr int halvings = 5, most_steps = 24;
}  // namespace safest

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
