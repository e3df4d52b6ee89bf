// SPDX-License-Identifier: MIT
#include "planners/learn/joint.hpp"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>

#include "planners/learn/bounds.hpp"

namespace bankshot::planning {
namespace {

/// Shots and coefficients as Ceres sees them.
struct Joint {
  Joint(Shots& shots, Common& common) {
    ceres::Problem::Options shared;
    shared.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    problem = std::make_unique<ceres::Problem>(shared);
    for (Seen& seen : shots) {
      if (seen.left_out) continue;
      costs.emplace_back(seen, common.names, common.base);
      std::vector<double*> blocks{seen.launch.data()};
      if (!common.values.empty()) blocks.push_back(common.values.data());
      problem->AddResidualBlock(&costs.back(), nullptr, blocks);
      bound_launch(*problem, seen);
    }
  }
  std::list<SeenCost> costs;
  std::unique_ptr<ceres::Problem> problem;
};

}  // namespace

void solve_joint(Shots& shots, Common& common, const std::vector<Fittable>& bounds, Work& work) {
  if (shots.empty() || common.names.empty()) return;
  Joint joint(shots, common);
  for (std::size_t k = 0; k < common.names.size(); ++k) {
    const auto bound = std::ranges::find(bounds, common.names[k], &Fittable::name);
    joint.problem->SetParameterLowerBound(common.values.data(), static_cast<int>(k), bound->low);
    joint.problem->SetParameterUpperBound(common.values.data(), static_cast<int>(k), bound->high);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  auto* const order = new ceres::ParameterBlockOrdering;
  for (Seen& seen : shots)
    if (!seen.left_out) order->AddElementToGroup(seen.launch.data(), 0);
  order->AddElementToGroup(common.values.data(), 1);
  options.linear_solver_ordering.reset(order);
  options.num_threads =
      1;  // sums of several threads round as these come to an end: the same input gives the same bytes
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = 100;
  // Paths have kinks, where a spin has just died or a contact just sticks: one shot at one must not stop all.
  options.use_nonmonotonic_steps = true;
  options.max_consecutive_nonmonotonic_steps = 10;
  options.function_tolerance = 1e-9;
  ceres::Solver::Summary summary;
  ceres::Solve(options, joint.problem.get(), &summary);
  work.simulations += static_cast<long>(summary.iterations.size() * shots.size());
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
  Joint joint(shots, common);
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::SPARSE_QR;
  ceres::Covariance covariance(options);
  const double* const block = common.values.data();
  const std::vector<std::pair<const double*, const double*>> pairs{{block, block}};
  if (!covariance.Compute(pairs, joint.problem.get())) return {};
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> out(m, m);
  covariance.GetCovarianceBlock(block, block, out.data());
  return out;
}

}  // namespace bankshot::planning
