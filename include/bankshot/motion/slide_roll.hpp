// SPDX-License-Identifier: MIT
//
// A ball on cloth: it slides until its contact point rests on the cloth, then it rolls, then it
// stops; vertical spin decays beside either (Leckie & Greenspan 2006; pooltool's theory notes).
//   slip      u = v − R (ω × ẑ) = (vx − R ωy, vy + R ωx)
//   sliding   v̇ = −μs g û,  ω̇∥ = (5 μs g / 2R)(ẑ × û),  u̇ = −(7/2) μs g û; û is constant, so the
//             path is a parabola, until t = 2|u| / (7 μs g)
//   rolling   v̇ = −μr g v̂,  ω∥ = ẑ × v / R
//   vertical  ω̇z = −sign(ωz) 5 μsp g / (2R), until ωz = 0
// Worked number: hit in the centre at v0 = 2 m/s with μs = 0.2, a ball rolls after 2 v0/(7 μs g) =
// 0.291 s and 12 v0²/(49 μs g) = 0.499 m, at 5/7 v0.
#pragma once

#include "bankshot/motion/rolling.hpp"
#include "bankshot/numbers/tolerances.hpp"

namespace bankshot {

struct SlideRoll {
  double radius = 0.028575;                       ///< R [m], > 0
  double sliding_friction = 0.2;                  ///< μs
  RollingFriction rolling_friction{};             ///< μr
  double spinning_friction = 4.0 / 9 * 0.028575;  ///< μsp, dimensionless
  double g = 9.81;                                ///< m/s²

  static constexpr bool straight = false;

  /// Velocity of the ball's lowest point over the cloth.
  template <class T>
  Vec2<T> slip(const State<T>& s) const {
    const Real<T> R(radius);
    return {s.velocity.x - R * s.spin.y, s.velocity.y + R * s.spin.x};
  }

  template <class T>
  Arc<T> arc(const State<T>& s) const {
    using std::sqrt;
    using Number = Real<T>;
    const Vec2<T> u = slip(s);
    const T slip2 = dot(u, u);
    constexpr double still = tolerance::slip * tolerance::slip;
    if (!(value(slip2) > still * squared_scale(s, radius))) return rolling_arc(s.at, s.velocity, rolling_friction, g);
    if (sliding_friction == 0) return {s.at, s.velocity, {T(0), T(0)}, T(forever), PhaseEnd::none};
    const Number a = Number(sliding_friction) * g;
    const T size = sqrt(slip2);
    return {s.at, s.velocity, u * T(-a / size), size * Number(2) / Number(7 * a), PhaseEnd::roll};
  }

  template <class T>
  void turn(State<T>& s, const Arc<T>& arc, const T& t) const {
    using Number = Real<T>;
    if (arc.end == PhaseEnd::roll) {
      // ẑ × û (5 μs g / 2R) t, with û taken from the acceleration −μs g û.
      const T by_radius = t * Number(Number(2.5) / radius);
      s.spin.x += arc.acceleration.y * by_radius;
      s.spin.y -= arc.acceleration.x * by_radius;
    } else if (arc.end == PhaseEnd::rest) {
      set_rolling(s);
    }
    const T lost = t * Number(Number(2.5) * spinning_friction * g / radius);
    if (value(s.spin.z) > value(lost))
      s.spin.z -= lost;
    else if (value(s.spin.z) < -value(lost))
      s.spin.z += lost;
    else
      s.spin.z = T(0);
  }

  template <class T>
  void finish(State<T>& s, const Arc<T>& arc) const {
    if (arc.end == PhaseEnd::rest) s.velocity = {T(0), T(0)};
    set_rolling(s);
  }

  template <class T>
  Vec3<T> spin(const State<T>& s) const {
    return s.spin;
  }
  /// Of a slow ball [m/s²].
  double deceleration() const { return rolling_friction.at_rest * g; }

 private:
  template <class T>
  void set_rolling(State<T>& s) const {
    s.spin.x = -s.velocity.y / Real<T>(radius);
    s.spin.y = s.velocity.x / Real<T>(radius);
  }
};

}  // namespace bankshot
