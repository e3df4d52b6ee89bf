// SPDX-License-Identifier: MIT
#include "planners/evaluate/sensitivity.hpp"

#include <cmath>

#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/trace/trace.hpp"
#include "planners/trace/varied.hpp"

namespace bankshot::planning {
namespace {

using Varied = Dual<one_varies>;

/// Returns how far the arrival moves, as in Verification::by_angle [m per unit of the coefficient that varies].
template <class Motion>
double moved(const SearchRequest& request, const Shot& shot, const Route& route,
             const VariedPhysics<one_varies>& physics, const Motion& motion, Work& work) {
  const RouteBalls plain = request.problem->balls();
  const RouteBallsOf<Varied> balls(plain.struck, plain.others, physics.balls, plain.carom);
  const State<Varied> start = to<Varied>(start_of(request, shot.launch));
  const Body& body = request.problem->boundary_of(request.problem->aim_point_of(shot).ball).body;
  const auto arrival =
      trace(balls, motion, physics.cushion, std::span<const Meeting>(route), start,
            {body, shot.path.arrival.at, 0, request.stop}, work, Unobserved{}, LostLeg::is_passed_over);
  if (!arrival) return 0;
  const Vec2<Varied>& end = arrival->state.at;
  if (request.stop) return std::hypot(end.x.v[0], end.y.v[0]);
  const Vec2<Varied> u = arrival->heading / norm(arrival->heading);
  return std::abs(cross(u, to<Varied>(shot.path.arrival.at) - end).v[0]);
}

}  // namespace

void add_sensitivity(const SearchRequest& request, Shot& shot, Work& work) {
  const Route route = route_with_jaws_of(shot);
  const Physics& physics = request.puzzle().physics;
  const std::size_t count = VariedPhysics<one_varies>(physics).coefficients(!shot.path.hits.empty()).size();
  for (std::size_t i = 0; i < count; ++i) {
    VariedPhysics<one_varies> varied(physics);
    const VariedPhysics<one_varies>::Named named = varied.coefficients(!shot.path.hits.empty())[i];
    for (Varied* const coefficient : named.at) coefficient->v[0] = 1;
    const bool leans = !varied.level || named.name.starts_with("tilt");
    const double by = varied.with_motion(
        leans, [&](const auto& motion) { return moved(request, shot, route, varied, motion, work); });
    shot.robustness.sensitivity.push_back({named.name, by});
  }
}

}  // namespace bankshot::planning
