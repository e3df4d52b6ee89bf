// SPDX-License-Identifier: MIT
//
// The evidence of one attempt: how far its launch lay from the intended one.
#pragma once

#include <Eigen/Core>

#include "bankshot/learn/advise.hpp"
#include "planners/learn/unknowns.hpp"

namespace bankshot::planning {

/// Number of errors of a launch: angle, speed, side, top, in units of `usual_error`.
inline constexpr int error_size = 4;
using LaunchError = Eigen::Vector4d;
/// Returns the units of the errors: rad, m/s, LaunchSpin.
LaunchError usual_error();

/// A launch near the intended one, drawn for an attempt of which it is known only whether it was made.
struct Draw {
  double angle, speed;  ///< in units of `usual_error`, from the intended launch
  double density;       ///< relative probability density of being drawn
  bool made;
};

struct Evidence {
  AttemptError error;
  double meant_speed = 0;  ///< m/s
  /// The log likelihood of the launch's distance e from the intended launch is gradient · e − eᵀ information e / 2. If
  /// different launches explain the observations, it is that of a normal distribution with the mean and covariance of
  /// all.
  LaunchError gradient = LaunchError::Zero();
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  std::vector<Draw> draws{};  ///< only if all that was observed is whether it was made
  bool made = false;
};

/// `noise` [m]: standard error of one coordinate, if the recording gives none.
Evidence evidence_of(const Attempt& attempt, double noise, Spent& work);

}  // namespace bankshot::planning
