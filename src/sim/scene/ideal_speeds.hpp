// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "bankshot/scene/puzzle.hpp"

namespace bankshot {

/// Returns the speeds [m/s] that the puzzle allows in ideal physics, where a ball arrives as fast as it is launched.
/// Empty, with its ends exchanged, if there are none.
inline Range ideal_speeds(const Puzzle& p) {
  const Range& asked = p.arrive ? *p.arrive : p.speed;
  return {std::max(p.speed.low, asked.low), std::min(p.speed.high, asked.high)};
}

}  // namespace bankshot
