// SPDX-License-Identifier: MIT
//
// Impact of two balls: normal restitution along the line of centres, and Coulomb friction across it. Friction throws
// the object ball and spins both (D. Alciatore, The Illustrated Principles of Pool and Billiards, TP A.14; here for
// balls of any size and mass).
//   n  from the first centre to the second, in plan; lever arms are R₁ n and −R₂ n. The impulse between balls of
//      different radii stays horizontal along n: its small vertical part is left out
//   w = v₁ − v₂ + (R₁ ω₁ + R₂ ω₂) × n,  μ₁₂ = m₁ m₂/(m₁ + m₂)
//   J = (1 + e)(w·n) μ₁₂,  T = min(μ J, 2/7 μ₁₂ |w_t|),  μ = a + b exp(−c |w_t|), often a constant
//   P = −J n − T ŵ_t;  v₁ += P/m₁, v₂ −= P/m₂ without their vertical part;  ωᵢ += 5/(2 mᵢ Rᵢ) n × P
// Two balls that approach slower than tolerance::slow_contact do not part again: then e = 0, without friction.
#pragma once

#include "bankshot/motion/arc.hpp"
#include "bankshot/numbers/tolerances.hpp"
#include "bankshot/scene/laws.hpp"

namespace bankshot {

template <class C>
template <class T>
inline T BallFrictionOf<C>::operator()(const T& slip) const {
  using std::exp;
  using K = Coefficient<T, C>;
  if (constant()) return T(K(fast));
  const T power = slip * T(K(fades));
  const Real<T> at = exp(-value(power));
  // exp(−p) and its derivative, −exp(−p)
  if constexpr (has_derivatives<T>)
    return T(K(fast)) + T(K(more)) * (T(at) - (power - T(value(power))) * at);
  else
    return T(K(fast)) + T(K(more)) * at;
}

template <class C>
template <class T>
inline T BallBallOf<C>::approach(const State<T>& first, const State<T>& second, const Vec2<T>& n) {
  return dot(first.velocity - second.velocity, n);
}

template <class C>
template <class T>
inline void BallBallOf<C>::collide(const Body& body1, State<T>& first, const Body& body2, State<T>& second) const {
  using std::sqrt;
  using Number = Real<T>;
  using K = Coefficient<T, C>;
  const Vec2<T> between = second.at - first.at, n = between / norm(between), t = perpendicular(n);
  const T closing = approach(first, second, n);
  const bool slow = lasts && value(closing) < Number(tolerance::slow_contact);
  const Number m1(body1.mass), m2(body2.mass), mass = m1 * m2 / (m1 + m2);
  const T normal = closing * T(K(slow ? K(1) : K(K(1) + K(restitution)))) * mass;
  T along(0), up(0);  // parts of the impulse T ŵ_t
  if (!slow && !friction.none()) {
    const auto surface = [&](const T& first_spin, const T& second_spin) {
      return T(first_spin * Number(body1.radius) + second_spin * Number(body2.radius));
    };
    const T wx = surface(first.spin.x, second.spin.x), wy = surface(first.spin.y, second.spin.y);
    const T slip_along = dot(first.velocity - second.velocity, t) + surface(first.spin.z, second.spin.z);
    const T slip_up = wx * n.y - wy * n.x;
    // Squares are compared, because a root of 0 has no derivative.
    const T slip2 = slip_along * slip_along + slip_up * slip_up;
    const T most = normal * (friction.constant() ? T(K(friction.fast))
                             : value(slip2) > 0  ? friction(T(sqrt(slip2)))
                                                 : friction(T(Number(0))));
    const Number sticks = mass * Number(2) / Number(7);
    const bool slides = value(slip2) * sticks * sticks > value(most) * value(most);
    const T share = slides ? T(most / sqrt(slip2)) : T(sticks);
    along = slip_along * share;
    up = slip_up * share;
  }
  const Vec2<T> push = n * normal + t * along;
  first.velocity -= push * T(Number(1) / m1);
  second.velocity += push * T(Number(1) / m2);
  turn(body1, first, n, along, up);
  turn(body2, second, n, along, up);
}

template <class C>
template <class T>
inline void BallBallOf<C>::turn(const Body& body, State<T>& s, const Vec2<T>& n, const T& along, const T& up) {
  using Number = Real<T>;
  const T by(Number(5) / (Number(2) * Number(body.mass) * Number(body.radius)));
  s.spin.x -= by * up * n.y;
  s.spin.y += by * up * n.x;
  s.spin.z -= by * along;
}

}  // namespace bankshot
