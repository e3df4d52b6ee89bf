// SPDX-License-Identifier: MIT
#include "planners/solve/point.hpp"

#include <algorithm>
#include <cmath>

#include "planners/solve/start_at.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::planning::branch {
namespace {

template <int N>
std::optional<Point> look_at(const Branch& a, const Vector& x, Work& work) {
  using T = Dual<N>;
  const SearchRequest& request = a.request;
  const auto arrival = arrival_of(a, start_at<N>(request, x), request.puzzle().physics, work);
  if (!arrival) return {};
  Point p{x};
  p.time = value_of<N>(arrival->time);
  const T diagonal(request.problem->boundary.diagonal);
  const Vec2<T> off = to<T>(a.aim_point.at) - arrival->state.at;
  if (request.stop) {
    p.equations = 2;
    p.off = {value_of<N>(off.x / diagonal), value_of<N>(off.y / diagonal)};
    return p;
  }
  const Vec2<T> u = arrival->heading / norm(arrival->heading);
  p.off[0] = value_of<N>(beside_exact(a.aim_point, u, off) / diagonal);
  p.speed2 = value_of<N>(arrival_square(request.puzzle().physics, *arrival, u, off));
  return p;
}

}  // namespace

Vector vector_of(const Launch& launch, const LaunchSpin& spin) {
  Vector x;
  x << launch.angle, std::log(launch.speed), spin.top, spin.side, spin.masse;
  return x;
}

Launch launch_of(const Vector& x) { return {std::exp(x[log_speed]), wrap_angle(x[aim])}; }

LaunchSpin spin_of(const Vector& x) { return {x[top], x[side], x[masse]}; }

std::optional<Point> look(const Branch& a, EvaluationBudget& budget, const Vector& x, Vary vary) {
  if (budget.spent()) return {};
  budget.charge(a.route.size());
  return vary == Vary::launch ? look_at<2>(a, x, budget.work()) : look_at<coordinates>(a, x, budget.work());
}

}  // namespace bankshot::planning::branch
