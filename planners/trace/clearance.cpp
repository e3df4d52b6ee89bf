// SPDX-License-Identifier: MIT
#include "planners/trace/clearance.hpp"

#include <algorithm>
#include <limits>

#include "bankshot/detail/roots/roots.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/trace/arrival.hpp"
#include "planners/trace/in_the_way.hpp"

namespace bankshot::planning {
namespace {

class Clearance {
 public:
  explicit Clearance(const Branch& aim) : aim_(aim), room_{aim.aim_point.reach, infinite} {}

  const Room& room() const { return room_; }

  void arc(std::size_t leg, const Arc<double>& arc, double t) {
    reached_ = arc.position(t);
    if (!(t > 0)) return;
    const detail::Reach<double> reach(arc, t, 0);
    const auto keeps_from = [&](const Circle& c) {
      const double near = c.radius + room_.on_the_way;
      if (near < 0 || reach.misses(c.centre, near)) return;    // something else is nearer
      const bool inside = norm(arc.at - c.centre) < c.radius;  // a ball that starts inside must first come out
      if (!inside) on_the_way(norm(arc.position(detail::closest_time(arc, t, c.centre)) - c.centre) - c.radius);
    };
    each_in_the_way(aim_.request.problem->boundary_of(aim_.ball(leg)), aim_.before(leg), aim_.next(leg),
                    aim_.aim_point.taken_by, keeps_from);
  }

  void met(std::size_t leg, const State<double>&) {
    const Meeting& meeting = aim_.route[leg];
    const Boundary& boundary = aim_.request.problem->boundary_of(meeting.ball);
    const Wall* const line = boundary.line(meeting.with);
    if (!line) return;
    const double along = dot(line->along, reached_);
    on_the_way(std::min(along - dot(line->along, line->from), dot(line->along, line->to) - along) + boundary.touch);
  }

  void arrival(const LockedArrival<double>& a) {
    const Vec2d off = aim_.aim_point.at - a.state.at;
    const Vec2d u = a.heading / norm(a.heading);
    const double offset = -cross(u, off);
    const Gap<double> gap = aim_.aim_point.gap(u, offset);
    if (aim_.aim_point.drops()) room_.hidden = hidden(aim_.aim_point.opening, u);
    at_aim_point(a.at_rest ? aim_.aim_point.reach - norm(off) : std::min(offset - gap.low, gap.high - offset));
    if (aim_.aim_point.capture() > 0 && !a.at_rest)
      at_aim_point(even_square(aim_.request.puzzle().physics, dot(a.state.velocity, a.state.velocity)) /
                   (2 * deceleration(aim_.request.puzzle().physics)));
    const Boundary& boundary = aim_.request.problem->boundary_of(aim_.aim_point.ball);
    at_aim_point(boundary.clearance(a.state.at) + boundary.touch);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  void on_the_way(double metres) { room_.on_the_way = std::min(room_.on_the_way, metres); }
  void at_aim_point(double metres) { room_.at_aim_point = std::min(room_.at_aim_point, metres); }

  const Branch& aim_;
  Room room_;
  Vec2d reached_{};  ///< end of the last arc
};

}  // namespace

double hidden(const Opening& opening, const Vec2d& u) {
  if (opening.covers(-u)) return 0;
  return std::max(0.0, std::min(dot(opening.first, u), dot(opening.last, u)) / opening.radius);
}

std::optional<double> clearance(const Branch& aim, EvaluationBudget& budget, const Launch& launch) {
  const auto r = room(aim, budget, launch);
  return r ? std::optional(r->least()) : std::nullopt;
}

std::optional<Room> room(const Branch& aim, EvaluationBudget& budget, const Launch& launch) {
  const SearchRequest& request = aim.request;
  if (budget.spent()) return {};
  budget.charge(aim.route.size());
  return with_physics(request.puzzle().physics, [&](const auto& motion, const auto& cushion) -> std::optional<Room> {
    Clearance out(aim);
    const auto arrival = trace(request.problem->balls(), motion, cushion, aim.route, start_of(request, launch),
                               destination(aim), budget.work(), out);
    if (!arrival) return {};
    out.arrival(*arrival);
    return out.room();
  });
}

}  // namespace bankshot::planning
