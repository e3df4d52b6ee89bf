// SPDX-License-Identifier: MIT
//
// The arrival of a locked path and its residuals there, in any scalar type.
#pragma once

#include <optional>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/trace/residual.hpp"
#include "planners/trace/trace.hpp"

namespace bankshot::planning {

/// Returns where a branch leads.
inline Destination destination(const Branch& b) {
  return {b.request.problem->boundary_of(b.aim_point.ball).body, b.aim_point.at, b.aim_point.capture(), b.request.stop};
}

/// Returns the arrival of a branch; none if it never gets to its last leg (trace.hpp).
template <class T>
std::optional<LockedArrival<T>> arrival_of(const Branch& b, const State<T>& start, const Physics& physics, Work& work) {
  return with_physics(physics, [&](const auto& motion, const auto& cushion) {
    return trace(b.request.problem->balls(), motion, cushion, b.route, start, destination(b), work);
  });
}

/// Returns the squared speed [m²/s²], rescaled so that it falls evenly along a roll even where friction grows with the
/// speed. It is twice the deceleration of a slow ball times the metres to rest. Squares that are not positive stay as
/// they are.
template <class T>
T even_square(const Physics& physics, const T& square) {
  using std::sqrt;
  const auto* const motion = std::get_if<SlideRoll>(&physics.motion);
  const detail::Drag<double> drag{deceleration(physics), motion ? motion->rolling_friction.per_speed * motion->g : 0};
  return drag.none() || !(square > T(0)) ? square : T(drag.length(T(sqrt(square)), T(0)) * (2 * drag.constant));
}

/// Returns the squared arrival speed as residual [1] counts it. The ball moves along the unit vector u, and `off` leads
/// from it to the aim point. The square is continued below 0 for a ball that rests before the aim point.
template <class T>
T arrival_square(const Physics& physics, const LockedArrival<T>& arrival, const Vec2<T>& u, const Vec2<T>& off) {
  if (arrival.at_rest) return T(-2 * deceleration(physics)) * dot(u, off);
  return even_square(physics, T(dot(arrival.state.velocity, arrival.state.velocity)));
}

/// Returns how far the exact line lies to the left of the ball [m]. The ball moves along the unit vector u, and `off`
/// leads from it to the aim point.
template <class T>
T beside_exact(const AimPoint& aim_point, const Vec2<T>& u, const Vec2<T>& off) {
  const T centre = cross(u, off);
  return aim_point.exact_offset(u, -value(centre)) + centre;
}

/// Computes the N residuals of residual.hpp. Returns false where the ball arrives with no direction.
template <int N, class T>
bool residuals_of(const Branch& a, const LockedArrival<T>& arrival, T* r) {
  const Vec2<T>& heading = arrival.heading;
  if (!(dot(heading, heading) > T(0))) return false;
  const T diagonal(a.request.problem->boundary.diagonal);
  const Vec2<T> off = to<T>(a.aim_point.at) - arrival.state.at;
  if (a.request.stop) {
    r[0] = off.x / diagonal;
    if constexpr (N > 1) r[1] = off.y / diagonal;
    return true;
  }
  const Vec2<T> u = heading / norm(heading);
  r[0] = beside_exact(a.aim_point, u, off) / diagonal;
  if constexpr (N > 1) {
    const Physics& physics = a.request.puzzle().physics;
    const T square = arrival_square(physics, arrival, u, off);
    const double asked = even_square(physics, a.request.asked * a.request.asked);
    r[1] = (square - T(asked)) / T(std::max(1.0, asked));
  }
  return true;
}

/// Returns the values and derivatives of N dual residuals of an arrival at this time.
template <int N, class Dual>
Linear linear(const Dual* r, double time) {
  Linear out;
  out.time = time;
  for (std::size_t k = 0; k < N; ++k) {
    out.r[k] = r[k].a;
    for (int i = 0; i < N; ++i) out.by[k][static_cast<std::size_t>(i)] = r[k].v[i];
  }
  return out;
}

}  // namespace bankshot::planning
