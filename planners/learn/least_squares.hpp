// SPDX-License-Identifier: MIT
//
// The least-squares problems that Ceres solves: one launch, or all launches and the coefficients that they share.
#pragma once

#include <Eigen/Core>

#include "planners/learn/seen.hpp"

namespace bankshot::planning {

/// Fits the launch alone, up to the window, along the stored contacts. Returns the root mean square distance in sigmas.
double solve_launch(Seen& seen, const Common& common, Spent& work);

/// Fits the coefficients together with the launches of all shots that are not left out.
void solve_all(Shots& shots, Common& common, Spent& work);

/// Returns −2 log of the likelihood of the observations, integrated over the launches around this one (Laplace's
/// approximation), up to a constant that all launches of the shot share. A sample that is not followed, as after a ball
/// fell, counts as far off as an outlier. Otherwise a launch that follows no samples would be likeliest.
double unlikelihood(const Seen& seen, const Common& common);

/// Returns the information on the launch, prior included, in units of sigmas (JᵀJ).
Eigen::Matrix<double, launch_size, launch_size> launch_information(const Seen& seen, const Common& common);

/// Returns the information of the shots on the coefficients, with the launches unknown too: the inverse of their
/// covariance, in units of sigmas. (The Schur complement of the launches in JᵀJ.)
Eigen::MatrixXd information(const Shots& shots, const Common& common);

/// Returns the covariance of the coefficients (ceres::Covariance), in units of sigmas; empty if it does not exist.
Eigen::MatrixXd covariance(Shots& shots, const Common& common);

}  // namespace bankshot::planning
