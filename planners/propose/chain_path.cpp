// SPDX-License-Identifier: MIT
#include "planners/propose/chain_path.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "bankshot/geometry/aim_point.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "planners/start.hpp"
#include "planners/trace/arrival.hpp"
#include "planners/trace/real_legs.hpp"

namespace bankshot::planning::propose {
namespace {

Pass pass_of(const Place& place, const Vec2d& u, const Vec2d& off) {
  const double left = place.aim_point ? beside_exact(*place.aim_point, u, off) : cross(u, off);
  return {left, dot(u, off) > -place.reach};
}

Fall fall_of(const Route& route, const Launch& launch, const AimPoint& aim_point, const State<double>& s) {
  const double speed = norm(s.velocity);
  return {route, launch, speed, -cross(s.velocity, aim_point.at - s.at) / speed, &aim_point};
}

}  // namespace

ChainPath::ChainPath(const SearchRequest& request, EvaluationBudget& budget, const Objects::Chain& chain)
    : request_(request), budget_(budget), chain_(chain) {
  for (const Objects::Object* ball : chain.balls) alone_.emplace_back(request.puzzle().table, ball->at_rest.body);
}

const CushionRule& ChainPath::rule(int n) const {
  return n == 0 || request_.problem->carom() ? request_.cushions()
                                             : request_.cushions_of(static_cast<std::size_t>(n) - 1);
}

Place ChainPath::next_of(int n) const {
  const Objects::Object& next = object(n + 1);
  return {next.at_rest.at, touching_distance(body(n), next.at_rest.body)};
}

bool ChainPath::is_on(int n, const std::vector<Contact>& met) const {
  const auto& asked = rule(n).sequence;
  return static_cast<int>(met.size()) <= rule(n).max &&
         (!asked || (met.size() <= asked->size() && std::equal(met.begin(), met.end(), asked->begin())));
}

Followed ChainPath::follow(int n, const Route& before, const Place& place, const Launch& launch) {
  Followed out;
  budget_.charge(before.size(), before.empty() ? 1 : 2);
  with_physics(request_.puzzle().physics, [&](const auto& motion, const auto& cushion) {
    const auto path = follow_locked(request_.problem->balls(), motion, cushion, before, start_of(request_, launch));
    budget_.work() += path.work;
    if (path.end != LockedEnd::complete || !(dot(path.state.velocity, path.state.velocity) > 0)) return;
    follow_on(motion, cushion, n, path.state, before, place, launch, out);
  });
  return out;
}

template <class Motion, class Cushion>
void ChainPath::follow_on(const Motion& motion, const Cushion& cushion, int n, const State<double>& sent,
                          const Route& before, const Place& place, const Launch& launch, Followed& out) const {
  Simulator sim(alone(n), motion, cushion, sent);
  Route route;  // cushions met, until there are too many of them or the ball falls or rests
  std::vector<Contact> met;
  if (n > 0 && request_.problem->carom()) met = contacts_of(before);
  const auto fell = [&](const State<double>& s) {
    if (norm(s.velocity) > 0) out.falls.push_back(fall_of(joined(before, route), launch, *place.aim_point, s));
  };
  double nearest = forever;  // m, on this leg
  Pass pass{0, false};
  State<double> passing = sent;
  const auto begins = [&] {
    nearest = forever, pass = {0, false}, passing = sent;
    return true;
  };
  const auto look = [&](const Arc<double>& arc, double travelled) {
    const double t = detail::closest_time(arc, travelled, place.at);
    const Vec2d off = place.at - arc.position(t), v = arc.velocity_at(t);
    if (!(norm(off) < nearest) || !(norm(v) > 0)) return;
    nearest = norm(off), pass = pass_of(place, v / norm(v), off);
    passing.at = arc.position(t), passing.velocity = v;
  };
  const auto ends = [&](const Event& e) {
    const bool counts = static_cast<int>(met.size()) >= least(n);
    if (counts && nearest < forever) out.passes.emplace(route, pass);
    if (counts && place.aim_point && e.kind == EventKind::pocket && e.contact == place.aim_point->taken_by)
      fell(sim.state());
    if (counts && place.aim_point && !place.aim_point->drops() && nearest < place.reach) fell(passing);
    if (e.kind != EventKind::cushion) return false;
    met.push_back(e.contact);
    if (!is_on(n, met)) return false;
    route.push_back({number(n), e.contact});
    return true;
  };
  each_leg(sim, budget_.work(), begins, ends, look);
}

std::optional<Pass> ChainPath::locked_pass(const Route& route, int n, const Place& place, const Launch& launch) {
  if (budget_.spent()) return {};
  budget_.charge(route.size());
  return with_physics(request_.puzzle().physics, [&](const auto& motion, const auto& cushion) -> std::optional<Pass> {
    const Destination to{body(n), place.at, place.aim_point ? place.aim_point->capture() : 0, false};
    const auto there = trace(request_.problem->balls(), motion, cushion, std::span<const Meeting>(route),
                             start_of(request_, launch), to, budget_.work());
    if (!there) return {};
    return pass_of(place, there->heading / norm(there->heading), place.at - there->state.at);
  });
}

std::optional<double> ChainPath::left_of(const Route& route, int n, const Place& place, const Launch& launch) {
  const auto pass = locked_pass(route, n, place, launch);
  return pass ? std::optional(pass->left) : std::nullopt;
}

Route joined(Route a, const Route& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace bankshot::planning::propose
