// SPDX-License-Identifier: MIT
//
// Runs the simulator in a scalar T and records its events, for run.hpp and the tests.
#pragma once

#include "bankshot/detail/roots/roots.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "truth/run.hpp"

namespace bankshot::truth {

inline double rounded(double x) { return x; }
/// Rounds a multiprecision number to double.
template <class T>
requires requires(const T& x) { x.template convert_to<double>(); }
double rounded(const T& x) { return x.template convert_to<double>(); }

/// Returns the run's start in T, turned and pushed.
template <class T>
State<T> start_of(const Run& run) {
  State<T> s = to<T>(run.start);
  if (run.turned == 0 && run.pushed == 0) return s;
  const T turn(run.turned), grow = T(1) + T(run.pushed);
  const auto change = [&](T& x, T& y) {
    const T before = x;
    x = grow * (before - turn * y);
    y = grow * (y + turn * before);
  };
  change(s.velocity.x, s.velocity.y);
  change(s.spin.x, s.spin.y);
  s.spin.z *= grow;
  return s;
}

/// Returns the state at parameter t of an arc that started at `began`, relative to `target`.
template <class T>
Passing passing(const Arc<T>& arc, const T& began, const T& t, const Vec2d& target) {
  const Vec2<T> at = arc.position(t), v = arc.velocity_at(t), off = to<T>(target) - at;
  const T speed = norm(v), time = began + arc.seconds(t);
  const T lateral = speed > T(0) ? T(cross(v, off) / speed) : T(0);
  const double side = rounded(lateral);
  return {rounded(time),         rounded(speed), {rounded(at.x), rounded(at.y)}, {rounded(v.x), rounded(v.y)},
          rounded(T(norm(off))), side,           rounded(T(lateral - side))};
}

/// Returns the passing on the arc that led `sim` to its last event.
template <class T, class Sim>
Passing passing(const Sim& sim, const T& t, const Vec2d& target) {
  return passing<T>(sim.arc(), T(sim.time() - sim.arc().seconds(sim.travelled())), t, target);
}

/// Returns the contact that a line of travel leads to; for jaws, their pocket.
inline Contact towards(const Event& e) {
  return e.kind == EventKind::jaw ? Contact::pocket(e.contact.jaw_pocket()) : e.contact;
}

template <class T, class Sim>
Passing passing_of(const Run& run, const Event& e, const Sim& sim) {
  if (e.kind == EventKind::horizon) return {};
  if (run.target) return passing<T>(sim, detail::closest_time(sim.arc(), sim.travelled(), *run.target), *run.target);
  if (e.kind != EventKind::pocket && e.kind != EventKind::jaw && e.kind != EventKind::ball) return {};
  Passing p = passing<T>(sim, sim.travelled(), run.boundary.rim(towards(e))->centre);
  p.miss = std::abs(p.lateral);
  return p;
}

template <class T>
TruthEvent note(const Event& e, const T& time, const State<T>& s, const Passing& p, int ball = 0) {
  const double t = rounded(time), x = rounded(s.at.x), y = rounded(s.at.y);
  const Vec2d v{rounded(s.velocity.x), rounded(s.velocity.y)};
  return {e.kind,
          e.contact,
          t,
          rounded(T(time - t)),
          {{x, y}, v, {rounded(s.spin.x), rounded(s.spin.y), rounded(s.spin.z)}},
          {rounded(T(s.at.x - x)), rounded(T(s.at.y - y))},
          p,
          ball};
}

/// Runs in T and calls `see(event, simulator)` for each event. Returns true if the run reached its end.
template <class T, class See>
bool follow(const Run& run, const State<T>& start, See&& see) {
  return with_physics(run.physics, [&](const auto& motion, const auto& cushion) {
    Simulator sim(run.boundary, motion, cushion, start);
    int cushions = 0;
    for (long i = 0; i < run.events; ++i) {
      const Event e = run.until < forever ? sim.step(T(T(run.until) - sim.time())) : sim.step();
      see(e, sim);
      if (e.kind == EventKind::cushion) ++cushions;
      if (e.final() || cushions >= run.cushions) return e.kind != EventKind::horizon || run.until < forever;
    }
    return false;
  });
}

template <class T>
Path recorded(const Run& run) {
  Path path;
  path.ended = follow<T>(run, start_of<T>(run), [&](const Event& e, const auto& sim) {
    path.events.push_back(note<T>(e, sim.time(), sim.state(), passing_of<T>(run, e, sim)));
  });
  return path;
}

}  // namespace bankshot::truth
