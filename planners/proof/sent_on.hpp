// SPDX-License-Identifier: MIT
//
// From the contact on: the ball that the struck one has touched, on its way to the target, and the struck one, which
// must not touch it again. Only these two move; whatever else stands is an obstacle to both.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "bankshot/simulate/many_balls.hpp"
#include "planners/proof/goal.hpp"
#include "planners/proof/line_of_travel.hpp"
#include "planners/proof/sequence_check.hpp"

namespace bankshot::planning {

template <class Motion, class Cushion>
class SentOn {
 public:
  /// `out` gets what it comes to.
  SentOn(const Question& q, const Motion& motion, const Cushion& cushion, const Objects::Object& object,
         const Goal& goal, Replay& out)
      : q_(q),
        motion_(motion),
        cushion_(cushion),
        object_(object),
        asked_(goal.of_sent(q)),
        check_(asked_.sequence),
        out_(out) {}

  /// `struck` touches the ball, `begin` seconds after the launch.
  void run(const State<double>& struck, double begin) {
    const std::array<BallStart<double>, 2> balls{
        {{&object_.struck, struck, 0}, {&object_.own, {.at = object_.at_rest.at}, object_.ball}}};
    ManyBalls sim(std::span<const BallStart<double>>(balls), motion_, cushion_, collisions(q_.puzzle.physics));
    begin_ = begin;
    out_.then = Onward{object_.ball, {}};
    for (;;) {
      bool arrived = false;
      const BallEvent e = sim.step(
          forever, [&](int ball, double began, const State<double>&, const Arc<double>& arc, double travelled) {
            if (ball == sent_ball && touched_) arrived = arrived || passes(began, arc, travelled);
          });
      // One that still comes nearer when its slide, or a piece of it, ends is closest on the next arc.
      if (near_end_ && e.ball == sent_ball && e.event.kind != EventKind::slide_to_roll) arrived = out_.made = true;
      if (arrived || over(e, sim)) return;
    }
  }

 private:
  static constexpr int sent_ball = 1;  ///< of the two; 0 is the struck one

  template <class Sim>
  bool over(const BallEvent& e, const Sim& sim) {
    switch (e.event.kind) {
      case EventKind::ball:
        if (touched_ || e.event.contact != Contact::ball(object_.ball)) return fail(Foul::hit_ball, e.event.contact);
        touched_ = true;
        return false;
      case EventKind::cushion:
        return e.ball == sent_ball && bounces(e.event, sim);
      case EventKind::jaw:
        if (e.ball == sent_ball) rattle(e.event.contact, sim);
        return false;
      case EventKind::pocket:
        return e.ball == sent_ball && falls(e.event.contact, sim);
      case EventKind::rest:
        return e.ball == sent_ball && rests(sim);
      case EventKind::horizon:
        return fail(Foul::fell_short);
      default:
        return false;
    }
  }

  bool counts() const { return bounces_ >= asked_.min && !check_.open(); }

  template <class Sim>
  bool bounces(const Event& e, const Sim& sim) {
    last_ = sim.state(sent_ball).at;
    if (sim.time() == 0) return false;  // against a cushion that it touches, in the instant in which it is hit
    if (bounces_ == asked_.max) return fail(Foul::extra_cushion, e.contact);
    if (!check_.accepts(bounces_, e)) return fail(Foul::wrong_cushion, e.contact);
    ++bounces_;
    out_.then->cushions.push_back(e.contact);
    return false;
  }

  /// An arc of the ball that was sent on: closest to a point, and whether it is made there.
  bool passes(double began, const Arc<double>& arc, double travelled) {
    last_ = arc.position(travelled);
    incoming_ = {last_, arc.velocity_at(travelled)};
    if (q_.stop || !counts()) return false;
    for (const Mark& mark : q_.marks) {
      if (mark.captures() || mark.ball != object_.ball) continue;
      const double t = closest_time(arc, travelled, mark.at);
      const Vec2d at = arc.position(t);
      const double miss = norm(at - mark.at);
      if (miss < out_.miss) {
        out_.miss = miss;
        out_.arrival = {begin_ + began + arc.seconds(t), norm(arc.velocity_at(t)), at};
      }
      near_end_ = miss <= mark.reach && !(t < travelled);
      if (miss <= mark.reach && t < travelled) return out_.made = true;
    }
    return false;
  }

  template <class Sim>
  bool falls(Contact pocket, const Sim& sim) {
    const State<double>& now = sim.state(sent_ball);
    const Mark* const mark = counts() ? q_.mark_taken_by(pocket, now.at, object_.ball) : nullptr;
    if (!mark) return fail(Foul::pocketed, pocket);
    out_.made = true;
    out_.arrival = {begin_ + sim.time(), norm(now.velocity), now.at};
    measure(q_, *mark, jaw_ ? *jaw_ : norm(now.velocity) > 0 ? Line{now.at, now.velocity} : incoming_, out_);
    return true;
  }

  template <class Sim>
  void rattle(Contact jaw, const Sim& sim) {
    const auto of_jaws = [&](const Mark& mark) { return mark.taken_by == Contact::pocket(jaw.jaw_pocket()); };
    if (!jaw_ && std::ranges::any_of(q_.marks, of_jaws)) jaw_ = Line{sim.state(sent_ball).at, incoming_.heading};
    out_.rattles = true;
  }

  template <class Sim>
  bool rests(const Sim& sim) {
    const Vec2d at = sim.state(sent_ball).at;
    if (!q_.stop || !counts()) return fail(Foul::fell_short);
    const Mark& mark = q_.nearest_mark(at, object_.ball);
    out_.miss = norm(at - mark.at);
    out_.arrival = {begin_ + sim.time(), 0, at};
    out_.made = out_.miss <= mark.reach;
    if (!out_.made) out_.failure = {Foul::missed};
    return true;
  }

  bool fail(Foul foul, Contact contact = {}) {
    if (!(out_.miss < std::numeric_limits<double>::infinity())) {
      out_.miss = norm(last_ - q_.nearest_mark(last_, object_.ball).at);
      out_.arrival = {begin_, 0, last_};
    }
    out_.failure = {foul, contact};
    return true;
  }

  const Question& q_;
  const Motion& motion_;
  const Cushion& cushion_;
  const Objects::Object& object_;
  const Goal::Bounces asked_;
  SequenceCheck check_;
  Replay& out_;
  double begin_ = 0;
  bool touched_ = false;
  bool near_end_ = false;  ///< a point was near where an arc ended
  int bounces_ = 0;
  Vec2d last_ = object_.at_rest.at;
  Line incoming_{};
  std::optional<Line> jaw_{};
};

}  // namespace bankshot::planning
