// SPDX-License-Identifier: MIT
#include "sim/simulate/record_many.hpp"

#include <algorithm>
#include <climits>
#include <iterator>

#include "bankshot/simulate/many_balls.hpp"
#include "bankshot/simulate/with_physics.hpp"
#include "sim/simulate/path_length.hpp"

namespace bankshot {
namespace {

template <class Motion, class Cushion>
class Recorder {
 public:
  /// `most` is the duration of the simulation [s].
  Recorder(const ShotRequest& r, const Motion& motion, const Cushion& cushion, double most)
      : r_(r), most_(most), starts_(r), motion_(motion), sim_(starts_.balls(), motion, cushion, collisions(r.physics)) {
    if (std::is_same_v<Motion, Ideal> && !r.until.time && !r.until.cushions && !r.until.length)
      cushions_ = ideal_cushions;
  }

  /// Records the shot until the cue ball's path is longer than `metres`.
  Trajectory run(double metres) {
    for (int ball = 0; ball < sim_.count(); ++ball) note(EventKind::start, ball);
    if (r_.launch.speed == 0) return finish(EventKind::rest);
    for (long events = 0; events < max_events; ++events) {
      if (!any_moves()) return finish(EventKind::rest);
      if (out_.length > metres) return finish(EventKind::horizon);
      const BallEvent e = sim_.step(most_ - sim_.time(), keeper());
      if (e.event.kind == EventKind::horizon) return finish(most_ < forever ? EventKind::horizon : EventKind::rest);
      note(e.event.kind, e.ball, e.event.contact);
      if (e.event.kind == EventKind::pocket) note(EventKind::end, e.ball);
      if (e.ball == 0 && e.event.kind == EventKind::cushion && ++out_.cushions >= cushions_.value_or(INT_MAX))
        return finish(EventKind::horizon);
    }
    return finish(EventKind::end);
  }

 private:
  bool any_moves() const {
    for (int ball = 0; ball < sim_.count(); ++ball)
      if (sim_.moves(ball)) return true;
    return false;
  }

  auto keeper() {
    return [this](int ball, double begin, const State<double>& start, const Arc<double>& arc, double parameter) {
      if (!(parameter > 0)) return;
      out_.legs.push_back({begin, parameter, arc, start, ball});
      if (ball == 0) out_.length += length(arc, parameter);
    };
  }

  State<double> with_spin(int ball, State<double> state) const {
    state.spin = motion_.spin(sim_.body(ball), state);
    return state;
  }

  void note(EventKind kind, int ball, Contact contact = {}) {
    Record record{kind, sim_.time(), with_spin(ball, sim_.state(ball)), contact, ball};
    if (kind == EventKind::ball) record.other = with_spin(contact.index, sim_.state(contact.index));
    out_.events.push_back(record);
  }

  Trajectory finish(EventKind end) {
    sim_.stop(keeper());
    out_.end = end == EventKind::rest && !sim_.in_play(0) ? EventKind::pocket : end;
    for (int ball = 0; ball < sim_.count(); ++ball)
      if (sim_.in_play(ball)) note(EventKind::end, ball);
    return std::move(out_);
  }

  const ShotRequest& r_;
  double most_;
  Starts starts_;
  Motion motion_;
  ManyBalls<double, Motion, Cushion> sim_;
  std::optional<int> cushions_ = r_.until.cushions;
  Trajectory out_{};
};

Trajectory record(const ShotRequest& request, double most, double metres) {
  return with_physics(request.physics, [&](const auto& motion, const auto& cushion) {
    return Recorder(request, motion, cushion, most).run(metres);
  });
}

/// Returns the time at which the cue ball has covered `metres`.
double time_to_length(const Trajectory& t, double metres) {
  std::vector<Leg> struck;
  std::ranges::copy_if(t.legs, std::back_inserter(struck), [](const Leg& leg) { return leg.ball == 0; });
  return struck.empty() ? forever : time_to_length(std::span<const Leg>(struck), metres);
}

}  // namespace

Starts::Starts(const ShotRequest& r) {
  const auto add = [&](const Ball& ball, const State<double>& state) {
    const auto same = std::ranges::find(boundaries_, ball.body, &Boundary::body);
    const Boundary& boundary = same != boundaries_.end() ? *same : boundaries_.emplace_back(r.table, ball.body);
    balls_.push_back({&boundary, state, static_cast<int>(balls_.size())});
  };
  add(r.ball, start_state(r));
  for (const Ball& other : r.others) add(other, {.at = other.at});
}

Trajectory record_many(const ShotRequest& request) {
  const double most = request.until.time.value_or(forever);
  const double metres = request.until.length.value_or(forever);
  Trajectory t = record(request, most, metres);
  if (!(metres < forever)) return t;
  const double then = time_to_length(t, metres);
  return then < most ? record(request, then, forever) : t;
}

}  // namespace bankshot
