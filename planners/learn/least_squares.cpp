// SPDX-License-Identifier: MIT
#include "planners/learn/least_squares.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "planners/learn/settings.hpp"

namespace bankshot::planning {
namespace {

/// Bounds a launch by what a cue can do.
void bound_launch(ceres::Problem& problem, const Seen& seen, double* block) {
  const auto keep = [&](LaunchIndex k, double low, double high) {
    block[k] = std::min(std::max(block[k], low), high);
    problem.SetParameterLowerBound(block, static_cast<int>(k), low);
    problem.SetParameterUpperBound(block, static_cast<int>(k), high);
  };
  constexpr double fastest = 20, most_spin = 2, most_masse = 1;
  // The ball's centre stays on the table.
  const Boundary& boundary = seen.stand.struck();
  double left = -forever, right = forever, bottom = -forever, above = forever;
  for (const Wall& w : boundary.walls) {
    if (w.normal.x == 1) left = w.offset;
    if (w.normal.x == -1) right = -w.offset;
    if (w.normal.y == 1) bottom = w.offset;
    if (w.normal.y == -1) above = -w.offset;
  }
  if (boundary.strictly_convex || boundary.unfolds()) {
    if (left > -forever && right < forever) keep(x, left, right);
    if (bottom > -forever && above < forever) keep(y, bottom, above);
  }
  keep(speed, settings::learn::least_speed, fastest);
  keep(top, -most_spin, most_spin);
  keep(side, -most_spin, most_spin);
  keep(masse, -most_masse, most_masse);
}

/// Shots and coefficients as Ceres sees them. They are in one array, because Ceres sorts blocks by address: addresses
/// that change from run to run would change the rounding.
class LeastSquares {
 public:
  LeastSquares(const std::vector<Seen*>& shots, const Common& common)
      : shots_(shots), unknowns_(shots.size() * launch_size), problem(costs_are_ours()) {
    unknowns_.insert(unknowns_.end(), common.values.begin(), common.values.end());
    options.logging_type = ceres::SILENT;
    for (std::size_t i = 0; i < shots.size(); ++i) {
      std::ranges::copy(shots[i]->launch, launch(i));
      costs_.emplace_back(*shots[i], common.names, common.base);
      std::vector<double*> blocks{launch(i)};
      if (!common.values.empty()) blocks.push_back(values());
      problem.AddResidualBlock(&costs_.back(), nullptr, blocks);
      bound_launch(problem, *shots[i], launch(i));
    }
  }

  double* launch(std::size_t i) { return unknowns_.data() + i * launch_size; }
  double* values() { return launch(shots_.size()); }

  /// Solves the problem and stores the launches with their shots.
  ceres::Solver::Summary solve(Spent& work) {
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    work.simulations += static_cast<long>(summary.iterations.size() * costs_.size());
    for (std::size_t i = 0; i < shots_.size(); ++i) std::copy_n(launch(i), launch_size, shots_[i]->launch.begin());
    return summary;
  }

 private:
  static ceres::Problem::Options costs_are_ours() {
    ceres::Problem::Options out;
    out.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return out;
  }

  std::vector<Seen*> shots_;
  std::vector<double> unknowns_;
  std::list<SeenCost> costs_;

 public:
  ceres::Problem problem;
  ceres::Solver::Options options;
};

std::vector<Seen*> that_teach(Shots& shots) {
  std::vector<Seen*> out;
  for (Seen& seen : shots)
    if (!seen.left_out) out.push_back(&seen);
  return out;
}

struct Linearised {
  Eigen::VectorXd off;  ///< residuals
  Eigen::Matrix<double, Eigen::Dynamic, launch_size, Eigen::RowMajor> by_launch;
};

/// Returns the residuals and their derivatives at the shot's launch.
Linearised linear(const Seen& seen, const Common& common) {
  const SeenCost cost(seen, common.names, common.base);
  Linearised out{Eigen::VectorXd(cost.num_residuals()), {cost.num_residuals(), launch_size}};
  const double* blocks[] = {seen.launch.data(), common.values.data()};
  double* jacobians[] = {out.by_launch.data(), nullptr};
  cost.Evaluate(blocks, out.off.data(), jacobians);
  return out;
}

}  // namespace

double solve_launch(Seen& seen, const Common& common, Spent& work) {
  LeastSquares squares({&seen}, common);
  if (!common.values.empty()) squares.problem.SetParameterBlockConstant(squares.values());
  squares.options.linear_solver_type = ceres::DENSE_QR;
  squares.options.max_num_iterations = 40;
  squares.options.function_tolerance = 1e-8;
  return std::sqrt(2 * squares.solve(work).final_cost / squares.problem.NumResiduals());
}

void solve_all(Shots& shots, Common& common, Spent& work) {
  if (shots.empty() || common.names.empty()) return;
  const std::vector<Seen*> teachers = that_teach(shots);
  LeastSquares squares(teachers, common);
  for (std::size_t k = 0; k < common.names.size(); ++k) {
    const Fittable& of = common.fittable(common.names[k]);
    squares.problem.SetParameterLowerBound(squares.values(), static_cast<int>(k), of.low);
    squares.problem.SetParameterUpperBound(squares.values(), static_cast<int>(k), of.high);
  }
  ceres::Solver::Options& options = squares.options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  auto* const order = new ceres::ParameterBlockOrdering;
  for (std::size_t i = 0; i < teachers.size(); ++i) order->AddElementToGroup(squares.launch(i), 0);
  order->AddElementToGroup(squares.values(), 1);
  options.linear_solver_ordering.reset(order);
  options.num_threads = 1;  // threads would sum in a varying order, and the last bits would differ
  options.max_num_iterations = 100;
  // Paths have kinks, where a spin has just died or a contact just sticks. One shot at a kink must not stop all.
  options.use_nonmonotonic_steps = true;
  options.max_consecutive_nonmonotonic_steps = 10;
  options.function_tolerance = 1e-9;
  squares.solve(work);
  std::copy_n(squares.values(), common.values.size(), common.values.begin());
}

double unlikelihood(const Seen& seen, const Common& common) {
  const auto [off, by_launch] = linear(seen, common);
  const Eigen::Matrix<double, launch_size, launch_size> told = by_launch.transpose() * by_launch;
  long samples = 0;
  for (const std::vector<char>& left_out : seen.outlier) samples += std::ranges::count(left_out, 0);
  using settings::learn::outlier;
  const double not_followed = outlier * outlier * static_cast<double>(samples - seen.samples_used());
  return off.squaredNorm() + not_followed + told.ldlt().vectorD().array().log().sum();
}

Eigen::Matrix<double, launch_size, launch_size> launch_information(const Seen& seen, const Common& common) {
  const auto [off, by_launch] = linear(seen, common);
  return by_launch.transpose() * by_launch;
}

Eigen::MatrixXd information(const Shots& shots, const Common& common) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto m = static_cast<Eigen::Index>(common.names.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(m, m);
  for (const Seen& seen : shots) {
    if (seen.left_out) continue;
    const SeenCost cost(seen, common.names, common.base);
    Rows launch(cost.num_residuals(), launch_size), shared(cost.num_residuals(), m);
    std::vector<double> residuals(static_cast<std::size_t>(cost.num_residuals()));
    const double* blocks[] = {seen.launch.data(), common.values.data()};
    double* jacobians[] = {launch.data(), shared.data()};
    cost.Evaluate(blocks, residuals.data(), jacobians);
    const Eigen::MatrixXd across = launch.transpose() * shared;
    sum += shared.transpose() * shared - across.transpose() * (launch.transpose() * launch).ldlt().solve(across);
  }
  return sum;
}

Eigen::MatrixXd covariance(Shots& shots, const Common& common) {
  const auto m = static_cast<Eigen::Index>(common.names.size());
  if (m == 0) return {};
  LeastSquares squares(that_teach(shots), common);
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::SPARSE_QR;
  ceres::Covariance covariance(options);
  const double* const block = squares.values();
  const std::vector<std::pair<const double*, const double*>> pairs{{block, block}};
  if (!covariance.Compute(pairs, &squares.problem)) return {};
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> out(m, m);
  covariance.GetCovarianceBlock(block, block, out.data());
  return out;
}

}  // namespace bankshot::planning
