// SPDX-License-Identifier: MIT
//
// The state of the cue ball right after the launch: the one place where a launch becomes motion.
#pragma once

#include "planners/question.hpp"

namespace bankshot::planning {

/// Returns the state for an angle [rad] and a speed [m/s], with or without derivatives.
template <class T>
State<T> start_of(const Question& q, const T& angle, const T& speed) {
  using std::cos, std::sin;
  return launched(q.puzzle.ball.at, q.puzzle.ball.body.radius, Vec2<T>{cos(angle), sin(angle)} * speed, q.spin);
}

/// Returns the state for an exact direction, as the simulator launches it.
inline State<double> start_of(const Question& q, const Launch& launch) {
  return launched(q.puzzle.ball.at, q.puzzle.ball.body.radius, direction(launch.angle) * launch.speed, q.spin);
}

/// Returns the state with its derivatives by the first N unknowns: the aim, and ln speed. `Dual<N>`: a dual number.
template <class Dual, int N>
State<Dual> dual_start(const Question& q, const Launch& launch) {
  const Vec2d v = direction(launch.angle) * launch.speed, turned = perpendicular(v);
  Vec2<Dual> velocity{Dual(v.x), Dual(v.y)};
  velocity.x.v[0] = turned.x;
  velocity.y.v[0] = turned.y;
  if constexpr (N > 1) {
    velocity.x.v[1] = v.x;
    velocity.y.v[1] = v.y;
  }
  return launched(q.puzzle.ball.at, q.puzzle.ball.body.radius, velocity, q.spin);
}

}  // namespace bankshot::planning
