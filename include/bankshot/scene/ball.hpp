// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "bankshot/numbers/angle.hpp"
#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/body.hpp"

namespace bankshot {

struct Ball {
  Vec2d at{};  ///< centre [m]
  Body body{};
  std::string id = "cue";  ///< name; the default is that of the cue ball
};

/// Speed and aim of the cue ball just after the strike.
struct Launch {
  double speed;  ///< m/s
  double angle;  ///< rad, anticlockwise from +x, in [0, 2π)
};

/// Spin at launch in units of natural roll, each ω R / v (dimensionless). It needs the physics `spin`.
struct LaunchSpin {
  double top = 0;    ///< topspin: 0 slides, 1 rolls, negative draws
  double side = 0;   ///< english, about the vertical axis; positive anticlockwise seen from above
  double masse = 0;  ///< about the line of travel; positive curves to the right
  bool operator==(const LaunchSpin&) const = default;
};

}  // namespace bankshot
