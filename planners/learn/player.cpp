// SPDX-License-Identifier: MIT
#include "planners/learn/player.hpp"

#include <ceres/autodiff_first_order_function.h>
#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace bankshot::planning {
namespace {

/// Unknowns of M errors: first the logarithm of each sigma, then each bias, in usual errors. The bias of the speed is a
/// share of the intended speed, in units of `share`.
template <int M>
using Unknowns = std::array<double, static_cast<std::size_t>(M) * 2>;
/// Positions in the unknowns.
constexpr std::size_t sigma_of(int k) { return static_cast<std::size_t>(k); }
template <int M>
constexpr std::size_t bias_of(int k) {
  return sigma_of(M) + sigma_of(k);
}
constexpr double share = 0.02;

/// Returns the factor from the bias of the speed to one attempt's error in usual errors.
double by_speed(const Evidence& e) { return e.meant_speed * share / usual_error()(1); }

/// Prior for any player: standard deviation of the logarithm of each sigma around the usual one. Ten measured attempts
/// outweigh it by far.
const double spread_of_players = std::log(4.0);
/// Prior of each bias, in usual errors (for the speed in `share`s).
constexpr double spread_of_bias = 20;

/// Largest logarithm of a sigma, in e-folds above the usual one. No player has so large a sigma, and rounding would
/// spoil its likelihood; a search that steps there steps back.
constexpr double widest = 10;

/// Probability that a player marks an attempt wrongly.
constexpr double wrong_mark = 1e-3;

bool is_finite(double x) { return std::isfinite(x); }
template <int N>
bool is_finite(const ceres::Jet<double, N>& x) {
  return std::isfinite(x.a) && x.v.allFinite();
}

/// − log of the restricted likelihood of M errors.
template <int M>
struct Unlikelihood {
  std::span<const Evidence> evidence;
  bool biased;              ///< if not, the bias is 0
  std::optional<int> held;  ///< a sigma that does not move
  double value = 0;         ///< logarithm of the sigma held

  template <class T>
  bool operator()(const T* x, T* out) const {
    for (int k = 0; k < M; ++k)
      if (held != k && x[k] > T(widest)) return false;
    using Matrix = Eigen::Matrix<T, M, M>;
    using Vector = Eigen::Matrix<T, M, 1>;
    Vector variance, bias;
    for (int k = 0; k < M; ++k) {
      variance(k) = exp(2.0 * (held == k ? T(value) : x[k]));
      bias(k) = biased ? x[M + k] : T(0);
    }
    const Matrix one = Matrix::Identity();
    Matrix known = one / T(spread_of_bias * spread_of_bias);
    T sum = bias.dot(bias) / (2 * spread_of_bias * spread_of_bias);
    for (int k = 0; k < M; ++k) {
      const T from_usual = log(variance(k)) / (2 * spread_of_players);
      sum += from_usual * from_usual / 2.0;
    }
    for (const Evidence& e : evidence) {
      if (e.error.left_out) continue;
      const double counts = by_speed(e);
      if (!e.error.measured) {
        sum -= log(wrong_mark + (1 - 2 * wrong_mark) * chance_of(e, variance, bias, counts));
        continue;
      }
      Vector middle = bias;
      middle(1) *= counts;
      const Matrix told = e.information.template topLeftCorner<M, M>().template cast<T>();
      const Vector gradient = e.gradient.template head<M>().template cast<T>();
      const Matrix both = one + told * variance.asDiagonal();
      const Matrix inverse = both.inverse();
      const Vector left = gradient - told * middle;
      const Vector spread = variance.asDiagonal() * (inverse * left);
      sum += middle.dot(told * middle) / 2.0 - gradient.dot(middle) - left.dot(spread) / 2.0 +
             log(both.determinant()) / 2.0;
      Matrix weight = inverse * told;
      weight.row(1) *= T(counts);
      weight.col(1) *= T(counts);
      known += weight;
    }
    if (biased) sum += log(known.determinant()) / 2.0;
    out[0] = sum;
    return is_finite(sum);
  }

  /// Returns the probability of the outcome, made or missed.
  template <class T>
  static T chance_of(const Evidence& e, const Eigen::Matrix<T, M, 1>& variance, const Eigen::Matrix<T, M, 1>& bias,
                     double counts) {
    T made(0), all(0);
    for (const Draw& d : e.draws) {
      const T a = d.angle - bias(0), v = d.speed - bias(1) * counts;
      const T weight =
          exp(-(a * a / variance(0) + v * v / variance(1)) / 2.0) / sqrt(variance(0) * variance(1)) / d.density;
      all += weight;
      if (d.made == e.made) made += weight;
    }
    return made / all;
  }
};

template <int M>
double lowest(const Unlikelihood<M>& f, Unknowns<M>& x) {
  const ceres::GradientProblem problem(
      new ceres::AutoDiffFirstOrderFunction<Unlikelihood<M>, 2 * M>(new Unlikelihood<M>(f)));
  ceres::GradientProblemSolver::Options options;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 200;
  options.line_search_interpolation_type = ceres::BISECTION;  // other types print complaints about their polynomials
  options.function_tolerance = 1e-12;
  ceres::GradientProblemSolver::Summary summary;
  ceres::Solve(options, problem, x.data(), &summary);
  return summary.final_cost;
}

/// Returns the value at which the profile of one sigma has risen by half of χ²₁'s 95 % quantile.
template <int M>
double end_of(Unlikelihood<M> f, const Unknowns<M>& best, int k, double least, double way) {
  constexpr double quantile = 3.841459;
  f.held = k;
  const auto rises = [&](double at) {
    Unknowns<M> x = best;
    f.value = at;
    return lowest(f, x) - least > quantile / 2;
  };
  const double begin = best[sigma_of(k)];
  double in = begin, step = way;
  constexpr double far = 8;  // e-folds
  while (!rises(in + step)) {
    in += step;
    if (std::abs(in - begin) > far) return way < 0 ? -forever : forever;
    step *= 2;
  }
  double out = in + step;
  constexpr double close = 1e-3;
  while (std::abs(out - in) > close) (rises((in + out) / 2) ? out : in) = (in + out) / 2;
  return in;
}

/// Returns the 97.5 % quantile of Student's t, by its expansion in 1/ν (Abramowitz & Stegun 26.7.5).
double student(double degrees) {
  constexpr double z = 1.959964, g1 = (z * z * z + z) / 4;
  const double g2 = (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / 96;
  return z + g1 / degrees + g2 / (degrees * degrees);
}

/// Returns the standard errors of the biases at these sigmas.
template <int M>
std::array<double, M> bias_errors(const Unlikelihood<M>& f, const Unknowns<M>& best) {
  constexpr double step = 1e-3;
  const ceres::GradientProblem problem(
      new ceres::AutoDiffFirstOrderFunction<Unlikelihood<M>, 2 * M>(new Unlikelihood<M>(f)));
  const auto gradient = [&](const Unknowns<M>& x) {
    Unknowns<M> out;
    double cost = 0;
    problem.Evaluate(x.data(), &cost, out.data());
    return out;
  };
  Eigen::Matrix<double, M, M> curve;
  for (int k = 0; k < M; ++k) {
    Unknowns<M> low = best, high = best;
    low[bias_of<M>(k)] -= step, high[bias_of<M>(k)] += step;
    const Unknowns<M> a = gradient(low), b = gradient(high);
    for (int i = 0; i < M; ++i) {
      const std::size_t at = bias_of<M>(i);
      curve(i, k) = (b[at] - a[at]) / (2 * step);
    }
  }
  const Eigen::Matrix<double, M, M> covariance = curve.inverse();
  std::array<double, M> out;
  for (int k = 0; k < M; ++k) out[sigma_of(k)] = std::sqrt(covariance(k, k));
  return out;
}

/// Leaves out attempts that lie too far from the others to belong to them; if many seem to, leaves out none. Returns
/// whether any was left out.
template <int M>
bool leave_out(std::span<Evidence> evidence, const Unknowns<M>& x) {
  constexpr double too_far = 30;  // χ² with four degrees of freedom exceeds this once in 200 000
  std::vector<Evidence*> far;
  for (Evidence& e : evidence) {
    if (!e.error.measured || e.error.left_out) continue;
    Eigen::Matrix<double, M, 1> variance, middle;
    for (int k = 0; k < M; ++k) {
      variance(k) = std::exp(2 * x[sigma_of(k)]);
      middle(k) = x[bias_of<M>(k)] * (k == 1 ? by_speed(e) : 1);
    }
    using Matrix = Eigen::Matrix<double, M, M>;
    const Matrix told = e.information.topLeftCorner<M, M>();
    const Eigen::Matrix<double, M, 1> left = e.gradient.head<M>() - told * middle;
    const Matrix with = Matrix::Identity() + variance.asDiagonal() * told;
    const Eigen::Matrix<double, M, 1> off = told.completeOrthogonalDecomposition().solve(left);
    if (left.dot(with.inverse() * off) > too_far) far.push_back(&e);
  }
  constexpr std::size_t few = 10;  // at most one in so many
  if (far.size() * few > evidence.size()) return false;
  for (Evidence* const e : far) e->error.left_out = true;
  return !far.empty();
}

bool is_told(std::span<const Evidence> evidence, int k) {
  return std::ranges::any_of(evidence, [&](const Evidence& e) {
    return !e.error.left_out && (e.error.measured ? e.information(k, k) > 0 : k < 2);
  });
}

template <int M>
std::vector<PlayerError> find(std::span<Evidence> evidence) {
  const auto measured =
      std::ranges::count_if(evidence, [](const Evidence& e) { return e.error.measured && !e.error.left_out; });
  Unlikelihood<M> f{evidence, measured > 1, {}};
  Unknowns<M> x{};
  double least = lowest(f, x);
  constexpr int rounds = 3;
  for (int i = 0; i < rounds && leave_out<M>(evidence, x); ++i) least = lowest(f, x);
  const auto errors = f.biased ? bias_errors<M>(f, x) : std::array<double, M>{};
  constexpr const char* names[] = {"angle", "speed", "side", "top"};
  std::vector<PlayerError> out;
  for (int k = 0; k < M; ++k) {
    const double unit = usual_error()(k), unit_of_bias = k == 1 ? share : unit;
    PlayerError& e = out.emplace_back(PlayerError{.name = names[k], .sigma_interval = {0, forever}});
    if (!is_told(evidence, k)) continue;
    e.sigma = unit * std::exp(x[sigma_of(k)]);
    constexpr double first = 0.1;  // e-folds
    e.sigma_interval = {unit * std::exp(end_of<M>(f, x, k, least, -first)),
                        unit * std::exp(end_of<M>(f, x, k, least, first))};
    if (!std::isfinite(errors[sigma_of(k)]) || !f.biased) continue;
    const double off = student(static_cast<double>(measured - 1)) * errors[sigma_of(k)];
    e.bias = unit_of_bias * x[bias_of<M>(k)];
    e.bias_interval = {unit_of_bias * (x[bias_of<M>(k)] - off), unit_of_bias * (x[bias_of<M>(k)] + off)};
    e.bias_is_told = true;
  }
  return out;
}

}  // namespace

std::vector<PlayerError> errors_of(std::span<Evidence> evidence) {
  return is_told(evidence, 2) || is_told(evidence, 3) ? find<4>(evidence) : find<2>(evidence);
}

}  // namespace bankshot::planning
