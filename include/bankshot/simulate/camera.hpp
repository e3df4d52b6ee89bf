// SPDX-License-Identifier: MIT
//
// A simulated shot as a camera would see it: what fits are tried on, since its truth is known.
#pragma once

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/recording.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

struct Camera {
  double rate = usual_rate;  ///< samples a second
  double noise = 0;          ///< m, standard deviation of each coordinate
  double drop = 0;           ///< share of samples that are missing
  double outliers = 0;       ///< share of samples that are anywhere within `astray`
  double astray = 0.3;       ///< m
};

/// Every ball that moves, from the launch to where it rests or falls. Physics and launch are not told, only which
/// physics it is; where balls stood and came to rest errs as all samples do.
Recording film(const ShotRequest& shot, const Trajectory& trajectory, const Camera& camera, Random& random);

}  // namespace bankshot
