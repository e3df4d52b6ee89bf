// SPDX-License-Identifier: MIT
#include "bankshot/simulate/trajectory.hpp"

#include <algorithm>

#include "bankshot/scene/boundary.hpp"
#include "bankshot/simulate/simulator.hpp"

namespace bankshot {
namespace {

/// How many seconds the ball may go on before `until` stops it.
double remaining(const ShotRequest::Until& until, double time, double length,
                 const Arc<double>& next) {
  double t = forever;
  if (until.time) t = std::min(t, std::max(0.0, *until.time - time));
  if (until.length) t = std::min(t, time_at_length(next, std::max(0.0, *until.length - length)));
  return t;
}

template <class Motion, class Cushion>
Trajectory record(const ShotRequest& r, const Motion& motion, const Cushion& cushion) {
  const Boundary boundary(r.table, r.ball.radius);
  const State<double> start{r.ball.at, direction(r.launch.angle) * r.launch.speed};
  ShotRequest::Until until = r.until;
  if (Motion::phase_end == PhaseEnd::none && !until.time && !until.cushions && !until.length)
    until.cushions = ideal_cushions;

  Trajectory out;
  out.events.push_back({Record::Kind::start, 0, start});
  Simulator sim(boundary, motion, cushion, start);
  const auto finish = [&](Trajectory::End end) {
    out.end = end;
    out.events.push_back({Record::Kind::end, sim.time(), sim.state()});
    return out;
  };
  if (r.launch.speed == 0) return finish(Trajectory::End::rest);
  for (long events = 0; events < max_events; ++events) {
    const double begin = sim.time();
    const Event e = sim.step(remaining(until, begin, out.length, motion.arc(sim.state())));
    if (sim.travelled() > 0) {
      out.legs.push_back({begin, sim.travelled(), sim.arc()});
      out.length += norm(sim.arc().position(sim.travelled()) - sim.arc().at);
    }
    switch (e.kind) {
      case EventKind::cushion:
        out.events.push_back({Record::Kind::cushion, sim.time(), sim.state(), e.index});
        ++out.cushions;
        if (until.cushions && out.cushions >= *until.cushions)
          return finish(Trajectory::End::until);
        break;
      case EventKind::pocket:
        out.events.push_back({Record::Kind::pocket, sim.time(), sim.state(), e.index});
        return finish(Trajectory::End::pocketed);
      case EventKind::rest:
        out.events.push_back({Record::Kind::roll_to_rest, sim.time(), sim.state()});
        return finish(Trajectory::End::rest);
      case EventKind::horizon:
        return finish(Trajectory::End::until);
    }
  }
  return finish(Trajectory::End::events);
}

}  // namespace

Trajectory simulate(const ShotRequest& request) {
  validate(request);
  return with_physics(request.physics, [&](const auto& motion, const auto& cushion) {
    return record(request, motion, cushion);
  });
}

std::vector<int> Trajectory::sequence() const {
  std::vector<int> out;
  for (const Record& e : events)
    if (e.kind == Record::Kind::cushion) out.push_back(e.index);
  return out;
}

Spin natural_roll(const Vec2d& velocity, double radius) {
  if (radius == 0) return {0, 0, 0};
  return {-velocity.y / radius, velocity.x / radius, 0};
}

double energy(const Ball& ball, const Vec2d& velocity) {
  const double v2 = dot(velocity, velocity);
  const Spin w = natural_roll(velocity, ball.radius);
  return ball.mass * (v2 / 2 + ball.radius * ball.radius * (w.x * w.x + w.y * w.y + w.z * w.z) / 5);
}

}  // namespace bankshot
