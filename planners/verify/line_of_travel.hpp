// SPDX-License-Identifier: MIT
//
// Measures how a replayed line of travel leads into a pocket, or onto a ball.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "bankshot/geometry/aim_point.hpp"
#include "planners/verify/replay.hpp"

namespace bankshot::planning {

/// A ball's line of travel.
struct Line {
  Vec2d at, heading;
};

/// Measures how a line leads into a pocket: sets miss and offset of the replay.
inline void measure(const SearchRequest& request, const AimPoint& aim_point, const Line& line, Replay& replay) {
  const Vec2d u = line.heading / norm(line.heading);
  const double offset = cross(u, line.at - aim_point.at), exact = aim_point.exact_offset(u, offset);
  replay.miss = std::abs(offset - exact);
  replay.offset = request.problem->centred(replay.miss) && !replay.path.touches_jaws ? exact : offset;
}

/// Returns the contact of a ball that moves along the line, at this speed, with a ball at `other`.
inline Hit hit_by(const Line& line, double speed, int ball, const Vec2d& other, double reach, int after) {
  const double size = norm(line.heading), offset = size > 0 ? cross(line.heading, line.at - other) / size : 0;
  return {ball, std::asin(std::clamp(-offset / reach, -1.0, 1.0)), speed, line.at, after};
}

/// Judges the contact with the ball that is the target: how far the cut is off, and whether it is allowed.
inline void touched(const AimPoint& aim_point, const Line& line, Replay& replay) {
  const double offset = cross(line.heading, line.at - aim_point.at) / norm(line.heading);
  replay.miss = std::abs(offset - aim_point.cuts->exact);
  replay.made = offset >= aim_point.cuts->low && offset <= aim_point.cuts->high;
  if (!replay.made) replay.failure = {FailureReason::other_cut, aim_point.taken_by};
}

/// Counts a jaw contact of a ball on a line. The first jaw met at a target pocket defines the line of travel there.
inline void touch_jaw(const SearchRequest& request, Contact jaw, const Line& line, std::optional<Line>& first,
                      ShotPath& path) {
  const Contact pocket = Contact::pocket(jaw.jaw_pocket());
  if (!first && std::ranges::count(request.problem->aim_points, pocket, &AimPoint::taken_by) > 0) first = line;
  path.touches_jaws = true;
  ++path.jaws;
}

/// Judges a ball of this number that comes to rest [m, s].
inline void rested(const SearchRequest& request, int ball, const Vec2d& at, double time, Replay& replay) {
  const AimPoint& aim_point = request.problem->nearest_aim_point(at, ball);
  replay.miss = norm(at - aim_point.at);
  replay.path.arrival = {time, 0, at};
  replay.made = replay.miss <= aim_point.reach;
  if (!replay.made) replay.failure = {FailureReason::missed};
}

}  // namespace bankshot::planning
