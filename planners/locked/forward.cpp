// SPDX-License-Identifier: MIT
#include "planners/locked/forward.hpp"

#include "bankshot/numbers/dual.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "planners/locked/arrival.hpp"
#include "planners/settings.hpp"

namespace bankshot::planning {
namespace {

using Dual = bankshot::Dual<2>;

/// One path, and what it passes.
class Follower {
 public:
  Follower(const Question& q, Forward& out) : q_(q), out_(out) {}

  template <class Motion, class Cushion>
  void along_route(const Motion& motion, const Cushion& cushion, const State<Dual>& start) {
    out_.route = *q_.route;
    const auto path = follow_locked(q_.boundary, motion, cushion, std::span<const Meeting>(out_.route), start);
    if (path.end == LockedEnd::complete) look(motion, path.state);
    out_.rests = path.end == LockedEnd::fell_short;
  }

  template <class Motion, class Cushion>
  void freely(const Motion& motion, const Cushion& cushion, const State<Dual>& start) {
    const CushionRule& rule = q_.cushions();
    Simulator sim(q_.alone(), motion, cushion, start);
    for (;;) {
      const std::size_t bounces = out_.route.size();
      if (static_cast<int>(bounces) >= rule.min && (!q_.route || out_.route == *q_.route)) look(motion, sim.state());
      if (static_cast<int>(bounces) == rule.max) return;
      Event e = sim.step();
      while (e.kind == EventKind::slide_to_roll) e = sim.step();
      out_.rests = e.kind == EventKind::rest;
      if (e.kind != EventKind::cushion || sim.time().a > q_.latest) return;
      out_.route.push_back({0, e.contact});
      const Wall* const line = q_.boundary.line(e.contact);
      const Dual along = line ? dot(line->along, sim.state().at) : Dual(0);
      out_.places.push_back({along.a, along.v[0]});
      if (q_.route && out_.route.back() != (*q_.route)[bounces]) return;
    }
  }

 private:
  /// Adds how a free leg from `state` misses each mark.
  template <class Motion>
  void look(const Motion& motion, const State<Dual>& state) {
    if (!(dot(state.velocity, state.velocity).a > 0)) return;
    for (std::size_t i = 0; i < q_.marks.size(); ++i) {
      const LockedAim aim{q_, out_.route, q_.marks[i]};
      const LockedArrival<Dual> arrival =
          arrive_locked(motion, q_.boundary.body, state, aim.mark.at, aim.mark.capture(), q_.stop);
      Dual r[2] = {Dual(0), Dual(0)};
      if (!(q_.one_unknown() ? residuals_of<1>(aim, arrival, r) : residuals_of<2>(aim, arrival, r))) continue;
      const Vec2<Dual> off = to<Dual>(aim.mark.at) - arrival.state.at;
      const double ahead = dot(arrival.heading, off).a / norm(arrival.heading).a;
      if (!q_.stop && !arrival.at_rest && ahead < -settings::forward::behind * q_.boundary.diagonal) continue;
      out_.passages.push_back({out_.route.size(), i, q_.one_unknown() ? linear<1>(r) : linear<2>(r)});
    }
  }

  const Question& q_;
  Forward& out_;
};

}  // namespace

void forward(const Question& q, Ledger& ledger, const Launch& launch, bool locked, Forward& out) {
  out.route.clear();
  out.places.clear();
  out.passages.clear();
  out.rests = false;
  if (ledger.spent()) return;
  with_physics(q.rough, [&](const auto& motion, const auto& cushion) {
    const State<Dual> start = dual_start<Dual, 2>(q, launch);
    Follower follower(q, out);
    if (q.route && locked)
      follower.along_route(motion, cushion, start);
    else
      follower.freely(motion, cushion, start);
  });
  ledger.charge(out.route.size());
}

}  // namespace bankshot::planning
