// SPDX-License-Identifier: MIT
//
// All shots of a fit at once: their launches, and the coefficients that they share.
#pragma once

#include <Eigen/Core>
#include <list>

#include "planners/learn/launch.hpp"

namespace bankshot::planning {

using Shots = std::list<Seen>;

/// Least squares over all shots, as each is told.
void solve_joint(Shots& shots, Common& common, const std::vector<Fittable>& bounds, Work& work);

/// What the shots tell of the coefficients, the launches being unknown too: the inverse of their covariance, in units
/// of sigmas. (The Schur complement of the launches in JᵀJ.)
Eigen::MatrixXd information(const Shots& shots, const Common& common);

/// The covariance of the coefficients (ceres::Covariance), in units of sigmas; empty where it has none.
Eigen::MatrixXd covariance(Shots& shots, Common& common);

}  // namespace bankshot::planning
