// SPDX-License-Identifier: MIT
#include "bankshot/simulate/trajectory.hpp"

#include <algorithm>
#include <climits>
#include <span>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/simulate/simulator.hpp"

namespace bankshot {
namespace {

/// Metres that a ball covers in t seconds of an arc: ∫|v + a t| dt, split along and across a; written so that nothing
/// cancels where a is small.
double length(const Arc<double>& arc, double t) {
  const double a = norm(arc.acceleration);
  if (!arc.bends || a == 0) return norm(arc.position(t) - arc.at);
  const double across = std::abs(cross(arc.acceleration, arc.velocity)) / a, across2 = across * across,
               begin = dot(arc.acceleration, arc.velocity) / a, end = begin + a * t, slow = std::hypot(begin, across),
               fast = std::hypot(end, across);
  if (!(slow + fast > 0)) return 0;
  const double part = begin * ((begin + end) / (slow + fast));
  const double turned = across2 > 0 ? across2 / a * std::asinh(a * t * (slow - part) / across2) : 0;
  return (t * (fast + part) + turned) / 2;
}

/// When a ball on this arc has covered `metres`; forever, where that lies beyond the arc's end.
double time_to_length(const Arc<double>& arc, double duration, double metres) {
  double low = 0, high = duration;
  if (!(length(arc, high) > metres)) return forever;
  if (!arc.bends) return arc.seconds(time_at_length(arc, metres));
  for (double t = low + (high - low) / 2; t > low && t < high; t = low + (high - low) / 2)
    (length(arc, t) < metres ? low : high) = t;
  return high;
}

/// The same from the first of these legs on.
double time_to_length(std::span<const Leg> legs, double metres) {
  for (const Leg& leg : legs) {
    const double t = time_to_length(leg.arc, leg.duration, metres);
    if (t < forever) return leg.begin - legs.front().begin + t;
    metres -= length(leg.arc, leg.duration);
  }
  return forever;
}

template <class Motion, class Cushion>
class Recorder {
 public:
  Recorder(const ShotRequest& r, const Motion& motion, const Cushion& cushion)
      : r_(r), boundary_(r.table, r.ball.body), motion_(motion), sim_(boundary_, motion, cushion, start_state(r)) {
    if (std::is_same_v<Motion, Ideal> && !r.until.time && !r.until.cushions && !r.until.length)
      cushions_ = ideal_cushions;
  }

  Trajectory run() {
    note(EventKind::start);
    if (r_.launch.speed == 0) return finish(EventKind::rest);
    for (long events = 0; events < max_events; ++events) {
      const Event e = next();
      if (e.kind == EventKind::horizon) return finish(stopped_ ? EventKind::horizon : EventKind::rest);
      note(e.kind, e.contact);
      if (e.final()) return finish(e.kind);
      if (e.kind == EventKind::cushion && ++out_.cushions >= cushions_.value_or(INT_MAX))
        return finish(EventKind::horizon);
    }
    return finish(EventKind::end);
  }

 private:
  /// The next event, or what `until` stops the ball at. A ball that stands though its spin never ends has neither.
  Event next() {
    const auto before = sim_;
    const std::size_t legs = out_.legs.size();
    const double length_before = out_.length, most = r_.until.length.value_or(forever),
                 limit = r_.until.time ? std::max(0.0, *r_.until.time - sim_.time()) : forever;
    stopped_ = r_.until.time.has_value();
    const Event e = step(limit);
    if (!(out_.length > most)) return e;
    const double horizon = time_to_length(std::span(out_.legs).subspan(legs), std::max(0.0, most - length_before));
    stopped_ = true;
    sim_ = before;
    out_.legs.resize(legs);
    out_.length = length_before;
    return step(std::min(limit, horizon));
  }

  Event step(double horizon) {
    double begin = sim_.time();
    const auto leg = [&](const Arc<double>& arc, double parameter) {
      if (!(parameter > 0)) return;
      out_.legs.push_back({begin, parameter, arc, sim_.before()});
      out_.length += length(arc, parameter);
      begin += arc.seconds(parameter);
    };
    const Event e = sim_.step(horizon, leg);
    leg(sim_.arc(), sim_.travelled());
    return e;
  }

  void note(EventKind kind, Contact contact = {}) {
    State<double> now = sim_.state();
    now.spin = motion_.spin(r_.ball.body, now);
    out_.events.push_back({kind, sim_.time(), now, contact});
  }

  Trajectory finish(EventKind end) {
    out_.end = end;
    note(EventKind::end);
    return std::move(out_);
  }

  const ShotRequest& r_;
  Boundary boundary_;
  Motion motion_;
  Simulator<double, Motion, Cushion> sim_;
  std::optional<int> cushions_ = r_.until.cushions;
  bool stopped_ = false;  ///< `until` stopped the ball
  Trajectory out_{};
};

}  // namespace

Trajectory simulate(const ShotRequest& request) {
  validate(request);
  return with_physics(request.physics, [&](const auto& motion, const auto& cushion) {
    return Recorder(request, motion, cushion).run();
  });
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
  const Vec3<double> w{body.radius * state.spin.x, body.radius * state.spin.y, body.radius * state.spin.z};
  return body.mass * (v2 / 2 + (w.x * w.x + w.y * w.y + w.z * w.z) / 5);
}

}  // namespace bankshot
