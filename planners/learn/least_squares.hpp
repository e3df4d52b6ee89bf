// SPDX-License-Identifier: MIT
//
// What Ceres solves: one launch, or all launches and the coefficients that they share.
#pragma once

#include <Eigen/Core>

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// The launch alone, up to the window, as the shot is told. Returns the root mean square distance in sigmas.
double solve_launch(Seen& seen, const Common& common, Work& work);

/// All shots that are not left out, with the coefficients.
void solve_all(Shots& shots, Common& common, Work& work);

/// -2 log of how likely what was seen is of the launches around this one together (Laplace's approximation), up to what
/// all launches of the shot share. A sample that is not followed, as after a ball fell, counts as one that is off as
/// far as an outlier is: else a launch that follows none would be likeliest.
double unlikelihood(const Seen& seen, const Common& common);

/// What is told of the launch, in units of sigmas, what is expected of it included (JᵀJ).
Eigen::Matrix<double, launch_size, launch_size> launch_information(const Seen& seen, const Common& common);

/// What the shots tell of the coefficients, the launches being unknown too: the inverse of their covariance, in units
/// of sigmas. (The Schur complement of the launches in JᵀJ.)
Eigen::MatrixXd information(const Shots& shots, const Common& common);

/// The covariance of the coefficients (ceres::Covariance), in units of sigmas; empty where it has none.
Eigen::MatrixXd covariance(Shots& shots, const Common& common);

}  // namespace bankshot::planning
