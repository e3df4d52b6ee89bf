// SPDX-License-Identifier: MIT
#include "planners/play/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/play/settings.hpp"
#include "planners/solve/start_at.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::planning::play {
namespace {

using namespace settings::leave;
using branch::aim;
using branch::coordinates;
using branch::log_speed;

template <int N>
std::optional<std::array<Value, 2>> rest_with(const SearchRequest& request, const CuePath& cue, const Vector& x,
                                              Work& work) {
  const Problem& problem = *request.problem;
  const RouteBalls balls(problem.boundary, cue.standing, collisions(problem.puzzle.physics), true);
  const Destination anywhere{problem.boundary.body, {}, 0, true};
  const auto arrival = with_physics(problem.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    return trace(balls, motion, cushion, std::span<const Meeting>(cue.meetings), branch::start_at<N>(request, x),
                 anywhere, work);
  });
  if (!arrival || !arrival->at_rest) return {};
  return std::array{branch::value_of<N>(arrival->state.at.x), branch::value_of<N>(arrival->state.at.y)};
}

double most_of(std::span<const Value> equations) {
  double most = 0;
  for (const Value& e : equations) most = std::max(most, std::abs(e.a));
  return most;
}

}  // namespace

std::optional<std::array<Value, 2>> rest_of(const SearchRequest& request, EvaluationBudget& budget, const CuePath& cue,
                                            const Vector& x, branch::Vary vary) {
  if (budget.spent()) return {};
  budget.charge(cue.meetings.size());
  return vary == branch::Vary::launch ? rest_with<2>(request, cue, x, budget.work())
                                      : rest_with<coordinates>(request, cue, x, budget.work());
}

branch::Equations equations_of(const Branch& a, const branch::Point& point, double shift) {
  branch::Equations out = branch::passes(point);
  const SearchRequest& request = a.request;
  if (!request.stop) out.each[0].a -= shift / request.problem->boundary.diagonal;
  if (!request.stop && request.arrival && request.arrival->fixed())
    out.add(
        branch::speed_off(point, even_square(request.puzzle().physics, request.arrival->low * request.arrival->low)));
  return out;
}

std::optional<Vector> place(const Branch& a, EvaluationBudget& budget, const CuePath& cue, const Vec2d& wanted,
                            const branch::Box& box, Vector x, double shift, branch::Vary vary) {
  const double diagonal = a.request.problem->boundary.diagonal;
  std::optional<Vector> best;
  double least = std::numeric_limits<double>::infinity();
  Vector before = x;
  for (int i = 0; i < settings::most_steps && !budget.spent(); ++i) {
    const auto point = branch::look(a, budget, x, vary);
    const auto at = point ? rest_of(a.request, budget, cue, x, vary) : std::nullopt;
    if (!at) {
      if (i == 0) return {};
      x = (x + before) / 2;
      continue;
    }
    const branch::Equations target = equations_of(a, *point, shift);
    std::array<Value, 2> rest{Value{((*at)[0].a - wanted.x) / diagonal, (*at)[0].by / diagonal},
                              Value{((*at)[1].a - wanted.y) / diagonal, (*at)[1].by / diagonal}};
    const double off = std::hypot(rest[0].a, rest[1].a), missed = most_of(target.all());
    const double loss = off + missed;
    // A step that leads away is halved; the branch bends there.
    if (i > 0 && !(loss < least) && branch::size_of(x - before) > settings::settled) {
      x = (x + before) / 2;
      continue;
    }
    least = std::min(least, loss);
    best = x;
    if (loss < solved) return best;
    const Vector step = branch::least_step(target.all(), rest, box, x);
    if (!step.allFinite()) return {};
    if (branch::size_of(step) < settings::settled && missed < solved) return best;
    before = x;
    x += branch::cut(step);
  }
  return best;
}

std::optional<Vector> on_target(const Branch& a, EvaluationBudget& budget, const branch::Box& box, const Vector& x,
                                double shift) {
  const SearchRequest& request = a.request;
  branch::Box moved{x, x};
  moved.low[aim] = -infinite, moved.high[aim] = infinite;
  if (request.stop || (request.arrival && request.arrival->fixed()))
    moved.low[log_speed] = box.low[log_speed], moved.high[log_speed] = box.high[log_speed];
  return branch::least_change(x, moved, settings::settled, [&](const Vector& at) -> std::optional<branch::Equations> {
    const auto point = branch::look(a, budget, at, branch::Vary::launch);
    return point ? std::optional(equations_of(a, *point, shift)) : std::nullopt;
  });
}

}  // namespace bankshot::planning::play
