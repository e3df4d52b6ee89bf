// SPDX-License-Identifier: MIT
//
// The state of the cue ball right after the launch.
#pragma once

#include "bankshot/motion/launched.hpp"
#include "planners/search_request.hpp"

namespace bankshot::planning {

/// Returns the state for an angle [rad] and a speed [m/s], with or without derivatives.
template <class T>
State<T> start_of(const SearchRequest& request, const T& angle, const T& speed) {
  using std::cos, std::sin;
  return launched(request.puzzle().ball.at, request.puzzle().ball.body.radius, Vec2<T>{cos(angle), sin(angle)} * speed,
                  request.spin);
}

/// Returns the state for an exact direction, as the simulator launches it.
inline State<double> start_of(const SearchRequest& request, const Launch& launch) {
  return launched(request.puzzle().ball.at, request.puzzle().ball.body.radius, direction(launch.angle) * launch.speed,
                  request.spin);
}

/// Returns the state with its derivatives by the first N unknowns: the aim, and ln speed. `Dual`: a dual number.
template <class Dual, int N>
State<Dual> dual_start(const SearchRequest& request, const Launch& launch, const LaunchSpin& spin) {
  const Vec2d v = direction(launch.angle) * launch.speed, turned = perpendicular(v);
  Vec2<Dual> velocity{Dual(v.x), Dual(v.y)};
  velocity.x.v[0] = turned.x;
  velocity.y.v[0] = turned.y;
  if constexpr (N > 1) {
    velocity.x.v[1] = v.x;
    velocity.y.v[1] = v.y;
  }
  return launched(request.puzzle().ball.at, request.puzzle().ball.body.radius, velocity, spin);
}

}  // namespace bankshot::planning
