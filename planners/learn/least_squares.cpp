// SPDX-License-Identifier: MIT
#include "planners/learn/least_squares.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>

#include "planners/learn/settings.hpp"

namespace bankshot::planning {
namespace {

/// Keeps a launch what a cue can do.
void bound_launch(ceres::Problem& problem, Seen& seen) {
  double* const block = seen.launch.data();
  const auto keep = [&](LaunchIndex k, double low, double high) {
    block[k] = std::min(std::max(block[k], low), high);
    problem.SetParameterLowerBound(block, static_cast<int>(k), low);
    problem.SetParameterUpperBound(block, static_cast<int>(k), high);
  };
  constexpr double fastest = 20, most_spin = 2, most_masse = 1;
  // The ball stands where its centre can be.
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

/// Shots and coefficients as Ceres sees them.
struct LeastSquares {
  explicit LeastSquares(Common& of) : common(of), problem(costs_are_ours()) { options.logging_type = ceres::SILENT; }

  void add(Seen& seen) {
    costs.emplace_back(seen, common.names, common.base);
    std::vector<double*> blocks{seen.launch.data()};
    if (!common.values.empty()) blocks.push_back(common.values.data());
    problem.AddResidualBlock(&costs.back(), nullptr, blocks);
    bound_launch(problem, seen);
  }
  void add(Shots& shots) {
    for (Seen& seen : shots)
      if (!seen.left_out) add(seen);
  }

  ceres::Solver::Summary solve(Work& work) {
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    work.simulations += static_cast<long>(summary.iterations.size() * costs.size());
    return summary;
  }

  static ceres::Problem::Options costs_are_ours() {
    ceres::Problem::Options out;
    out.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return out;
  }

  Common& common;
  std::list<SeenCost> costs;
  ceres::Problem problem;
  ceres::Solver::Options options;
};

}  // namespace

double solve_launch(Seen& seen, const Common& common, Work& work) {
  Common held = common;
  LeastSquares squares(held);
  squares.add(seen);
  if (!held.values.empty()) squares.problem.SetParameterBlockConstant(held.values.data());
  squares.options.linear_solver_type = ceres::DENSE_QR;
  squares.options.max_num_iterations = 40;
  squares.options.function_tolerance = 1e-8;
  return std::sqrt(2 * squares.solve(work).final_cost / squares.problem.NumResiduals());
}

void solve_all(Shots& shots, Common& common, Work& work) {
  if (shots.empty() || common.names.empty()) return;
  LeastSquares squares(common);
  squares.add(shots);
  for (std::size_t k = 0; k < common.names.size(); ++k) {
    const Fittable& of = common.fittable(common.names[k]);
    squares.problem.SetParameterLowerBound(common.values.data(), static_cast<int>(k), of.low);
    squares.problem.SetParameterUpperBound(common.values.data(), static_cast<int>(k), of.high);
  }
  ceres::Solver::Options& options = squares.options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  auto* const order = new ceres::ParameterBlockOrdering;
  for (Seen& seen : shots)
    if (!seen.left_out) order->AddElementToGroup(seen.launch.data(), 0);
  order->AddElementToGroup(common.values.data(), 1);
  options.linear_solver_ordering.reset(order);
  options.num_threads = 1;  // sums of several threads round as these come to an end: the bytes would differ
  options.max_num_iterations = 100;
  // Paths have kinks, where a spin has just died or a contact just sticks: one shot at one must not stop all.
  options.use_nonmonotonic_steps = true;
  options.max_consecutive_nonmonotonic_steps = 10;
  options.function_tolerance = 1e-9;
  squares.solve(work);
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

Eigen::MatrixXd covariance(Shots& shots, Common& common) {
  const auto m = static_cast<Eigen::Index>(common.names.size());
  if (m == 0) return {};
  LeastSquares squares(common);
  squares.add(shots);
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::SPARSE_QR;
  ceres::Covariance covariance(options);
  const double* const block = common.values.data();
  const std::vector<std::pair<const double*, const double*>> pairs{{block, block}};
  if (!covariance.Compute(pairs, &squares.problem)) return {};
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> out(m, m);
  covariance.GetCovarianceBlock(block, block, out.data());
  return out;
}

}  // namespace bankshot::planning
