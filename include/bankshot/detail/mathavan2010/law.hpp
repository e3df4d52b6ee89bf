// SPDX-License-Identifier: MIT
//
// The forces of the cushion impact of Mathavan, Jackson & Parkin (2010), written once for every way to integrate them.
// The ball has mass 1 and radius 1 (spin velocities are Rω). P is the normal impulse; x runs along the cushion, y into
// it. Per unit of P, the friction is I = (Ix, Iy) at the cushion and C = (Cx, Cy) at the cloth. The load on the cloth
// is q = sin θ + Iy cos θ. The paper's equations of motion then become
//   ẋI′ = −7/2 Ix − β Cx         ẏI′ = sin θ cos θ − (5/2 + sin²θ) Iy − γ Cy      slip at the cushion
//   ẋC′ = −β Ix − 7/2 Cx         ẏC′ = −cos θ − γ Iy − 7/2 Cy                     slip at the cloth
//   vy′ = −(cos θ − Iy sin θ + Cy),   β = 1 − 5/2 sin θ,  γ = 5/2 − sin θ
// A contact that slides has I = μw f or C = μs q f, where f is the direction of its slip. One that sticks has the force
// that keeps its slip at 0.
#pragma once

#include "bankshot/numbers/vec.hpp"

namespace bankshot::detail::mathavan {

/// Constants of an impact.
template <class T>
struct Nose {
  T sine, cosine, mu_w, mu_s;
  T beta, gamma, yy, push;  ///< β, γ, 5/2 + sin²θ, sin θ cos θ

  Nose(const T& s, const T& c, const T& w, const T& cloth)
      : sine(s),
        cosine(c),
        mu_w(w),
        mu_s(cloth),
        beta(T(1) - T(2.5) * s),
        gamma(T(2.5) - s),
        yy(T(2.5) + s * s),
        push(s * c) {}
};

struct Sliding {
  bool cushion, cloth;
  bool lifted;  ///< q < 0: the cushion's friction carries the ball, the cloth's is 0
};

template <class T>
struct Forces {
  Vec2<T> cushion, cloth;            ///< I and C
  T load;                            ///< q
  Vec2<T> cushion_rate, cloth_rate;  ///< rates of the slips
  T vy_rate;
};

/// Returns coefficient n of the series of the forces from those of the directions; values are coefficients 0. Argument
/// `one` is coefficient n of the number 1, and `lead` is coefficient 0 of the cloth's fy. Argument `known` is what
/// lower coefficients of Iy add to coefficient n of fy Iy. The function `times_load(q)` returns coefficient n of q f at
/// the cloth.
template <class T, class TimesLoad>
inline Forces<T> forces(const Nose<T>& nose, const Sliding& slides, const T& one, const Vec2<T>& cushion,
                        const Vec2<T>& cloth, const T& lead, const T& known, TimesLoad&& times_load) {
  Forces<T> out;
  Vec2<T>&w = out.cushion, &c = out.cloth;
  if (slides.cushion) {
    w = {nose.mu_w * cushion.x, nose.mu_w * cushion.y};
  } else {
    // ẏI′ = 0 with Cy = μs (sin θ + Iy cos θ) fy.
    const T g = nose.gamma * nose.mu_s, h = g * nose.cosine;
    w.y = (one * nose.push - g * nose.sine * cloth.y - h * known) / (nose.yy + h * lead);
  }
  out.load = one * nose.sine + w.y * nose.cosine;
  if (!slides.cloth) {
    c = {nose.beta * w.x / T(-3.5), (one * nose.cosine + nose.gamma * w.y) / T(-3.5)};
  } else if (slides.lifted) {
    c = {T(0), T(0)};
  } else {
    const Vec2<T> f = times_load(out.load);
    c = {nose.mu_s * f.x, nose.mu_s * f.y};
  }
  if (!slides.cushion) w.x = nose.beta * c.x / T(-3.5);
  out.cushion_rate = {T(-3.5) * w.x - nose.beta * c.x, one * nose.push - nose.yy * w.y - nose.gamma * c.y};
  out.cloth_rate = {-nose.beta * w.x - T(3.5) * c.x, -one * nose.cosine - nose.gamma * w.y - T(3.5) * c.y};
  out.vy_rate = nose.sine * w.y - one * nose.cosine - c.y;
  return out;
}

/// Returns the current forces.
template <class T>
inline Forces<T> forces(const Nose<T>& nose, const Sliding& slides, const Vec2<T>& cushion, const Vec2<T>& cloth) {
  return forces(nose, slides, T(1), cushion, cloth, cloth.y, T(0), [&](const T& q) {
    return Vec2<T>{q * cloth.x, q * cloth.y};
  });
}

}  // namespace bankshot::detail::mathavan
