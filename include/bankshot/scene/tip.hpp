// SPDX-License-Identifier: MIT
//
// Computes the tip position on the ball from the launch spin. An impulse J along the cue through a
// point r from the centre of a solid ball gives it m v = J and 2/5 m R² ω = r × J, so that each unit of spin (ω R / v)
// lies 2/5 R from the centre. A cue raised by θ adds spin about the line of travel: massé = side · tan θ.
#pragma once

#include <cmath>

#include "bankshot/scene/ball.hpp"

namespace bankshot {

/// The tip position, seen along a level cue.
struct Tip {
  double right, up;  ///< m; from the centre
  double from_centre() const { return std::hypot(right, up); }
};

inline Tip tip_of(const LaunchSpin& spin, double radius) { return {0.4 * radius * spin.side, 0.4 * radius * spin.top}; }

/// Largest tip offset, relative to the ball's radius; beyond it, even a chalked tip slips off. Generally accepted
/// (D. Alciatore, "How high or low should you hit the cue ball?", Billiards Digest).
inline constexpr double miscue_limit = 0.5;

inline bool may_miscue(const LaunchSpin& spin) { return tip_of(spin, 1).from_centre() > miscue_limit; }

}  // namespace bankshot
