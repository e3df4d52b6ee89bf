// SPDX-License-Identifier: MIT
#include "bankshot/simulate/trajectory.hpp"

#include <algorithm>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/simulator.hpp"

namespace bankshot {
namespace {

/// Metres that a ball covers in t seconds of an arc: ∫|v + a t| dt, split along and across a.
double length(const Arc<double>& arc, double t) {
  if (!arc.bends) return norm(arc.position(t) - arc.at);
  const double a = norm(arc.acceleration);
  const double across = std::abs(cross(arc.acceleration, arc.velocity)) / a,
               along = dot(arc.acceleration, arc.velocity) / a;
  const auto antiderivative = [&](double w) {
    return w * std::hypot(w, across) + (across > 0 ? across * across * std::asinh(w / across) : 0.0);
  };
  return (antiderivative(along + a * t) - antiderivative(along)) / (2 * a);
}

/// When a ball on this arc has covered `metres`; may lie beyond the arc's end.
double time_to_length(const Arc<double>& arc, double metres) {
  if (!arc.bends) return time_at_length(arc, metres);
  double low = 0, high = arc.duration;
  if (!(length(arc, high) > metres)) return forever;
  for (double t = low + (high - low) / 2; t > low && t < high; t = low + (high - low) / 2)
    (length(arc, t) < metres ? low : high) = t;
  return high;
}

/// How many seconds the ball may go on before `until` stops it.
double remaining(const ShotRequest::Until& until, double time, double length, const Arc<double>& next) {
  double t = forever;
  if (until.time) t = std::min(t, std::max(0.0, *until.time - time));
  if (until.length) t = std::min(t, next.seconds(time_to_length(next, std::max(0.0, *until.length - length))));
  return t;
}

template <class Motion, class Cushion>
Trajectory record(const ShotRequest& r, const Motion& motion, const Cushion& cushion) {
  const Boundary boundary(r.table, r.ball.body);
  const State<double> start = start_state(r);
  ShotRequest::Until until = r.until;
  if (std::is_same_v<Motion, Ideal> && !until.time && !until.cushions && !until.length) until.cushions = ideal_cushions;

  Trajectory out;
  Simulator sim(boundary, motion, cushion, start);
  const auto note = [&](EventKind kind, Contact contact = {}) {
    State<double> now = sim.state();
    now.spin = motion.spin(r.ball.body, now);
    out.events.push_back({kind, sim.time(), now, contact});
  };
  const auto finish = [&](EventKind end) {
    out.end = end;
    note(EventKind::end);
    return out;
  };
  note(EventKind::start);
  if (r.launch.speed == 0) return finish(EventKind::rest);
  for (long events = 0; events < max_events; ++events) {
    double begin = sim.time();
    const auto leg = [&](const Arc<double>& arc, double parameter) {
      if (!(parameter > 0)) return;
      out.legs.push_back({begin, parameter, arc, sim.before()});
      out.length += length(arc, parameter);
      begin += arc.seconds(parameter);
    };
    const Event e = sim.step(remaining(until, begin, out.length, motion.arc(r.ball.body, sim.state())), leg);
    leg(sim.arc(), sim.travelled());
    switch (e.kind) {
      case EventKind::cushion:
        note(EventKind::cushion, e.contact);
        ++out.cushions;
        if (until.cushions && out.cushions >= *until.cushions) return finish(EventKind::horizon);
        break;
      case EventKind::horizon:
        return finish(EventKind::horizon);
      default:
        note(e.kind, e.contact);
        if (e.final()) return finish(e.kind);
    }
  }
  return finish(EventKind::end);
}

}  // namespace

Trajectory simulate(const ShotRequest& request) {
  validate(request);
  return with_physics(request.physics,
                      [&](const auto& motion, const auto& cushion) { return record(request, motion, cushion); });
}

std::vector<Contact> Trajectory::sequence() const {
  std::vector<Contact> out;
  for (const Record& e : events)
    if (e.kind == EventKind::cushion) out.push_back(e.contact);
  return out;
}

State<double> start_state(const ShotRequest& r) {
  return launched(r.ball.at, r.ball.body.radius, direction(r.launch.angle) * r.launch.speed, r.spin);
}

State<double> state_at(const ShotRequest& r, const Leg& leg, double t) {
  return std::visit(
      [&](const auto& motion) {
        State<double> s = advance(motion, r.ball.body, leg.start, leg.arc, leg.arc.parameter(t));
        s.spin = motion.spin(r.ball.body, s);
        return s;
      },
      r.physics.motion);
}

double energy(const Body& body, const State<double>& state) {
  const double v2 = dot(state.velocity, state.velocity);
  const Vec3<double>& w = state.spin;
  return body.mass * (v2 / 2 + body.radius * body.radius * (w.x * w.x + w.y * w.y + w.z * w.z) / 5);
}

}  // namespace bankshot
