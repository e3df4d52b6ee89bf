// SPDX-License-Identifier: MIT
#include "planners/locked/clearance.hpp"

#include <algorithm>
#include <limits>

#include "bankshot/simulate/locked.hpp"
#include "planners/locked/arrival.hpp"
#include "planners/locked/in_the_way.hpp"
#include "planners/start.hpp"

namespace bankshot::planning {
namespace {

class Clearance {
 public:
  explicit Clearance(const LockedAim& aim) : aim_(aim) {}

  double least() const { return least_; }
  void consider(double metres) { least_ = std::min(least_, metres); }

  /// An arc of a ball on the way to the meeting `next`, or on the last leg (none).
  void arc(int ball, const Arc<double>& arc, double t, std::span<const Meeting> before, Contact next) {
    if (!(t > 0)) return;
    const auto keeps_from = [&](const Circle& c) {
      const bool inside = norm(arc.at - c.centre) < c.radius;  // such a ball must first come out
      if (!inside) consider(norm(arc.position(closest_time(arc, t, c.centre)) - c.centre) - c.radius);
    };
    each_in_the_way(aim_.q.boundary_of(ball), before, next, aim_.mark.taken_by, keeps_from);
  }

  void bounce(const Meeting& meeting, const Vec2d& at) {
    const Boundary& boundary = aim_.q.boundary_of(meeting.ball);
    const Wall* const line = boundary.line(meeting.with);
    if (!line) return;
    const double along = dot(line->along, at);
    consider(std::min(along - dot(line->along, line->from), dot(line->along, line->to) - along) + boundary.touch);
  }

  void arrival(const LockedArrival<double>& a) {
    const Vec2d off = aim_.mark.at - a.state.at;
    const Vec2d u = a.heading / norm(a.heading);
    const double offset = -cross(u, off);
    const Gap<double> gap = aim_.mark.gap(u, offset);
    consider(a.at_rest ? aim_.mark.reach - norm(off) : std::min(offset - gap.low, gap.high - offset));
    if (aim_.mark.capture() > 0 && !a.at_rest)
      consider(even_square(aim_.q.puzzle.physics, dot(a.state.velocity, a.state.velocity)) /
               (2 * deceleration(aim_.q.puzzle.physics)));
    const Boundary& boundary = aim_.q.boundary_of(aim_.mark.ball);
    consider(boundary.clearance(a.state.at) + boundary.touch);
  }

 private:
  const LockedAim& aim_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<double> clearance(const LockedAim& aim, Ledger& ledger, const Launch& launch) {
  const Question& q = aim.q;
  if (ledger.spent()) return {};
  ledger.charge(aim.route.size());
  return with_physics(q.puzzle.physics, [&](const auto& motion, const auto& cushion) -> std::optional<double> {
    Clearance out(aim);
    State<double> state = start_of(q, launch);
    std::span<const Meeting> before;
    for (const Meeting& meeting : aim.route) {
      Vec2d met = state.at;
      const auto watch = [&](const Arc<double>& arc, double t) {
        out.arc(meeting.ball, arc, t, before, meeting.with);
        met = arc.position(t);
      };
      const auto path = follow_locked(q.balls(), motion, cushion, std::span<const Meeting>(&meeting, 1), state, watch);
      if (path.end != LockedEnd::complete) return {};
      out.bounce(meeting, met);
      state = path.state;
      before = aim.route.first(before.size() + 1);
    }
    if (!(dot(state.velocity, state.velocity) > 0)) return {};
    const auto watch = [&](const Arc<double>& arc, double t) { out.arc(aim.mark.ball, arc, t, before, {}); };
    const auto arrival =
        arrive_locked(motion, q.boundary_of(aim.mark.ball).body, state, aim.mark.at, aim.mark.capture(), q.stop, watch);
    if (!(dot(arrival.heading, arrival.heading) > 0)) return {};
    out.arrival(arrival);
    return out.least();
  });
}

}  // namespace bankshot::planning
