// SPDX-License-Identifier: MIT
//
// The truth about a shot: the simulator itself, run in 50 decimal digits from the same double start.
// `verify`, `report` and the tests share it. Only digits50.cpp and many_balls.cpp use the long numbers.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/simulate/event.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::truth {

/// The closest approach of one arc to the run's target. Without a target, it is the line of travel into a pocket or its
/// jaws, or onto a ball, relative to the centre of that pocket or ball.
struct Passing {
  double time = 0;   ///< s since the launch
  double speed = 0;  ///< m/s
  Vec2d at{}, velocity{};
  double miss = std::numeric_limits<double>::infinity();  ///< m
  double lateral = 0, lateral_rest = 0;  ///< m; signed, across the line of travel; the sum has about 32 digits
};

/// An event. In 50 digits, the `rest` members hold the remainders that the doubles lose.
struct TruthEvent {
  EventKind kind;
  Contact contact;
  double time, time_rest;  ///< s; the sum has about 32 digits
  State<double> state;     ///< right after the event
  Vec2d at_rest;           ///< m; state.at + at_rest has about 32 digits
  Passing passing{};       ///< on the arc that led here
  int ball = 0;            ///< the ball of the event; 0 is the cue ball
};

/// A run and its limits: it stops after `cushions` bounces, `events` events, `until` seconds, or at rest.
struct Run {
  const Boundary& boundary;
  const Physics& physics;
  State<double> start;
  int cushions = 1000000;
  long events = 20000;
  std::optional<Vec2d> target{};
  double turned = 0;  ///< rad, small; the launch and its spin are turned by this, without rounding
  double pushed = 0;  ///< relative increase of the speed and spin, without rounding
  double until = forever;
  const ShotRequest* all = nullptr;  ///< set if other balls move: the shot, from this run's start
  int sends = 1;  ///< if `all`: number of object balls in turn; 0: a carom, where the cue ball goes on
};

struct Path {
  std::vector<TruthEvent> events;
  bool ended = false;  ///< ended by rest, a pocket, the time or the number of cushions
};

/// Returns a physics whose integrated impacts are 1e7 times finer than the solver's; any other physics is unchanged.
Physics refined(Physics physics);

/// Runs in 50 digits. If other balls move, each completed arc of theirs is recorded as well, as `slide_to_roll`.
Path run_truth(const Run& run);
/// Runs in double.
Path run_double(const Run& run);
/// Runs in 25, 50 or 100 digits, to measure the cost of digits.
Path run_in_digits(const Run& run, int digits);

/// d(position of the last event)/d(start), columns x, y, vx, vy, wx, wy, wz. It is computed by differences in 50
/// digits, exact to 1e-30, without dual numbers.
struct Jacobian {
  double d[2][7];
};
Jacobian truth_jacobian(const Run& run);

}  // namespace bankshot::truth
