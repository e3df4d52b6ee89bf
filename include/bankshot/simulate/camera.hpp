// SPDX-License-Identifier: MIT
//
// Films a simulated shot as a camera would see it. Fits are tested on such recordings, because their truth is known.
#pragma once

#include "bankshot/numbers/random.hpp"
#include "bankshot/scene/recording.hpp"
#include "bankshot/simulate/trajectory.hpp"

namespace bankshot {

struct Camera {
  double rate = usual_rate;  ///< samples per second
  double noise = 0;          ///< m, standard deviation of each coordinate
  double drop = 0;           ///< share of samples that are missing
  double outliers = 0;       ///< share of samples that are displaced by up to `astray` in each coordinate
  double astray = 0.3;       ///< m
};

/// Records every ball that moves, from the launch to where it rests or falls. The recording names the kind of physics,
/// but neither its coefficients nor the launch. Start and rest positions have the same errors as all samples.
Recording film(const ShotRequest& shot, const Trajectory& trajectory, const Camera& camera, Random& random);

}  // namespace bankshot
