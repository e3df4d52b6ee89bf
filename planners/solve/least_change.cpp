// SPDX-License-Identifier: MIT
#include "planners/solve/least_change.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "planners/solve/settings.hpp"

namespace bankshot::planning::branch {
namespace {

using namespace settings::branch;

constexpr int most_equations = 3;
template <int Rows, int Columns>
using Small = Eigen::Matrix<double, Eigen::Dynamic, Columns == 1 ? 1 : Eigen::Dynamic, 0, Rows, Columns>;
using Rows = Small<most_equations, coordinates>;
using Square = Small<coordinates, coordinates>;
using Column = Small<coordinates, 1>;

/// Linear equations in the free coordinates, in scales.
struct System {
  Rows a;
  Small<most_equations, 1> r;
};

/// `done`: what the other coordinates change.
System system_of(std::span<const Value> equations, std::span<const int> free, const Vector& done) {
  const auto rows = static_cast<Eigen::Index>(equations.size()), columns = static_cast<Eigen::Index>(free.size());
  System out{Rows(rows, columns), Small<most_equations, 1>(rows)};
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Value& e = equations[static_cast<std::size_t>(k)];
    out.r[k] = -e.a - e.by.dot(done);
    out.a.row(k) = e.by.cwiseProduct(scales())(free);
  }
  return out;
}

/// Returns the least solution, or what comes nearest to one.
Column least_step(const System& kept, const System& wanted) {
  const Eigen::Index n = kept.a.cols();
  if (kept.a.rows() == 1 && wanted.a.rows() == 0)
    return kept.a.row(0).transpose() * (kept.r[0] / kept.a.row(0).squaredNorm());
  const Eigen::CompleteOrthogonalDecomposition<Rows> onto(kept.a);
  Column first = onto.solve(kept.r);
  const Eigen::Index rank = onto.rank();
  if (rank >= n || wanted.a.rows() == 0) return first;
  const Square q = Eigen::HouseholderQR<Small<coordinates, most_equations>>(kept.a.transpose()).householderQ();
  const Square along = q.rightCols(n - rank);
  const Rows within = wanted.a * along;
  return first + along * Eigen::CompleteOrthogonalDecomposition<Rows>(within).solve(wanted.r - wanted.a * first);
}

}  // namespace

Box box_of(const SearchRequest& request) {
  const auto ln = [](double v) { return v > 0 ? std::log(v) : -infinite; };
  const Range v = request.pinned ? Range{*request.pinned, *request.pinned} : request.speed;
  const Range aims = request.angle.value_or(Range{-infinite, infinite});
  const LaunchSpin& s = request.spin;
  const SpinRange spin =
      request.puzzle().spin_range.value_or(SpinRange{{s.top, s.top}, {s.side, s.side}, {s.masse, s.masse}});
  Box box;
  box.low << aims.low, ln(v.low), spin.top.low, spin.side.low, spin.masse.low;
  box.high << aims.high, ln(v.high), spin.top.high, spin.side.high, spin.masse.high;
  return box;
}

double near_window(double angle, const std::optional<Range>& window) {
  if (!window) return angle;
  const double middle = (window->low + window->high) / 2;
  return middle + angle_difference(wrap_angle(middle), angle);
}

std::vector<int> free_of(const Box& box) {
  std::vector<int> out;
  for (int i = 0; i < coordinates; ++i)
    if (box.free(i)) out.push_back(i);
  return out;
}

Equations passes(const Point& p) {
  Equations out;
  for (int i = 0; i < p.equations; ++i) out.add(p.off[static_cast<std::size_t>(i)]);
  return out;
}

Value speed_off(const Point& p, double square) {
  const double unit = std::max(1.0, square);
  return {(p.speed2.a - square) / unit, p.speed2.by / unit};
}

const Vector& scales() {
  static const Vector each{scale_of_aim, scale_of_speed, scale_of_spin, scale_of_spin, scale_of_spin};
  return each;
}

double size_of(const Vector& step) { return step.cwiseQuotient(scales()).cwiseAbs().maxCoeff(); }

Vector cut(const Vector& step) {
  const double size = size_of(step);
  return size > longest_step ? Vector(step * (longest_step / size)) : step;
}

Vector least_step(std::span<const Value> kept, std::span<const Value> wanted, const Box& box, const Vector& x) {
  std::vector<int> free = free_of(box);
  Vector step = Vector::Zero();
  while (!free.empty()) {
    Vector fixed = step;
    for (const int i : free) fixed[i] = 0;
    const Column least = least_step(system_of(kept, free, fixed), system_of(wanted, free, fixed));
    auto out = free.end();
    for (auto i = free.begin(); i != free.end(); ++i) {
      step[*i] = least[i - free.begin()] * scales()[*i];
      const double to = std::clamp(x[*i] + step[*i], box.low[*i], box.high[*i]);
      if (to != x[*i] + step[*i] && out == free.end()) out = i, step[*i] = to - x[*i];
    }
    if (out == free.end() || !step.allFinite()) break;
    free.erase(out);
  }
  return step;
}

std::optional<Vector> least_change(Vector x, const Box& box, double tolerance,
                                   const std::function<std::optional<Equations>(const Vector&)>& equations_at) {
  x = x.cwiseMax(box.low).cwiseMin(box.high);
  Vector before = x;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < settings::most_steps; ++i) {
    const auto equations = equations_at(x);
    if (!equations && i == 0) return {};
    if (!equations) {
      x = (x + before) / 2;
      continue;
    }
    const Vector step = least_step(equations->all(), {}, box, x);
    const double size = size_of(step);
    if (!std::isfinite(size) || (i >= settings::patience && !(size < least))) return {};  // jumps across a kink
    least = std::min(least, size);
    before = x;
    x += cut(step);
    if (size < tolerance) {
      const double small = settings::alike * (tolerance / settings::settled);
      const bool solved = std::ranges::all_of(equations->all(), [&](const Value& e) { return std::abs(e.a) < small; });
      return solved ? std::optional(x) : std::nullopt;
    }
  }
  return {};
}

}  // namespace bankshot::planning::branch
