// SPDX-License-Identifier: MIT
//
// How a replayed line of travel leads into a pocket.
#pragma once

#include <cmath>

#include "planners/proof/replay.hpp"

namespace bankshot::planning {

/// Of a ball.
struct Line {
  Vec2d at, heading;
};

/// How a line leads into a pocket: miss and offset of the replay.
inline void measure(const Question& q, const Mark& mark, const Line& line, Replay& replay) {
  const Vec2d u = line.heading / norm(line.heading);
  const double offset = cross(u, line.at - mark.at), exact = mark.exact_offset(u, offset);
  replay.miss = std::abs(offset - exact);
  replay.offset = q.centred(replay.miss) && !replay.rattles ? exact : offset;
}

}  // namespace bankshot::planning
