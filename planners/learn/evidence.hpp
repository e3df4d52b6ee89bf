// SPDX-License-Identifier: MIT
//
// What one attempt says of how far its launch lay from what was meant.
#pragma once

#include <Eigen/Core>

#include "bankshot/learn/advise.hpp"
#include "planners/learn/unknowns.hpp"

namespace bankshot::planning {

/// Of a launch: angle, speed, side, top, in units of `usual_error`.
inline constexpr int error_size = 4;
using LaunchError = Eigen::Vector4d;
/// rad, m/s, LaunchSpin.
LaunchError usual_error();

/// A launch near the one that was meant, drawn for an attempt of which only is known whether it was made.
struct Draw {
  double angle, speed;  ///< in units of `usual_error`, from what was meant
  double density;       ///< of being drawn
  bool made;
};

struct Evidence {
  AttemptError error;
  double meant_speed = 0;  ///< m/s
  /// Of the launch's distance e from what was meant the log likelihood is gradient · e − eᵀ information e / 2. Where
  /// launches that differ explain what was seen, it is that of a normal distribution with the mean and covariance of
  /// all.
  LaunchError gradient = LaunchError::Zero();
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  std::vector<Draw> draws{};  ///< where it was seen only whether it was made
  bool made = false;
};

/// `noise` [m]: of one coordinate where the recording says none.
Evidence evidence_of(const Attempt& attempt, double noise, Work& work);

}  // namespace bankshot::planning
