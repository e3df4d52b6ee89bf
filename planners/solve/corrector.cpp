// SPDX-License-Identifier: MIT
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "planners/solve/branch_search.hpp"
#include "planners/solve/settings.hpp"
#include "planners/trace/arrival.hpp"

namespace bankshot::planning::branch {

using namespace settings::branch;

namespace {

/// Returns the equation of the arrival speed: its square less the square asked, over the larger of that and 1 m²/s².
Value speed_off(const Point& p, double square) {
  const double unit = std::max(1.0, square);
  return {(p.speed2.a - square) / unit, p.speed2.by / unit};
}

/// Returns the least step, in scales, that solves the linear equations; not finite where they are singular.
Vector least_step(const Point& p, std::span<const Value> equations, std::array<bool, coordinates> fixed, const Box& box,
                  const Vector& scale) {
  const auto rows = static_cast<Eigen::Index>(equations.size());
  Vector step = Vector::Zero();
  for (int round = 0; round <= coordinates; ++round) {
    Eigen::Matrix<double, Eigen::Dynamic, coordinates, 0, 2, coordinates> a(rows, coordinates);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1> r(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
      const Value& e = equations[static_cast<std::size_t>(k)];
      r[k] = -e.a;
      for (int i = 0; i < coordinates; ++i) {
        a(k, i) = fixed[static_cast<std::size_t>(i)] ? 0 : e.by[i] * scale[i];
        if (fixed[static_cast<std::size_t>(i)]) r[k] -= e.by[i] * step[i];
      }
    }
    const auto square = rows == 1 ? a.row(0).squaredNorm() : 0;
    const Vector least = square > 0 ? Vector(a.row(0).transpose() * (r[0] / square))
                                    : Vector(a.transpose() * (a * a.transpose()).fullPivLu().solve(r));
    bool pinned = false;
    for (int i = 0; i < coordinates; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (fixed[k]) continue;
      step[i] = least[i] * scale[i];
      const double to = std::clamp(p.x[i] + step[i], box.low[i], box.high[i]);
      if (to == p.x[i] + step[i] || !std::isfinite(step[i])) continue;
      step[i] = to - p.x[i];
      fixed[k] = pinned = true;
    }
    if (!pinned) return step;
  }
  return step;
}

}  // namespace

BranchSearch::Equations BranchSearch::equations(const Point& p, bool& at_bound) const {
  Equations out;
  for (int i = 0; i < p.equations; ++i) out.add(p.off[static_cast<std::size_t>(i)]);
  if (request_.stop || request_.pinned || !request_.arrival) return out;
  const auto counted = [&](double speed) { return even_square(request_.puzzle().physics, speed * speed); };
  const double square = p.speed2.a, low = counted(request_.arrival->low), high = counted(request_.arrival->high);
  at_bound = at_bound || !(square > low && square < high);
  if (at_bound) out.add(speed_off(p, square < (low + high) / 2 ? low : high));
  return out;
}

std::optional<Point> BranchSearch::corrected(Vector x, const Box& box, int held, double tolerance) {
  std::array<bool, coordinates> fixed{};
  for (int i = 0; i < coordinates; ++i) {
    fixed[static_cast<std::size_t>(i)] = !box.free(i) || i == held;
    x[i] = i == held ? x[i] : std::clamp(x[i], box.low[i], box.high[i]);
  }
  Vector before = x;
  bool at_bound = false;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < settings::most_steps && !budget_.spent(); ++i) {
    auto p = look(aim_, budget_, x, vary_);
    if (!p && i == 0) return {};
    if (!p) {
      x = (x + before) / 2;
      continue;
    }
    const Vector step = least_step(*p, equations(*p, at_bound).all(), fixed, box, scale_);
    const double size = step.cwiseQuotient(scale_).cwiseAbs().maxCoeff();
    if (!std::isfinite(size) || (i >= settings::patience && !(size < least))) return {};  // jumps across a kink
    least = std::min(least, size);
    before = x;
    x += size > longest_step ? Vector(step * (longest_step / size)) : step;
    if (size < tolerance) {
      const double small = settings::alike * (tolerance / settings::settled);
      const bool solved =
          std::ranges::all_of(equations(*p, at_bound).all(), [&](const Value& e) { return std::abs(e.a) < small; });
      p->x = x;
      return solved ? p : std::nullopt;
    }
  }
  return {};
}

Eigen::MatrixXd BranchSearch::tangents(const Point& p) const {
  bool at_bound = false;
  const Equations found = equations(p, at_bound);
  const bool any_speed = request_.arrival && !request_.arrival->fixed();
  const std::span<const Value> rows =
      any_speed ? found.all().first(static_cast<std::size_t>(p.equations)) : found.all();
  std::vector<int> free;
  for (int i = 0; i < coordinates; ++i)
    if (wide_.free(i)) free.push_back(i);
  const auto n = static_cast<Eigen::Index>(free.size()), m = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd a(n, m);
  for (Eigen::Index k = 0; k < m; ++k)
    for (Eigen::Index i = 0; i < n; ++i) {
      const int c = free[static_cast<std::size_t>(i)];
      a(i, k) = rows[static_cast<std::size_t>(k)].by[c] * scale_[c];
    }
  if (n <= m) return Eigen::MatrixXd(coordinates, 0);
  const Eigen::MatrixXd all = Eigen::HouseholderQR<Eigen::MatrixXd>(a).householderQ();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(coordinates, n - m);
  for (Eigen::Index i = 0; i < n; ++i) out.row(free[static_cast<std::size_t>(i)]) = all.row(i).tail(n - m);
  return out;
}

}  // namespace bankshot::planning::branch
