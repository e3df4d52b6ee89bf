// SPDX-License-Identifier: MIT
#include "bankshot/simulate/trajectory.hpp"

#include <algorithm>
#include <climits>
#include <span>

#include "bankshot/geometry/boundary.hpp"
#include "bankshot/motion/launched.hpp"
#include "bankshot/simulate/each.hpp"
#include "bankshot/simulate/simulator.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "sim/scene/validate_launch.hpp"
#include "sim/simulate/path_length.hpp"
#include "sim/simulate/record_many.hpp"

namespace bankshot {
namespace {

template <class Motion, class Cushion>
class Recorder {
 public:
  /// `out` must be empty; its capacity is reused.
  Recorder(const ShotRequest& r, const Boundary& boundary, const Motion& motion, const Cushion& cushion,
           Trajectory& out)
      : r_(r), motion_(motion), sim_(boundary, motion, cushion, start_state(r)), out_(out) {
    if (std::is_same_v<Motion, Ideal> && !r.until.time && !r.until.cushions && !r.until.length)
      cushions_ = ideal_cushions;
  }

  void run() {
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
  /// Returns the next event, or the limit of `until`. A ball at rest whose spin never ends has neither.
  Event next() {
    const double limit = r_.until.time ? std::max(0.0, *r_.until.time - sim_.time()) : forever;
    stopped_ = r_.until.time.has_value();
    return r_.until.length ? step_to_length(*r_.until.length, limit) : step(limit);
  }

  Event step_to_length(double most, double limit) {
    const auto before = sim_;
    const std::size_t legs = out_.legs.size();
    const double length_before = out_.length;
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

  void finish(EventKind end) {
    out_.end = end;
    note(EventKind::end);
  }

  const ShotRequest& r_;
  Motion motion_;
  Simulator<double, Motion, Cushion> sim_;
  std::optional<int> cushions_ = r_.until.cushions;
  bool stopped_ = false;  ///< `until` stopped the ball
  Trajectory& out_;
};

}  // namespace

Trajectory simulate(const ShotRequest& request) {
  validate(request);
  if (!request.others.empty()) return record_many(request);
  const Boundary boundary(request.table, request.ball.body);
  Trajectory out;
  with_physics(request.physics, [&](const auto& motion, const auto& cushion) {
    Recorder(request, boundary, motion, cushion, out).run();
  });
  return out;
}

namespace {

bool can_be(const Stroke& stroke) {
  try {
    validate(stroke.launch, stroke.spin);
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

}  // namespace

void simulate_each(ShotRequest scene, std::span<const Stroke> strokes,
                   const std::function<void(std::size_t, const Trajectory*)>& see) {
  scene.launch = {1, 0}, scene.spin = {};
  validate(scene);
  const Boundary boundary(scene.table, scene.ball.body);
  Trajectory out;
  with_physics(scene.physics, [&](const auto& motion, const auto& cushion) {
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      scene.launch = strokes[i].launch, scene.spin = strokes[i].spin;
      const bool can = can_be(strokes[i]);
      if (can && scene.others.empty()) {
        out.events.clear(), out.legs.clear();
        out.length = 0, out.cushions = 0;
        Recorder(scene, boundary, motion, cushion, out).run();
      } else if (can) {
        out = record_many(scene);
      }
      see(i, can ? &out : nullptr);
    }
  });
}

std::vector<Contact> Trajectory::sequence() const {
  std::vector<Contact> out;
  for (const Record& e : events)
    if (e.kind == EventKind::cushion && e.ball == events.front().ball) out.push_back(e.contact);
  return out;
}

Trajectory path_of(const Trajectory& t, int ball) {
  Trajectory own;
  for (const Record& e : t.events) {
    if (e.ball == ball)
      own.events.push_back(e);
    else if (e.kind == EventKind::ball && e.contact.index == ball)
      own.events.push_back({e.kind, e.time, e.other, Contact::ball(e.ball), ball, e.state});
  }
  for (const Leg& leg : t.legs)
    if (leg.ball == ball) {
      own.legs.push_back(leg);
      own.length += length(leg.arc, leg.duration);
    }
  const auto count = [&](EventKind kind) { return std::ranges::count(own.events, kind, &Record::kind); };
  own.cushions = static_cast<int>(count(EventKind::cushion));
  own.end = ball == 0 ? t.end : count(EventKind::pocket) > 0 ? EventKind::pocket : t.end;
  return own;
}

const Record& end_of(const Trajectory& t, int ball) {
  const auto ends = [&](const Record& e) { return e.kind == EventKind::end && e.ball == ball; };
  return *std::ranges::find_if(t.events, ends);
}

State<double> start_state(const ShotRequest& r) {
  return launched(r.ball.at, r.ball.body.radius, direction(r.launch.angle) * r.launch.speed, r.spin);
}

const Ball& ball_of(const ShotRequest& r, int ball) {
  return ball == 0 ? r.ball : r.others[static_cast<std::size_t>(ball) - 1];
}

State<double> state_at(const ShotRequest& r, const Leg& leg, double t) {
  return state_on(r, leg, leg.arc.parameter(t));
}

State<double> state_on(const ShotRequest& r, const Leg& leg, double parameter) {
  const Body& body = ball_of(r, leg.ball).body;
  return with_motion(r.physics, [&](const auto& motion) {
    State<double> s = advance(motion, body, leg.start, leg.arc, parameter);
    s.spin = motion.spin(body, s);
    return s;
  });
}

double energy(const Body& body, const State<double>& state) {
  const double v2 = dot(state.velocity, state.velocity);
  const Vec3<double> w{body.radius * state.spin.x, body.radius * state.spin.y, body.radius * state.spin.z};
  return body.mass * (v2 / 2 + (w.x * w.x + w.y * w.y + w.z * w.z) / 5);
}

double energy(const Physics& physics, const Body& body, const State<double>& state) {
  return energy(body, state) + body.mass * gravity(physics) * dot(physics.tilt, state.at);
}

}  // namespace bankshot
