// SPDX-License-Identifier: MIT
#include "planners/merit/first_order.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/locked.hpp"
#include "planners/start.hpp"

namespace bankshot::planning {

void add_first_order(const Question& q, Shot& shot) {
  using Dual = bankshot::Dual<2>;
  const Vec2d& target = shot.arrival.at;
  const State<Dual> start = dual_start<Dual, 2>(q, shot.launch);
  const Route route = route_by(shot.cushions);
  const Vec2<Dual> end = with_physics(q.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    const auto path = follow_locked(q.boundary, motion, cushion, route, start);
    const auto arrival = arrive_locked(motion, q.boundary.body, path.state, target, 0, q.stop);
    if (q.stop) return arrival.state.at;
    // Along the line of travel nothing is missed: only the lateral part counts.
    const Vec2<Dual> u = arrival.heading / norm(arrival.heading);
    const Vec2d line{-u.y.a, u.x.a};
    const Dual lateral = cross(u, to<Dual>(target) - arrival.state.at);
    return Vec2<Dual>{lateral * line.x, lateral * line.y};
  });
  const Vec2d by_log_speed{end.x.v[1], end.y.v[1]};
  shot.by_angle = {end.x.v[0], end.y.v[0]};
  shot.by_speed = by_log_speed / shot.launch.speed;
  shot.condition = std::max(norm(shot.by_angle), norm(by_log_speed));
  const Noise& noise = q.puzzle.noise;
  const double spread = std::hypot(norm(shot.by_angle) * noise.angle, norm(shot.by_speed) * noise.speed);
  shot.first_order = q.nearest_mark(shot.arrival.at).reach / spread;
}

}  // namespace bankshot::planning
