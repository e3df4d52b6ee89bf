// SPDX-License-Identifier: MIT
#include "planners/play/rest.hpp"

#include <Eigen/QR>
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

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 4, coordinates>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, coordinates, 1>;

Vector scales() {
  using namespace settings::branch;
  Vector s;
  s << scale_of_aim, scale_of_speed, scale_of_spin, scale_of_spin, scale_of_spin;
  return s;
}

/// Linear equations in the free coordinates, in scales.
struct System {
  Matrix a;
  Column r;
};

System system_of(std::span<const Value> equations, std::span<const int> free, const Vector& scale, const Vector& done) {
  System out{Matrix(static_cast<Eigen::Index>(equations.size()), static_cast<Eigen::Index>(free.size())),
             Column(static_cast<Eigen::Index>(equations.size()))};
  for (Eigen::Index k = 0; k < out.a.rows(); ++k) {
    const Value& e = equations[static_cast<std::size_t>(k)];
    out.r[k] = -e.a - e.by.dot(done);
    for (Eigen::Index i = 0; i < out.a.cols(); ++i) {
      const int c = free[static_cast<std::size_t>(i)];
      out.a(k, i) = e.by[c] * scale[c];
    }
  }
  return out;
}

/// The least step that keeps to the target and, with what that leaves free, brings the rest as near as it can.
Column least_step(const System& target, const System& rest) {
  const Eigen::Index n = rest.a.cols();
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> onto(target.a);
  const Eigen::VectorXd first = onto.solve(target.r);
  const Eigen::Index rank = onto.rank();
  if (rank >= n) return first;
  const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(target.a.transpose()).householderQ();
  const Eigen::MatrixXd along = q.rightCols(n - rank);
  const Eigen::MatrixXd within = rest.a * along;
  return first + along * Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(within).solve(rest.r - rest.a * first);
}

/// A step inside the box: a coordinate that would leave it stays at its bound.
Vector step_inside(std::span<const Value> target, std::span<const Value> rest, const branch::Box& box,
                   const Vector& x) {
  const Vector scale = scales();
  std::vector<int> free;
  for (int i = 0; i < coordinates; ++i)
    if (box.free(i)) free.push_back(i);
  Vector step = Vector::Zero();
  while (!free.empty()) {
    Vector fixed = step;
    for (const int i : free) fixed[i] = 0;
    const Column least = least_step(system_of(target, free, scale, fixed), system_of(rest, free, scale, fixed));
    int out = -1;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const int i = free[k];
      step[i] = least[static_cast<Eigen::Index>(k)] * scale[i];
      const double to = std::clamp(x[i] + step[i], box.low[i], box.high[i]);
      if (to != x[i] + step[i] && out < 0) out = static_cast<int>(k), step[i] = to - x[i];
    }
    if (out < 0) break;
    free.erase(free.begin() + out);
  }
  return step;
}

double size_of(const Vector& step) { return step.cwiseQuotient(scales()).cwiseAbs().maxCoeff(); }

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

TargetEquations equations_of(const Branch& a, const branch::Point& point, double shift) {
  TargetEquations out;
  for (int i = 0; i < point.equations; ++i) out.each[out.count++] = point.off[static_cast<std::size_t>(i)];
  const SearchRequest& request = a.request;
  if (!request.stop) out.each[0].a -= shift / request.problem->boundary.diagonal;
  if (request.stop || !request.arrival || !request.arrival->fixed()) return out;
  const double asked = even_square(request.puzzle().physics, request.arrival->low * request.arrival->low);
  const double unit = std::max(1.0, asked);
  out.each[out.count++] = {(point.speed2.a - asked) / unit, point.speed2.by / unit};
  return out;
}

std::optional<Vector> place(const Branch& a, EvaluationBudget& budget, const CuePath& cue, const Vec2d& wanted,
                            const branch::Box& box, Vector x, double shift, branch::Vary vary) {
  const double diagonal = a.request.problem->boundary.diagonal;
  std::optional<Vector> best;
  double least = std::numeric_limits<double>::infinity();
  Vector before = x;
  for (int i = 0; i < most_steps && !budget.spent(); ++i) {
    const auto point = branch::look(a, budget, x, vary);
    const auto at = point ? rest_of(a.request, budget, cue, x, vary) : std::nullopt;
    if (!at) {
      if (i == 0) return {};
      x = (x + before) / 2;
      continue;
    }
    const TargetEquations target = equations_of(a, *point, shift);
    std::array<Value, 2> rest{Value{((*at)[0].a - wanted.x) / diagonal, (*at)[0].by / diagonal},
                              Value{((*at)[1].a - wanted.y) / diagonal, (*at)[1].by / diagonal}};
    const double off = std::hypot(rest[0].a, rest[1].a), missed = most_of(target.all());
    const double loss = off + missed;
    // A step that leads away is halved; the branch bends there.
    if (i > 0 && !(loss < least) && size_of(x - before) > settings::settled) {
      x = (x + before) / 2;
      continue;
    }
    least = std::min(least, loss);
    best = x;
    if (loss < solved) return best;
    const Vector step = step_inside(target.all(), rest, box, x);
    const double size = size_of(step);
    if (!std::isfinite(size)) return {};
    if (size < settings::settled && missed < solved) return best;
    before = x;
    x += size > longest_step ? Vector(step * (longest_step / size)) : step;
  }
  return best;
}

std::optional<Vector> on_target(const Branch& a, EvaluationBudget& budget, const branch::Box& box, Vector x,
                                double shift) {
  for (int i = 0; i < most_steps && !budget.spent(); ++i) {
    const auto point = branch::look(a, budget, x, branch::Vary::launch);
    if (!point) return {};
    const TargetEquations e = equations_of(a, *point, shift);
    Vector step = Vector::Zero();
    if (e.count == 1) {
      step[aim] = -e.each[0].a / e.each[0].by[aim];
    } else {
      const double det = e.each[0].by[aim] * e.each[1].by[log_speed] - e.each[0].by[log_speed] * e.each[1].by[aim];
      step[aim] = (e.each[0].by[log_speed] * e.each[1].a - e.each[1].by[log_speed] * e.each[0].a) / det;
      step[log_speed] = (e.each[1].by[aim] * e.each[0].a - e.each[0].by[aim] * e.each[1].a) / det;
    }
    const double size = size_of(step);
    if (!std::isfinite(size)) return {};
    x += size > longest_step ? Vector(step * (longest_step / size)) : step;
    if (size < settings::settled) {
      const double v = x[log_speed];
      return v >= box.low[log_speed] - solved && v <= box.high[log_speed] + solved ? std::optional(x) : std::nullopt;
    }
  }
  return {};
}

}  // namespace bankshot::planning::play
