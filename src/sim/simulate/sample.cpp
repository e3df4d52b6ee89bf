// SPDX-License-Identifier: MIT
#include <cstddef>
#include <vector>

#include "bankshot/simulate/trajectory.hpp"
#include "bankshot/simulate/with_physics.hpp"

namespace bankshot {
namespace {

using See = std::function<void(double, int, const State<double>&)>;

/// The positions of all balls over time.
class Positions {
 public:
  Positions(const ShotRequest& r, const Trajectory& t) : r_(r), balls_(r.others.size() + 1) {
    for (const Leg& leg : t.legs) of(leg.ball).legs.push_back(&leg);
  }

  void saw(const Record& e) {
    saw(e.ball, e.time, e.state);
    if (e.kind == EventKind::ball) saw(e.contact.index, e.time, e.other);
    if (e.kind == EventKind::pocket) of(e.ball).in_play = false;
  }

  /// Reports the balls in play that have no event at exactly this time.
  void at(double time, const See& see) {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      Ball& b = balls_[i];
      if (!b.in_play || b.time == time) continue;
      while (b.leg + 1 < b.legs.size() && b.legs[b.leg + 1]->begin <= time) ++b.leg;
      see(time, static_cast<int>(i), state(static_cast<int>(i), b, time));
    }
  }

 private:
  struct Ball {
    std::vector<const Leg*> legs{};
    std::size_t leg = 0;
    double time = 0;  ///< s; time of its last event
    State<double> state{};
    bool in_play = true;
  };

  Ball& of(int ball) { return balls_[static_cast<std::size_t>(ball)]; }
  void saw(int ball, double time, const State<double>& state) {
    of(ball).time = time;
    of(ball).state = state;
  }

  State<double> state(int ball, const Ball& b, double time) const {
    if (b.leg < b.legs.size()) {
      const Leg& leg = *b.legs[b.leg];
      if (leg.begin <= time && time < leg.begin + leg.arc.seconds(leg.duration))
        return state_at(r_, leg, time - leg.begin);
    }
    State<double> s = b.state;  // the ball is at rest, and its vertical spin fades
    std::visit(
        [&](const auto& motion) {
          const Body& body = ball_of(r_, ball).body;
          motion.turn(body, s, motion.arc(body, s), time - b.time);
        },
        r_.physics.motion);
    return s;
  }

  const ShotRequest& r_;
  std::vector<Ball> balls_;
};

}  // namespace

void sample(const ShotRequest& r, const Trajectory& t, double rate, const See& see) {
  Positions positions(r, t);
  auto event = t.events.begin();
  const auto events_until = [&](double time) {
    for (; event != t.events.end() && event->time <= time; ++event) {
      see(event->time, event->ball, event->state);
      if (event->kind == EventKind::ball) see(event->time, event->contact.index, event->other);
      positions.saw(*event);
    }
  };
  const double end = t.events.back().time;
  events_until(0);
  for (long number = 1; static_cast<double>(number) / rate < end; ++number) {
    const double time = static_cast<double>(number) / rate;
    events_until(time);
    positions.at(time, see);
  }
  events_until(forever);
}

}  // namespace bankshot
