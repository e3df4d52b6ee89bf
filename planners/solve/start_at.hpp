// SPDX-License-Identifier: MIT
//
// A launch as the start of a path with derivatives by its coordinates, and the values at the path's end.
#pragma once

#include "bankshot/motion/launched.hpp"
#include "bankshot/numbers/dual.hpp"
#include "planners/solve/point.hpp"

namespace bankshot::planning::branch {

/// Returns the launch with the derivatives by its first N coordinates.
template <int N>
State<Dual<N>> start_at(const SearchRequest& request, const Vector& x) {
  using T = Dual<N>;
  const double R = request.puzzle().ball.body.radius;
  const Launch launch = launch_of(x);
  const Vec2d v = direction(launch.angle) * launch.speed, turned = perpendicular(v);
  Vec2<T> velocity{T(v.x), T(v.y)};
  velocity.x.v[aim] = turned.x;
  velocity.y.v[aim] = turned.y;
  velocity.x.v[log_speed] = v.x;
  velocity.y.v[log_speed] = v.y;
  State<T> s = launched(request.puzzle().ball.at, R, velocity, spin_of(x));
  if constexpr (N == coordinates) {
    s.spin.x.v[top] = turned.x / R;
    s.spin.y.v[top] = turned.y / R;
    s.spin.x.v[masse] = v.x / R;
    s.spin.y.v[masse] = v.y / R;
    s.spin.z = norm(velocity) * (x[side] / R);
    s.spin.z.v[side] = launch.speed / R;
  }
  return s;
}

template <int N>
Value value_of(const Dual<N>& d) {
  Value out{d.a, {}};
  for (int i = 0; i < coordinates; ++i) out.by[i] = i < N ? d.v[static_cast<std::size_t>(i)] : 0;
  return out;
}

}  // namespace bankshot::planning::branch
