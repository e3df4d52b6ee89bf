// SPDX-License-Identifier: MIT
#include "planners/trace/discover.hpp"

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/settings.hpp"
#include "planners/trace/arrival.hpp"
#include "planners/trace/real_legs.hpp"

namespace bankshot::planning {
namespace {

using Dual2 = Dual<2>;

/// Follows one path, and notes what it passes.
class Follower {
 public:
  Follower(const SearchRequest& request, std::span<const AimPoint> aim_points, std::optional<double> near, Work& work,
           Discovery& out)
      : request_(request), aim_points_(aim_points), near_(near), work_(work), out_(out) {}

  template <class Motion, class Cushion>
  void along_route(const Motion& motion, const Cushion& cushion, const State<Dual2>& start) {
    out_.route = *request_.route;
    const auto path =
        follow_locked(request_.problem->boundary, motion, cushion, std::span<const Meeting>(out_.route), start);
    work_ += path.work;
    if (path.end == LockedEnd::complete) look(motion, path.state, path.time.a);
    out_.rests = path.end == LockedEnd::fell_short;
  }

  template <class Motion, class Cushion>
  void freely(const Motion& motion, const Cushion& cushion, const State<Dual2>& start) {
    Simulator sim(request_.problem->alone(), motion, cushion, start);
    const auto begins = [&] {
      if (may_arrive()) look(motion, sim.state(), sim.time().a);
      return near_ || bounces_ < request_.cushions().max;
    };
    each_leg(sim, work_, begins, [&](const Event& e) { return goes_on(e, sim.time().a, sim.state().at); });
  }

 private:
  /// Returns whether the meetings so far are those asked for, or may lie on a path through jaws.
  bool may_arrive() const {
    return near_ || (bounces_ >= request_.cushions().min && (!request_.route || out_.route == *request_.route));
  }

  /// Notes what ends a leg; returns whether the next one may be asked for.
  bool goes_on(const Event& e, double time, const Vec2<Dual2>& at) {
    out_.rests = e.kind == EventKind::rest;
    const bool bounce = e.kind == EventKind::cushion && bounces_ < request_.cushions().max;
    if (!(bounce || (near_ && e.kind == EventKind::jaw)) || time > request_.latest) return false;
    out_.route.push_back({0, e.contact});
    const Wall* const line = request_.problem->boundary.line(e.contact);
    const Dual2 along = line ? dot(line->along, at) : Dual2(0);
    out_.places.push_back({along.a, along.v[0]});
    const bool as_asked =
        !bounce || !request_.route || out_.route.back() == (*request_.route)[static_cast<std::size_t>(bounces_)];
    bounces_ += bounce;
    return as_asked;
  }

  /// Adds the misses of a free leg that begins in this state, one for each aim point.
  template <class Motion>
  void look(const Motion& motion, const State<Dual2>& state, double begin) {
    if (!(dot(state.velocity, state.velocity).a > 0)) return;
    for (std::size_t i = 0; i < aim_points_.size(); ++i) {
      const Branch aim{request_, out_.route, aim_points_[i]};
      if (near_ && !leads_near(aim.aim_point, state)) continue;
      const LockedArrival<Dual2> arrival = arrive_locked(motion, request_.problem->boundary.body, state,
                                                         aim.aim_point.at, aim.aim_point.capture(), request_.stop);
      work_ += arrival.work;
      Dual2 r[2] = {Dual2(0), Dual2(0)};
      if (!(request_.one_unknown() ? residuals_of<1>(aim, arrival, r) : residuals_of<2>(aim, arrival, r))) continue;
      const Vec2<Dual2> off = to<Dual2>(aim.aim_point.at) - arrival.state.at;
      const double ahead = dot(arrival.heading, off).a / norm(arrival.heading).a;
      if (!request_.stop && !arrival.at_rest &&
          ahead < -settings::discover::behind * request_.problem->boundary.diagonal)
        continue;
      const Vec2d heading = value(arrival.heading);
      const double time = begin + arrival.time.a;
      out_.passages.push_back({out_.route.size(), i, request_.one_unknown() ? linear<1>(r, time) : linear<2>(r, time),
                               heading / norm(heading)});
    }
  }

  /// Returns whether the line of travel leads into a mouth, for some aim within `near_` of this one.
  bool leads_near(const AimPoint& aim_point, const State<Dual2>& state) const {
    const Vec2<Dual2> off = to<Dual2>(aim_point.at) - state.at, u = state.velocity / norm(state.velocity);
    const Dual2 lateral = cross(u, off);
    const double room = 2 * aim_point.reach + settings::discover::bends * norm(off).a + *near_ * std::abs(lateral.v[0]);
    return std::abs(lateral.a) < room && dot(u, off).a > -room;
  }

  const SearchRequest& request_;
  std::span<const AimPoint> aim_points_;
  std::optional<double> near_;  ///< rad; range of aims that may lead into a mouth through jaws; none: jaws end the path
  Work& work_;
  Discovery& out_;
  int bounces_ = 0;
};

void follow(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch,
            std::span<const AimPoint> aim_points, std::optional<double> near, bool locked, Discovery& out) {
  out.route.clear();
  out.places.clear();
  out.passages.clear();
  out.rests = false;
  if (budget.spent()) return;
  with_physics(request.problem->rough, [&](const auto& motion, const auto& cushion) {
    Follower follower(request, aim_points, near, budget.work(), out);
    const auto start = dual_start<Dual2, 2>(request, launch, request.spin);
    locked ? follower.along_route(motion, cushion, start) : follower.freely(motion, cushion, start);
  });
  budget.charge(out.route.size());
}

}  // namespace

void discover(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, bool locked,
              Discovery& out) {
  follow(request, budget, launch, request.problem->aim_points, {}, request.route && locked, out);
}

void discover_through_jaws(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, double near,
                           std::span<const AimPoint> mouths, Discovery& out) {
  follow(request, budget, launch, mouths, near, false, out);
}

}  // namespace bankshot::planning
