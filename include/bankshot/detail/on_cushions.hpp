// SPDX-License-Identifier: MIT
//
// The contacts that the centre is exactly on, and those of them that hold it. There are two at most, in a corner.
// Properties, numbered as in simulator.hpp:
//  4. A bounce puts the centre exactly on the cushion's line, and the gap to a cushion just left is exactly 0. The same
//     bounce is therefore never found twice.
//  5. A ball at a cushion, with hardly any speed away from it, is held there if friction drives it in. Its normal
//     motion stops. Its tangential motion and its slip go on until the acceleration points away (held.hpp). This is
//     not a bounce; it ends the endless bouncing of a ball that returns slower each time. A ball that starts within
//     Boundary::touch of a cushion is put on its line. A ball slower than tolerance::still of its launch after a bounce
//     rests. A round tip holds it only if friction could take it round. Limitation: the ball then goes on along the
//     tangent all the same, as it does at a reflex vertex.
#pragma once

#include <cmath>
#include <utility>

#include "bankshot/detail/held.hpp"
#include "bankshot/geometry/boundary.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot::detail {

/// Decides on numbers N without derivatives; the states that it moves may have some.
template <class N>
class OnCushions {
 public:
  /// `launch2` is the squared_scale of the launch.
  explicit OnCushions(const N& launch2)
      : bounced2_(launch2),
        resting2_(launch2 * (tolerance::resting * tolerance::resting)),
        still2_(launch2 * (tolerance::still * tolerance::still)) {}

  /// Returns true if the centre is exactly on the contact.
  bool on(Contact contact) const { return contact == on_[0] || contact == on_[1]; }
  bool on_rail() const { return on_[0].kind == ContactKind::rail || on_[1].kind == ContactKind::rail; }
  /// Returns true if the contact holds the ball because friction drives it in.
  bool held(Contact contact) const { return contact == held_[0] || contact == held_[1]; }

  /// Returns the first (0) or second (1) contact that the centre is on, or none.
  Contact at(int k) const { return on_[k]; }
  /// Makes a contact hold the ball, because other balls press the ball against it. The centre must be on it.
  void hold(Contact contact) { held_[contact == on_[0] ? 0 : 1] = contact; }

  /// Releases a ball at `at` from the contacts that other balls push it away from.
  void let_go(const Boundary& boundary, const Vec2<N>& at, const Vec2<N>& push) {
    for (Contact& c : held_) {
      if (!c) continue;
      const N away = dot(boundary.normal(c, at), push);
      if (away > N(0) && away * away > dot(push, push) * (tolerance::along * tolerance::along)) c = {};
    }
  }

  /// Returns true if some contact holds the ball.
  bool any_holds() const { return held_[0] || held_[1]; }

  /// Records that a ball of this squared_scale is about to bounce.
  void bounces(const N& scale2) { bounced2_ = scale2; }

  /// Returns true if a squared speed is no more than the rounding of the last bounce.
  bool is_rounding(const N& speed2) const { return speed2 < bounced2_ * (tolerance::along * tolerance::along); }

  /// Returns true if a ball of this squared_scale rests after a bounce.
  bool is_still(const N& scale2) const { return scale2 < still2_; }

  /// Forgets the contacts that do not hold the ball, because it has moved.
  void leave() {
    on_[0] = held_[0];
    on_[1] = held_[1];
    if (!on_[0]) std::swap(on_[0], on_[1]);  // a single contact comes first
  }

  /// Records that the centre is on the contact.
  void meet(Contact contact) {
    if (contact != on_[0]) on_[1] = std::exchange(on_[0], contact);
  }

  /// Puts the centre exactly on the contact.
  template <class T>
  void settle(const Boundary& boundary, Contact contact, Vec2<T>& at) {
    if (const Wall* const w = boundary.line(contact)) {
      const T gap = dot(w->normal, at) - N(w->offset);
      at -= {gap * w->normal.x, gap * w->normal.y};
    }
    meet(contact);
  }

  /// Puts a ball that starts against a cushion exactly on its line, so that the gap is 0.
  template <class T>
  void settle_at_start(const Boundary& boundary, Vec2<T>& centre) {
    using std::abs;
    const N near(boundary.touch);
    const Vec2<N> at = value(centre);
    int found = 0;
    const auto try_wall = [&](const Wall& w) {
      if (found == 2 || !(abs(dot(w.normal, at) - N(w.offset)) <= near)) return;
      const N s = dot(w.along, at);
      if (!(s >= w.begin - near && s <= w.end + near)) return;
      if (w.contact.kind == ContactKind::rail && boundary.break_at(w, static_cast<double>(s)) >= 0) return;
      settle(boundary, w.contact, centre);
      ++found;
    };
    for (const Wall& w : boundary.walls) try_wall(w);
    for (const JawWalls& jaws : boundary.jaws)
      if (jaws.faced)
        for (const Wall& w : jaws.facings) try_wall(w);
  }

  /// Removes the normal motion from the arc of a ball that stays at a cushion because friction drives it in. Between
  /// two cushions, one may hold the ball while it leaves the other along the first. If both hold it, it stays in place.
  template <class T>
  void hold(const Boundary& boundary, Arc<T>& arc) {
    held_[0] = held_[1] = {};
    if (!on_[0]) return;
    const Arc<N>& plain = value(arc);
    const Contact corner = corner_to_crawl_in(boundary, plain);
    const Contact at[] = {on_[0], corner ? corner : on_[1]};
    const auto is_slow = [&](Contact contact) {
      return (corner || rests_at(boundary, contact, plain)) && !is_past_end(boundary, contact, plain.at);
    };
    const bool slow[] = {is_slow(at[0]), is_slow(at[1])};
    if (!slow[0] && !slow[1]) return;
    const Vec2<N> a = plain.acceleration;
    bool pressed = false;
    for (int k = 0; k < 2; ++k) {
      if (!slow[k]) continue;
      const Vec2<N> n = boundary.normal(at[k], plain.at);
      const N into = dot(n, a) + curved_away(boundary, at[k], plain);
      if (!brings_back(into, dot(n, plain.velocity), plain.duration)) continue;
      pressed = true;
      const Vec2<N> along = a - n * dot(n, a);
      if (slow[1 - k] && dot(boundary.normal(at[1 - k], plain.at), along) < 0) continue;
      held_[k] = on_[k] = at[k];
      stop_along(n, arc.velocity);
      hold_slip(arc, n);
      return;
    }
    if (!pressed) return;
    for (int k = 0; k < 2; ++k) held_[k] = on_[k] = at[k];
    hold_slip_in_corner(arc);
  }

 private:
  /// Returns true if the ball has passed, or is just passing, the end of a rail at a pocket's jaws.
  static bool is_past_end(const Boundary& boundary, Contact contact, const Vec2<N>& at) {
    if (contact.kind != ContactKind::rail || boundary.jaws.empty()) return false;
    const Wall& w = *boundary.line(contact);
    const double along = static_cast<double>(dot(w.along, at));
    return boundary.break_at(w, along - boundary.touch) >= 0 || boundary.break_at(w, along + boundary.touch) >= 0;
  }

  /// Returns true if the arc ends with a speed towards the cushion. Otherwise the ball is not pressed against it: the
  /// normal part of an acceleration along the cushion is only rounding and decides nothing. A ball that rolls away ends
  /// with speed 0, up to rounding. The factor 1.01 tells the two cases apart.
  static bool brings_back(const N& acceleration, const N& speed, const N& duration) {
    using std::abs;
    return acceleration < 0 && -acceleration * duration > 1.01 * abs(speed);
  }

  /// Returns the other cushion of a corner in which the ball hardly moves, else none. Friction into the corner and spin
  /// at the cushions might otherwise feed the same tiny bounces between them forever.
  Contact corner_to_crawl_in(const Boundary& boundary, const Arc<N>& arc) const {
    using std::abs;
    constexpr double more = tolerance::crawling / tolerance::resting;
    if (dot(arc.velocity, arc.velocity) > resting2_ * (more * more) || !boundary.line(on_[0])) return {};
    for (const Wall& w : boundary.walls)
      if (w.contact != on_[0] && abs(N(dot(w.normal, arc.at) - N(w.offset))) <= N(boundary.touch) &&
          boundary.break_at(w, static_cast<double>(dot(w.along, arc.at))) < 0)
        return w.contact;
    return {};
  }

  /// Returns true if the ball has hardly any speed towards or away from this contact.
  bool rests_at(const Boundary& boundary, Contact contact, const Arc<N>& arc) const {
    if (!contact) return false;
    const N speed = dot(boundary.normal(contact, arc.at), arc.velocity);
    return speed * speed <= resting2_;
  }

  /// Returns the acceleration [m/s²] with which a round contact recedes from a ball that goes on along its tangent.
  static N curved_away(const Boundary& boundary, Contact contact, const Arc<N>& arc) {
    const Circle* const rim = boundary.line(contact) ? nullptr : boundary.rim(contact);
    return rim && rim->radius > 0 ? N(dot(arc.velocity, arc.velocity) / N(rim->radius)) : N(0);
  }

  template <class T>
  static void stop_along(const Vec2<N>& n, Vec2<T>& v) {
    const T part = dot(n, v);
    v -= {part * n.x, part * n.y};
  }

  // Squares of speeds [m²/s²]:
  N bounced2_;       ///< scale before the last bounce, which sets its rounding
  N resting2_;       ///< a ball that leaves a cushion slower than this may be held
  N still2_;         ///< a ball slower than this after a bounce rests
  Contact on_[2];    ///< contacts the centre is exactly on
  Contact held_[2];  ///< contacts among them that friction drives it into
};

}  // namespace bankshot::detail
