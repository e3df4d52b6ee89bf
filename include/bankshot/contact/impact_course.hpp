// SPDX-License-Identifier: MIT
//
// The course of a cushion impact of mathavan2010: whether it jammed, its steps, and its changes between sticking and
// sliding.
#pragma once

#include <array>

namespace bankshot {

struct ImpactCourse {
  /// Bit set: the cushion slides (bit 0), the cloth slides (bit 1), the cloth carries nothing (bit 2), and the ball is
  /// on its way back (bit 3).
  using Mode = unsigned char;

  bool jams = false;  ///< the ball stops approaching too soon, no forces are consistent, or there were too many steps
  int steps = 0;
  int modes = 0;
  std::array<Mode, 16> mode{};  ///< first sixteen modes, in order
};

}  // namespace bankshot
