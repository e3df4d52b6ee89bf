// SPDX-License-Identifier: MIT
//
// The truth about a shot: the simulator itself, run in 50 decimal digits from the same double start.
// `verify`, `report` and the tests share it. digits50.cpp is the one file that needs the long numbers.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/scene/physics.hpp"
#include "bankshot/simulate/event.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot::truth {

/// The closest approach of one arc to the run's target; without one, the line of travel into a pocket or its jaws or
/// onto a ball, seen from its centre.
struct Passing {
  double time = 0;   ///< s since the launch
  double speed = 0;  ///< m/s
  Vec2d at{}, velocity{};
  double miss = std::numeric_limits<double>::infinity();  ///< m
  double lateral = 0, lateral_rest = 0;  ///< m, signed, across the line of travel: their sum has about 32 digits
};

/// An event; in 50 digits `rest` keeps what the doubles lose.
struct TruthEvent {
  EventKind kind;
  Contact contact;
  double time, time_rest;  ///< s: their sum has about 32 digits
  State<double> state;     ///< right after it
  Vec2d at_rest;           ///< m: state.at + at_rest has about 32 digits
  Passing passing{};       ///< of the arc that led here
  int ball = 0;            ///< whose event it is; 0 is the struck one
};

/// What to run and when to stop: at the last of `cushions` bounces, `events` events, `until` seconds, or at rest.
struct Run {
  const Boundary& boundary;
  const Physics& physics;
  State<double> start;
  int cushions = 1000000;
  long events = 20000;
  std::optional<Vec2d> target{};
  double turned = 0;  ///< rad, small: the launch is turned by this, its spin with it, ...
  double pushed = 0;  ///< ... and made faster by this, relative; both without rounding
  double until = forever;
  const ShotRequest* all = nullptr;  ///< where other balls move: the shot, from this run's start
  int sends = 1;  ///< then: so many are sent on in turn; 0: the struck ball goes on, off one to another
};

struct Path {
  std::vector<TruthEvent> events;
  bool ended = false;  ///< by rest, a pocket, the time or the number of cushions
};

/// Physics whose integrated impacts are 1e7 times finer than those of the solver; any other physics as it is.
Physics refined(Physics physics);

/// In 50 digits. Where other balls move, each arc of theirs that ends is told as well, as `slide_to_roll`.
Path run_truth(const Run& run);
/// The same in double.
Path run_double(const Run& run);
/// In 25, 50 or 100 digits: to see what digits cost.
Path run_in_digits(const Run& run, int digits);

/// d(position of the last event)/d(start), columns x, y, vx, vy, wx, wy, wz, from differences in 50
/// digits, exact to 1e-30: no dual number is involved.
struct Jacobian {
  double d[2][7];
};
Jacobian truth_jacobian(const Run& run);

}  // namespace bankshot::truth
