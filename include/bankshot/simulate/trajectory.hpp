// SPDX-License-Identifier: MIT
//
// A shot, simulated and recorded: its events and the arcs between them, of every ball on the table.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/event.hpp"

namespace bankshot {

/// The state right after an event. `contact` is the cushion, the vertex, the pocket or the other ball.
struct Record {
  EventKind kind;
  double time;  ///< s
  State<double> state;
  Contact contact{};
  int ball = 0;           ///< 0 is the one that is struck
  State<double> other{};  ///< of two balls that meet: of the one that `contact` names
};

/// The arc of a ball between two events.
struct Leg {
  double begin;     ///< s since the launch
  double duration;  ///< of the arc's parameter: s, unless the arc has a drag
  Arc<double> arc;
  State<double> start;
  int ball = 0;
};

/// What is not said to be of all balls is that of the struck one.
struct Trajectory {
  std::vector<Record> events;       ///< of all balls, in order
  std::vector<Leg> legs;            ///< of all balls, each one's in order; without those of no duration
  EventKind end = EventKind::rest;  ///< rest, pocket, horizon (what was asked), or end: too many events
  double length = 0;                ///< m, of the path
  int cushions = 0;

  std::vector<Contact> sequence() const;  ///< the cushions in order
};

/// Of one ball alone; where another met it, seen from this one.
Trajectory path_of(const Trajectory& trajectory, int ball);

/// Of one ball, its last: where it rests, falls or is stopped.
const Record& end_of(const Trajectory& trajectory, int ball);

inline constexpr long max_events = 1000000;
inline constexpr int ideal_cushions = 100;  ///< where an `ideal` shot without `until` ends

/// Throws InvalidInput.
Trajectory simulate(const ShotRequest& request);

/// ½ m v² + ⅕ m R² ω² [J].
double energy(const Body& body, const State<double>& state);
/// With its height on a table that is not level.
double energy(const Physics& physics, const Body& body, const State<double>& state);

/// 0 is the one that is struck.
const Ball& ball_of(const ShotRequest& request, int ball);

/// The state `t` seconds into a leg; and at a parameter of its arc, which may be a chord of the path.
State<double> state_at(const ShotRequest& request, const Leg& leg, double t);
State<double> state_on(const ShotRequest& request, const Leg& leg, double parameter);

/// The state right after the launch.
State<double> start_state(const ShotRequest& request);

/// The `simulate --json` document, one line.
std::string to_json(const ShotRequest& request, const Trajectory& trajectory);

inline constexpr double usual_rate = 60;  ///< points a second, where nothing else is asked

/// `see(time, ball, state)` of each ball in play `rate` times a second, and at each event of its balls.
void sample(const ShotRequest& request, const Trajectory& trajectory, double rate,
            const std::function<void(double, int, const State<double>&)>& see);

/// t,ball,x,y,vx,vy,wx,wy,wz: a row for each of these.
std::string to_csv(const ShotRequest& request, const Trajectory& trajectory, double rate);

}  // namespace bankshot
