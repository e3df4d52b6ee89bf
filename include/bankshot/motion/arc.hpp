// SPDX-License-Identifier: MIT
//
// What a motion model hands to the event finder: between two events the centre moves on an arc
// of degree two in time. Models differ only in how they make the next arc.
//   r(t) = at + velocity t + acceleration t²/2,  0 <= t <= duration     [m, m/s, m/s², s]
//
// A motion model is a value with
//   straight                 true when every arc is a straight line and its shape does not depend
//                            on the speed
//   arc(state)               the next arc
//   turn(state, arc, t)      what t seconds on that arc do to the spin
//   finish(state, arc)       makes the state exact where the arc ends by itself
//   spin(state)              the spin of a state, also where the model does not carry it
#pragma once

#include <limits>

#include "bankshot/vec.hpp"

namespace bankshot {

/// A moving ball: centre [m], velocity [m/s], spin [rad/s] (carried by models that need it).
template <class T>
struct State {
  Vec2<T> at{}, velocity{};
  Vec3<T> spin{};
};

/// Longer than any shot: the duration of a motion that never ends by itself.
inline constexpr double forever = std::numeric_limits<double>::infinity();

/// What happens when an arc ends before it meets anything.
enum class PhaseEnd { none, roll, rest };

template <class T>
struct Arc {
  Vec2<T> at{}, velocity{}, acceleration{};
  T duration{};
  PhaseEnd end = PhaseEnd::none;

  /// At a time with or without derivatives.
  template <class S>
  Vec2<T> position(const S& t) const {
    return at + (velocity + acceleration * S(t * 0.5)) * t;
  }
  template <class S>
  Vec2<T> velocity_at(const S& t) const {
    return velocity + acceleration * t;
  }
};

/// The arc without derivatives: itself where it has none.
template <class T>
decltype(auto) value(const Arc<T>& a) {
  if constexpr (has_derivatives<T>)
    return Arc<Real<T>>{value(a.at), value(a.velocity), value(a.acceleration), value(a.duration), a.end};
  else
    return (a);
}

/// The state t seconds into the arc that `motion` made of `s`.
template <class T, class Motion>
State<T> advance(const Motion& motion, const State<T>& s, const Arc<T>& arc, const T& t) {
  State<T> out{arc.position(t), arc.velocity_at(t), s.spin};
  motion.turn(out, arc, t);
  return out;
}

/// Spin of a ball of radius R that rolls naturally with `velocity`: ẑ × v / R; 0 for a point.
template <class T>
Vec3<T> natural_roll(const Vec2<T>& velocity, double radius) {
  if (radius == 0) return {T(0), T(0), T(0)};
  return {-velocity.y / Real<T>(radius), velocity.x / Real<T>(radius), T(0)};
}

}  // namespace bankshot
