// SPDX-License-Identifier: MIT
//
// All tolerances of the project, each with its unit, its reason and its consequence.
// A tolerance "relative to the diagonal" is multiplied by the diagonal of the table's bounding box, in metres.
#pragma once

namespace bankshot::tolerance {

/// Relative to the diagonal. The largest miss of an answer: the centre passes this close to the target.
inline constexpr double exact_miss = 1e-9;

/// Relative to max(1 m/s, speed). An answer's arrival speed may differ this much from the requested one.
inline constexpr double exact_speed = 1e-9;

/// Relative to the diagonal. A point pocket (radius 0) captures a path that passes this close to it.
inline constexpr double point_pocket = 1e-9;

// The next group is used inside the simulator, where the scalar may be double, a dual number or a number of 50 digits.
// These tolerances are part of the laws and the same in every scalar. They forgive the rounding of *input*, which is
// always double, or decide what counts as rest. A run in 50 digits is therefore the exact reference for the run in
// double. Only `along` forgives the simulator's own rounding; it is far below any stated error bound, so it can be the
// same in every scalar, too.

/// Relative to the diagonal. A centre this far beyond a cushion line still counts as touching it, because input
/// such as `length - R` and each bounce are rounded. A larger value would let a ball start outside;
/// a smaller one would let a ball slip behind a cushion at a corner.
inline constexpr double touch = 1e-12;

/// Relative to the largest coordinate. It replaces `touch` if it is the larger length: a gap is the difference of two
/// lengths of that size, rounded five times. A larger value would forgive more than rounding; a smaller one would lose
/// a ball on a table far from the origin.
inline constexpr double coordinate = 2e-15;

/// Relative to |v| + R|ω| before the last bounce. A ball on a cushion with a lower approach speed travels along it:
/// such a speed is the rounding of a velocity that was projected on an inclined cushion and carried over an arc. A
/// larger value would swallow real grazing bounces. A total speed below this after a bounce is 0.
inline constexpr double along = 4e-15;

/// Relative to |v| + R|ω|. A ball whose slip is below this rolls: natural roll requested as topspin 1 gives slip 0 only
/// up to three roundings. A larger value would change the path of sliding balls by this fraction of its length; a
/// smaller one would turn rounding into a slide with a random direction.
inline constexpr double slip = 1e-15;

/// Relative to the launch's |v| + R|ω|. A ball that leaves a cushion slower than this, while friction drives
/// it back, stays on the cushion. A larger value would move the path measurably, by (resting·v)²/a; a smaller one
/// only adds bounces to a series that never ends.
inline constexpr double resting = 1e-9;

/// Relative to the launch's |v| + R|ω|. A ball that touches both cushions of a corner and is slower than this, while
/// friction drives it in, stays there. It must be a few times `resting`, which is the size of the bounces that it ends.
inline constexpr double crawling = 1e-8;

/// Seconds. The slip of a ball that a cushion holds turns. Its path is divided into pieces of at most `longest_piece`,
/// each with a fixed direction of slip; a slip that lasts at most `last_piece` ends without turning. Longer pieces
/// would be less exact (detail/held.hpp), shorter ones slower.
inline constexpr double longest_piece = 2e-3, last_piece = 1e-6;

/// `turned` in radians, `quiet_piece` in seconds. A piece of balls in persistent contact may last up to `quiet_piece`
/// instead of `longest_piece`, as long as no line of centres and no friction turns by more than `turned`. This halves
/// the number of pieces at equal accuracy. Larger values would be less exact, smaller ones slower.
inline constexpr double turned = 5e-3, quiet_piece = 2e-2;

/// Relative to the ball's radius (for a point, a pool ball's). On a tilted table, events are found on parabolas this
/// close to the path and then moved onto the path. A larger value would overlook grazed cushions and show in the miss
/// of a target that is passed. A smaller one takes more pieces: their number grows with the inverse cube root.
inline constexpr double chord = 4e-9;

/// m/s. Above this speed, `chord` grows with the fourth power of the speed, so that a fast path takes hardly more
/// pieces.
inline constexpr double fast_chord = 8;

/// m/s. A ball that rolls slower than this on a tilted table halts, and starts again downhill if it cannot rest.
/// Otherwise a ball that rolls nearly straight uphill would turn in ever shorter pieces. The effect on a path is not
/// visible.
inline constexpr double halt = 1e-30;

/// Seconds. If friction grows with the speed, a ball that starts downhill from a halt accelerates evenly for this time.
/// The error is far below rounding.
inline constexpr double first_piece = 1e-4;

/// Relative to the launch's |v| + R|ω|. A ball slower than this after a bounce is at rest. Without friction, each
/// bounce reduces the speed by a factor without end; with a much smaller value the squares of the speed would
/// underflow.
inline constexpr double still = 1e-100;

/// m/s. Two balls that meet slower than this stay together: the collision has no restitution and no friction. Otherwise
/// two balls that roll side by side would meet ever more slowly without end. A larger value would be visible, a smaller
/// one takes more events.
inline constexpr double slow_contact = 1e-4;

/// `held_contact` in m/s; `held_part` relative to the launch's |v| + R|ω|; the smaller speed counts. Balls that touch
/// and approach or part slower than this, while friction drives them together, are in persistent contact, which is no
/// event. A larger value would pull on balls that part; a smaller one takes thousands of events in a crowd of balls.
inline constexpr double held_contact = 1e-5, held_part = 1e-3;

/// m. Balls in persistent contact stay so up to this gap, which is less than the roundness error of balls. Within a
/// piece they separate by up to 2e-7 m if one moves round the other fast, and usually by 1e-10 m. A smaller value takes
/// hundreds of events, because released balls come back and bounce.
inline constexpr double held_gap = 1e-5;

/// Relative to the launch's |v| + R|ω|. Touching balls that approach slower than this, with friction that soon stops
/// them, count as not approaching. A larger value would let them overlap by more than rounding; a smaller one takes
/// hundreds of events when a ball rolls past another.
inline constexpr double still_contact = 1e-12;

/// Relative to slow_contact. A rolling ball that others press on comes to rest if it is slower than this when a piece
/// of its path ends.
inline constexpr double pressed_rest = 0.1;

/// m. Balls that overlap by at most this at the start count as touching: positions in a file are rounded.
inline constexpr double overlap = 1e-9;

/// m. If the scene asks for it ("settle"), balls that overlap by at most this are moved apart. Positions measured by
/// camera or hand have such errors. A larger value would move balls visibly; a smaller one would refuse well-measured
/// racks.
inline constexpr double settled_overlap = 1e-4;

/// Relative to the normal approach speed. Error allowed in the steps of an integrated cushion impact. A larger value
/// saves little time and shows sooner in paths with many cushions; a smaller one is below rounding.
inline constexpr double impact = 1e-13;

/// Relative to the normal approach speed. The tolerance `impact` for the search for seeds, which are refined later. Ten
/// times larger doubles the simulations because seeds lead nowhere; a hundred times smaller adds half to the time.
inline constexpr double rough_impact = 1e-4;

/// Relative to Boundary::extent. A hit this far beyond the end of an edge still belongs to it, so that
/// no path of a ball of radius 0 slips between two edges that meet at a reflex vertex.
inline constexpr double edge_end = 1e-15;

/// No unit: C of the error bound of the simulator (simulate/simulator.hpp, property 6): |error of the
/// final position| <= C · 2⁻⁵³ · size · κ. A larger value would promise less. `shots --truth` and tests/simulate log
/// the worst ratio seen.
inline constexpr double simulation_error = 4;

/// Factor on the unit 2⁻⁵³ of that bound for tilted tables, where a path is the sum of hundreds of pieces and each
/// piece is rounded. `shots --family tilted` reports the worst ratio, which C = 4 must exceed.
inline constexpr double pieces_rounding = 64;

/// Relative to the diagonal. For a target exactly on a cushion line, or a path through a corner, the aim is moved by
/// this length at the target, and by ten times it, to the side that keeps the requested bounces. It is well below
/// `exact_miss` and well above rounding.
inline constexpr double nudge = 2e-11;

/// Radians. Two shots with the same bounces whose aims differ by less are one shot.
inline constexpr double same_aim = 1e-9;

/// Relative to max(1, bound). A speed or aim this far outside its bounds is moved back onto them, because
/// the root of a puzzle whose answer lies exactly on a bound is rounded.
inline constexpr double bound = 1e-12;

/// m/s and m/s². Larger and smaller speeds and decelerations are refused, because their squares and products would
/// leave the range of a double. No real ball moves like that.
inline constexpr double fastest = 1e6;
inline constexpr double slowest = 1e-60;

/// Relative to the margin. The bisection for a margin stops at this accuracy.
inline constexpr double margin = 1e-6;

/// Probability. Largest error of an answer's `success`. It is twice the worst error seen among 1,050 random shots
/// against 100,000 draws each (test_plan "[long]"). A larger value would let wrong probabilities pass `verify`.
inline constexpr double success = 0.01;

// Limits for recordings of real shots (scene/recording.hpp). Cameras err by millimetres and lose a ball for moments.
namespace recording {

/// m. Two consecutive samples this far beyond the cushions are off the table. A larger value would fit a ball that lies
/// on the floor; a smaller one would refuse lenses that distort the edges.
inline constexpr double off_the_table = 0.05;

/// m/s and m. Between two samples a ball moves at most `jump` plus `fastest_ball` times the time; the fastest break
/// shots reach 14 m/s. Larger values would accept another ball as this one; smaller ones would refuse fast shots.
inline constexpr double fastest_ball = 20, jump = 0.05;

/// m and s. A ball that stays within `standing` for `standing_time` is at rest. Larger distances would take a slow ball
/// for one at rest; smaller ones would take a camera's noise for motion.
inline constexpr double standing = 0.01, standing_time = 0.5;

}  // namespace recording

}  // namespace bankshot::tolerance
