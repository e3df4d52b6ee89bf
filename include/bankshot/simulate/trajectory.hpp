// SPDX-License-Identifier: MIT
//
// A shot, simulated and recorded: the events and the arcs between them, of every ball on the table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/event.hpp"

namespace bankshot {

/// The state right after an event. `contact` is the cushion, vertex, jaw, pocket or other ball.
struct Record {
  EventKind kind;
  double time;  ///< s
  State<double> state;
  Contact contact{};
  int ball = 0;           ///< 0 is the cue ball
  State<double> other{};  ///< if two balls meet: state of the one that `contact` names
};

/// The arc of a ball between two events.
struct Leg {
  double begin;     ///< s since the launch
  double duration;  ///< range of the arc's parameter: s, unless the arc has a drag
  Arc<double> arc;
  State<double> start;
  int ball = 0;
};

/// The cue ball's data, except where a member is for all balls.
struct Trajectory {
  std::vector<Record> events;       ///< of all balls, in order
  std::vector<Leg> legs;            ///< of all balls, in order for each ball; without those of no duration
  EventKind end = EventKind::rest;  ///< rest, pocket, horizon (as asked for), or end: too many events
  double length = 0;                ///< m, of the path
  int cushions = 0;

  std::vector<Contact> sequence() const;  ///< returns the cushions in order
};

/// Returns the trajectory of one ball alone. Meetings with other balls are seen from this one.
Trajectory path_of(const Trajectory& trajectory, int ball);

/// Returns the last record of one ball: where it rests, falls or is stopped.
const Record& end_of(const Trajectory& trajectory, int ball);

inline constexpr long max_events = 1000000;
inline constexpr int ideal_cushions = 100;  ///< number of cushions at which an `ideal` shot without `until` ends

/// Simulates a shot. Throws InvalidInput.
Trajectory simulate(const ShotRequest& request);

/// Returns ½ m v² + ⅕ m R² ω² [J].
double energy(const Body& body, const State<double>& state);
/// Returns the same plus the energy of the ball's height on a table that is not level [J].
double energy(const Physics& physics, const Body& body, const State<double>& state);

/// Returns a ball by number; 0 is the cue ball.
const Ball& ball_of(const ShotRequest& request, int ball);

/// Return the state `t` seconds into a leg, and at a parameter of its arc, which may be a chord of the path.
State<double> state_at(const ShotRequest& request, const Leg& leg, double t);
State<double> state_on(const ShotRequest& request, const Leg& leg, double parameter);

/// Returns the state right after the launch.
State<double> start_state(const ShotRequest& request);

/// Returns the `simulate --json` document, on one line.
std::string to_json(const ShotRequest& request, const Trajectory& trajectory);

inline constexpr double usual_rate = 60;  ///< points per second, unless another rate is asked for

/// Calls `see(time, ball, state)` for each ball in play `rate` times per second, and for the balls of each event.
void sample(const ShotRequest& request, const Trajectory& trajectory, double rate,
            const std::function<void(double, int, const State<double>&)>& see);

/// Returns CSV with the columns t,ball,x,y,vx,vy,wx,wy,wz and one row per call of `see`.
std::string to_csv(const ShotRequest& request, const Trajectory& trajectory, double rate);

}  // namespace bankshot
