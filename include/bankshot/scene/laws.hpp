// SPDX-License-Identifier: MIT
//
// The laws of moving and colliding balls as data: their coefficients. The equations are in the headers of their names:
// motion/ideal.hpp, rolling.hpp and slide_roll.hpp, and contact/ball_ball.hpp. To simulate, include those too;
// simulate/with_physics.hpp includes them all. The laws of cushions are in contact/cushion_registry.hpp.
// A law over dual numbers C is differentiated by its coefficients.
#pragma once

#include "bankshot/numbers/scalar.hpp"
#include "bankshot/numbers/vec.hpp"
#include "bankshot/scene/body.hpp"

namespace bankshot {

template <class T>
struct State;
template <class T>
struct Arc;

/// Constant speed on a straight line, as in mathematical billiards.
struct Ideal {
  static constexpr bool straight = true;

  template <class T>
  Arc<T> arc(const Body& body, const State<T>& s) const;
  template <class T>
  void turn(const Body&, State<T>&, const Arc<T>&, const T&) const {}
  template <class T>
  void finish(const Body&, State<T>&, const Arc<T>&) const {}
  template <class T>
  void roll(const Body&, State<T>&) const {}
  template <class T>
  Vec3<T> spin(const Body& body, const State<T>& s) const;
  /// Returns the deceleration along the path [m/s²].
  double deceleration() const { return 0; }
};

/// Rolling friction μr = at_rest + per_speed · v, dimensionless.
template <class C>
struct RollingFrictionOf {
  C at_rest{0.01};
  C per_speed{0};  ///< s/m, >= 0; unless it is 0, at_rest is greater than 0

  constexpr RollingFrictionOf() = default;
  constexpr RollingFrictionOf(const C& constant) : at_rest(constant) {}
  constexpr RollingFrictionOf(const C& rest, const C& slope) : at_rest(rest), per_speed(slope) {}
};
using RollingFriction = RollingFrictionOf<double>;

/// Natural roll from the first instant.
template <class C>
struct RollingOf {
  C friction{0.01};  ///< μr, dimensionless, >= 0
  double g = 9.81;   ///< m/s², > 0

  static constexpr bool straight = true;

  template <class T>
  Arc<T> arc(const Body& body, const State<T>& s) const;
  template <class T>
  void turn(const Body&, State<T>&, const Arc<T>&, const T&) const {}
  template <class T>
  void finish(const Body& body, State<T>& s, const Arc<T>& arc) const;
  template <class T>
  void roll(const Body&, State<T>&) const {}
  template <class T>
  Vec3<T> spin(const Body& body, const State<T>& s) const;
  /// Returns the deceleration along the path [m/s²].
  C deceleration() const { return friction * g; }
};
using Rolling = RollingOf<double>;

/// A ball that slides, rolls and spins. It needs a radius, because slip does.
template <class C>
struct SlideRollOf {
  C sliding_friction{0.2};                  ///< μs
  RollingFrictionOf<C> rolling_friction{};  ///< μr
  C spinning_friction{4.0 / 9 * 0.028575};  ///< μsp, dimensionless
  double g = 9.81;                          ///< m/s²

  static constexpr bool straight = false;

  /// Returns the velocity of the ball's lowest point over the cloth.
  template <class T>
  static Vec2<T> slip(const Body& body, const State<T>& s);
  template <class T>
  Arc<T> arc(const Body& body, const State<T>& s) const;
  template <class T>
  void turn(const Body& body, State<T>& s, const Arc<T>& arc, const T& t) const;
  /// Lets the spin about the vertical fade for t seconds.
  template <class T>
  void fade(const Body& body, State<T>& s, const T& t) const;
  template <class T>
  void finish(const Body& body, State<T>& s, const Arc<T>& arc) const;
  template <class T>
  static void roll(const Body& body, State<T>& s);
  template <class T>
  Vec3<T> spin(const Body& body, const State<T>& s) const;
  /// Returns the deceleration of a slow ball [m/s²].
  C deceleration() const { return rolling_friction.at_rest * g; }

 private:
  /// Takes from the speed its share, 2/7, of the slip that is left after it turned (held.hpp, pressed.hpp). Otherwise
  /// the last of the slip would come back as energy. The ball moves along a cushion, which took the part across it.
  template <class T>
  static void slow_to_roll(const Body& body, State<T>& s);
};
using SlideRoll = SlideRollOf<double>;

/// Friction coefficient a + b exp(−c s) at the slip speed s [m/s].
template <class C>
struct BallFrictionOf {
  C fast{0.05};  ///< a, >= 0: friction at fast slip
  C more{0};     ///< b: additional friction at slow slip
  C fades{0};    ///< c [s/m], >= 0: rate at which b fades

  constexpr BallFrictionOf() = default;
  constexpr BallFrictionOf(const C& constant) : fast(constant) {}
  constexpr BallFrictionOf(const C& a, const C& b, const C& c) : fast(a), more(b), fades(c) {}
  friend bool operator==(const BallFrictionOf&, const BallFrictionOf&) = default;

  bool constant() const { return value(more) == 0; }
  bool none() const { return constant() && value(fast) == 0; }
  template <class T>
  T operator()(const T& slip) const;
};
using BallFriction = BallFrictionOf<double>;

/// The impact of two balls.
template <class C>
struct BallBallOf {
  C restitution{0.95};  ///< e, in [0, 1]
  BallFrictionOf<C> friction{};
  bool lasts = true;  ///< slow contacts persist

  friend bool operator==(const BallBallOf&, const BallBallOf&) = default;

  /// Returns the speed at which the two come nearer [m/s]; n is the unit vector from the first centre to the second.
  template <class T>
  static T approach(const State<T>& first, const State<T>& second, const Vec2<T>& n);
  /// Applies the impact to both balls where they are.
  template <class T>
  void collide(const Body& body1, State<T>& first, const Body& body2, State<T>& second) const;

 private:
  /// Changes the spin by n × P = −along ẑ − up (n_y, −n_x, 0), where P is the impulse.
  template <class T>
  static void turn(const Body& body, State<T>& s, const Vec2<T>& n, const T& along, const T& up);
};
using BallBall = BallBallOf<double>;

}  // namespace bankshot
