// SPDX-License-Identifier: MIT
#include "planners/learn/way.hpp"

namespace bankshot::planning {
namespace {

/// Returns the contacts of the cue ball; other balls that it touches must stand where they stood.
Told of_struck(const Trajectory& shot, double until) {
  Told told;
  std::vector<int> moved;
  for (const Record& e : shot.events) {
    if (e.time > until) break;
    if (e.kind == EventKind::ball) {
      const bool struck = e.ball == 0 || e.contact.index == 0;
      const int other = e.ball == 0 ? e.contact.index : e.ball;
      const bool stood = std::ranges::find(moved, other) == moved.end() && e.ball == 0;
      moved.push_back(other);
      if (!struck) moved.push_back(e.contact.index);
      if (struck && !stood) return told.until = e.time, told;
      if (struck) told.route.push_back({0, e.contact});
    } else if (e.ball == 0 && is_bounce(e.kind)) {
      told.route.push_back({0, e.contact});
    } else if (e.ball == 0 && e.kind == EventKind::pocket) {
      return told.until = e.time, told;
    }
  }
  return told;
}

Told of_other(const Trajectory& shot, int ball, double until) {
  Told told{.ball = ball};
  bool sent = false;
  for (const Record& e : shot.events) {
    if (e.time > until) break;
    if (e.kind == EventKind::ball) {
      const bool its = e.ball == ball || e.contact.index == ball;
      // Only the cue ball's first contact is followed on.
      if (sent ? its : e.ball != 0 || e.contact.index != ball) return told.until = e.time, told;
      if (!sent) told.before.push_back({0, e.contact});
      sent = true;
    } else if (is_bounce(e.kind) && e.ball == (sent ? ball : 0)) {
      (sent ? told.route : told.before).push_back({e.ball, e.contact});
    } else if (e.ball == ball && e.kind == EventKind::pocket) {
      return told.until = e.time, told;
    }
  }
  if (!sent) told.until = 0;
  return told;
}

}  // namespace

Told told_of(const Trajectory& shot, int ball, double until) {
  return ball == 0 ? of_struck(shot, until) : of_other(shot, ball, until);
}

Stand::Stand(const ShotRequest& scene) : struck_(scene.table, scene.ball.body, scene.others) {
  for (std::size_t i = 0; i < scene.others.size(); ++i) {
    const Ball& other = scene.others[i];
    boundaries_.emplace_back(scene.table, other.body);
    others_.push_back({static_cast<int>(i) + 1, &boundaries_.back(), other.at});
  }
}

}  // namespace bankshot::planning
