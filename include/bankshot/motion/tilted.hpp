// SPDX-License-Identifier: MIT
//
// Sliding, rolling and spin on a cloth that rises by s metres per metre, along x and y. Gravity along the table, −g s,
// acts in full on a ball that slides and by 5/7 on one that rolls. With the slip u and its direction û,
//   sliding  v̇ = −μs g û − g s,   u̇ = −(7/2) μs g û − g s
//   rolling  v̇ = −μr(v) g v̂ − (5/7) g s
// The slip therefore turns, and a ball that rolls curves. A ball rolls if (2/7)|s| <= μs, else it slides forever. It
// rests if (5/7)|s| <= μr, else it starts downhill. Both laws have one form (detail/incline.hpp).
// Method: an arc is a chord, the parabola through both ends of a piece of the path with the velocity where the piece
// begins. It is never farther than tolerance::chord from the path. Events are found on the chord. Their time and state
// are then found on the path itself (`follow`), to a few units in the last place.
// Limitation: events closer to each other than the chord is to the path may come in the wrong order. A cushion grazed
// by less than that may be missed.
// A ball that is held by a cushion, or pushed by other balls, moves by short pieces (detail/held.hpp, pressed.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "bankshot/detail/incline.hpp"
#include "bankshot/motion/slide_roll.hpp"

namespace bankshot {

template <class C>
struct TiltedOf : SlideRollOf<C> {
  using Level = SlideRollOf<C>;

  Vec2<C> rise{};             ///< s, not 0
  bool always_rolls = false;  ///< rolls from the start, as in Rolling: the ball carries no spin

  static constexpr bool straight = false;
  static constexpr bool plain = !has_derivatives<C>;  ///< true if coefficients have no derivatives

  template <class T>
  Arc<T> arc(const Body& body, const State<T>& s) const {
    using N = Real<T>;
    const Phase<T> phase = phase_of(body, s);
    if (phase.stands) return {s.at, {T(0), T(0)}, {T(0), T(0)}, T(0), PhaseEnd::rest};
    Arc<T> out{s.at, s.velocity};
    out.bends = true;
    if (!phase.slides) out.pressed = Press::rolls;
    const Piece piece = piece_of(body, phase);
    if (piece.even) {  // downhill from a halt
      const Vec2<T> pull = phase.downhill(phase.law.pull - phase.law.friction);
      out.acceleration = pull * T(phase.share) + phase.weight;
      out.duration = T(value(phase.law.drag) == N(0) ? N(forever) : N(tolerance::first_piece));
      if (out.duration < T(forever)) out.end = PhaseEnd::piece;
      return with_friction(out, phase);
    }
    Vec2<T> beyond;
    if (piece.last) {
      const detail::Stop<T> stop = detail::stop_on(phase.law, phase.w);
      out.duration = stop.time;
      beyond = stop.beyond;
      out.end = phase.slides ? PhaseEnd::roll : phase.stays ? PhaseEnd::rest : PhaseEnd::piece;
    } else {
      const detail::Glide<T, K<T>> glide(phase.law, phase.w, N(piece.step));
      out.duration = glide.time(T(1));
      beyond = glide.beyond(T(1));
      out.end = PhaseEnd::piece;
    }
    out.chord = true;
    out.acceleration = beyond * T(phase.share * N(2) / (out.duration * out.duration)) + phase.weight;
    return with_friction(out, phase);
  }

  /// Returns the state t seconds along the path of which the arc from `s` is a chord.
  template <class T>
  State<T> follow(const Body& body, const State<T>& s, const Arc<T>& arc, const T& t) const {
    using N = Real<T>;
    const Phase<T> phase = phase_of(body, s);
    const Piece piece = piece_of(body, phase);
    const bool whole = value(t) == value(arc.duration);
    Vec2<T> w = phase.w, beyond{T(0), T(0)};
    if (piece.last && whole) {
      beyond = detail::stop_on(phase.law, w).beyond;
      w = {T(0), T(0)};
    } else {
      const detail::Glide<T, K<T>> glide(phase.law, w, N(piece.step));
      const T covered = glide.time(T(1));
      if (piece.last && value(t) > value(covered)) {
        // Beyond the series: all that is left now, less what is left then.
        const detail::Stop<T> stop = detail::stop_on(phase.law, w);
        const T left = stop.time - t;
        w = detail::before_stop(phase.law, w, left);
        beyond = stop.beyond + (phase.w - w) * left - detail::stop_on(phase.law, w).beyond;
      } else {
        const T here = whole ? T(1) : glide.at(t);
        beyond = glide.beyond(here);
        w = glide.velocity(here);
      }
    }
    State<T> out = s;
    out.at += s.velocity * t + beyond * T(phase.share) + phase.weight * T(t * t * N(0.5));
    out.velocity += (w - phase.w) * T(phase.share) + phase.weight * t;
    if (always_rolls) return out;
    if (phase.slides) {
      const N R(body.radius);
      out.spin.x = (w.y - out.velocity.y) / R;
      out.spin.y = (out.velocity.x - w.x) / R;
    } else {
      Level::roll(body, out);
    }
    Level::fade(body, out, t);
    return out;
  }

  /// Returns the arc of a ball held by the cushion with this normal, a unit vector into the table. `corner`: two hold
  /// it.
  template <class T>
  Arc<T> held(const Body& body, const State<T>& s, const Vec2<Real<T>>& n, bool corner) const {
    using N = Real<T>;
    using std::abs;
    const Phase<T> phase = phase_of(body, s);
    const Vec2<T> along = to<T>(perpendicular(n));
    Arc<T> out{s.at, corner ? Vec2<T>{T(0), T(0)} : along * dot(along, s.velocity)};
    out.bends = true;
    const Vec2<T> weight = phase.slides ? full_weight<T>() : phase.downhill(phase.law.pull);
    const T pull = corner ? T(0) : T(dot(along, weight));
    if (phase.slides) {
      // û turns while the slip fades, so this is a piece with its present direction (detail/held.hpp).
      const T size = norm(phase.w), friction = sliding_deceleration<T>();
      const Vec2<T> unit = direction(phase);
      const T part = corner ? T(0) : T(dot(along, unit));
      const T fades = friction * (part * part * N(3.5) + (T(1) - part * part) * N(2.5)) + pull * part;
      out.acceleration = corner ? Vec2<T>{T(0), T(0)} : along * T(pull - friction * part);
      out.taken = unit * T(-friction) - out.acceleration;
      const T lasts = value(fades) > N(0) ? T(size / fades) : T(forever);
      const bool ends = corner || !(value(lasts) > N(tolerance::last_piece));
      out.end = ends && value(lasts) < N(forever) ? PhaseEnd::roll : PhaseEnd::piece;
      out.duration = ends ? lasts : T(lasts * N(0.5));
      if (!ends && !(value(out.duration) < N(tolerance::longest_piece))) out.duration = T(N(tolerance::longest_piece));
      return out;
    }
    out.pressed = Press::rolls;
    const T v = corner ? T(0) : T(dot(along, s.velocity));
    const T friction = T(phase.law.friction + phase.law.drag * N(abs(value(v))));
    const bool stands = value(v) == N(0);
    const bool pulled = abs(value(pull)) > abs(value(friction));
    if (stands && !pulled) {
      out.velocity = {T(0), T(0)};
      out.end = PhaseEnd::rest;
      out.duration = T(0);
      return out;
    }
    const bool forward = stands ? value(pull) > N(0) : value(v) > N(0);
    const T slope = forward ? T(pull - friction) : T(pull + friction);
    out.acceleration = along * slope;
    const bool brakes = !stands && (value(slope) > N(0)) != (value(v) > N(0));
    out.duration = brakes ? T(-v / slope) : T(forever);
    out.end = !brakes ? PhaseEnd::none : pulled ? PhaseEnd::piece : PhaseEnd::rest;
    if (value(phase.law.drag) > N(0) && !(value(out.duration) < N(tolerance::longest_piece))) {
      out.duration = T(N(tolerance::longest_piece));
      out.end = PhaseEnd::piece;
    }
    return out;
  }

  template <class T>
  void turn(const Body& body, State<T>& s, const Arc<T>& arc, const T& t) const {
    if (always_rolls) return;
    if (arc.pressed != Press::rolls) return Level::turn(body, s, arc, t);
    Level::roll(body, s);
    Level::fade(body, s, t);
  }

  template <class T>
  void finish(const Body& body, State<T>& s, const Arc<T>& arc) const {
    if (arc.end == PhaseEnd::rest) s.velocity = {T(0), T(0)};
    if (always_rolls || arc.end == PhaseEnd::piece) return;
    if (arc.chord)
      Level::roll(body, s);
    else
      Level::finish(body, s, arc);
  }

  template <class T>
  void roll(const Body& body, State<T>& s) const {
    if (!always_rolls) Level::roll(body, s);
  }
  template <class T>
  Vec3<T> spin(const Body& body, const State<T>& s) const {
    return always_rolls ? natural_roll(s.velocity, body.radius) : s.spin;
  }

 private:
  template <class T>
  using K = Coefficient<T, C>;

  /// Present phase of a ball. w is its slip, or its velocity if it rolls. v changes by `share` of the change of w, and
  /// by the acceleration `weight`.
  template <class T>
  struct Phase {
    detail::Incline<K<T>> law;
    Vec2<T> w;
    Real<T> share;
    Vec2<T> weight;
    bool slides, stays, stands;  ///< `stays`: once w = 0, the ball would rest or roll

    Vec2<T> downhill(const K<T>& size) const { return {T(law.down.x * size), T(law.down.y * size)}; }
  };

  template <class T>
  Vec2<T> full_weight() const {
    const Real<T> weight(Level::g);
    return {T(-K<T>(rise.x) * weight), T(-K<T>(rise.y) * weight)};
  }

  template <class T>
  Phase<T> phase_of(const Body& body, const State<T>& s) const {
    using N = Real<T>;
    using std::sqrt;
    const N weight(Level::g), seven(7);
    const K<T> x(rise.x), y(rise.y), slope = sqrt(K<T>(x * x + y * y));
    const Vec2<K<T>> down{-x / slope, -y / slope};
    const K<T> pull = slope * weight;
    if (!always_rolls) {
      const Vec2<T> u = Level::slip(body, s);
      constexpr double still = tolerance::slip * tolerance::slip;
      const bool slips = value(dot(u, u)) > still * squared_scale(s, body.radius);
      const K<T> friction = K<T>(Level::sliding_friction) * N(3.5) * weight;
      const bool stays = !(value(friction) < value(pull));
      if (slips || !stays) {
        const N part = N(5) / seven;
        return {{friction, K<T>(N(0)), pull, down}, u, N(2) / seven, full_weight<T>() * T(part), true, stays, false};
      }
    }
    const K<T> friction = K<T>(Level::rolling_friction.at_rest) * weight,
               drag = K<T>(Level::rolling_friction.per_speed) * weight;
    const K<T> rolls = pull * N(N(5) / seven);
    const bool stays = !(value(friction) < value(rolls));
    const bool halts = !(value(dot(s.velocity, s.velocity)) > N(tolerance::halt * tolerance::halt));
    const Vec2<T> velocity = halts ? Vec2<T>{T(0), T(0)} : s.velocity;
    return {{friction, drag, rolls, down}, velocity, N(1), {T(0), T(0)}, false, stays, halts && stays};
  }

  /// Piece of a path: a step of its series, all that is left, or an even acceleration.
  struct Piece {
    double step = 0;
    bool last = false, even = false;
  };

  /// Returns the direction of w, or downhill if w is 0.
  template <class T>
  static Vec2<T> direction(const Phase<T>& phase) {
    const T size = norm(phase.w);
    return value(size) > Real<T>(0) ? phase.w / size : phase.downhill(K<T>(Real<T>(1)));
  }
  template <class T>
  T sliding_deceleration() const {
    return T(K<T>(Level::sliding_friction) * Real<T>(Level::g));
  }

  /// Sets `taken` so that the acceleration and `taken` add up to the friction of the slip, which the spin feels.
  template <class T>
  Arc<T> with_friction(Arc<T> arc, const Phase<T>& phase) const {
    if (!phase.slides) return arc;
    arc.taken = direction(phase) * T(-sliding_deceleration<T>()) - arc.acceleration;
    return arc;
  }

  /// Returns half of the least σ in which w can change by its own size.
  template <class L, class W>
  static double shortest_step(const L& law, const W& w) {
    const auto number = [](const auto& v) { return static_cast<double>(value(v)); };
    const double q = std::hypot(number(w.x), number(w.y));
    return 0.5 / (number(law.friction) + number(law.pull) + number(law.drag) * q);
  }

  template <class T>
  Piece piece_of(const Body& body, const Phase<T>& phase) const {
    const auto number = [](const auto& v) { return static_cast<double>(value(v)); };
    const detail::Incline<K<T>>& law = phase.law;
    const double m = number(law.friction), a = number(law.pull), b = number(law.drag);
    const double across = number(cross(value(law.down), value(phase.w)));
    const double along = number(dot(value(law.down), value(phase.w)));
    const double q = std::hypot(along, across), share = number(phase.share);
    Piece piece;
    if (!(q > 0)) return {.even = true};
    const double half = shortest_step(law, value(phase.w)), sine = std::abs(across) / q;
    piece.step = half;
    const double fast = std::max(1.0, q / tolerance::fast_chord), beyond = fast * fast;  // a planner may try any speed
    const double size = body.radius > 0 ? body.radius : Body{}.radius;
    const double fine = tolerance::chord * size * beyond * beyond;
    const double epsilon = static_cast<double>(std::numeric_limits<Real<T>>::epsilon());
    const double turns = sine == 0 ? 0 : along < 0 ? 1 : sine;
    const bool stops = m > a || (sine == 0 && along < 0);
    if (stops) {
      const double lasts = along < 0 && !(m > a) ? q / (m + a) : (m * q + a * along) / ((m - a) * (m + a));
      const double off = m > a ? share * turns * a / m * q * lasts / 8 : 0;
      // The closed form has no drag. Its effect on the distance left must be less than rounding.
      if (off <= fine && b * lasts <= std::sqrt(epsilon) && b * lasts * share * q * lasts <= epsilon * size) {
        piece.last = true;
        return piece;
      }
    }
    const double jerk = share * (m * a * std::max(sine, least_sine) / q + b * (m + a + b * q));
    if (jerk > 0) piece.step = std::min(half, std::cbrt(40 * fine / jerk) / q);
    return piece;
  }

  /// Least sine for the error of a chord, since a path that is nearly straight may turn sooner than it looks.
  static constexpr double least_sine = 0.02;
};
using Tilted = TiltedOf<double>;

}  // namespace bankshot
