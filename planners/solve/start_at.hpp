// SPDX-License-Identifier: MIT
//
// A launch as the start of a path with derivatives by its coordinates, and the values at the path's end.
#pragma once

#include "bankshot/numbers/dual.hpp"
#include "planners/solve/point.hpp"
#include "planners/start.hpp"

namespace bankshot::planning::branch {

/// Returns the launch with the derivatives by its first N coordinates.
template <int N>
State<Dual<N>> start_at(const SearchRequest& request, const Vector& x) {
  const Launch launch = launch_of(x);
  State<Dual<N>> s = dual_start<Dual<N>, 2>(request, launch, spin_of(x));
  if constexpr (N == coordinates) {
    const double R = request.puzzle().ball.body.radius;
    const Vec2d v = direction(launch.angle) * launch.speed, turned = perpendicular(v);
    s.spin.x.v[top] = turned.x / R;
    s.spin.y.v[top] = turned.y / R;
    s.spin.x.v[masse] = v.x / R;
    s.spin.y.v[masse] = v.y / R;
    s.spin.z = norm(s.velocity) * (x[side] / R);
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
