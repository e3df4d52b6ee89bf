// SPDX-License-Identifier: MIT
#include "support/flight.hpp"

#include <algorithm>
#include <cmath>

#include "bankshot/motion/launched.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "support/drop.hpp"

namespace bankshot::test {
namespace {

constexpr std::uint64_t first_route = 1469598103934665603ULL, prime = 1099511628211ULL;  // FNV-1a

std::uint64_t add(std::uint64_t route, Contact c) {
  return (route ^ (static_cast<std::uint64_t>(c.kind) * 64 + static_cast<std::uint64_t>(c.index + 1))) * prime;
}

/// Returns the parameter at which an arc comes abreast of a point; negative when it does not.
double abreast(const Arc<double>& arc, double end, const Vec2d& at) {
  // A straight arc keeps its direction to its end, where the computed tangent of a ball that stops is only rounding.
  const auto ahead = [&](double p) { return dot(arc.bends ? arc.tangent(p) : arc.velocity, at - arc.position(p)); };
  double low = 0, high = end, f_low = ahead(low), f_high = ahead(high);
  if (!(f_low > 0) || f_high > 0) return -1;
  constexpr int steps = 60;
  for (int i = 0; i < steps && high - low > 1e-16 * end; ++i) {
    double p = low - f_low * (high - low) / (f_high - f_low);
    if (!(p > low && p < high) || i % 3 == 2) p = (low + high) / 2;
    const double f = ahead(p);
    if (f == 0) return p;
    (f > 0 ? low : high) = p;
    (f > 0 ? f_low : f_high) = f;
  }
  return (low + high) / 2;
}

/// Returns true when the rule allows this cushion as the next bounce.
bool in_order(const CushionRule& rule, int bounces, Contact c) {
  return !rule.sequence || (*rule.sequence)[static_cast<std::size_t>(bounces)] == c;
}

template <class Sim>
double side_of(const Boundary& boundary, const Sim& sim, Contact pocket) {
  const Vec2d v = sim.arc().velocity + sim.arc().acceleration * sim.travelled();
  return left_of_drop(boundary, pocket, sim.state().at, norm(v) > 0 ? v : sim.arc().velocity);
}

/// Follows a flight. `on_leg` is called after each arc, `on_end` at rest or in a pocket; `on_leg` may end the flight. A
/// jaw ends it too, unless jaws are `passed`.
enum class AtJaws { end, passed };
template <class OnLeg, class OnEnd>
void follow(const Aimed& a, const Launch& launch, const LaunchSpin& spin, OnLeg&& on_leg, OnEnd&& on_end, AtJaws jaws,
            std::vector<Contact>* contacts) {
  const CushionRule& rule = a.puzzle.cushions;
  with_physics(a.puzzle.physics, [&](const auto& motion, const auto& cushion) {
    Simulator sim(a.boundary, motion, cushion,
                  launched(a.puzzle.ball.at, a.puzzle.ball.body.radius, direction(launch.angle) * launch.speed, spin));
    std::uint64_t route = first_route;
    for (int bounces = 0;;) {
      const double before = sim.time();
      const Event e = sim.step();
      if (bounces >= rule.min && on_leg(sim, bounces, route, before)) return;
      if (e.kind == EventKind::rest || e.kind == EventKind::pocket) {
        if (bounces >= rule.min) on_end(sim, e, bounces, e.kind == EventKind::pocket ? add(route, e.contact) : route);
        return;
      }
      if (e.kind == EventKind::slide_to_roll || (e.kind == EventKind::jaw && jaws == AtJaws::passed)) continue;
      if (e.kind != EventKind::cushion || bounces == rule.max || !in_order(rule, bounces, e.contact)) return;
      route = add(route, e.contact);
      if (contacts) contacts->push_back(e.contact);
      ++bounces;
    }
  });
}

}  // namespace

Aimed::Aimed(const Puzzle& p) : puzzle(p), boundary(p.table, p.ball.body) {
  const auto arrival = arrival_range(p);
  const auto* point = std::get_if<PointTarget>(&p.target);
  falls = !point;
  stops = point && arrival && arrival->high == 0;
  if (point) at = point->at;
  if (!point) pocket = std::get<PocketTarget>(p.target).pocket.value_or(-1);
}

Flight fly(const Aimed& a, const Launch& launch, const LaunchSpin& spin, double arrival,
           std::vector<Contact>* contacts) {
  Flight out;
  const int most_bounces = a.puzzle.cushions.max;
  const auto keep = [&](const Pass& pass) {
    if (out.count < Flight::most) out.passes[static_cast<std::size_t>(out.count++)] = pass;
  };
  double last_speed = 0;
  bool ended = false;
  const auto on_leg = [&](const auto& sim, int bounces, std::uint64_t route, double before) {
    const Arc<double>& arc = sim.arc();
    last_speed = bounces == most_bounces ? norm(arc.velocity_at(sim.travelled())) : 0;
    if (a.falls || a.stops) return false;
    const double p = abreast(arc, sim.travelled(), a.at);
    if (p < 0) return false;
    const Vec2d line = arc.tangent(p);
    keep({bounces, route, norm(arc.velocity_at(p)), cross(line / norm(line), a.at - arc.position(p)),
          before + arc.seconds(p)});
    return false;
  };
  const auto on_end = [&](const auto& sim, const Event& e, int bounces, std::uint64_t route) {
    ended = true;
    if (a.falls && e.kind == EventKind::pocket && (a.pocket < 0 || a.pocket == e.contact.index)) {
      keep({bounces, route, norm(sim.state().velocity), side_of(a.boundary, sim, e.contact), sim.time()});
    } else if (a.stops && e.kind == EventKind::rest) {
      const Vec2d line = sim.arc().velocity / norm(sim.arc().velocity), off = a.at - sim.state().at;
      keep({bounces, route, -dot(line, off), cross(line, off), sim.time()});
    }
  };
  follow(a, launch, spin, on_leg, on_end, AtJaws::end, contacts);
  constexpr double spare = 1.5;  // topspin may speed the ball up once more
  out.too_fast = !ended && last_speed > spare * arrival;
  return out;
}

bool makes(const Aimed& a, const Launch& launch, const LaunchSpin& spin) {
  if (!(launch.speed > 0)) return false;
  const double within = a.falls ? 0 : std::get<PointTarget>(a.puzzle.target).within;
  bool made = false;
  const auto on_leg = [&](const auto& sim, int, std::uint64_t, double) {
    if (a.falls || a.stops) return false;
    const Arc<double>& arc = sim.arc();
    const double p = abreast(arc, sim.travelled(), a.at);
    const auto near = [&](double q) { return norm(arc.position(q) - a.at) <= within; };
    return made = near(0) || near(sim.travelled()) || (p >= 0 && near(p));
  };
  const auto on_end = [&](const auto& sim, const Event& e, int, std::uint64_t) {
    if (a.falls) made = e.kind == EventKind::pocket && (a.pocket < 0 || a.pocket == e.contact.index);
    if (a.stops) made = e.kind == EventKind::rest && norm(sim.state().at - a.at) <= within;
  };
  follow(a, launch, spin, on_leg, on_end, AtJaws::passed, nullptr);
  return made;
}

}  // namespace bankshot::test
