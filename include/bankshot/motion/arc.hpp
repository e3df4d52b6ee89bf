// SPDX-License-Identifier: MIT
//
// What a motion model hands to the event finder: between two events the centre moves on an arc
// of degree two in time. Models differ only in how they make the next arc.
//   r(p) = at + velocity p + acceleration p²/2,  0 <= p <= duration     [m, m/s, m/s², s]
// The parameter p is the time in seconds, unless the arc has a drag: then it is the time that the ball
// would need without slowing down, and `seconds` tells the time. Event finders see only p.
//
// A motion model is a value with
//   straight                     true when every arc is a straight line and its shape does not depend
//                                on the speed
//   arc(body, state)             the next arc
//   turn(body, state, arc, t)    what t seconds on that arc do to the spin
//   finish(body, state, arc)     makes the state exact where the arc ends by itself
//   roll(body, state)            makes the spin that of a ball that rolls
//   spin(body, state)            the spin of a state, also where the model does not carry it
//   follow(body, state, arc, t)  where its arcs are only chords of its paths (motion/tilted.hpp): the state on the path
//   held(body, state, n, corner) there, too: the arc of a ball that cushions hold
// It holds coefficients only; `body` is the ball's.
//
// A law that is no polynomial in time may hand over short pieces, each an arc of degree two that ends with
// PhaseEnd::piece, and states the error that they add: where two balls share a clock, and where a path has no
// closed form. Nothing happens where a piece ends.
#pragma once

#include <cstdint>
#include <limits>

#include "bankshot/detail/drag.hpp"
#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/body.hpp"

namespace bankshot {

/// A moving ball: centre [m], velocity [m/s], spin [rad/s] (carried by models that need it).
template <class T>
struct State {
  Vec2<T> at{}, velocity{};
  Vec3<T> spin{};
};

template <class T>
State<Real<T>> value(const State<T>& s) {
  return {value(s.at), value(s.velocity), {value(s.spin.x), value(s.spin.y), value(s.spin.z)}};
}

/// v² + (Rω)² of the part of the spin that moves the ball [m²/s²]: what speeds are small against.
template <class T>
Real<T> squared_scale(const State<T>& s, double radius) {
  const Vec2<Real<T>> v = value(s.velocity), w{value(s.spin.x), value(s.spin.y)};
  return dot(v, v) + Real<T>(radius) * radius * dot(w, w);
}

/// Longer than any shot: the duration of a motion that never ends by itself.
inline constexpr double forever = std::numeric_limits<double>::infinity();

/// What happens when an arc ends before it meets anything: it never does, the ball begins to roll, it stops, or it goes
/// on along the next piece of the same motion.
enum class PhaseEnd { none, roll, rest, piece };

/// Other balls push the ball all along the arc, on which it slides, or rolls though it bends (detail/pressed.hpp).
enum class Press : std::uint8_t { none, slides, rolls };

template <class T>
struct Arc {
  Vec2<T> at{}, velocity{}, acceleration{};
  T duration{};
  PhaseEnd end = PhaseEnd::none;
  bool bends = false;  ///< the acceleration need not be along the velocity
  Press pressed = Press::none;
  bool chord = false;  ///< of a path that is no parabola: `follow` of the motion knows that
  Drag<T> drag{};
  Vec2<T> taken{};  ///< m/s²: friction that a cushion, or other balls, take from the centre, and that turns the ball
                    ///< all the same

  /// The ball still moves where the arc ends.
  bool goes_on() const { return end == PhaseEnd::roll || end == PhaseEnd::piece; }

  /// At a parameter with or without derivatives.
  template <class S>
  Vec2<T> position(const S& p) const {
    return at + (velocity + acceleration * S(p * 0.5)) * p;
  }
  /// dr/dp
  template <class S>
  Vec2<T> tangent(const S& p) const {
    return velocity + acceleration * p;
  }
  /// dr/dt
  Vec2<T> velocity_at(const T& p) const { return drag.none() ? tangent(p) : slowed_velocity(p); }
  /// The time at p.
  T seconds(const T& p) const { return drag.none() ? p : slowed_seconds(p); }
  /// The p at a time, which may be beyond the arc's end.
  T parameter(const T& t) const { return drag.none() ? t : slowed_parameter(t); }

 private:
  // Out of line: rare, and long enough to keep the common case from being inlined.
  [[gnu::noinline]] Vec2<T> slowed_velocity(const T& p) const {
    const T v0 = norm(velocity);
    return velocity * (drag.speed_after(v0, T(p * v0)) / v0);
  }
  [[gnu::noinline]] T slowed_seconds(const T& p) const {
    const T v0 = norm(velocity);
    // At its end the ball rests: a speed found from the length would be the root of a rounding.
    if (end == PhaseEnd::rest && !(value(p) < value(duration))) return drag.seconds(v0, T(0));
    return drag.seconds(v0, drag.speed_after(v0, T(p * v0)));
  }
  [[gnu::noinline]] T slowed_parameter(const T& t) const {
    if (!(value(t) < value(slowed_seconds(duration)))) return t;
    const T v0 = norm(velocity);
    return drag.length_in(v0, t) / v0;
  }
};

/// The arc without derivatives: itself where it has none.
template <class T>
decltype(auto) value(const Arc<T>& a) {
  if constexpr (has_derivatives<T>)
    return Arc<Real<T>>{value(a.at),
                        value(a.velocity),
                        value(a.acceleration),
                        value(a.duration),
                        a.end,
                        a.bends,
                        a.pressed,
                        a.chord,
                        {value(a.drag.constant), value(a.drag.linear)},
                        value(a.taken)};
  else
    return (a);
}

/// For those who only ask where paths lead.
struct Unwatched {
  template <class... A>
  void operator()(const A&...) const {}
};

/// Arcs of the motion may be chords of its paths.
template <class Motion>
inline constexpr bool has_chords = requires {
  Motion::plain;
};

/// The state at t on the arc that `motion` made of `s`.
template <class T, class Motion>
State<T> advance(const Motion& motion, const Body& body, const State<T>& s, const Arc<T>& arc, const T& t) {
  if constexpr (has_chords<Motion>)
    if (arc.chord) return motion.follow(body, s, arc, t);
  State<T> out{arc.position(t), arc.velocity_at(t), s.spin};
  motion.turn(body, out, arc, arc.seconds(t));
  return out;
}

/// Spin of a ball of radius R that rolls naturally with `velocity`: ẑ × v / R; 0 for a point.
template <class T>
Vec3<T> natural_roll(const Vec2<T>& velocity, double radius) {
  if (radius == 0) return {T(0), T(0), T(0)};
  return {-velocity.y / Real<T>(radius), velocity.x / Real<T>(radius), T(0)};
}

}  // namespace bankshot
