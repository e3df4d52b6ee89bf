// SPDX-License-Identifier: MIT
//
// A shot, simulated and recorded: its events and the arcs between them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bankshot/motion/arc.hpp"
#include "bankshot/scene/puzzle.hpp"
#include "bankshot/simulate/event.hpp"

namespace bankshot {

/// The state right after an event. `contact` is the cushion, the vertex or the pocket.
struct Record {
  EventKind kind;
  double time;  ///< s
  State<double> state;
  Contact contact{};
};

/// The arc between two events.
struct Leg {
  double begin;     ///< s since the launch
  double duration;  ///< of the arc's parameter: s, unless the arc has a drag
  Arc<double> arc;
  State<double> start;
};

struct Trajectory {
  std::vector<Record> events;
  std::vector<Leg> legs;            ///< without those of no duration
  EventKind end = EventKind::rest;  ///< rest, pocket, horizon (what was asked), or end: too many events
  double length = 0;                ///< m, of the path
  int cushions = 0;

  std::vector<Contact> sequence() const;  ///< the contacts in order
};

inline constexpr long max_events = 1000000;
inline constexpr int ideal_cushions = 100;  ///< where an `ideal` shot without `until` ends

/// Throws InvalidInput.
Trajectory simulate(const ShotRequest& request);

/// ½ m v² + ⅕ m R² ω² [J].
double energy(const Body& body, const State<double>& state);

/// The state `t` seconds into a leg.
State<double> state_at(const ShotRequest& request, const Leg& leg, double t);

/// The state right after the launch.
State<double> start_state(const ShotRequest& request);

/// The `simulate --json` document, one line.
std::string to_json(const ShotRequest& request, const Trajectory& trajectory);

inline constexpr double usual_rate = 60;  ///< points a second, where nothing else is asked

/// `see(time, state)` at each event, and `rate` times a second between them.
void sample(const ShotRequest& request, const Trajectory& trajectory, double rate,
            const std::function<void(double, const State<double>&)>& see);

/// t,ball,x,y,vx,vy,wx,wy,wz: `rate` rows a second and one at each event.
std::string to_csv(const ShotRequest& request, const Trajectory& trajectory, double rate);

}  // namespace bankshot
