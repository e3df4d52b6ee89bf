// SPDX-License-Identifier: MIT
#include "planners/locked/forward.hpp"

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/locked/arrival.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

using Dual2 = Dual<2>;

/// One path, and what it passes.
class Follower {
 public:
  Follower(const SearchRequest& request, std::span<const AimPoint> aim_points, Forward& out)
      : request_(request), aim_points_(aim_points), out_(out) {}

  template <class Motion, class Cushion>
  void along_route(const Motion& motion, const Cushion& cushion, const State<Dual2>& start) {
    out_.route = *request_.route;
    const auto path =
        follow_locked(request_.problem->boundary, motion, cushion, std::span<const Meeting>(out_.route), start);
    if (path.end == LockedEnd::complete) look(motion, path.state, path.time.a);
    out_.rests = path.end == LockedEnd::fell_short;
  }

  template <class Motion, class Cushion>
  void freely(const Motion& motion, const Cushion& cushion, const State<Dual2>& start) {
    const CushionRule& rule = request_.cushions();
    Simulator sim(request_.problem->alone(), motion, cushion, start);
    for (;;) {
      const std::size_t bounces = out_.route.size();
      if (static_cast<int>(bounces) >= rule.min && (!request_.route || out_.route == *request_.route))
        look(motion, sim.state(), sim.time().a);
      if (static_cast<int>(bounces) == rule.max) return;
      Event e = sim.step();
      while (e.kind == EventKind::slide_to_roll) e = sim.step();
      out_.rests = e.kind == EventKind::rest;
      if (e.kind != EventKind::cushion || sim.time().a > request_.latest) return;
      out_.route.push_back({0, e.contact});
      const Wall* const line = request_.problem->boundary.line(e.contact);
      const Dual2 along = line ? dot(line->along, sim.state().at) : Dual2(0);
      out_.places.push_back({along.a, along.v[0]});
      if (request_.route && out_.route.back() != (*request_.route)[bounces]) return;
    }
  }

  /// Past aims so near [rad].
  template <class Motion, class Cushion>
  void through_jaws(const Motion& motion, const Cushion& cushion, const State<Dual2>& start, double near) {
    near_ = near;
    Simulator sim(request_.problem->alone(), motion, cushion, start);
    for (int bounces = 0;;) {
      look(motion, sim.state(), sim.time().a);
      Event e = sim.step();
      while (e.kind == EventKind::slide_to_roll) e = sim.step();
      const bool bounce = e.kind == EventKind::cushion && bounces < request_.cushions().max;
      if (!(bounce || e.kind == EventKind::jaw) || sim.time().a > request_.latest) return;
      if (bounce && request_.route && e.contact != (*request_.route)[static_cast<std::size_t>(bounces)].with) return;
      out_.route.push_back({0, e.contact});
      bounces += bounce;
    }
  }

 private:
  /// Adds how a free leg that begins so misses each aim point.
  template <class Motion>
  void look(const Motion& motion, const State<Dual2>& state, double begin) {
    if (!(dot(state.velocity, state.velocity).a > 0)) return;
    for (std::size_t i = 0; i < aim_points_.size(); ++i) {
      const LockedAim aim{request_, out_.route, aim_points_[i]};
      if (near_ && !leads_near(aim.aim_point, state)) continue;
      const LockedArrival<Dual2> arrival = arrive_locked(motion, request_.problem->boundary.body, state,
                                                         aim.aim_point.at, aim.aim_point.capture(), request_.stop);
      Dual2 r[2] = {Dual2(0), Dual2(0)};
      if (!(request_.one_unknown() ? residuals_of<1>(aim, arrival, r) : residuals_of<2>(aim, arrival, r))) continue;
      const Vec2<Dual2> off = to<Dual2>(aim.aim_point.at) - arrival.state.at;
      const double ahead = dot(arrival.heading, off).a / norm(arrival.heading).a;
      if (!request_.stop && !arrival.at_rest &&
          ahead < -settings::forward::behind * request_.problem->boundary.diagonal)
        continue;
      const Vec2d heading = value(arrival.heading);
      const double time = begin + arrival.time.a;
      out_.passages.push_back({out_.route.size(), i, request_.one_unknown() ? linear<1>(r, time) : linear<2>(r, time),
                               heading / norm(heading)});
    }
  }

  /// The line of travel does, of some aim that is as near as asked.
  bool leads_near(const AimPoint& aim_point, const State<Dual2>& state) const {
    const Vec2<Dual2> off = to<Dual2>(aim_point.at) - state.at, u = state.velocity / norm(state.velocity);
    const Dual2 lateral = cross(u, off);
    const double room = 2 * aim_point.reach + settings::forward::bends * norm(off).a + *near_ * std::abs(lateral.v[0]);
    return std::abs(lateral.a) < room && dot(u, off).a > -room;
  }

  const SearchRequest& request_;
  std::span<const AimPoint> aim_points_;
  std::optional<double> near_{};
  Forward& out_;
};

/// `f(follower, motion, cushion, start)` of an answer that is empty yet.
template <class F>
void follow(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch,
            std::span<const AimPoint> aim_points, Forward& out, F&& f) {
  out.route.clear();
  out.places.clear();
  out.passages.clear();
  out.rests = false;
  if (budget.spent()) return;
  with_physics(request.problem->rough, [&](const auto& motion, const auto& cushion) {
    Follower follower(request, aim_points, out);
    f(follower, motion, cushion, dual_start<Dual2, 2>(request, launch));
  });
  budget.charge(out.route.size());
}

}  // namespace

void forward(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, bool locked, Forward& out) {
  follow(request, budget, launch, request.problem->aim_points, out,
         [&](auto& follower, const auto& motion, const auto& cushion, const State<Dual2>& start) {
           if (request.route && locked)
             follower.along_route(motion, cushion, start);
           else
             follower.freely(motion, cushion, start);
         });
}

void forward_through_jaws(const SearchRequest& request, EvaluationBudget& budget, const Launch& launch, double near,
                          std::span<const AimPoint> mouths, Forward& out) {
  follow(request, budget, launch, mouths, out,
         [near](auto& follower, const auto& motion, const auto& cushion, const State<Dual2>& start) {
           follower.through_jaws(motion, cushion, start, near);
         });
}

}  // namespace bankshot::planning
