// SPDX-License-Identifier: MIT
//
// The arcs that a motion model hands to the event finder. Between two events the centre moves on an arc of degree two
// in time. Models differ only in how they make the next arc.
//   r(p) = at + velocity p + acceleration p²/2,  0 <= p <= duration     [m, m/s, m/s², s]
// The parameter p is the time in seconds, unless the arc has a drag. Then it is the time that the ball would need
// without slowing down, and `seconds` gives the time. Event finders see only p.
//
// A motion model is a value with
//   straight                     true if every arc is a straight line whose shape does not depend on the speed
//   arc(body, state)             returns the next arc
//   turn(body, state, arc, t)    changes the spin by t seconds on that arc
//   finish(body, state, arc)     makes the state exact where the arc ends by itself
//   roll(body, state)            makes the spin that of a ball that rolls
//   spin(body, state)            returns the spin of a state, even if the model does not carry it
// and, if its arcs are only chords of its paths (motion/tilted.hpp),
//   follow(body, state, arc, t)  returns the state on the path
//   held(body, state, n, corner) returns the arc of a ball that cushions hold
// It holds coefficients only; `body` is the ball's.
//
// A law that is no polynomial in time may hand over short pieces. Each is an arc of degree two that ends with
// PhaseEnd::piece, and the law states the error that they add. Pieces serve balls in persistent contact, and paths
// without a closed form. Nothing happens where a piece ends.
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

/// Converts a state to another scalar.
template <class T, class U>
State<T> to(const State<U>& s) {
  return {to<T>(s.at), to<T>(s.velocity), {T(s.spin.x), T(s.spin.y), T(s.spin.z)}};
}

/// Returns v² + (Rω)², with the part of the spin that moves the ball [m²/s²]. It is the scale for speeds that count as
/// small.
template <class T>
Real<T> squared_scale(const State<T>& s, double radius) {
  const Vec2<Real<T>> v = value(s.velocity), w{value(s.spin.x), value(s.spin.y)};
  return dot(v, v) + Real<T>(radius) * radius * dot(w, w);
}

/// Longer than any shot: the duration of a motion that never ends by itself.
inline constexpr double forever = std::numeric_limits<double>::infinity();

/// End of an arc that meets nothing: it never ends, the ball begins to roll, it stops, or it goes on along the next
/// piece of the same motion.
enum class PhaseEnd { none, roll, rest, piece };

/// Motion of a ball that other balls push all along the arc (detail/pressed.hpp): it slides, or it rolls although the
/// arc bends. On a tilted table, every rolling arc is marked `rolls`.
enum class Press : std::uint8_t { none, slides, rolls };

template <class T>
struct Arc {
  Vec2<T> at{}, velocity{}, acceleration{};
  T duration{};
  PhaseEnd end = PhaseEnd::none;
  bool bends = false;  ///< the acceleration need not be along the velocity
  Press pressed = Press::none;
  bool chord = false;  ///< chord of a path that is no parabola; the motion's `follow` gives the path
  detail::Drag<T> drag{};
  Vec2<T> taken{};  ///< m/s²: friction less acceleration of a sliding ball; friction turns the ball even where a
                    ///< cushion or other balls keep it from moving the centre

  /// Returns true if the ball still moves where the arc ends.
  bool goes_on() const { return end == PhaseEnd::roll || end == PhaseEnd::piece; }

  /// Returns the centre at a parameter, which may have derivatives.
  template <class S>
  Vec2<T> position(const S& p) const {
    return at + (velocity + acceleration * S(p * 0.5)) * p;
  }
  /// Returns dr/dp.
  template <class S>
  Vec2<T> tangent(const S& p) const {
    return velocity + acceleration * p;
  }
  /// Returns dr/dt.
  Vec2<T> velocity_at(const T& p) const { return drag.none() ? tangent(p) : slowed_velocity(p); }
  /// Returns the time at p.
  T seconds(const T& p) const { return drag.none() ? p : slowed_seconds(p); }
  /// Returns the p at a time, which may be beyond the arc's end.
  T parameter(const T& t) const { return drag.none() ? t : slowed_parameter(t); }

 private:
  // These are out of line: they are rare, and long enough to keep the common case from being inlined.
  [[gnu::noinline]] Vec2<T> slowed_velocity(const T& p) const {
    const T v0 = norm(velocity);
    return velocity * (drag.speed_after(v0, T(p * v0)) / v0);
  }
  [[gnu::noinline]] T slowed_seconds(const T& p) const {
    const T v0 = norm(velocity);
    // At its end the ball rests. A speed found from the length would be the root of a rounding error.
    if (end == PhaseEnd::rest && !(value(p) < value(duration))) return drag.seconds(v0, T(0));
    return drag.seconds(v0, drag.speed_after(v0, T(p * v0)));
  }
  [[gnu::noinline]] T slowed_parameter(const T& t) const {
    if (!(value(t) < value(slowed_seconds(duration)))) return t;
    const T v0 = norm(velocity);
    return drag.length_in(v0, t) / v0;
  }
};

/// Returns the arc without derivatives: itself if it has none.
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

/// A watcher that does nothing, for callers who only ask where paths lead.
struct Unwatched {
  template <class... A>
  void operator()(const A&...) const {}
};

/// True if arcs of the motion may be chords of its paths.
template <class Motion>
inline constexpr bool has_chords = requires {
  Motion::plain;
};

/// Returns the state at t on the arc that `motion` made of `s`.
template <class T, class Motion>
State<T> advance(const Motion& motion, const Body& body, const State<T>& s, const Arc<T>& arc, const T& t) {
  if constexpr (has_chords<Motion>)
    if (arc.chord) return motion.follow(body, s, arc, t);
  State<T> out{arc.position(t), arc.velocity_at(t), s.spin};
  motion.turn(body, out, arc, arc.seconds(t));
  return out;
}

/// Returns the spin of a ball of radius R that rolls naturally with `velocity`: ẑ × v / R; 0 for a point.
template <class T>
Vec3<T> natural_roll(const Vec2<T>& velocity, double radius) {
  if (radius == 0) return {T(0), T(0), T(0)};
  return {-velocity.y / Real<T>(radius), velocity.x / Real<T>(radius), T(0)};
}

}  // namespace bankshot
