// SPDX-License-Identifier: MIT
#include "planners/locked/clearance.hpp"

#include <algorithm>
#include <limits>

#include "bankshot/simulate/locked.hpp"
#include "bankshot/simulate/simulator.hpp"

namespace bankshot::planning {
namespace {

class Clearance {
 public:
  explicit Clearance(const LockedAim& aim) : aim_(aim), boundary_(aim.s.boundary) {}

  double least() const { return least_; }
  void consider(double metres) { least_ = std::min(least_, metres); }

  /// An arc on the way to the bounce `next`, none on the last leg.
  void arc(const Arc<double>& arc, double t, Contact before, Contact next) {
    if (!(t > 0)) return;
    const auto keeps_from = [&](const Circle& c) {
      const bool inside = norm(arc.at - c.centre) < c.radius;  // such a ball must first come out
      if (!inside) consider(norm(arc.position(closest_time(arc, t, c.centre)) - c.centre) - c.radius);
    };
    for (const Circle& pocket : boundary_.pockets)
      if (next || !(pocket.centre == aim_.target)) keeps_from(pocket);
    for (const Circle& tip : boundary_.tips)
      if (tip.contact != before && tip.contact != next) keeps_from(tip);
  }

  void bounce(Contact contact, const Vec2d& at) {
    const Wall* const w = boundary_.line(contact);
    if (!w) return;
    const double along = dot(w->along, at);
    consider(std::min(along - dot(w->along, w->from), dot(w->along, w->to) - along) + boundary_.touch);
  }

  void arrival(const LockedArrival<double>& a) {
    const Vec2d off = aim_.target - a.state.at;
    consider(aim_.s.reach(aim_.target) - (a.at_rest ? norm(off) : std::abs(cross(a.heading, off)) / norm(a.heading)));
    if (aim_.capture() > 0 && !a.at_rest)
      consider(dot(a.state.velocity, a.state.velocity) / (2 * deceleration(aim_.s.puzzle.physics)));
    consider(boundary_.clearance(a.state.at) + boundary_.touch);
  }

 private:
  const LockedAim& aim_;
  const Boundary& boundary_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::optional<double> clearance(Search& s, const LockedAim& aim, const Launch& launch) {
  s.spend(aim.contacts.size());
  return with_physics(s.puzzle.physics, [&](const auto& motion, const auto& cushion) -> std::optional<double> {
    Clearance out(aim);
    State<double> state =
        launched(s.puzzle.ball.at, s.puzzle.ball.body.radius, direction(launch.angle) * launch.speed, s.puzzle.spin);
    Contact before;
    for (const Contact contact : aim.contacts) {
      Vec2d met = state.at;
      const auto watch = [&](const Arc<double>& arc, double t) {
        out.arc(arc, t, before, contact);
        met = arc.position(t);
      };
      const auto path = follow_locked(s.boundary, motion, cushion, std::span<const Contact>(&contact, 1), state, watch);
      if (path.end != LockedEnd::complete) return {};
      out.bounce(contact, met);
      state = path.state;
      before = contact;
    }
    if (!(dot(state.velocity, state.velocity) > 0)) return {};
    const auto arrival = arrive_locked(motion, s.boundary.body, state, aim.target, aim.capture(), s.stop,
                                       [&](const Arc<double>& arc, double t) { out.arc(arc, t, before, {}); });
    if (!(dot(arrival.heading, arrival.heading) > 0)) return {};
    out.arrival(arrival);
    return out.least();
  });
}

}  // namespace bankshot::planning
