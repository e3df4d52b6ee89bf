// SPDX-License-Identifier: MIT
//
// What a motion model hands to the event finder: between two events the centre moves on an arc
// of degree two in time. Models differ only in how they make the next arc.
//   r(t) = at + velocity t + acceleration t²/2,  0 <= t <= duration     [m, m/s, m/s², s]
#pragma once

#include <limits>

#include "bankshot/vec.hpp"

namespace bankshot {

/// A moving ball: centre [m] and velocity [m/s].
template <class T>
struct State {
  Vec2<T> at, velocity;
};

template <class T>
struct Arc {
  Vec2<T> at, velocity, acceleration;
  T duration;

  Vec2<T> position(const T& t) const { return at + (velocity + acceleration * (t / T(2))) * t; }
  Vec2<T> velocity_at(const T& t) const { return velocity + acceleration * t; }
  State<T> state_at(const T& t) const { return {position(t), velocity_at(t)}; }
};

/// Longer than any shot: the duration of a motion that never ends by itself.
inline constexpr double forever = std::numeric_limits<double>::infinity();

/// What happens when an arc ends before it meets anything.
enum class PhaseEnd { none, rest };

}  // namespace bankshot
