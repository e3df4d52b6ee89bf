// SPDX-License-Identifier: MIT
//
// Every tolerance of the project, each with its unit, its reason and what follows from it.
// "of the diagonal" means: times the diagonal of the table's bounding box, in metres.
#pragma once

namespace bankshot::tolerance {

/// Of the diagonal. An answer's miss: the centre passes this close to what was asked.
inline constexpr double exact_miss = 1e-9;

/// Times max(1 m/s, speed). An answer's arrival speed may differ this much from the one asked.
inline constexpr double exact_speed = 1e-9;

/// Of the diagonal. A point pocket (radius 0) captures a path that passes this close to it.
inline constexpr double point_pocket = 1e-9;

// The next group is used inside the simulator, where the scalar may be double, a dual number or a
// number of 50 digits. All are part of the law, the same in every scalar: they forgive the rounding of
// *input* (which is double everywhere) or decide what counts as rest, so that the run in 50 digits is the
// truth about the run in double. Only `along` forgives the simulator's own rounding; it is far
// below any bound stated, so it may be the same as well.

/// Of the diagonal. A centre this far beyond a cushion line still counts as touching it: input
/// such as `length - R` and each bounce are rounded. Larger would let a ball start outside;
/// smaller would let one slip behind a cushion at a corner.
inline constexpr double touch = 1e-12;

/// Of the largest coordinate, where that is more than `touch` of the diagonal: a gap is the difference
/// of two lengths of that size, rounded five times. Larger would forgive more than rounding; smaller
/// would lose a ball on a table far from the origin.
inline constexpr double coordinate = 2e-15;

/// Of |v| + R|ω| before the last bounce. A ball on a cushion whose approach speed is below this travels
/// along it: it is the rounding of a velocity that was projected on an inclined cushion and carried over
/// an arc. Larger would swallow real grazing bounces. A whole speed below this after a bounce is 0.
inline constexpr double along = 4e-15;

/// Of the speed |v| + R|ω|. A contact point slower than this rolls: natural roll asked as topspin 1
/// is slip 0 only up to three roundings. Larger would change the path of balls that do slide, by this
/// of its length; smaller would make a slide out of rounding, with a direction of noise.
inline constexpr double slip = 1e-15;

/// Of the launch's |v| + R|ω|. A ball that leaves a cushion slower than this, while friction drives
/// it back, stays on the cushion. Larger would move the path measurably (by (this·v)²/a); smaller
/// only adds bounces to a series that never ends.
inline constexpr double resting = 1e-9;

/// Of the launch's |v| + R|ω|. A ball that touches both cushions of a corner and is slower than this, while
/// friction drives it in, stays there. It must be a few times `resting`, which is the size of the bounces it ends.
inline constexpr double crawling = 1e-8;

/// Seconds. The slip of a ball that a cushion holds turns; a piece of its path with the slip's direction held is no
/// longer than this, and a slip that lasts no longer than the second ends without turning. Longer would be less exact
/// (detail/held.hpp), shorter slower.
inline constexpr double longest_piece = 2e-3, last_piece = 1e-6;

/// Radians, and seconds. Of balls that press on each other a piece may last longer than longest_piece, up to the
/// second, as long as no line of centres and no friction turns by more than the first: the paths are as exact in half
/// the pieces. Larger would be less exact, smaller slower.
inline constexpr double turned = 5e-3, quiet_piece = 2e-2;

/// Of the ball's radius (of a point, a pool ball's). On a tilted table events are looked for on parabolas this close to
/// the path; then they are moved onto it. Larger would miss cushions that are grazed, and show in the miss of a target
/// passed; smaller takes more pieces, as its cube root.
inline constexpr double chord = 4e-9;

/// m/s. Of a faster ball that is larger by the fourth power of its speed, so that a path takes hardly more pieces.
inline constexpr double fast_chord = 8;

/// m/s. A ball that rolls slower than this on a tilted table halts, and starts again downhill where it cannot rest: one
/// that rolls nearly straight uphill would else turn in ever shorter pieces. No path shows it.
inline constexpr double halt = 1e-30;

/// Seconds. A ball that starts downhill from a halt, where friction grows with the speed, speeds up evenly for so long:
/// what that neglects is far below rounding.
inline constexpr double first_piece = 1e-4;

/// Of the launch's |v| + R|ω|. A ball slower than this after a bounce is at rest. Without friction it
/// slows down by a factor a bounce for ever; much smaller and the squares of its speed would underflow.
inline constexpr double still = 1e-100;

/// m/s. Two balls that meet slower than this stay together, by a law without restitution and friction: two that roll
/// side by side would else meet ever more slowly without end. Larger would be seen, smaller takes more events.
inline constexpr double slow_contact = 1e-4;

/// m/s, and of the launch's |v| + R|ω| where that is less. Balls that touch and approach or part slower than this while
/// friction drives them together are held, which is no event. Larger would pull on balls that part; smaller takes
/// thousands of events where several balls crowd together.
inline constexpr double held_contact = 1e-5, held_part = 1e-3;

/// m. Balls that are held come apart by up to 2e-7 m in a piece where one goes round the other fast, mostly by 1e-10.
/// Not more apart than this they go on being held: balls are less round. Smaller takes hundreds of events, for two that
/// are let go come back and bounce.
inline constexpr double held_gap = 1e-5;

/// Of the launch's |v| + R|ω|. Balls that touch and approach slower than this do not, where friction soon stops them.
/// Larger would let them overlap by more than rounding; smaller takes hundreds of events where a ball rolls past
/// another.
inline constexpr double still_contact = 1e-12;

/// Of slow_contact. A ball that others press on, and that rolls slower than this where a piece of its path ends, rests.
inline constexpr double pressed_rest = 0.1;

/// m. Balls may overlap so much at the start, by the rounding of whoever wrote the file; they count as touching.
inline constexpr double overlap = 1e-9;

/// m. Balls that overlap by up to this are moved apart where the scene asks for it ("settle"): a camera or a hand is
/// off so far. Larger would move balls by what a player sees; smaller would refuse racks that are measured well.
inline constexpr double settled_overlap = 1e-4;

/// Of the normal approach speed. What the steps of an integrated cushion impact may neglect. Larger
/// saves little time and shows sooner in paths of many cushions; smaller is below rounding.
inline constexpr double impact = 1e-13;

/// The same where a seed is looked for, not a root. Ten times larger costs twice the simulations, for seeds that lead
/// nowhere; a hundredth of it costs half as much time again.
inline constexpr double rough_impact = 1e-4;

/// Of the extent (see Boundary). A hit this far beyond the end of an edge still belongs to it, so that
/// no path slips between two edges that meet at a reflex vertex when the ball has radius 0.
inline constexpr double edge_end = 1e-15;

/// No unit: C of the error bound of the simulator (simulate/simulator.hpp, property 6): |error of the
/// final position| <= C · 2⁻⁵³ · size · κ. Larger would promise less; the worst ratio seen is
/// logged by `shots --truth` and by tests/simulate (1.7 among 72,000 shots).
inline constexpr double simulation_error = 4;

/// Of the unit of that bound, 2⁻⁵³: what it is where a table leans, and a path is summed up of hundreds of pieces, each
/// rounded anew. Of 1,000 shots of `shots --family tilted` (125 each of the seeds 1 to 8) the worst is at 1.7 units,
/// where C is 4.
inline constexpr double pieces_rounding = 64;

/// Of the diagonal. A target asked exactly on a cushion line, or a path through a corner, is
/// approached from the side that keeps the asked bounces by moving the aim this much (and ten
/// times this) at the target. Well inside `exact_miss`, well above rounding.
inline constexpr double nudge = 2e-11;

/// Radians. Two shots with the same bounces whose aims differ by less are one shot.
inline constexpr double same_aim = 1e-9;

/// Of max(1, bound). A speed or aim this far outside its bounds is brought back onto them: the
/// root of a puzzle whose answer lies exactly on a bound is rounded.
inline constexpr double bound = 1e-12;

/// m/s and m/s². Speeds and decelerations beyond these are refused: their squares and products would
/// leave the range of a double long before a ball could move like that.
inline constexpr double fastest = 1e6;
inline constexpr double slowest = 1e-60;

/// Of the margin. Where the bisection for a margin stops.
inline constexpr double margin = 1e-6;

/// Of probability. What an answer's `success` may be off by: twice the worst of 1,050 random shots against 100,000
/// draws (test_plan "[long]", 0.0051, draws included). Larger would let wrong chances pass `verify`.
inline constexpr double success = 0.01;

// What a recording of a real shot may be (scene/recording.hpp). Cameras err by millimetres and lose a ball for moments.
namespace recording {

/// m. Two samples in a row this far beyond the cushions are not on the table. Larger would fit what is seen of a ball
/// on the floor; smaller would refuse lenses that bend the edges.
inline constexpr double off_the_table = 0.05;

/// m/s, and m. Between two samples no ball goes farther than this speed leads, and this much more: the fastest break
/// shots are 14 m/s. Larger would take another ball for this one; smaller would refuse a fast shot.
inline constexpr double fastest_ball = 20, jump = 0.05;

/// m, and s. A ball that stays within this for so long stands. Larger would take a slow ball for one that stands,
/// smaller a camera's noise for motion.
inline constexpr double standing = 0.01, standing_time = 0.5;

}  // namespace recording

}  // namespace bankshot::tolerance
